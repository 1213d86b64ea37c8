// SPDX-License-Identifier: Apache-2.0
// FILL's requests (docs/slb.md, "Implementation: back end"): a span of lines after the other, from the first to the last
// touched row; of a span its lines with lines, or, where all are plain, its first one.

`include "assertions.svh"

module slb_fill_ask #(
  parameter int unsigned PLANE_LOG2 = 8,
  parameter int unsigned LINE_BITS  = 12,  // of the index of a line
  parameter int unsigned SPAN_BITS  = 2,   // 2^SPAN_BITS lines a span, all of one row
  // Derived; not to be overridden.
  parameter int unsigned SPAN  = 1 << SPAN_BITS,
  parameter int unsigned SPANS = LINE_BITS - SPAN_BITS,
  parameter int unsigned ITEM  = slb_pkg::fill_item_bits(LINE_BITS, SPAN_BITS)
) (
  input  logic                  clk_i,
  input  logic                  rst_ni,
  input  logic                  start_i,
  input  logic                  touched_i,
  input  logic [PLANE_LOG2-1:0] first_row_i,
  input  logic [PLANE_LOG2-1:0] last_row_i,
  output logic                  idle_o,
  // Spans: which of their lines a chain has gone to.
  output logic                  span_valid_o,
  input  logic                  span_ready_i,
  output logic [SPANS-1:0]      span_o,
  input  logic                  word_valid_i,
  output logic                  word_ready_o,
  input  logic [SPAN-1:0]       word_i,
  input  logic [SPANS-1:0]      word_span_i,
  // Lines of the scratch memory.
  output logic                  read_valid_o,
  input  logic                  read_ready_i,
  output logic [ITEM-1:0]       read_item_o  // {first of its row, first of its span, lines of its span with lines, line}
);

  localparam int unsigned P = PLANE_LOG2;

  // ---- Spans: those of consecutive rows are consecutive ----
  logic             asking_q, busy_q;
  logic [SPANS-1:0] ask_q, last_q;
  logic             given;  // the last request of a span
  assign span_valid_o = asking_q;
  assign span_o       = ask_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni)                                              asking_q <= 1'b0;
    else if (start_i)                                         asking_q <= touched_i;
    else if (span_valid_o && span_ready_i && ask_q == last_q) asking_q <= 1'b0;
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni)                               busy_q <= 1'b0;
    else if (start_i)                          busy_q <= touched_i;
    else if (given && word_span_i == last_q)   busy_q <= 1'b0;
  end
  if (SPANS > P) begin : gen_spans_a_row
    always_ff @(posedge clk_i) begin
      if (start_i) last_q <= {last_row_i, {(SPANS - P){1'b1}}};
      if (start_i) ask_q <= {first_row_i, (SPANS - P)'(0)};
      else if (span_valid_o && span_ready_i) ask_q <= ask_q + 1'b1;
    end
  end else begin : gen_span_a_row
    always_ff @(posedge clk_i) begin
      if (start_i) last_q <= last_row_i;
      if (start_i) ask_q <= first_row_i;
      else if (span_valid_o && span_ready_i) ask_q <= ask_q + 1'b1;
    end
  end

  // ---- Lines of a span, the lowest first ----
  logic                 begun_q, last, row_begins;
  logic [SPAN-1:0]      left_q, left, after;
  logic [LINE_BITS-1:0] line;
  assign left  = begun_q ? left_q : word_i;
  assign after = left & (left - 1'b1);
  assign last  = after == '0;
  always_comb begin
    line = LINE_BITS'(word_span_i) << SPAN_BITS;
    for (int i = SPAN - 1; i >= 0; i--) begin
      if (left[i]) line = (LINE_BITS'(word_span_i) << SPAN_BITS) + LINE_BITS'(i);
    end
  end
  if (SPANS > P) begin : gen_row_begins
    assign row_begins = word_span_i[SPANS-P-1:0] == '0;
  end else begin : gen_row_always_begins
    assign row_begins = 1'b1;
  end
  assign read_valid_o = word_valid_i;
  assign read_item_o  = {row_begins && !begun_q, !begun_q, word_i, line};
  assign given        = read_valid_o && read_ready_i && last;
  assign word_ready_o = read_ready_i && last;
  always_ff @(posedge clk_i) begin
    if (!rst_ni)                           begun_q <= 1'b0;
    else if (read_valid_o && read_ready_i) begun_q <= !last;
  end
  always_ff @(posedge clk_i) begin
    if (read_valid_o && read_ready_i) left_q <= after;
  end

  assign idle_o = !busy_q;

  `GNOMON_ASSERT_STREAM(a_span_stable, span_valid_o, span_ready_i, span_o)
  `GNOMON_ASSERT_STREAM(a_read_stable, read_valid_o, read_ready_i, read_item_o)
  `GNOMON_ASSERT(a_start_while_idle, !start_i || idle_o)

endmodule
