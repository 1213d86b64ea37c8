// SPDX-License-Identifier: Apache-2.0
// A memory of topology mode behind a cache (docs/cache.md): entries of which a clear leaves none, updated and read, in
// order. Whoever uses it says where an entry lies: in which line, and at what place there.

`include "assertions.svh"

module memory_cache #(
  parameter int unsigned LINE_BITS     = 15,
  parameter int unsigned PLACE_LOG2    = 3,    // 2^PLACE_LOG2 entries a line
  parameter int unsigned ENTRY_BITS    = 42,
  parameter int unsigned OPERAND_BITS  = 59,
  parameter int unsigned TAG_BITS      = 49,
  parameter int unsigned SIZE_LOG2     = 14,
  parameter int unsigned FIRST_LINE    = 0,
  parameter int unsigned LINE_IDS_LOG2 = 4,
  parameter int unsigned STALL_SEED    = 0
) (
  input  logic                         clk_i,
  input  logic                         rst_ni,
  // Update port and the unit's combinational modify function; every update writes its entry, which makes it present.
  input  logic                         update_valid_i,
  output logic                         update_ready_o,
  input  logic [LINE_BITS-1:0]         update_line_i,
  input  logic [PLACE_LOG2-1:0]        update_place_i,
  input  logic [OPERAND_BITS-1:0]      update_operand_i,
  output logic                         modify_valid_o,
  output logic                         modify_present_o,
  output logic [ENTRY_BITS-1:0]        modify_entry_o,
  output logic [OPERAND_BITS-1:0]      modify_operand_o,
  input  logic [ENTRY_BITS-1:0]        modify_entry_i,
  // Read port.
  input  logic                         read_valid_i,
  output logic                         read_ready_o,
  input  logic [LINE_BITS-1:0]         read_line_i,
  input  logic [PLACE_LOG2-1:0]        read_place_i,
  input  logic [TAG_BITS-1:0]          read_tag_i,
  output logic                         entry_valid_o,
  input  logic                         entry_ready_i,
  output logic                         entry_present_o,
  output logic [ENTRY_BITS-1:0]        entry_o,
  output logic [TAG_BITS-1:0]          entry_tag_o,
  // Clear; only while idle.
  input  logic                         clear_i,
  output logic                         clearing_o,
  output logic                         idle_o,
  // Line port.
  output cache_pkg::want_t             want_o,
  input  cache_pkg::give_t             give_i,
  output cache_pkg::events_t           events_o
);

  localparam int unsigned WIDTH   = cache_pkg::LINE >> PLACE_LOG2;  // of an entry's place
  localparam int unsigned BANKS   = WIDTH / cache_pkg::BANK;
  localparam int unsigned PAYLOAD = gnomon_pkg::max_of(OPERAND_BITS, TAG_BITS);
  localparam int unsigned INFO    = 1 + PLACE_LOG2 + PAYLOAD;

  localparam bit          STALLS = STALL_SEED != 0;
  localparam logic [15:0] SEED   = 16'(STALL_SEED);

  // ---- Gates for tests ----
  logic update_gated, update_granted, read_gated, read_granted, entry_given, entry_taken;
  stall_gate #(.SEED(STALLS ? SEED ^ 16'h1F35 : 16'd0)) u_stall_update (
    .clk_i, .rst_ni, .valid_i(update_valid_i), .ready_o(update_ready_o), .valid_o(update_gated),
    .ready_i(update_granted)
  );
  stall_gate #(.SEED(STALLS ? SEED ^ 16'h60D2 : 16'd0)) u_stall_read (
    .clk_i, .rst_ni, .valid_i(read_valid_i), .ready_o(read_ready_o), .valid_o(read_gated), .ready_i(read_granted)
  );
  stall_gate #(.SEED(STALLS ? SEED ^ 16'hB94C : 16'd0)) u_stall_entry (
    .clk_i, .rst_ni, .valid_i(entry_given), .ready_o(entry_taken), .valid_o(entry_valid_o), .ready_i(entry_ready_i)
  );

  // ---- Clear: waits for what is being written back ----
  logic clear_q, clear_ready, clear_cache;
  assign clear_cache = clear_q && clear_ready;
  assign clearing_o  = clear_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni)          clear_q <= 1'b0;
    else if (clear_i)     clear_q <= 1'b1;
    else if (clear_cache) clear_q <= 1'b0;
  end

  // ---- Requests: updates first ----
  logic                       ready, first, serve, room, hand, cache_idle, none;
  logic [INFO-1:0]            first_info, hand_info;
  logic [cache_pkg::LINE-1:0] line;
  logic                       y_ready, first_y, hand_y, y_info, unused_y;
  logic [cache_pkg::LINE-1:0] y_line;
  logic [cache_pkg::BANKS-1:0] write;
  assign unused_y       = ^{y_ready, first_y, hand_y, y_info, y_line};
  assign update_granted = ready && !clear_q;
  assign read_granted   = ready && !clear_q && !update_gated;
  line_cache #(
    .LINE_BITS(LINE_BITS), .SIZE_LOG2(SIZE_LOG2), .FIRST_LINE(FIRST_LINE), .LINE_IDS_LOG2(LINE_IDS_LOG2), .X_BITS(INFO)
  ) u_cache (
    .clk_i, .rst_ni, .x_valid_i((update_gated || read_gated) && !clear_q), .x_ready_o(ready), .x_use_i(1'b1),
    .x_line_i(update_gated ? update_line_i : read_line_i),
    .x_info_i(update_gated ? {1'b0, update_place_i, PAYLOAD'(update_operand_i)} :
                             {1'b1, read_place_i, PAYLOAD'(read_tag_i)}),
    .y_valid_i(1'b0), .y_ready_o(y_ready), .y_line_i('0), .y_info_i(1'b0), .first_valid_o(first),
    .first_x_info_o(first_info), .first_y_o(first_y), .serve_i(serve), .hand_valid_o(hand), .x_info_o(hand_info),
    .x_line_o(line), .y_o(hand_y), .y_info_o(y_info), .y_line_o(y_line), .write_i(write),
    .write_line_i({1 << PLACE_LOG2{WIDTH'({1'b1, modify_entry_i})}}), .clear_i(clear_cache),
    .clear_ready_o(clear_ready), .idle_o(cache_idle), .want_o, .give_i, .events_o
  );

  // ---- The entry in hand ----
  logic                  hand_read, first_read, present, unused_first;
  logic [PLACE_LOG2-1:0] place;
  logic [PAYLOAD-1:0]    payload;
  logic [ENTRY_BITS-1:0] entry;
  assign {hand_read, place, payload} = hand_info;
  assign {present, entry} = line[place*WIDTH+:ENTRY_BITS+1];
  assign modify_valid_o   = hand && !hand_read;
  assign modify_present_o = present;
  assign modify_entry_o   = entry;
  assign modify_operand_o = payload[OPERAND_BITS-1:0];
  for (genvar i = 0; i < (1 << PLACE_LOG2); i++) begin : gen_places
    assign write[i*BANKS+:BANKS] = (modify_valid_o && place == PLACE_LOG2'(i)) ? '1 : '0;
  end

  // ---- Answers ----
  assign first_read   = first_info[INFO-1];
  assign unused_first = ^first_info[INFO-2:0];
  assign serve        = first && (room || !first_read);
  cache_answers #(.WIDTH(1 + ENTRY_BITS + TAG_BITS)) u_answers (
    .clk_i, .rst_ni, .expect_i(serve && first_read), .room_o(room), .valid_i(hand && hand_read),
    .data_i({present, entry, payload[TAG_BITS-1:0]}), .valid_o(entry_given), .ready_i(entry_taken),
    .data_o({entry_present_o, entry_o, entry_tag_o}), .none_o(none)
  );

  assign idle_o = !clear_q && cache_idle && none;

  `GNOMON_ASSERT(a_clear_while_idle, !clear_i || (idle_o && !update_valid_i && !read_valid_i))

endmodule
