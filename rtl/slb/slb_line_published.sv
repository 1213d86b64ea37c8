// SPDX-License-Identifier: Apache-2.0
// Rounding `published` (docs/slb.md): each field on its own, the fraction mirrored for negative slopes. Four stages, two of
// them only to be as long as `better`.

module slb_line_published #(
  parameter int unsigned FRAC_BITS     = 7,
  parameter int unsigned SLOPE_BITS    = 7,
  parameter int unsigned SUBPIXEL_BITS = 10,
  // Derived; not to be overridden.
  parameter int unsigned CB = FRAC_BITS + SUBPIXEL_BITS + 3,
  parameter int unsigned K  = FRAC_BITS + SUBPIXEL_BITS
) (
  input  logic                  clk_i,
  input  logic [3:0]            en_i,          // stages that hold a line
  input  logic signed [CB-1:0]  c0_i, c1_i,
  input  logic                  i0_i, i1_i,
  input  logic                  xsign_i,
  input  logic [K:0]            slope_i,       // of the edge, in 1/(2U) pixel
  // Four cycles later.
  output logic                  cross_o,
  output logic [FRAC_BITS-1:0]  frac_o,
  output logic [SLOPE_BITS-1:0] slope_o
);

  localparam int unsigned F = FRAC_BITS;
  localparam int unsigned S = SLOPE_BITS;
  localparam int unsigned B = SUBPIXEL_BITS;
  localparam logic signed [CB-1:0] U = CB'(((1 << F) - 1) << B);

  // 1. The border that the pixel has inside; mirrored, U - c - i is U minus the exact crossing rounded down.
  logic                 at_one, inexact;
  logic signed [CB-1:0] chosen, c_1_q;
  logic                 cross_1_q;
  logic [K:0]           t_1_q;
  assign at_one   = !(c0_i >= 0 && (c0_i < U || (c0_i == U && !i0_i)));
  assign chosen  = at_one ? c1_i : c0_i;
  assign inexact = at_one ? i1_i : i0_i;
  always_ff @(posedge clk_i) begin
    if (en_i[0]) begin
      cross_1_q <= at_one;
      c_1_q     <= xsign_i ? U - chosen - signed'(CB'(inexact)) : chosen;
      t_1_q     <= slope_i;
    end
  end

  // 2. Codes. The fraction is within 0..D0, as the crossing is within the pixel.
  logic signed [CB-1:0] rounded;
  logic [S-1:0]         slope;
  assign rounded = c_1_q + signed'(CB'(1 << (B - 1)));
  logic unused_bits;
  assign unused_bits = ^{rounded[CB-1:F+B], rounded[B-1:0]};
  slb_line_slope #(.FRAC_BITS(F), .SLOPE_BITS(S), .SUBPIXEL_BITS(B)) u_slope (
    .t_i({2'b00, t_1_q}), .slope_o(slope)
  );

  logic [F+S:0] line_2_q, line_3_q, line_4_q;
  always_ff @(posedge clk_i) begin
    if (en_i[1]) line_2_q <= {cross_1_q, rounded[B+:F], slope};
    if (en_i[2]) line_3_q <= line_2_q;
    if (en_i[3]) line_4_q <= line_3_q;
  end
  assign {cross_o, frac_o, slope_o} = line_4_q;

endmodule
