// SPDX-License-Identifier: Apache-2.0
// FILL: sums the winding numbers of the touched rows up, says of plain lines whether they are covered, and updates the plane:
// every pixel with lines, with the first of a line the pixels beside it (docs/slb.md, "Implementation: back end").

`include "assertions.svh"

module slb_fill #(
  parameter int unsigned PLANE_LOG2 = 8,
  parameter int unsigned SLOT_BITS  = 4,  // 2^SLOT_BITS pixels a line
  parameter int unsigned SPAN_BITS  = 2,  // 2^SPAN_BITS lines a span
  // Derived; not to be overridden.
  parameter int unsigned SLOTS     = 1 << SLOT_BITS,
  parameter int unsigned SPAN      = 1 << SPAN_BITS,
  parameter int unsigned LINE_BITS = 2 * PLANE_LOG2 - SLOT_BITS,
  parameter int unsigned ITEM      = slb_pkg::fill_item_bits(LINE_BITS, SPAN_BITS),
  parameter int unsigned CHANGE    = slb_pkg::CHANGE_BITS,
  parameter int unsigned WORD      = SLOTS * (CHANGE + 1) + CHANGE,
  parameter int unsigned WINDING   = PLANE_LOG2 + 9
) (
  input  logic                           clk_i,
  input  logic                           rst_ni,
  input  logic                           flat_i,          // the object is flat: full depths of covered pixels change
  output logic                           idle_o,
  // Lines of the scratch memory, with what slb_fill_ask says of them.
  input  logic                           word_valid_i,
  output logic                           word_ready_o,
  input  logic [WORD-1:0]                word_i,
  input  logic [ITEM-1:0]                word_item_i,
  // Updates of the plane.
  output logic                           update_valid_o,
  input  logic                           update_ready_i,
  output logic                           update_line_o,   // of a plain line alone
  output logic [2*PLANE_LOG2-1:0]        update_index_o,
  output logic [SLOTS-1:0]               slots_o,         // the pixels without lines that this update is for
  output logic [SLOTS-1:0]               covered_o,       // and which of them are covered
  output logic signed [WINDING-1:0]      winding_o,       // of the pixel with lines
  // Lines of a span: which of them to write, which are plain, which of those are covered.
  output logic [SPAN-1:0]                plain_write_o,
  output logic [LINE_BITS-SPAN_BITS-1:0] plain_span_o,
  output logic [SPAN-1:0]                plain_o,
  output logic [SPAN-1:0]                plain_covered_o,
  // Events.
  output logic                           step_o,
  output logic [6:0]                     pixels_o,        // at most four lines
  output logic [6:0]                     covered_pixels_o // of those without lines
);

  // ---- Stage 1: sums inside the line. 16 changes of -127..127 fit 12 bits ----
  localparam int unsigned SUM = CHANGE + SLOT_BITS;
  logic                     valid1_q, ready1;
  logic [SLOTS*SUM-1:0]     sums, sums1_q;   // of the pixels before each
  logic signed [SUM-1:0]    total1_q, running;
  logic signed [CHANGE-1:0] carry1_q;
  logic [SLOTS-1:0]         lines1_q;
  logic [ITEM-1:0]          item1_q;
  logic [SLOTS*CHANGE-1:0]  changes;
  logic [SLOTS-1:0]         lines;
  logic [CHANGE-1:0]        carry;
  assign {carry, lines, changes} = word_i;
  always_comb begin
    running = '0;
    sums    = '0;
    if (word_valid_i) begin
      for (int i = 0; i < SLOTS; i++) begin
        sums[i*SUM+:SUM] = running;
        running          = running + SUM'(signed'(changes[i*CHANGE+:CHANGE]));
      end
    end
  end
  assign word_ready_o = !valid1_q || ready1;
  always_ff @(posedge clk_i) begin
    if (!rst_ni)           valid1_q <= 1'b0;
    else if (word_ready_o) valid1_q <= word_valid_i;
  end
  always_ff @(posedge clk_i) begin
    if (word_valid_i && word_ready_o) begin
      sums1_q  <= sums;
      total1_q <= running;
      carry1_q <= carry;
      lines1_q <= lines;
      item1_q  <= word_item_i;
    end
  end

  // ---- Stage 2: winding numbers, before and behind the line and of every pixel ----
  logic                      row_begins, span_begins;
  logic [SPAN-1:0]           touched;  // lines of the span with lines
  logic [LINE_BITS-1:0]      line;
  logic signed [WINDING-1:0] base_q, base, behind;
  assign {row_begins, span_begins, touched, line} = item1_q;
  assign behind                                   = base + WINDING'(total1_q);
  always_comb begin
    base = row_begins ? WINDING'(carry1_q) : base_q;
    if (row_begins && mutations_pkg::SLB_LOSE_CARRY) base = '0;
  end

  logic [SLOTS*WINDING-1:0]  windings;
  logic [SLOTS-1:0]          covered;
  logic signed [WINDING-1:0] winding;
  always_comb begin
    windings = '0;
    covered  = '0;
    winding  = '0;
    if (valid1_q) begin
      for (int i = 0; i < SLOTS; i++) begin
        winding                      = base + WINDING'(signed'(sums1_q[i*SUM+:SUM]));
        windings[i*WINDING+:WINDING] = winding;
        covered[i]                   = winding > 0;
      end
    end
  end

  // ---- The lines that this step decides: its own, the plain ones before the span's first, those up to the next ----
  logic [SPAN-1:0] own, plain, plain_covered;
  logic            passed;  // its own line, and no other with lines since
  assign own = (touched == '0) ? '0 : SPAN'(1) << (line & LINE_BITS'(SPAN - 1));
  always_comb begin
    passed        = 1'b0;
    plain         = '0;
    plain_covered = '0;
    if (valid1_q) begin
      for (int i = 0; i < SPAN; i++) begin
        if (touched[i]) begin
          passed = own[i];
        end else if (passed) begin
          plain[i]         = 1'b1;
          plain_covered[i] = (mutations_pkg::SLB_PLAIN_BEFORE ? base : behind) > 0;
        end else if (span_begins && (own == '0 || (SPAN'(1) << i) < own)) begin
          plain[i]         = 1'b1;
          plain_covered[i] = base > 0;
        end
      end
    end
  end

  // ---- Updates: the line's pixels with lines, then plain lines whose full depths change ----
  logic                 started_q, entry, update, give;
  logic [SLOTS-1:0]     left_q, left, left_after;
  logic [SPAN-1:0]      flat_q, flat, flat_after;
  logic [SLOT_BITS-1:0] slot;
  logic [LINE_BITS-1:0] flat_line;
  assign left  = started_q ? left_q : lines1_q;
  assign flat  = started_q ? flat_q : (flat_i ? plain_covered : '0);
  assign entry = left != '0;
  always_comb begin
    slot      = '0;
    flat_line = '0;
    if (valid1_q) begin
      for (int i = SLOTS - 1; i >= 0; i--) begin
        if (left[i]) slot = SLOT_BITS'(i);
      end
      for (int i = SPAN - 1; i >= 0; i--) begin
        if (flat[i]) flat_line = LINE_BITS'(i);
      end
    end
  end
  assign left_after = left & (left - 1'b1);
  assign flat_after = entry ? flat : flat & (flat - 1'b1);

  assign update         = entry || flat != '0;
  assign update_valid_o = valid1_q && update;
  assign update_line_o  = !entry;
  assign update_index_o = {entry ? line : (line & ~LINE_BITS'(SPAN - 1)) | flat_line, slot};
  assign slots_o        = !entry ? '1 : started_q ? '0 : ~lines1_q;
  assign covered_o      = !entry ? '1 : covered & ~lines1_q;
  assign winding_o      = windings[slot*WINDING+:WINDING];

  assign give   = valid1_q && (!update || update_ready_i);
  assign ready1 = give && left_after == '0 && flat_after == '0;
  always_ff @(posedge clk_i) begin
    if (!rst_ni)   started_q <= 1'b0;
    else if (give) started_q <= !ready1;
  end
  always_ff @(posedge clk_i) begin
    if (give) begin
      left_q <= left_after;
      flat_q <= flat_after;
    end
    if (ready1) base_q <= behind;
  end

  // ---- What is said once of the step's lines ----
  logic first;
  assign first           = give && !started_q;
  assign plain_write_o   = first ? own | plain : '0;
  assign plain_span_o    = line[LINE_BITS-1:SPAN_BITS];
  assign plain_o         = mutations_pkg::SLB_FORGET_PLAIN ? '0 : plain;
  assign plain_covered_o = plain_covered;
  always_comb begin
    pixels_o         = '0;
    covered_pixels_o = '0;
    if (first) begin
      for (int i = 0; i < SPAN; i++) begin
        if (plain_write_o[i]) pixels_o = pixels_o + 7'(SLOTS);
        if (plain_covered[i]) covered_pixels_o = covered_pixels_o + 7'(SLOTS);
      end
      for (int i = 0; i < SLOTS; i++) begin
        if (own != '0 && covered[i] && !lines1_q[i]) covered_pixels_o = covered_pixels_o + 7'd1;
      end
    end
  end

  assign step_o = give;
  assign idle_o = !valid1_q;

  `GNOMON_ASSERT_STREAM(a_update_stable, update_valid_o, update_ready_i,
                        {update_line_o, update_index_o, slots_o, covered_o, winding_o})
  `GNOMON_ASSERT(a_lines_are_told, !valid1_q || (own != '0) == (lines1_q != '0))
  `GNOMON_ASSERT(a_plain_is_plain, !valid1_q || own != '0 || sums1_q == '0)

endmodule
