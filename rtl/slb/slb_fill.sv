// SPDX-License-Identifier: Apache-2.0
// FILL: sweeps the touched rows line by line of 16 pixels, sums the winding numbers up, and updates the plane: one update
// for the pixels of a line without lines, one for every pixel with lines (docs/slb.md, "Winding and FILL").

`include "assertions.svh"

module slb_fill #(
  parameter int unsigned PLANE_LOG2 = 8,
  parameter int unsigned SLOT_BITS  = 4,
  // Derived; not to be overridden.
  parameter int unsigned SLOTS     = 1 << SLOT_BITS,
  parameter int unsigned LINE_BITS = 2 * PLANE_LOG2 - SLOT_BITS,
  parameter int unsigned CHANGE    = slb_pkg::CHANGE_BITS,
  parameter int unsigned WORD      = SLOTS * (CHANGE + 1) + CHANGE,
  parameter int unsigned WINDING   = PLANE_LOG2 + 9
) (
  input  logic                      clk_i,
  input  logic                      rst_ni,
  input  logic                      start_i,
  input  logic                      touched_i,
  input  logic [PLANE_LOG2-1:0]     first_row_i,
  input  logic [PLANE_LOG2-1:0]     last_row_i,
  output logic                      idle_o,
  // Lines of the scratch memory.
  output logic                      read_valid_o,
  input  logic                      read_ready_i,
  output logic [LINE_BITS-1:0]      read_line_o,
  input  logic                      word_valid_i,
  output logic                      word_ready_o,
  input  logic [WORD-1:0]           word_i,
  input  logic [LINE_BITS-1:0]      word_line_i,
  // Updates of the plane.
  output logic                      update_valid_o,
  input  logic                      update_ready_i,
  output logic                      update_line_o,     // of the pixels of a line that have no lines
  output logic [2*PLANE_LOG2-1:0]   update_index_o,
  output logic [SLOTS-1:0]          slots_o,           // which those are
  output logic [SLOTS-1:0]          covered_o,         // and which of them are covered
  output logic signed [WINDING-1:0] winding_o          // of a pixel with lines
);

  localparam int unsigned P = PLANE_LOG2;

  // ---- Requests: consecutive lines are consecutive rows ----
  logic                 asking_q;
  logic [LINE_BITS-1:0] ask_q, last_q;
  assign read_valid_o = asking_q;
  assign read_line_o  = ask_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni)                                                   asking_q <= 1'b0;
    else if (start_i)                                              asking_q <= touched_i;
    else if (read_valid_o && read_ready_i && ask_q == last_q)      asking_q <= 1'b0;
  end
  if (LINE_BITS > P) begin : gen_lines_a_row
    always_ff @(posedge clk_i) begin
      if (start_i) last_q <= {last_row_i, {(LINE_BITS - P){1'b1}}};
      if (start_i) ask_q <= {first_row_i, (LINE_BITS - P)'(0)};
      else if (read_valid_o && read_ready_i) ask_q <= ask_q + 1'b1;
    end
  end else begin : gen_line_a_row
    always_ff @(posedge clk_i) begin
      if (start_i) last_q <= last_row_i;
      if (start_i) ask_q <= first_row_i;
      else if (read_valid_o && read_ready_i) ask_q <= ask_q + 1'b1;
    end
  end

  // ---- Stage 1: sums inside the line. 16 changes of -127..127 fit 12 bits ----
  localparam int unsigned SUM = CHANGE + SLOT_BITS;
  logic                           valid1_q, ready1;
  logic [SLOTS*SUM-1:0]           sums, sums1_q;   // of the pixels before each
  logic signed [SUM-1:0]          total1_q, running;
  logic signed [CHANGE-1:0]       carry1_q;
  logic [SLOTS-1:0]               lines1_q;
  logic [LINE_BITS-1:0]           line1_q;
  logic [SLOTS*CHANGE-1:0]        changes;
  logic [SLOTS-1:0]               lines;
  logic [CHANGE-1:0]              carry;
  assign {carry, lines, changes} = word_i;
  always_comb begin
    running = '0;
    for (int i = 0; i < SLOTS; i++) begin
      sums[i*SUM+:SUM] = running;
      running          = running + SUM'(signed'(changes[i*CHANGE+:CHANGE]));
    end
  end
  assign word_ready_o = !valid1_q || ready1;
  always_ff @(posedge clk_i) begin
    if (!rst_ni)           valid1_q <= 1'b0;
    else if (word_ready_o) valid1_q <= word_valid_i;
  end
  always_ff @(posedge clk_i) begin
    if (word_ready_o) begin
      sums1_q  <= sums;
      total1_q <= running;
      carry1_q <= carry;
      lines1_q <= lines;
      line1_q  <= word_line_i;
    end
  end

  // ---- Stage 2: the winding number of every pixel, then an update after the other ----
  logic signed [WINDING-1:0] base_q, base;  // winding number at the line's first pixel
  logic                      row_begins;
  if (LINE_BITS > P) begin : gen_row_begins
    assign row_begins = line1_q[LINE_BITS-P-1:0] == '0;
  end else begin : gen_row_always_begins
    assign row_begins = 1'b1;
  end
  always_comb begin
    base = row_begins ? WINDING'(carry1_q) : base_q;
    if (row_begins && mutations_pkg::SLB_LOSE_CARRY) base = '0;
  end

  logic [SLOTS*WINDING-1:0] windings;
  logic [SLOTS-1:0]         covered;
  logic signed [WINDING-1:0] winding;
  always_comb begin
    for (int i = 0; i < SLOTS; i++) begin
      winding                      = base + WINDING'(signed'(sums1_q[i*SUM+:SUM]));
      windings[i*WINDING+:WINDING] = winding;
      covered[i]                   = winding > 0;
    end
  end

  // Pixels with lines that are still to come; the line itself goes first.
  logic                 started_q;
  logic [SLOTS-1:0]     left_q, left;
  logic [SLOT_BITS-1:0] slot;
  assign left = started_q ? left_q : lines1_q;
  always_comb begin
    slot = '0;
    for (int i = SLOTS - 1; i >= 0; i--) begin
      if (left_q[i]) slot = SLOT_BITS'(i);
    end
  end

  logic             give, last;
  logic [SLOTS-1:0] after;
  assign update_valid_o = valid1_q;
  assign update_line_o  = !started_q;
  assign update_index_o = {line1_q, started_q ? slot : SLOT_BITS'(0)};
  assign slots_o        = ~lines1_q;
  assign covered_o      = covered & ~lines1_q;
  assign winding_o      = windings[slot*WINDING+:WINDING];
  assign give           = update_valid_o && update_ready_i;
  assign after          = started_q ? left & ~(SLOTS'(1) << slot) : left;
  assign last           = after == '0;
  assign ready1         = give && last;

  always_ff @(posedge clk_i) begin
    if (!rst_ni)   started_q <= 1'b0;
    else if (give) started_q <= !last;
  end
  always_ff @(posedge clk_i) begin
    if (give)   left_q <= after;
    if (ready1) base_q <= base + WINDING'(total1_q);
  end

  assign idle_o = !asking_q && !valid1_q;

  `GNOMON_ASSERT_STREAM(a_update_stable, update_valid_o, update_ready_i,
                        {update_line_o, update_index_o, slots_o, covered_o, winding_o})
  `GNOMON_ASSERT(a_start_while_idle, !start_i || idle_o)

endmodule
