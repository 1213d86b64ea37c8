// SPDX-License-Identifier: Apache-2.0
// From an edge's positions on the borders M = 0 and M = 1 of a pixel to the bits of its line (docs/slb.md, "Line of the
// edge in the current pixel"). A line a cycle, five cycles latency, never held back.

module slb_line_encoder #(
  parameter int unsigned FRAC_BITS     = 7,
  parameter int unsigned SLOPE_BITS    = 7,
  parameter int unsigned SUBPIXEL_BITS = 10,
  parameter int unsigned ROUNDING      = 0,
  // Derived; not to be overridden.
  parameter int unsigned K = FRAC_BITS + SUBPIXEL_BITS,
  parameter int unsigned L = 4 + FRAC_BITS + SLOPE_BITS
) (
  input  logic         clk_i,
  input  logic         rst_ni,
  input  logic [4:0]   en_i,                  // stages that hold a line; bit 0 is the input
  input  logic [K+3:0] low_i, high_i,         // {cell relative to the pixel 3, k, inexact 1}
  input  logic         y_major_i, forward_i, negative_i, level_i,
  input  logic [K:0]   slope_i,
  output logic [L-1:0] line_o                 // {major, xsign, cross, inner, frac, slope}, five cycles later
);

  localparam int unsigned F  = FRAC_BITS;
  localparam int unsigned S  = SLOPE_BITS;
  localparam int unsigned B  = SUBPIXEL_BITS;
  localparam int unsigned CB = K + 3;

  // c = cell·U + k, |c| below 2U + 1
  function automatic logic signed [CB-1:0] crossing(logic [K+2:0] position);
    logic signed [CB-1:0] scaled;
    scaled   = signed'({{(CB-3){position[K+2]}}, position[K+2:K]});
    crossing = (((scaled <<< F) - scaled) <<< B) + signed'({3'b000, position[K-1:0]});
  endfunction

  logic signed [CB-1:0] c0_q, c1_q;
  logic                 i0_q, i1_q, negative_q, level_q;
  logic [K:0]           slope_q;
  always_ff @(posedge clk_i) begin
    if (en_i[0]) begin
      c0_q       <= crossing(low_i[K+3:1]);
      c1_q       <= crossing(high_i[K+3:1]);
      i0_q       <= low_i[0] && !mutations_pkg::SLB_EXACT_ALWAYS;
      i1_q       <= high_i[0] && !mutations_pkg::SLB_EXACT_ALWAYS;
      negative_q <= negative_i;
      level_q    <= level_i;
      slope_q    <= slope_i;
    end
  end
  // What goes beside the stages: major, xsign, inner.
  for (genvar n = 0; n < 5; n++) begin : gen_beside
    logic [2:0] beside, beside_q;
    if (n == 0) begin : gen_first
      assign beside = {y_major_i, negative_i, y_major_i != forward_i};
    end else begin : gen_next
      assign beside = gen_beside[n-1].beside_q;
    end
    always_ff @(posedge clk_i) begin
      if (en_i[n]) beside_q <= beside;
    end
  end

  logic         at_one;
  logic [F-1:0] frac;
  logic [S-1:0] slope;
  if (ROUNDING == 0) begin : gen_better
    slb_line_better #(.FRAC_BITS(F), .SLOPE_BITS(S), .SUBPIXEL_BITS(B)) u_line (
      .clk_i, .rst_ni, .en_i(en_i[4:1]), .c0_i(c0_q), .c1_i(c1_q), .i0_i(i0_q), .i1_i(i1_q), .xsign_i(negative_q),
      .level_i(level_q), .cross_o(at_one), .frac_o(frac), .slope_o(slope)
    );
    logic unused_slope;
    assign unused_slope = ^slope_q;
  end else begin : gen_published
    slb_line_published #(.FRAC_BITS(F), .SLOPE_BITS(S), .SUBPIXEL_BITS(B)) u_line (
      .clk_i, .en_i(en_i[4:1]), .c0_i(c0_q), .c1_i(c1_q), .i0_i(i0_q), .i1_i(i1_q), .xsign_i(negative_q),
      .slope_i(slope_q), .cross_o(at_one), .frac_o(frac), .slope_o(slope)
    );
    logic unused_level;
    assign unused_level = level_q ^ rst_ni;
  end
  logic major, xsign, inner;
  assign {major, xsign, inner} = gen_beside[4].beside_q;
  assign line_o                = {major, xsign, at_one, inner, frac, slope};

endmodule
