// SPDX-License-Identifier: Apache-2.0
// Back end of the silhouette-line buffer: from chains and crossings to entries, from points to answers (docs/slb.md,
// "Implementation: back end"). The decoder's barriers see to it that one command of a kind at a time is at work.

`include "assertions.svh"

module slb_backend #(
  parameter int unsigned FRAC_BITS       = 7,
  parameter int unsigned SLOPE_BITS      = 7,
  parameter int unsigned FRAGS_PER_PIXEL = 2,
  parameter int unsigned DEPTH_BITS      = 20,
  parameter int unsigned PLANE_LOG2      = 8,
  parameter int unsigned QUERY_BITS      = 10,
  parameter int unsigned ROUNDING        = 0,
  parameter int unsigned MEM_LATENCY     = 1,
  parameter int unsigned MEM_STALL_SEED  = 0,
  parameter int unsigned CACHE_LOG2      = 0,  // not 0: entries in memory, behind caches (docs/cache.md)
  parameter int unsigned LINE_IDS_LOG2   = 4,
  parameter int unsigned FIRST_LINE      = 0,  // there
  // Derived; not to be overridden.
  parameter int unsigned LINE      = slb_pkg::line_bits(FRAC_BITS, SLOPE_BITS),
  parameter int unsigned CELL_BITS = PLANE_LOG2 + 2
) (
  input  logic                            clk_i,
  input  logic                            rst_ni,
  // A command begins; of an object: what it is.
  input  logic                            start_i,
  input  gnomon_pkg::header_t             header_i,
  input  logic [slb_pkg::OBJECT_BITS-1:0] object_i,
  input  logic                            flat_i,
  input  logic [DEPTH_BITS-1:0]           flat_depth_i,
  // Items of COVER and of QUERY.
  input  logic                            cover_valid_i,
  output logic                            cover_ready_o,
  input  logic                            query_valid_i,
  output logic                            query_ready_o,
  input  logic [63:0]                     item_i,
  // Chains and crossings of the walk, on the plane and off it.
  input  logic                            chain_valid_i,
  output logic                            chain_ready_o,
  input  logic signed [CELL_BITS-1:0]     chain_column_i,
  input  logic signed [CELL_BITS-1:0]     chain_row_i,
  input  logic [1:0]                      chain_op_i,
  input  logic [LINE-1:0]                 chain_a_i,
  input  logic [LINE-1:0]                 chain_b_i,
  input  logic                            chain_corner_i,
  input  logic [DEPTH_BITS-1:0]           chain_depth_i,
  input  logic                            wind_valid_i,
  output logic                            wind_ready_o,
  input  logic signed [CELL_BITS-1:0]     wind_column_i,
  input  logic signed [CELL_BITS-1:0]     wind_row_i,
  input  logic                            wind_up_i,
  // SLB_ANSWER words, and entries as read back.
  output logic                            result_valid_o,
  input  logic                            result_ready_i,
  output logic [63:0]                     result_o,
  output logic                            idle_o,
  output logic                            step_o,          // one step of a clear, a fill or a read
  output logic                            wait_o,          // a memory holds something back
  output gnomon_pkg::slb_events_t         events_o,        // those of the back end
  // Line port of the caches: lanes, then fragments in the upper half.
  output logic [2*cache_pkg::WANT-1:0] cache_want_o,
  input  logic [2*cache_pkg::GIVE-1:0] cache_give_i,
  output logic [2*cache_pkg::EVENTS-1:0]        cache_events_o
);

  localparam int unsigned P       = PLANE_LOG2;
  localparam int unsigned D       = DEPTH_BITS;
  localparam int unsigned K       = FRAGS_PER_PIXEL;
  localparam int unsigned INDEX   = 2 * P;
  localparam int unsigned SLOT    = (P < gnomon_pkg::LINE_LOG2) ? P : gnomon_pkg::LINE_LOG2;  // a line lies in one row
  localparam int unsigned SLOTS   = 1 << SLOT;
  localparam int unsigned LINES   = INDEX - SLOT;
  localparam int unsigned SPAN    = (LINES - P < slb_pkg::SPAN_LOG2) ? LINES - P : slb_pkg::SPAN_LOG2;  // likewise a span
  localparam int unsigned SPANS   = LINES - SPAN;
  localparam int unsigned ITEM    = slb_pkg::fill_item_bits(LINES, SPAN);
  localparam int unsigned ENTRY   = slb_pkg::entry_bits(FRAC_BITS, SLOPE_BITS, K, D);
  localparam int unsigned WORD    = ENTRY + K + 2;
  localparam int unsigned WINDING = P + 9;
  localparam int unsigned TAG     = 2 * QUERY_BITS + 2 * D + 17;
  localparam int unsigned SCRATCH = SLOTS * (slb_pkg::CHANGE_BITS + 1) + slb_pkg::CHANGE_BITS;

  localparam bit          STALLS = MEM_STALL_SEED != 0;
  localparam logic [15:0] SEED   = 16'(MEM_STALL_SEED);

  // ---- Commands ----
  logic           fill_start, read_start, clear_start, begin_object;
  logic [D-1:0]   level_q;   // margin of COVER, bias of QUERY
  logic [15:0]    number_q;  // of the next item in its command
  assign begin_object = start_i && header_i.op == gnomon_pkg::OP_BEGIN_OBJECT;
  assign fill_start   = start_i && header_i.op == gnomon_pkg::OP_FILL;
  assign read_start   = start_i && header_i.op == gnomon_pkg::OP_READ_ENTRIES;
  assign clear_start  = start_i && header_i.op == gnomon_pkg::OP_SLB_CLEAR;
  always_ff @(posedge clk_i) begin
    if (start_i) begin
      level_q  <= header_i.arg[D-1:0];
      number_q <= '0;
    end else if (query_valid_i && query_ready_o) begin
      number_q <= number_q + 16'd1;
    end
  end

  // ---- Chains ----
  logic             put_valid, put_ready, put_contains, put_corner;
  logic [INDEX-1:0] put_index;
  logic [1:0]       put_op;
  logic [LINE-1:0]  put_a, put_b, put_join;
  logic [D-1:0]     put_depth;
  slb_chain_stage #(
    .FRAC_BITS(FRAC_BITS), .SLOPE_BITS(SLOPE_BITS), .DEPTH_BITS(D), .PLANE_LOG2(P), .ROUNDING(ROUNDING)
  ) u_chains (
    .clk_i, .rst_ni, .chain_valid_i, .chain_ready_o, .chain_column_i, .chain_row_i, .chain_op_i, .chain_a_i,
    .chain_b_i, .chain_corner_i, .chain_depth_i, .valid_o(put_valid), .ready_i(put_ready), .index_o(put_index),
    .op_o(put_op), .a_o(put_a), .b_o(put_b), .join_o(put_join), .contains_o(put_contains), .corner_o(put_corner),
    .depth_o(put_depth), .given_o(events_o.chain), .off_plane_o(events_o.chain_off_plane)
  );

  // ---- Winding numbers ----
  logic                 wind_gated, wind_granted, scratch_ask, scratch_asked, scratch_valid, scratch_ready, winding_idle;
  logic                 span_ask, span_asked, span_valid, span_ready, touched, scrubbing;
  logic [LINES-1:0]     scrub_line;
  logic [ITEM-1:0]      scratch_item, scratch_word_item;
  logic [SCRATCH-1:0]   scratch_word;
  logic [SPANS-1:0]     span, span_word_span;
  logic [(1<<SPAN)-1:0] span_word;
  logic [P-1:0]         first_row, last_row;
  stall_gate #(.SEED(STALLS ? SEED ^ 16'h71C3 : 16'd0)) u_stall_wind (
    .clk_i, .rst_ni, .valid_i(wind_valid_i), .ready_o(wind_ready_o), .valid_o(wind_gated), .ready_i(wind_granted)
  );
  slb_winding #(.PLANE_LOG2(P), .SLOT_BITS(SLOT), .SPAN_BITS(SPAN), .READ_LATENCY(MEM_LATENCY)) u_winding (
    .clk_i, .rst_ni, .begin_i(begin_object), .wind_valid_i(wind_gated), .wind_ready_o(wind_granted), .wind_column_i,
    .wind_row_i, .wind_up_i, .saturated_o(events_o.winding_saturated), .mark_i(put_valid && put_ready),
    .mark_index_i(put_index), .span_valid_i(span_ask), .span_ready_o(span_asked), .span_i(span),
    .span_word_valid_o(span_valid), .span_word_ready_i(span_ready), .span_word_o(span_word),
    .span_word_span_o(span_word_span), .read_valid_i(scratch_ask), .read_ready_o(scratch_asked),
    .read_item_i(scratch_item), .word_valid_o(scratch_valid), .word_ready_i(scratch_ready), .word_o(scratch_word),
    .word_item_o(scratch_word_item), .touched_o(touched), .first_row_o(first_row), .last_row_o(last_row),
    .scrub_i(scrubbing), .scrub_line_i(scrub_line), .idle_o(winding_idle)
  );

  // ---- FILL ----
  logic                      fill_asked, fill_idle, fill_valid, fill_ready, fill_line, fill_step;
  logic [INDEX-1:0]          fill_index;
  logic [SLOTS-1:0]          fill_slots, fill_covered;
  logic signed [WINDING-1:0] fill_winding;
  logic [(1<<SPAN)-1:0]      plain_write, plain, plain_covered;
  logic [SPANS-1:0]          plain_span;
  logic [6:0]                fill_covered_pixels;
  slb_fill_ask #(.PLANE_LOG2(P), .LINE_BITS(LINES), .SPAN_BITS(SPAN)) u_fill_ask (
    .clk_i, .rst_ni, .start_i(fill_start), .touched_i(touched), .first_row_i(first_row), .last_row_i(last_row),
    .idle_o(fill_asked), .span_valid_o(span_ask), .span_ready_i(span_asked), .span_o(span),
    .word_valid_i(span_valid), .word_ready_o(span_ready), .word_i(span_word), .word_span_i(span_word_span),
    .read_valid_o(scratch_ask), .read_ready_i(scratch_asked), .read_item_o(scratch_item)
  );
  slb_fill #(.PLANE_LOG2(P), .SLOT_BITS(SLOT), .SPAN_BITS(SPAN)) u_fill (
    .clk_i, .rst_ni, .flat_i, .idle_o(fill_idle), .word_valid_i(scratch_valid), .word_ready_o(scratch_ready),
    .word_i(scratch_word), .word_item_i(scratch_word_item), .update_valid_o(fill_valid),
    .update_ready_i(fill_ready), .update_line_o(fill_line), .update_index_o(fill_index), .slots_o(fill_slots),
    .covered_o(fill_covered), .winding_o(fill_winding), .plain_write_o(plain_write), .plain_span_o(plain_span),
    .plain_o(plain), .plain_covered_o(plain_covered), .step_o(fill_step), .pixels_o(events_o.fill_pixels),
    .covered_pixels_o(fill_covered_pixels)
  );

  // ---- COVER ----
  logic             sample_valid, sample_ready;
  logic [INDEX-1:0] sample_index;
  logic [D-1:0]     sample_depth, sample_front, sample_margin;
  slb_cover_stage #(.DEPTH_BITS(D), .PLANE_LOG2(P)) u_samples (
    .clk_i, .rst_ni, .item_valid_i(cover_valid_i), .item_ready_o(cover_ready_o), .item_i, .margin_i(level_q),
    .touched_i(touched), .first_row_i(first_row), .last_row_i(last_row), .valid_o(sample_valid),
    .ready_i(sample_ready), .index_o(sample_index), .depth_o(sample_depth), .front_o(sample_front),
    .margin_o(sample_margin)
  );

  // ---- Updates: chains, FILL and COVER never at the same time; each kind has its fields in the operand ----
  localparam int unsigned PUT     = D + 2 + 3 * LINE + 2;
  localparam int unsigned FILL    = WINDING + 2 * SLOTS;
  localparam int unsigned SAMPLE  = 3 * D;
  localparam int unsigned FIELDS  = gnomon_pkg::max_of(gnomon_pkg::max_of(PUT, FILL), SAMPLE);
  localparam int unsigned OPERAND = 2 + FIELDS;
  logic               update_valid, update_ready, update_gated, update_granted, update_line;
  logic [INDEX-1:0]   update_index;
  logic [OPERAND-1:0] update_operand;
  logic [1:0]         update_kind;
  logic [FIELDS-1:0]  update_fields;
  assign update_valid = put_valid || fill_valid || sample_valid;
  assign update_line  = fill_valid;
  assign put_ready    = update_ready;
  assign fill_ready   = update_ready;
  assign sample_ready = update_ready;
  always_comb begin
    if (fill_valid) begin
      update_index  = fill_index;
      update_kind   = fill_line ? slb_pkg::UPDATE_LINE : slb_pkg::UPDATE_FINISH;
      update_fields = FIELDS'({fill_slots, fill_covered, fill_winding});
    end else if (sample_valid) begin
      update_index  = sample_index;
      update_kind   = slb_pkg::UPDATE_COVER;
      update_fields = FIELDS'({sample_front, sample_margin, sample_depth});
    end else begin
      update_index  = put_index;
      update_kind   = slb_pkg::UPDATE_INSERT;
      update_fields = 'x;
      if (put_valid) update_fields = FIELDS'({put_corner, put_contains, put_join, put_b, put_a, put_op, put_depth});
    end
  end
  assign update_operand = {update_kind, update_fields};

  // ---- Queries and READ_ENTRIES: the read port belongs to the reader while it lasts ----
  logic             query_ask, query_asked, query_entry, query_taken, query_idle, query_valid;
  logic             reader_ask, reader_asked, reader_entry, reader_taken, reader_busy, reader_valid;
  logic [INDEX-1:0] query_index, reader_index;
  logic [TAG-1:0]   query_tag, reader_tag, entry_tag;
  logic [ENTRY-1:0] entry;
  logic [63:0]      query_result, reader_result;
  slb_query #(
    .FRAC_BITS(FRAC_BITS), .SLOPE_BITS(SLOPE_BITS), .FRAGS_PER_PIXEL(K), .DEPTH_BITS(D), .PLANE_LOG2(P),
    .QUERY_BITS(QUERY_BITS), .ROUNDING(ROUNDING)
  ) u_query (
    .clk_i, .rst_ni, .item_valid_i(query_valid_i), .item_ready_o(query_ready_o), .item_i, .bias_i(level_q),
    .number_i(number_q), .idle_o(query_idle), .read_valid_o(query_ask), .read_ready_i(query_asked),
    .read_index_o(query_index), .read_tag_o(query_tag), .entry_valid_i(query_entry), .entry_ready_o(query_taken),
    .entry_i(entry), .entry_tag_i(entry_tag), .result_valid_o(query_valid), .result_ready_i, .result_o(query_result)
  );
  slb_entry_reader #(
    .INDEX_BITS(INDEX), .ENTRY_BITS(ENTRY), .WORDS(slb_pkg::dump_words(FRAC_BITS, SLOPE_BITS, K, D)), .TAG_BITS(TAG)
  ) u_reader (
    .clk_i, .rst_ni, .start_i(read_start), .first_i(header_i.arg[INDEX-1:0]), .count_minus1_i(header_i.arg[31:24]),
    .busy_o(reader_busy), .read_valid_o(reader_ask), .read_ready_i(reader_asked), .read_index_o(reader_index),
    .read_tag_o(reader_tag), .entry_valid_i(reader_entry), .entry_ready_o(reader_taken), .entry_i(entry),
    .entry_tag_i(entry_tag), .result_valid_o(reader_valid), .result_ready_i, .result_o(reader_result)
  );

  logic             ask, asked, ask_gated, ask_granted, given, taken, given_gated, taken_gated;
  logic [INDEX-1:0] ask_index;
  logic [TAG-1:0]   ask_tag;
  assign ask          = reader_busy ? reader_ask : query_ask;
  assign ask_index    = reader_busy ? reader_index : query_index;
  assign ask_tag      = reader_busy ? reader_tag : query_tag;
  assign reader_asked = reader_busy && asked;
  assign query_asked  = !reader_busy && asked;
  assign reader_entry = reader_busy && given_gated;
  assign query_entry  = !reader_busy && given_gated;
  assign taken_gated  = reader_busy ? reader_taken : query_taken;

  stall_gate #(.SEED(STALLS ? SEED ^ 16'h2E85 : 16'd0)) u_stall_update (
    .clk_i, .rst_ni, .valid_i(update_valid), .ready_o(update_ready), .valid_o(update_gated), .ready_i(update_granted)
  );
  stall_gate #(.SEED(STALLS ? SEED ^ 16'h946B : 16'd0)) u_stall_ask (
    .clk_i, .rst_ni, .valid_i(ask), .ready_o(asked), .valid_o(ask_gated), .ready_i(ask_granted)
  );
  stall_gate #(.SEED(STALLS ? SEED ^ 16'hD3F2 : 16'd0)) u_stall_entry (
    .clk_i, .rst_ni, .valid_i(given), .ready_o(taken), .valid_o(given_gated), .ready_i(taken_gated)
  );

  // ---- The plane and its modify function ----
  logic               modify_valid, modify_write, line_write, plane_idle, filled_covered;
  logic [WORD-1:0]    modify_word, new_word;
  logic [OPERAND-1:0] modify_operand;
  logic [D-1:0]       line_depth;
  if (CACHE_LOG2 == 0) begin : gen_on_chip
    slb_plane #(
      .FRAC_BITS(FRAC_BITS), .SLOPE_BITS(SLOPE_BITS), .FRAGS_PER_PIXEL(K), .DEPTH_BITS(D), .INDEX_BITS(INDEX),
      .SLOT_BITS(SLOT), .SPAN_BITS(SPAN), .OPERAND_BITS(OPERAND), .TAG_BITS(TAG), .READ_LATENCY(MEM_LATENCY)
    ) u_plane (
      .clk_i, .rst_ni, .update_valid_i(update_gated), .update_ready_o(update_granted), .update_line_i(update_line),
      .update_index_i(update_index), .update_operand_i(update_operand), .modify_valid_o(modify_valid),
      .modify_word_o(modify_word), .modify_operand_o(modify_operand), .modify_write_i(modify_write),
      .modify_word_i(new_word), .line_write_i(line_write),
      .line_slots_i(modify_operand[WINDING+SLOTS+:SLOTS]), .line_covered_i(modify_operand[WINDING+:SLOTS]),
      .line_depth_i(line_depth), .plain_write_i(plain_write), .plain_span_i(plain_span), .plain_i(plain),
      .plain_covered_i(plain_covered), .read_valid_i(ask_gated), .read_ready_o(ask_granted), .read_index_i(ask_index),
      .read_tag_i(ask_tag), .entry_valid_o(given), .entry_ready_i(taken), .entry_o(entry), .entry_tag_o(entry_tag),
      .clear_i(clear_start), .scrubbing_o(scrubbing), .scrub_line_o(scrub_line), .idle_o(plane_idle)
    );
    logic unused_give;
    assign unused_give    = (^cache_give_i) ^ (FIRST_LINE + LINE_IDS_LOG2 == 0);
    assign cache_want_o   = '0;
    assign cache_events_o = '0;
  end else begin : gen_cached
    slb_plane_cache #(
      .FRAC_BITS(FRAC_BITS), .SLOPE_BITS(SLOPE_BITS), .FRAGS_PER_PIXEL(K), .DEPTH_BITS(D), .INDEX_BITS(INDEX),
      .SLOT_BITS(SLOT), .SPAN_BITS(SPAN), .OPERAND_BITS(OPERAND), .TAG_BITS(TAG), .SIZE_LOG2(CACHE_LOG2),
      .FIRST_LINE(FIRST_LINE), .LINE_IDS_LOG2(LINE_IDS_LOG2)
    ) u_plane (
      .clk_i, .rst_ni, .update_valid_i(update_gated), .update_ready_o(update_granted), .update_index_i(update_index), .update_operand_i(update_operand), .modify_valid_o(modify_valid),
      .modify_word_o(modify_word), .modify_operand_o(modify_operand), .modify_write_i(modify_write),
      .modify_word_i(new_word), .line_write_i(line_write),
      .line_slots_i(modify_operand[WINDING+SLOTS+:SLOTS]), .line_covered_i(modify_operand[WINDING+:SLOTS]),
      .line_depth_i(line_depth), .plain_write_i(plain_write), .plain_span_i(plain_span), .plain_i(plain),
      .plain_covered_i(plain_covered), .read_valid_i(ask_gated), .read_ready_o(ask_granted), .read_index_i(ask_index),
      .read_tag_i(ask_tag), .entry_valid_o(given), .entry_ready_i(taken), .entry_o(entry), .entry_tag_o(entry_tag),
      .clear_i(clear_start), .scrubbing_o(scrubbing), .scrub_line_o(scrub_line), .idle_o(plane_idle),
      .want_o(cache_want_o), .give_i(cache_give_i), .events_o(cache_events_o)
    );
    logic unused_line;
    assign unused_line = update_line;
  end
  slb_modify #(
    .FRAC_BITS(FRAC_BITS), .SLOPE_BITS(SLOPE_BITS), .FRAGS_PER_PIXEL(K), .DEPTH_BITS(D), .PLANE_LOG2(P),
    .ROUNDING(ROUNDING)
  ) u_modify (
    .object_i, .flat_i, .flat_depth_i, .valid_i(modify_valid), .kind_i(modify_operand[OPERAND-1-:2]),
    .word_i(modify_word), .depth_i(modify_operand[0+:D]), .op_i(modify_operand[D+:2]),
    .a_i(modify_operand[D+2+:LINE]), .b_i(modify_operand[D+2+LINE+:LINE]),
    .join_i(modify_operand[D+2+2*LINE+:LINE]), .contains_i(modify_operand[D+2+3*LINE]),
    .corner_i(modify_operand[D+3+3*LINE]), .winding_i(modify_operand[0+:WINDING]),
    .front_i(modify_operand[2*D+:D]), .margin_i(modify_operand[D+:D]),
    .write_o(modify_write), .word_o(new_word), .line_write_o(line_write), .line_depth_o(line_depth),
    .dropped_o(events_o.chain_dropped), .reduced_o(events_o.chain_reduced), .evicted_o(events_o.group_evicted),
    .filled_group_o(events_o.fill_group), .filled_covered_o(filled_covered), .cover_used_o(events_o.cover_used)
  );

  // ---- Results ----
  assign result_valid_o = reader_valid || query_valid;
  assign result_o       = reader_valid ? reader_result : query_result;

  // ---- Account ----
  assign idle_o = !put_valid && !sample_valid && fill_asked && fill_idle && winding_idle && plane_idle && query_idle && !reader_busy;
  assign step_o = scrubbing || fill_step || (reader_busy && ((ask && asked) || (reader_valid && result_ready_i)));
  assign wait_o = (update_valid && !update_ready) || (ask && !asked) || (wind_valid_i && !wind_ready_o);

  gnomon_pkg::slb_answer_t answer;
  logic                    answered;
  assign answer                   = query_result;
  assign answered                 = query_valid && result_ready_i;
  assign events_o.object          = begin_object;
  assign events_o.fill_covered    = fill_covered_pixels + 7'(filled_covered);
  assign events_o.cover_sample    = cover_valid_i && cover_ready_o;
  assign events_o.query           = answered;
  assign events_o.query_shadow    = answered && answer.shadow;
  assign events_o.query_off_plane = answered && answer.off_plane;
  assign events_o.query_overflow  = answered && answer.overflow;
  // The front end's.
  assign events_o.loop            = 1'b0;
  assign events_o.loop_short      = 1'b0;
  assign events_o.loop_tiny       = 1'b0;
  assign events_o.tiny_area2      = '0;
  assign events_o.vertex          = 1'b0;
  assign events_o.vertex_repeated = 1'b0;
  assign events_o.crossing        = 1'b0;

  logic unused_bits;
  assign unused_bits = ^{header_i.flags, header_i.count, answer};

  `GNOMON_ASSERT(a_one_update_source, 2'(put_valid) + 2'(fill_valid) + 2'(sample_valid) <= 2'd1)
  `GNOMON_ASSERT(a_one_result_source, !(reader_valid && query_valid))
  `GNOMON_ASSERT(a_start_while_idle, !(start_i && !idle_o) || header_i.op == gnomon_pkg::OP_LOOP ||
                 header_i.op == gnomon_pkg::OP_COVER || header_i.op == gnomon_pkg::OP_QUERY)

endmodule
