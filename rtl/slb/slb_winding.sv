// SPDX-License-Identifier: Apache-2.0
// Scratch memory of the object being drawn (docs/slb.md, "Winding and FILL"): changes of the winding number and has_lines of
// every pixel, a carry of every row, the rows touched and, span by span, the lines touched. FILL clears by reading.

`include "assertions.svh"

module slb_winding #(
  parameter int unsigned PLANE_LOG2   = 8,
  parameter int unsigned SLOT_BITS    = 4,   // 2^SLOT_BITS pixels a line
  parameter int unsigned SPAN_BITS    = 2,   // 2^SPAN_BITS lines a span
  parameter int unsigned READ_LATENCY = 1,
  // Derived; not to be overridden.
  parameter int unsigned CELL_BITS  = PLANE_LOG2 + 2,
  parameter int unsigned SLOTS      = 1 << SLOT_BITS,
  parameter int unsigned LINE_BITS  = 2 * PLANE_LOG2 - SLOT_BITS,
  parameter int unsigned SPAN       = 1 << SPAN_BITS,
  parameter int unsigned SPANS      = LINE_BITS - SPAN_BITS,
  parameter int unsigned ITEM       = slb_pkg::fill_item_bits(LINE_BITS, SPAN_BITS),
  parameter int unsigned CHANGE     = slb_pkg::CHANGE_BITS,
  parameter int unsigned WORD       = SLOTS * (CHANGE + 1) + CHANGE  // {carry, has_lines, dw}
) (
  input  logic                        clk_i,
  input  logic                        rst_ni,
  input  logic                        begin_i,        // a new object: no row is touched
  // Crossings of y = row.
  input  logic                        wind_valid_i,
  output logic                        wind_ready_o,
  input  logic signed [CELL_BITS-1:0] wind_column_i,
  input  logic signed [CELL_BITS-1:0] wind_row_i,
  input  logic                        wind_up_i,
  output logic                        saturated_o,    // event: a change did not fit
  // A chain goes to this pixel.
  input  logic                        mark_i,
  input  logic [2*PLANE_LOG2-1:0]     mark_index_i,
  // FILL: which lines of a span chains have gone to.
  input  logic                        span_valid_i,
  output logic                        span_ready_o,
  input  logic [SPANS-1:0]            span_i,
  output logic                        span_word_valid_o,
  input  logic                        span_word_ready_i,
  output logic [SPAN-1:0]             span_word_o,
  output logic [SPANS-1:0]            span_word_span_o,
  // FILL: lines.
  input  logic                        read_valid_i,
  output logic                        read_ready_o,
  input  logic [ITEM-1:0]             read_item_i,
  output logic                        word_valid_o,
  input  logic                        word_ready_i,
  output logic [WORD-1:0]             word_o,
  output logic [ITEM-1:0]             word_item_o,
  output logic                        touched_o,      // some row is
  output logic [PLANE_LOG2-1:0]       first_row_o,
  output logic [PLANE_LOG2-1:0]       last_row_o,
  // After reset everything is scrubbed, line by line.
  input  logic                        scrub_i,
  input  logic [LINE_BITS-1:0]        scrub_line_i,
  output logic                        idle_o
);

  localparam int unsigned P = PLANE_LOG2;

  // ---- Where a crossing goes: to a pixel, to its row's carry, or nowhere ----
  logic          row_on, left, column_on, take, to_pixel, to_carry;
  logic [2*P-1:0] wind_index;
  assign row_on       = wind_row_i[CELL_BITS-1:P] == '0;
  assign column_on    = wind_column_i[CELL_BITS-1:P] == '0;
  assign left         = wind_column_i[CELL_BITS-1];
  assign wind_index   = {wind_row_i[P-1:0], wind_column_i[P-1:0]};
  assign wind_ready_o = !scrub_i;
  assign take         = wind_valid_i && wind_ready_o && row_on;
  assign to_pixel     = take && column_on;
  assign to_carry     = take && left;

  // ---- Rows touched ----
  logic         touched_q;
  logic [P-1:0] first_q, last_q, mark_row;
  assign mark_row = mark_index_i[P+:P];
  logic         touch_wind;
  assign touch_wind = to_pixel || to_carry;
  // Of the two rows that may be touched in a cycle, the lower and the upper.
  logic [P-1:0] low, high;
  always_comb begin
    if (touch_wind && mark_i) begin
      low  = (wind_row_i[P-1:0] < mark_row) ? wind_row_i[P-1:0] : mark_row;
      high = (wind_row_i[P-1:0] < mark_row) ? mark_row : wind_row_i[P-1:0];
    end else begin
      low  = touch_wind ? wind_row_i[P-1:0] : mark_row;
      high = low;
    end
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni || begin_i) begin
      touched_q <= 1'b0;
      first_q   <= '0;
      last_q    <= '0;
    end else if (touch_wind || mark_i) begin
      touched_q <= 1'b1;
      if (!touched_q || low < first_q) first_q <= low;
      if (!touched_q || high > last_q) last_q <= high;
    end
  end
  assign touched_o   = touched_q;
  assign first_row_o = first_q;
  assign last_row_o  = last_q;

  // ---- Changes: one read-modify-write a cycle, of a pixel or of a row ----
  logic                 read, row_begins;
  logic [LINE_BITS-1:0] read_line;

  logic              pixel_valid, pixel_down, pixel_full, pixel_write, pixel_idle, carry_valid, carry_down, carry_full;
  logic              carry_write, carry_idle;
  logic [CHANGE-1:0] pixel_ram, pixel_sum, pixel_new, pixel_word, carry_ram, carry_sum, carry_new, carry_word;
  logic [2*P-1:0]    pixel_at, pixel_index;
  logic [P-1:0]      carry_at, carry_index;
  slb_change u_pixel_change (
    .sum_i(pixel_sum), .down_i(pixel_down), .sum_o(pixel_new), .saturated_o(pixel_full)
  );
  plane_update #(
    .INDEX_BITS(2 * P), .OPERAND_BITS(1), .WORD_BITS(CHANGE), .READ_LATENCY(READ_LATENCY)
  ) u_pixel (
    .clk_i, .rst_ni, .valid_i(to_pixel), .index_i(wind_index), .operand_i(!wind_up_i), .ram_word_i(pixel_ram),
    .modify_valid_o(pixel_valid), .modify_index_o(pixel_at), .modify_word_o(pixel_sum), .modify_operand_o(pixel_down),
    .modify_write_i(!pixel_full), .modify_word_i(pixel_new), .write_o(pixel_write), .write_index_o(pixel_index),
    .write_word_o(pixel_word), .idle_o(pixel_idle)
  );
  slb_change u_carry_change (
    .sum_i(carry_sum), .down_i(carry_down), .sum_o(carry_new), .saturated_o(carry_full)
  );
  plane_update #(
    .INDEX_BITS(P), .OPERAND_BITS(1), .WORD_BITS(CHANGE), .READ_LATENCY(READ_LATENCY)
  ) u_carry (
    .clk_i, .rst_ni, .valid_i(to_carry), .index_i(wind_row_i[P-1:0]), .operand_i(!wind_up_i), .ram_word_i(carry_ram),
    .modify_valid_o(carry_valid), .modify_index_o(carry_at), .modify_word_o(carry_sum), .modify_operand_o(carry_down),
    .modify_write_i(!carry_full), .modify_word_i(carry_new), .write_o(carry_write), .write_index_o(carry_index),
    .write_word_o(carry_word), .idle_o(carry_idle)
  );
  assign saturated_o = (pixel_valid && pixel_full) || (carry_valid && carry_full);

  // ---- Banks: FILL reads a line and writes zeros over it in the same cycle; the read gives the old words ----
  logic                    clear;
  logic [LINE_BITS-1:0]    clear_line, b_line, a_line;
  logic [SLOT_BITS-1:0]    slot;
  (* mem2reg *) logic [CHANGE-1:0] changes [SLOTS];
  logic [SLOTS-1:0]        read_lines, lines;
  assign clear      = scrub_i || read;
  assign clear_line = scrub_i ? scrub_line_i : read_line;
  assign b_line     = clear ? clear_line : pixel_index[2*P-1:SLOT_BITS];
  assign a_line     = to_pixel ? wind_index[2*P-1:SLOT_BITS] : read_line;
  logic [SLOTS-1:0] change_reads, change_writes, line_writes;
  always_comb begin
    change_reads  = '0;
    change_writes = '0;
    line_writes   = '0;
    if (to_pixel)    change_reads[wind_index[SLOT_BITS-1:0]] = 1'b1;
    if (read)        change_reads = '1;
    if (pixel_write) change_writes[pixel_index[SLOT_BITS-1:0]] = 1'b1;
    if (clear)       change_writes = '1;
    if (mark_i)      line_writes[mark_index_i[SLOT_BITS-1:0]] = 1'b1;
    if (mutations_pkg::SLB_KEEP_LINES ? scrub_i : clear) line_writes = '1;
  end
  for (genvar i = 0; i < SLOTS; i++) begin : gen_banks
    logic [CHANGE-1:0] read_change, change, unused_change;
    logic              unused_line;
    plane_bank #(.ADDRESS_BITS(LINE_BITS), .WIDTH(CHANGE)) u_changes (
      .clk_i, .a_read_i(change_reads[i]), .a_address_i(a_line),
      .a_word_o(read_change), .b_read_i(1'b0),
      .b_write_i(change_writes[i]), .b_address_i(b_line),
      .b_word_i(clear ? '0 : pixel_word), .b_word_o(unused_change)
    );
    plane_bank #(.ADDRESS_BITS(LINE_BITS), .WIDTH(1)) u_lines (
      .clk_i, .a_read_i(read), .a_address_i(read_line), .a_word_o(read_lines[i]), .b_read_i(1'b0),
      .b_write_i(line_writes[i]),
      .b_address_i(clear ? clear_line : mark_index_i[2*P-1:SLOT_BITS]), .b_word_i(!clear), .b_word_o(unused_line)
    );
    delay_line #(.WIDTH(CHANGE), .CYCLES(READ_LATENCY - 1)) u_delay (
      .clk_i, .data_i(read_change), .data_o(change)
    );
    assign changes[i] = change;
  end
  // The carry counts with the first line of its row that is read.
  logic [CHANGE-1:0] read_carry, unused_carry;
  logic [P-1:0]      clear_row;
  if (LINE_BITS > P) begin : gen_lines_a_row
    assign clear_row = scrub_i ? scrub_line_i[P-1:0] : read_line[LINE_BITS-1-:P];
  end else begin : gen_line_a_row
    assign clear_row = clear_line;
  end
  plane_bank #(.ADDRESS_BITS(P), .WIDTH(CHANGE)) u_carries (
    .clk_i, .a_read_i(read || to_carry), .a_address_i(read ? read_line[LINE_BITS-1-:P] : wind_row_i[P-1:0]),
    .a_word_o(read_carry), .b_read_i(1'b0), .b_write_i(scrub_i || (read && row_begins) || carry_write),
    .b_address_i(carry_write ? carry_index : clear_row), .b_word_i(carry_write ? carry_word : '0),
    .b_word_o(unused_carry)
  );

  // ---- What was read READ_LATENCY cycles ago ----
  delay_line #(.WIDTH(SLOT_BITS), .CYCLES(READ_LATENCY)) u_slot (
    .clk_i, .data_i(wind_index[SLOT_BITS-1:0]), .data_o(slot)
  );
  delay_line #(.WIDTH(CHANGE + SLOTS), .CYCLES(READ_LATENCY - 1)) u_delay (
    .clk_i, .data_i({read_carry, read_lines}), .data_o({carry_ram, lines})
  );
  assign pixel_ram = changes[slot];
  logic            word_read;
  logic [WORD-1:0] word;
  delay_line #(.WIDTH(1), .CYCLES(READ_LATENCY)) u_word_read (.clk_i, .data_i(read), .data_o(word_read));
  always_comb begin
    word = 'x;
    if (word_read) begin
      for (int i = 0; i < SLOTS; i++) word[i*CHANGE+:CHANGE] = changes[i];
      word[WORD-1:SLOTS*CHANGE] = {carry_ram, lines};
    end
  end

  logic read_idle;
  assign row_begins = read_item_i[ITEM-1];
  plane_read_port #(
    .INDEX_BITS(LINE_BITS), .TAG_BITS(ITEM), .ENTRY_BITS(WORD), .READ_LATENCY(READ_LATENCY)
  ) u_read (
    .clk_i, .rst_ni, .request_valid_i(read_valid_i), .request_ready_o(read_ready_o),
    .request_index_i(read_item_i[LINE_BITS-1:0]), .request_tag_i(read_item_i), .ram_free_i(!scrub_i),
    .ram_read_o(read), .ram_index_o(read_line), .ram_entry_i(word),
    .response_valid_o(word_valid_o), .response_ready_i(word_ready_i), .response_entry_o(word_o),
    .response_tag_o(word_item_o), .idle_o(read_idle)
  );

  // ---- Lines touched: a bit for each, those of a span side by side ----
  logic                 span_read, span_idle;
  logic [SPANS-1:0]     span_index, span_write_index;
  logic [LINE_BITS-1:0] span_line;  // scrubbed or touched
  logic [SPAN-1:0]      read_touched, touched;
  assign span_line        = scrub_i ? scrub_line_i : mark_index_i[2*P-1:SLOT_BITS];
  assign span_write_index = span_read ? span_index : span_line[LINE_BITS-1:SPAN_BITS];
  for (genvar i = 0; i < SPAN; i++) begin : gen_touched
    logic unused_touched;
    plane_bank #(.ADDRESS_BITS(SPANS), .WIDTH(1)) u_bank (
      .clk_i, .a_read_i(span_read), .a_address_i(span_index), .a_word_o(read_touched[i]), .b_read_i(1'b0),
      .b_write_i(span_read || ((scrub_i || mark_i) && (span_line & LINE_BITS'(SPAN - 1)) == LINE_BITS'(i))),
      .b_address_i(span_write_index), .b_word_i(!span_read && !scrub_i), .b_word_o(unused_touched)
    );
  end
  delay_line #(.WIDTH(SPAN), .CYCLES(READ_LATENCY - 1)) u_touched_delay (
    .clk_i, .data_i(read_touched), .data_o(touched)
  );
  plane_read_port #(
    .INDEX_BITS(SPANS), .TAG_BITS(SPANS), .ENTRY_BITS(SPAN), .READ_LATENCY(READ_LATENCY)
  ) u_spans (
    .clk_i, .rst_ni, .request_valid_i(span_valid_i), .request_ready_o(span_ready_o), .request_index_i(span_i),
    .request_tag_i(span_i), .ram_free_i(!scrub_i), .ram_read_o(span_read), .ram_index_o(span_index),
    .ram_entry_i(touched), .response_valid_o(span_word_valid_o), .response_ready_i(span_word_ready_i),
    .response_entry_o(span_word_o), .response_tag_o(span_word_span_o), .idle_o(span_idle)
  );

  assign idle_o = pixel_idle && carry_idle && read_idle && span_idle;

  logic unused_at;
  assign unused_at = ^{pixel_at, carry_at};

  `GNOMON_ASSERT(a_fill_after_walk,
                 !((read || span_read) && (to_pixel || to_carry || mark_i || pixel_write || carry_write)))

endmodule
