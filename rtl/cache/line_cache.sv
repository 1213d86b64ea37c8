// SPDX-License-Identifier: Apache-2.0
// A cache of lines that looks requests up long before it serves them, so that a line is there when its request comes to be
// served (docs/cache.md). In order; whoever uses it says when the oldest request is served, and what becomes of its line.

`include "assertions.svh"

module line_cache #(
  parameter int unsigned LINE_BITS     = 14,  // 2^LINE_BITS lines
  parameter int unsigned SIZE_LOG2     = 15,  // bytes
  parameter int unsigned FIRST_LINE    = 0,   // number of the first line in memory
  parameter int unsigned LINE_IDS_LOG2 = 4,
  parameter int unsigned X_BITS        = 64,
  parameter int unsigned Y_BITS        = 1
) (
  input  logic                        clk_i,
  input  logic                        rst_ni,
  // Requests: x, and a read beside it that is taken with x or not at all.
  input  logic                        x_valid_i,
  output logic                        x_ready_o,
  input  logic                        x_use_i,      // it needs a line; else it only keeps its place in the order
  input  logic [LINE_BITS-1:0]        x_line_i,
  input  logic [X_BITS-1:0]           x_info_i,
  input  logic                        y_valid_i,
  output logic                        y_ready_o,
  input  logic [LINE_BITS-1:0]        y_line_i,
  input  logic [Y_BITS-1:0]           y_info_i,
  // The oldest request can be served, and is.
  output logic                        first_valid_o,
  output logic [X_BITS-1:0]           first_x_info_o,
  output logic                        first_y_o,
  input  logic                        serve_i,
  // A cycle later its line is in hand.
  output logic                        hand_valid_o,
  output logic [X_BITS-1:0]           x_info_o,
  output logic [cache_pkg::LINE-1:0]  x_line_o,
  output logic                        y_o,
  output logic [Y_BITS-1:0]           y_info_o,
  output logic [cache_pkg::LINE-1:0]  y_line_o,
  input  logic [cache_pkg::BANKS-1:0] write_i,      // banks of x that are written; combinational
  input  logic [cache_pkg::LINE-1:0]  write_line_i,
  // Clear: every line reads as zeros. Only when ready.
  input  logic                        clear_i,
  output logic                        clear_ready_o,
  output logic                        idle_o,       // no request under way, no clear going on
  // Line port.
  output cache_pkg::want_t            want_o,
  input  cache_pkg::give_t            give_i,
  output cache_pkg::events_t          events_o
);

  localparam int unsigned SETS_LOG2 = cache_pkg::sets_log2(SIZE_LOG2, LINE_BITS);
  localparam int unsigned SLOT_BITS = SETS_LOG2 + 1;
  localparam int unsigned FILL      = LINE_IDS_LOG2 + 1;  // more lines are to come than can be under way
  localparam int unsigned VICTIM    = LINE_IDS_LOG2 + 2;  // and more on their way out than are to come
  localparam int unsigned NUMBER    = cache_pkg::NUMBER;
  localparam int unsigned LINE      = cache_pkg::LINE;

  // ---- Look-up ----
  logic                 x_hit, y_hit, victim_there, queue_ready, fills_room, victims_room, leaving, scrubbing;
  logic                 x_take, y_take, miss_take;
  logic [SLOT_BITS-1:0] x_slot, y_slot;
  logic [LINE_BITS-1:0] victim_there_line;
  cache_tags #(.LINE_BITS(LINE_BITS), .SETS_LOG2(SETS_LOG2)) u_tags (
    .clk_i, .rst_ni, .clear_i, .x_line_i, .x_hit_o(x_hit), .x_slot_o(x_slot), .victim_o(victim_there),
    .victim_line_o(victim_there_line), .x_take_i(x_take && x_use_i), .y_line_i, .y_hit_o(y_hit), .y_slot_o(y_slot),
    .y_take_i(y_take)
  );
  assign x_ready_o = queue_ready && !scrubbing &&
                     (!x_use_i || x_hit || (fills_room && victims_room && !leaving));
  assign y_ready_o = x_take && x_use_i && x_hit && y_hit;
  assign x_take    = x_valid_i && x_ready_o;
  assign y_take    = y_valid_i && y_ready_o;
  assign miss_take = x_take && x_use_i && !x_hit;

  // ---- Requests wait ----
  localparam int unsigned WORD = 3 + 2 * SLOT_BITS + X_BITS + Y_BITS;
  logic                 first_wanted, first_miss, first_use, queue_empty;
  logic [SLOT_BITS-1:0] first_x_slot, first_y_slot;
  logic [Y_BITS-1:0]    first_y_info;
  cache_queue #(.WIDTH(WORD), .DEPTH_LOG2(cache_pkg::QUEUE_LOG2)) u_queue (
    .clk_i, .rst_ni, .valid_i(x_take), .ready_o(queue_ready),
    .data_i({x_use_i && !x_hit, x_use_i, y_take, x_slot, y_slot, x_info_i, y_info_i}), .valid_o(first_wanted),
    .ready_i(serve_i),
    .data_o({first_miss, first_use, first_y_o, first_x_slot, first_y_slot, first_x_info_o, first_y_info}),
    .empty_o(queue_empty)
  );

  // ---- Fills ----
  logic             ask_valid, ask_ready, told_valid, told_present, known, writing, back_room;
  logic [LINE_BITS-1:0] ask_line, read_line;
  logic [FILL-1:0]  ask_id, told_id, read_id;
  logic [4:0]       told_bit;
  logic [31:0]      told_word;
  logic [LINE-1:0]  fill_line;
  cache_fills #(.LINE_BITS(LINE_BITS), .ID_BITS(FILL)) u_fills (
    .clk_i, .rst_ni, .miss_i(miss_take), .miss_line_i(x_line_i), .room_o(fills_room), .ask_valid_o(ask_valid),
    .ask_ready_i(ask_ready), .ask_line_o(ask_line), .ask_id_o(ask_id), .told_valid_i(told_valid),
    .told_id_i(told_id), .told_touched_i(told_present && told_word[told_bit]), .read_valid_o(want_o.read_valid),
    .read_ready_i(give_i.read_ready), .read_line_o(read_line), .read_id_o(read_id),
    .data_valid_i(give_i.data_valid), .data_id_i(FILL'(give_i.data_id)), .data_i(give_i.data), .known_o(known),
    .use_i(serve_i && first_miss), .line_o(fill_line)
  );
  assign want_o.read_id   = cache_pkg::FILL_ID'(read_id);
  assign want_o.read_line = NUMBER'(FIRST_LINE) + NUMBER'(read_line);

  // ---- A request is served ----
  logic            hand_miss, victim_dirty, back, back_queued;
  logic [LINE-1:0] victim_data;
  assign first_valid_o = first_wanted && (!first_miss || (known && back_room)) && !(first_y_o && writing);
  cache_data #(.SLOT_BITS(SLOT_BITS)) u_data (
    .clk_i, .rst_ni, .serve_i, .x_use_i(first_use), .x_miss_i(first_miss), .x_slot_i(first_x_slot), .y_i(first_y_o),
    .y_slot_i(first_y_slot), .writing_o(writing), .valid_o(hand_valid_o), .miss_o(hand_miss),
    .fill_line_i(fill_line), .x_line_o, .y_line_o, .victim_line_o(victim_data), .victim_dirty_o(victim_dirty),
    .write_i, .write_line_i
  );
  always_ff @(posedge clk_i) begin
    x_info_o <= first_x_info_o;
    y_o      <= first_y_o;
    y_info_o <= first_y_info;
  end

  // ---- Victims and their way to memory ----
  logic                 victim, no_victims;
  logic [LINE_BITS-1:0] victim_line, back_line;
  logic [VICTIM-1:0]    victim_id, back_id;
  assign back = hand_miss && victim && victim_dirty && !mutations_pkg::CACHE_LOSE_WRITE_BACK;
  cache_victims #(.LINE_BITS(LINE_BITS), .ID_BITS(VICTIM)) u_victims (
    .clk_i, .rst_ni, .add_i(miss_take), .add_victim_i(victim_there), .add_line_i(victim_there_line),
    .room_o(victims_room), .line_i(x_line_i), .leaving_o(leaving), .victim_o(victim), .victim_line_o(victim_line),
    .victim_id_o(victim_id), .serve_i(hand_miss), .write_i(back), .written_valid_i(give_i.written_valid),
    .written_id_i(VICTIM'(give_i.written_id)), .none_o(no_victims)
  );

  localparam int unsigned BACK_LOG2 = 2;
  stream_fifo #(.WIDTH(VICTIM + LINE_BITS + LINE), .DEPTH_LOG2(BACK_LOG2)) u_back (
    .clk_i, .rst_ni, .valid_i(back), .ready_o(back_queued), .data_i({victim_id, victim_line, victim_data}),
    .valid_o(want_o.write_valid), .ready_i(give_i.write_ready),
    .data_o({back_id, back_line, want_o.write_data})
  );
  assign want_o.write_id   = cache_pkg::VICTIM_ID'(back_id);
  assign want_o.write_line = NUMBER'(FIRST_LINE) + NUMBER'(back_line);

  // Places in that queue, also those that a miss may still need.
  logic [BACK_LOG2:0] back_used_q;
  logic               back_more, back_spared, back_gone;
  assign back_room   = !back_used_q[BACK_LOG2];
  assign back_more   = serve_i && first_miss;
  assign back_spared = hand_miss && !back;
  assign back_gone   = want_o.write_valid && give_i.write_ready;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) back_used_q <= '0;
    else back_used_q <= back_used_q + (BACK_LOG2 + 1)'(back_more) - (BACK_LOG2 + 1)'(back_spared) -
                        (BACK_LOG2 + 1)'(back_gone);
  end

  // ---- One bit a line: memory has it ----
  localparam int unsigned WORD_BITS = (LINE_BITS > 10) ? LINE_BITS - 5 : 5;  // the memory of entries is no smaller
  logic        touched_idle, touch_ready, touch_valid, touch_present;
  logic [31:0] touch_word, touch_new;
  logic [4:0]  touch_bit, victim_bit, ask_bit;
  assign victim_bit = 5'(victim_line);
  assign ask_bit    = 5'(ask_line);
  assign touch_new = (touch_present ? touch_word : 32'd0) | (32'd1 << touch_bit);
  entry_memory #(
    .INDEX_BITS(WORD_BITS), .ENTRY_BITS(32), .OPERAND_BITS(5), .TAG_BITS(5 + FILL), .READ_LATENCY(1)
  ) u_touched (
    .clk_i, .rst_ni, .update_valid_i(back), .update_ready_o(touch_ready),
    .update_index_i(WORD_BITS'((LINE_BITS + 5)'(victim_line) >> 5)), .update_operand_i(victim_bit),
    .modify_valid_o(touch_valid), .modify_present_o(touch_present), .modify_entry_o(touch_word),
    .modify_operand_o(touch_bit), .modify_entry_i(touch_new), .read_valid_i(ask_valid), .read_ready_o(ask_ready),
    .read_index_i(WORD_BITS'((LINE_BITS + 5)'(ask_line) >> 5)), .read_tag_i({ask_bit, ask_id}),
    .entry_valid_o(told_valid), .entry_ready_i(1'b1), .entry_present_o(told_present), .entry_o(told_word),
    .entry_tag_o({told_bit, told_id}), .clear_i(clear_i && !mutations_pkg::CACHE_KEEP_TOUCHED), .scrubbing_o(scrubbing),
    .idle_o(touched_idle)
  );
  // ---- State ----
  assign idle_o        = queue_empty && !hand_valid_o && !scrubbing;
  assign clear_ready_o = idle_o && touched_idle && no_victims && !ask_valid;

  assign events_o.hit        = x_take && x_use_i && x_hit;
  assign events_o.hit_beside = y_take;
  assign events_o.miss       = miss_take;
  assign events_o.fill       = want_o.read_valid && give_i.read_ready;
  assign events_o.write_back = back_gone;
  assign events_o.wait_fill  = first_wanted && first_miss && !known;

  logic unused_touch;
  assign unused_touch = touch_valid;

  `GNOMON_ASSERT(a_serve_what_can_be, !serve_i || first_valid_o)
  `GNOMON_ASSERT(a_back_has_room, !back || (back_queued && touch_ready))
  `GNOMON_ASSERT(a_clear_when_ready, !clear_i || clear_ready_o)

endmodule
