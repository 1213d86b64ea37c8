// SPDX-License-Identifier: Apache-2.0
// Rounding `better` (docs/slb.md): the best of up to three candidates, of equal ones the first. Four stages.

`include "assertions.svh"

module slb_line_better #(
  parameter int unsigned FRAC_BITS     = 7,
  parameter int unsigned SLOPE_BITS    = 7,
  parameter int unsigned SUBPIXEL_BITS = 10,
  // Derived; not to be overridden.
  parameter int unsigned CB = FRAC_BITS + SUBPIXEL_BITS + 3
) (
  input  logic                  clk_i,
  input  logic                  rst_ni,
  input  logic [3:0]            en_i,          // stages that hold a line
  input  logic signed [CB-1:0]  c0_i, c1_i,
  input  logic                  i0_i, i1_i,
  input  logic                  xsign_i,
  input  logic                  level_i,       // dm = 0
  // Four cycles later.
  output logic                  cross_o,
  output logic [FRAC_BITS-1:0]  frac_o,
  output logic [SLOPE_BITS-1:0] slope_o
);

  localparam int unsigned F  = FRAC_BITS;
  localparam int unsigned S  = SLOPE_BITS;
  localparam int unsigned B  = SUBPIXEL_BITS;
  localparam int unsigned EB = F + S + B + 5;

  logic [2:0]    ok;
  logic [F-1:0]  frac0, frac1, frac2;
  logic [S-1:0]  slope0, slope1, slope2;
  logic [EB-1:0] score0, score1, score2;
  slb_line_candidate #(.FRAC_BITS(F), .SLOPE_BITS(S), .SUBPIXEL_BITS(B), .CROSS(1'b0), .HALFWAY(1'b0)) u_low (
    .clk_i, .en_i(en_i[2:0]), .stored_i(c0_i), .stored_inexact_i(i0_i), .other_i(c1_i), .other_inexact_i(i1_i), .xsign_i,
    .ok_o(ok[0]), .frac_o(frac0), .slope_o(slope0), .score_o(score0)
  );
  slb_line_candidate #(.FRAC_BITS(F), .SLOPE_BITS(S), .SUBPIXEL_BITS(B), .CROSS(1'b1), .HALFWAY(1'b0)) u_high (
    .clk_i, .en_i(en_i[2:0]), .stored_i(c1_i), .stored_inexact_i(i1_i), .other_i(c0_i), .other_inexact_i(i0_i), .xsign_i,
    .ok_o(ok[1]), .frac_o(frac1), .slope_o(slope1), .score_o(score1)
  );
  if (F == S) begin : gen_halfway
    slb_line_candidate #(.FRAC_BITS(F), .SLOPE_BITS(S), .SUBPIXEL_BITS(B), .CROSS(1'b1), .HALFWAY(1'b1)) u_halfway (
      .clk_i, .en_i(en_i[2:0]), .stored_i(c1_i), .stored_inexact_i(i1_i), .other_i(c0_i), .other_inexact_i(i0_i),
      .xsign_i, .ok_o(ok[2]), .frac_o(frac2), .slope_o(slope2), .score_o(score2)
    );
  end else begin : gen_no_halfway
    assign ok[2]  = 1'b0;
    assign frac2  = '0;
    assign slope2 = '0;
    assign score2 = '0;
  end

  logic level_1_q, level_2_q, level_3_q;
  always_ff @(posedge clk_i) begin
    if (en_i[0]) level_1_q <= level_i;
    if (en_i[1]) level_2_q <= level_1_q;
    if (en_i[2]) level_3_q <= level_2_q;
  end

  // A straight line is candidate 1 with slope 0 everywhere.
  logic          second, third;
  logic [EB-1:0] score;  // of the better of the first two
  always_comb begin
    second = 'x;
    score  = 'x;
    third  = 'x;
    if (en_i[3]) begin
      second = ok[1] && !(ok[0] && (score0 < score1 || (score0 == score1 && !mutations_pkg::SLB_LAST_OF_EQUAL)));
      score  = second ? score1 : score0;
      third  = ok[2] && !((ok[0] || ok[1]) && score <= score2);
    end
  end

  always_ff @(posedge clk_i) begin
    if (en_i[3]) begin
      cross_o <= !level_3_q && (second || third);
      frac_o  <= level_3_q ? frac0 : third ? frac2 : second ? frac1 : frac0;
      slope_o <= level_3_q ? '0 : third ? slope2 : second ? slope1 : slope0;
    end
  end

  `GNOMON_ASSERT(a_some_candidate, !en_i[3] || ok != '0)

endmodule
