// SPDX-License-Identifier: Apache-2.0
// The entries of the silhouette-line buffer in memory: the ports of slb_plane behind two caches in step, one of full depths
// and flags, one of fragments (docs/cache.md). What FILL says of plain lines stays on chip.
//
//   lanes:     {present, has fragments, covered, rim, full_depth} of 16 pixels of a row, 32 bits each
//   fragments: {answers at the centre, fragments, corner, open, overflow, count}, a power of two of bits each

`include "assertions.svh"

module slb_plane_cache #(
  parameter int unsigned FRAC_BITS       = 7,
  parameter int unsigned SLOPE_BITS      = 7,
  parameter int unsigned FRAGS_PER_PIXEL = 2,
  parameter int unsigned DEPTH_BITS      = 20,
  parameter int unsigned INDEX_BITS      = 16,
  parameter int unsigned SLOT_BITS       = 4,    // 2^SLOT_BITS pixels a line of lanes
  parameter int unsigned SPAN_BITS       = 2,    // 2^SPAN_BITS lines a span
  parameter int unsigned OPERAND_BITS    = 64,   // the highest two say what kind of update
  parameter int unsigned TAG_BITS        = 64,
  parameter int unsigned SIZE_LOG2       = 15,   // bytes: half for lanes, a quarter for fragments
  parameter int unsigned FIRST_LINE      = 0,
  parameter int unsigned LINE_IDS_LOG2   = 4,
  // Derived; not to be overridden.
  parameter int unsigned ENTRY = slb_pkg::entry_bits(FRAC_BITS, SLOPE_BITS, FRAGS_PER_PIXEL, DEPTH_BITS),
  parameter int unsigned WORD  = ENTRY + FRAGS_PER_PIXEL + 2,  // {covered, rim, centre, entry}
  parameter int unsigned SLOTS = 1 << SLOT_BITS,
  parameter int unsigned SPAN  = 1 << SPAN_BITS,
  parameter int unsigned SPANS = INDEX_BITS - SLOT_BITS - SPAN_BITS
) (
  input  logic                        clk_i,
  input  logic                        rst_ni,
  // Update port: of an entry, and of others in its line.
  input  logic                        update_valid_i,
  output logic                        update_ready_o,
  input  logic [INDEX_BITS-1:0]       update_index_i,
  input  logic [OPERAND_BITS-1:0]     update_operand_i,
  // The unit's modify function, combinational. Of a line: which slots get new flags, which of them are covered, which depth
  // those get at most.
  output logic                        modify_valid_o,
  output logic [WORD-1:0]             modify_word_o,
  output logic [OPERAND_BITS-1:0]     modify_operand_o,
  input  logic                        modify_write_i,
  input  logic [WORD-1:0]             modify_word_i,
  input  logic                        line_write_i,
  input  logic [SLOTS-1:0]            line_slots_i,
  input  logic [SLOTS-1:0]            line_covered_i,
  input  logic [DEPTH_BITS-1:0]       line_depth_i,
  // FILL's word on the lines of a span, beside the updates.
  input  logic [SPAN-1:0]             plain_write_i,
  input  logic [SPANS-1:0]            plain_span_i,
  input  logic [SPAN-1:0]             plain_i,
  input  logic [SPAN-1:0]             plain_covered_i,
  // Read port.
  input  logic                        read_valid_i,
  output logic                        read_ready_o,
  input  logic [INDEX_BITS-1:0]       read_index_i,
  input  logic [TAG_BITS-1:0]         read_tag_i,
  output logic                        entry_valid_o,
  input  logic                        entry_ready_i,
  output logic [ENTRY-1:0]            entry_o,
  output logic [TAG_BITS-1:0]         entry_tag_o,
  // Clear; only while idle. After reset every line of the neighbours' memories is scrubbed.
  input  logic                        clear_i,
  output logic                        scrubbing_o,
  output logic [INDEX_BITS-SLOT_BITS-1:0] scrub_line_o,
  output logic                        idle_o,
  // Line port: lanes, then fragments in the upper half.
  output logic [2*cache_pkg::WANT-1:0]   want_o,
  input  logic [2*cache_pkg::GIVE-1:0]   give_i,
  output logic [2*cache_pkg::EVENTS-1:0]          events_o
);

  localparam int unsigned D         = DEPTH_BITS;
  localparam int unsigned K         = FRAGS_PER_PIXEL;
  localparam int unsigned LOW       = slb_pkg::count_bits(K) + 2 + slb_pkg::CORNER_BITS;  // below full_depth
  localparam int unsigned HIGH      = ENTRY - LOW - D;                                    // fragments
  localparam int unsigned FRAG      = K + HIGH + LOW;
  localparam int unsigned PER_LINE  = cache_pkg::slb_entries_a_line(FRAG);                // entries' fragments
  localparam int unsigned PER_LOG2  = $clog2(PER_LINE);
  localparam int unsigned PLACE     = cache_pkg::LINE / PER_LINE;                         // bits of one
  localparam int unsigned PLACE_BANKS = PLACE / cache_pkg::BANK;
  localparam int unsigned LINE_BITS = INDEX_BITS - SLOT_BITS;
  localparam int unsigned FRAG_LINE_BITS = INDEX_BITS - PER_LOG2;
  localparam int unsigned P         = INDEX_BITS / 2;
  localparam int unsigned ROWS      = 1 << P;
  localparam int unsigned COLUMN_STEP_LOG2 = 3;
  localparam int unsigned PAYLOAD   = gnomon_pkg::max_of(OPERAND_BITS, TAG_BITS);
  localparam int unsigned BANK      = cache_pkg::BANK;
  localparam int unsigned BANKS     = cache_pkg::BANKS;
  localparam int unsigned LINE      = cache_pkg::LINE;
  localparam int unsigned LANES_SIZE     = SIZE_LOG2 - 1;
  localparam int unsigned FRAGMENTS_SIZE = SIZE_LOG2 - 2;
  localparam int unsigned FIRST_FRAGMENT = FIRST_LINE + cache_pkg::region_lines(LINE_BITS);

  // ---- Clear: the caches forget; the neighbours' memories are scrubbed ----
  logic                                   scrub_last, unused_scrub, lanes_clear_ready, fragments_clear_ready, clear_q;
  logic [gnomon_pkg::GENERATION_BITS-1:0] generation, marked, unused_marked;
  plane_clear #(.LINE_ADDRESS_BITS(LINE_BITS)) u_clear (
    .clk_i, .rst_ni, .clear_i, .scrubbing_o, .last_o(scrub_last), .line_o(scrub_line_o), .generation_o(generation)
  );
  assign unused_scrub = scrub_last ^ (^unused_marked);
  // The caches may still be writing back: nothing is taken until they have been cleared.
  logic clear_caches;
  assign clear_caches = clear_q && lanes_clear_ready && fragments_clear_ready;
  always_ff @(posedge clk_i) begin
    if (!rst_ni)           clear_q <= 1'b0;
    else if (clear_i)      clear_q <= 1'b1;
    else if (clear_caches) clear_q <= 1'b0;
  end

  // ---- Requests: updates first; held for a cycle, in which is read whether its line of lanes has fragments at all ----
  logic                  closed, accept, held_q, take, lanes_ready, fragments_ready, makes_fragments, held_read_q, held_make_q;
  logic [INDEX_BITS-1:0] index, held_index_q;
  logic [PAYLOAD-1:0]    payload, held_payload_q;
  logic [1:0]            kind, held_kind;
  assign closed          = scrubbing_o || clear_q;
  assign accept          = (update_valid_i || read_valid_i) && update_ready_o;
  assign update_ready_o  = (!held_q || take) && !closed;
  assign read_ready_o    = update_ready_o && !update_valid_i;
  assign index           = update_valid_i ? update_index_i : read_index_i;
  assign payload         = update_valid_i ? PAYLOAD'(update_operand_i) : PAYLOAD'(read_tag_i);
  assign kind            = update_operand_i[OPERAND_BITS-1-:2];
  assign makes_fragments = update_valid_i && (kind == slb_pkg::UPDATE_INSERT || kind == slb_pkg::UPDATE_FINISH);
  always_ff @(posedge clk_i) begin
    if (!rst_ni)     held_q <= 1'b0;
    else if (accept) held_q <= 1'b1;
    else if (take)   held_q <= 1'b0;
  end
  always_ff @(posedge clk_i) begin
    if (accept) begin
      held_read_q    <= !update_valid_i;
      held_make_q    <= makes_fragments;
      held_index_q   <= index;
      held_payload_q <= payload;
    end
  end

  // The generation in which a line got its first fragments; 0: in none.
  logic                                   held_use;
  plane_bank #(.ADDRESS_BITS(LINE_BITS), .WIDTH(gnomon_pkg::GENERATION_BITS)) u_marks (
    .clk_i, .a_read_i(accept), .a_address_i(index[INDEX_BITS-1:SLOT_BITS]), .a_word_o(marked), .b_read_i(1'b0),
    .b_write_i(scrubbing_o || (accept && makes_fragments)),
    .b_address_i(scrubbing_o ? scrub_line_o : index[INDEX_BITS-1:SLOT_BITS]),
    .b_word_i(scrubbing_o ? '0 : generation), .b_word_o(unused_marked)
  );
  assign held_kind = held_payload_q[OPERAND_BITS-1-:2];
  assign held_use  = held_make_q || (marked == generation && (held_read_q || held_kind == slb_pkg::UPDATE_COVER));

  // ---- Into both caches or into neither. Lines are numbered down the columns, so that a set's number is a place in a column,
  // and each column begins eight places on: what is drawn crosses many rows and few columns of lines ----
  logic [LINE_BITS-1:0]      in_row, in_column, line;
  logic [FRAG_LINE_BITS-1:0] in_row_fragments, in_column_fragments, fragments_number;
  assign in_row              = held_index_q[INDEX_BITS-1:SLOT_BITS];
  assign in_row_fragments    = held_index_q[INDEX_BITS-1:PER_LOG2];
  assign in_column           = LINE_BITS'({in_row, in_row} >> (LINE_BITS - P));
  assign in_column_fragments = FRAG_LINE_BITS'({in_row_fragments, in_row_fragments} >> (FRAG_LINE_BITS - P));
  // The column stands above the row; what is carried beyond the row's bits is lost by the mask of the column.
  assign line = (in_column & ~LINE_BITS'(ROWS - 1)) |
                ((in_column + ((in_column >> P) << COLUMN_STEP_LOG2)) & LINE_BITS'(ROWS - 1));
  assign fragments_number =
    (in_column_fragments & ~FRAG_LINE_BITS'(ROWS - 1)) |
    ((in_column_fragments + ((in_column_fragments >> P) << COLUMN_STEP_LOG2)) & FRAG_LINE_BITS'(ROWS - 1));
  assign take             = held_q && lanes_ready && fragments_ready;

  logic                                  lanes_first, fragments_first, room, serve, first_read, hand;
  logic [2+INDEX_BITS+PAYLOAD-1:0]       first_info, hand_info;
  logic [LINE-1:0]                       lanes_line, fragments_line, lanes_new, fragments_new;
  logic [BANKS-1:0]                      lanes_write, fragments_write;
  logic                                  lanes_idle, fragments_idle;
  cache_pkg::want_t                      lanes_want, fragments_want;
  cache_pkg::give_t                      lanes_give, fragments_give;
  cache_pkg::events_t                    lanes_events, fragments_events;
  assign want_o                       = {fragments_want, lanes_want};
  assign {fragments_give, lanes_give} = give_i;
  assign events_o                     = {fragments_events, lanes_events};
  assign first_read = first_info[INDEX_BITS+PAYLOAD];
  assign serve      = lanes_first && fragments_first && (room || !first_read);

  // Of both caches only the first request beside x is not used.
  logic lanes_y_ready, lanes_first_y, lanes_y, lanes_y_info;
  logic fragments_y_ready, fragments_first_y, fragments_y, fragments_y_info, fragments_first_info, fragments_info;
  logic fragments_hand, unused_y;
  logic [LINE-1:0] lanes_y_line, fragments_y_line;
  assign unused_y = ^{
    lanes_y_ready, lanes_first_y, lanes_y, lanes_y_info, lanes_y_line, fragments_y_ready, fragments_first_y, fragments_y,
    fragments_y_info, fragments_y_line, fragments_first_info, fragments_info, fragments_hand
  };
  line_cache #(
    .LINE_BITS(LINE_BITS), .SIZE_LOG2(LANES_SIZE), .FIRST_LINE(FIRST_LINE), .LINE_IDS_LOG2(LINE_IDS_LOG2),
    .X_BITS(2 + INDEX_BITS + PAYLOAD)
  ) u_lanes (
    .clk_i, .rst_ni, .x_valid_i(held_q && fragments_ready), .x_ready_o(lanes_ready), .x_use_i(1'b1), .x_line_i(line),
    .x_info_i({held_use, held_read_q, held_index_q, held_payload_q}), .y_valid_i(1'b0),
    .y_ready_o(lanes_y_ready), .y_line_i('0), .y_info_i(1'b0), .first_valid_o(lanes_first),
    .first_x_info_o(first_info), .first_y_o(lanes_first_y), .serve_i(serve), .hand_valid_o(hand),
    .x_info_o(hand_info), .x_line_o(lanes_line), .y_o(lanes_y), .y_info_o(lanes_y_info), .y_line_o(lanes_y_line),
    .write_i(lanes_write), .write_line_i(lanes_new), .clear_i(clear_caches), .clear_ready_o(lanes_clear_ready),
    .idle_o(lanes_idle), .want_o(lanes_want), .give_i(lanes_give), .events_o(lanes_events)
  );
  line_cache #(
    .LINE_BITS(FRAG_LINE_BITS), .SIZE_LOG2(FRAGMENTS_SIZE), .FIRST_LINE(FIRST_FRAGMENT), .LINE_IDS_LOG2(LINE_IDS_LOG2),
    .X_BITS(1)
  ) u_fragments (
    .clk_i, .rst_ni, .x_valid_i(held_q && lanes_ready), .x_ready_o(fragments_ready), .x_use_i(held_use),
    .x_line_i(fragments_number), .x_info_i(1'b0), .y_valid_i(1'b0), .y_ready_o(fragments_y_ready),
    .y_line_i('0), .y_info_i(1'b0), .first_valid_o(fragments_first), .first_x_info_o(fragments_first_info),
    .first_y_o(fragments_first_y), .serve_i(serve), .hand_valid_o(fragments_hand), .x_info_o(fragments_info),
    .x_line_o(fragments_line), .y_o(fragments_y), .y_info_o(fragments_y_info), .y_line_o(fragments_y_line),
    .write_i(fragments_write), .write_line_i(fragments_new), .clear_i(clear_caches),
    .clear_ready_o(fragments_clear_ready), .idle_o(fragments_idle), .want_o(fragments_want), .give_i(fragments_give),
    .events_o(fragments_events)
  );

  // ---- Plain lines, read when a request is served ----
  logic [SPANS-1:0]  first_span;
  logic [2*SPAN-1:0] plain;
  logic              line_plain, line_covered;
  assign first_span = first_info[PAYLOAD+SLOT_BITS+SPAN_BITS+:SPANS];
  for (genvar i = 0; i < SPAN; i++) begin : gen_plain
    logic [1:0] unused_plain;
    plane_bank #(.ADDRESS_BITS(SPANS), .WIDTH(2)) u_bank (
      .clk_i, .a_read_i(serve), .a_address_i(first_span), .a_word_o(plain[2*i+:2]),
      .b_read_i(1'b0), .b_write_i(plain_write_i[i]), .b_address_i(plain_span_i),
      .b_word_i({plain_i[i], plain_covered_i[i]}), .b_word_o(unused_plain)
    );
  end

  // ---- The entry in hand ----
  logic                     hand_use, hand_read, hand_cover;
  logic [INDEX_BITS-1:0]    hand_index;
  logic [PAYLOAD-1:0]       hand_payload;
  logic [SLOT_BITS-1:0]     slot;
  logic [31:0]              span_line, frag_place;
  logic                     lane_present, lane_has, lane_covered, lane_rim;
  logic [D-1:0]             lane_full;
  logic [FRAG-1:0]          seen;
  logic [WORD-1:0]          word;
  assign {hand_use, hand_read, hand_index, hand_payload} = hand_info;
  assign slot       = hand_index[SLOT_BITS-1:0];
  assign span_line  = (32'(hand_index) >> SLOT_BITS) & 32'(SPAN - 1);
  assign frag_place = 32'(hand_index) & 32'(PER_LINE - 1);
  assign {line_plain, line_covered} = plain[2*span_line+:2];
  assign {lane_present, lane_has, lane_covered, lane_rim, lane_full} = lanes_line[slot*BANK+:D+4];
  assign seen = (lane_present && lane_has) ? fragments_line[frag_place*PLACE+:FRAG] : '0;
  assign word = {
    line_plain ? line_covered : lane_covered, lane_rim && !line_plain, seen[LOW+:K+HIGH],
    lane_present ? lane_full : {D{1'b1}}, seen[LOW-1:0]
  };
  assign modify_valid_o   = hand && !hand_read;
  assign modify_word_o    = word;
  assign modify_operand_o = hand_payload[OPERAND_BITS-1:0];

  // ---- What becomes of it, and of its line ----
  logic            write, line_write, new_covered, new_rim;
  logic [K-1:0]    new_centre;
  logic [HIGH-1:0] new_high;
  logic [D-1:0]    new_full;
  logic [LOW-1:0]  new_low;
  logic            new_has;  // a sample of COVER lowers the full depth alone
  assign {new_covered, new_rim, new_centre, new_high, new_full, new_low} = modify_word_i;
  assign hand_cover = hand_payload[OPERAND_BITS-1-:2] == slb_pkg::UPDATE_COVER;
  assign write      = modify_valid_o && modify_write_i;
  assign line_write = modify_valid_o && line_write_i;
  assign new_has    = !hand_cover || (lane_present && lane_has);
  for (genvar i = 0; i < BANKS; i++) begin : gen_lanes
    if (i < SLOTS) begin : gen_slot
      logic         entry_write, old_present, old_has, old_covered, old_rim, lower, unused_flags;
      logic [D-1:0] old_full;
      assign {old_present, old_has, old_covered, old_rim, old_full} = lanes_line[i*BANK+:D+4];
      assign unused_flags = old_covered ^ old_rim;
      assign entry_write  = write && slot == SLOT_BITS'(i);
      // No depth is nearer than all ones: without a flat caster the entry stays as empty as it was.
      assign lower        = line_covered_i[i] && line_depth_i < (old_present ? old_full : {D{1'b1}});
      assign lanes_write[i] = entry_write || (line_write && line_slots_i[i]);
      assign lanes_new[i*BANK+:BANK] = entry_write ? BANK'({1'b1, new_has, new_covered, new_rim, new_full}) :
        BANK'({lower || old_present, old_has && old_present, line_covered_i[i], 1'b0, lower ? line_depth_i : old_full});
    end else begin : gen_none
      assign lanes_write[i]          = 1'b0;
      assign lanes_new[i*BANK+:BANK] = '0;
    end
  end
  for (genvar i = 0; i < PER_LINE; i++) begin : gen_fragments
    assign fragments_write[i*PLACE_BANKS+:PLACE_BANKS] = (write && !hand_cover && frag_place == 32'(i)) ? '1 : '0;
    assign fragments_new[i*PLACE+:PLACE]               = PLACE'({new_centre, new_high, new_low});
  end

  // ---- Answers ----
  logic none;
  cache_answers #(.WIDTH(ENTRY + TAG_BITS)) u_answers (
    .clk_i, .rst_ni, .expect_i(serve && first_read), .room_o(room), .valid_i(hand && hand_read),
    .data_i({word[ENTRY-1:0], hand_payload[TAG_BITS-1:0]}), .valid_o(entry_valid_o), .ready_i(entry_ready_i),
    .data_o({entry_o, entry_tag_o}), .none_o(none)
  );

  assign idle_o = !closed && !held_q && lanes_idle && fragments_idle && none;

  logic unused_first;
  assign unused_first = ^{first_info[1+INDEX_BITS+PAYLOAD], first_info[PAYLOAD+SLOT_BITS+SPAN_BITS-1:0]};

  `GNOMON_ASSERT(a_in_step, hand == fragments_hand)
  `GNOMON_ASSERT(a_write_with_fragments, !write || hand_cover || hand_use)
  `GNOMON_ASSERT(a_fragments_are_there,
                 !hand || hand_use || !(lane_present && lane_has) || hand_payload[OPERAND_BITS-1-:2] == slb_pkg::UPDATE_LINE)

endmodule
