// SPDX-License-Identifier: Apache-2.0
// One candidate of a line with its score (docs/slb.md, "better"): which border it stores, and whether halfway between two
// codes. Three stages: fraction and difference, slope, score.

module slb_line_candidate #(
  parameter int unsigned FRAC_BITS     = 7,
  parameter int unsigned SLOPE_BITS    = 7,
  parameter int unsigned SUBPIXEL_BITS = 10,
  parameter bit          CROSS         = 1'b0,  // stores the crossing of M = 1
  parameter bit          HALFWAY       = 1'b0,  // h
  // Derived; not to be overridden.
  parameter int unsigned CB = FRAC_BITS + SUBPIXEL_BITS + 3,             // of a crossing in 1/U pixel, with its sign
  parameter int unsigned EB = FRAC_BITS + SLOPE_BITS + SUBPIXEL_BITS + 5  // of a score, with a sign
) (
  input  logic                   clk_i,
  input  logic [2:0]             en_i,                     // stages that hold a line
  input  logic signed [CB-1:0]   stored_i, other_i,
  input  logic                   stored_inexact_i, other_inexact_i,
  input  logic                   xsign_i,
  // Three cycles later.
  output logic                   ok_o,
  output logic [FRAC_BITS-1:0]   frac_o,
  output logic [SLOPE_BITS-1:0]  slope_o,
  output logic [EB-1:0]          score_o
);

  localparam int unsigned F  = FRAC_BITS;
  localparam int unsigned S  = SLOPE_BITS;
  localparam int unsigned B  = SUBPIXEL_BITS;
  localparam int unsigned HB = CB + 1;  // of a position in 1/(2U) pixel
  localparam logic signed [CB-1:0] U = CB'(((1 << F) - 1) << B);

  // 1. Fraction (HALFWAY: floor, and the pixel's end belongs to the code before; else to nearest, ties up).
  logic signed [CB-1:0]  rounded;
  logic signed [CB-B-1:0] code;
  logic                 in_range;  // 0 <= code <= D0 - h
  logic signed [HB-1:0] back, difference, stored_off;
  always_comb begin
    rounded    = 'x;
    code       = 'x;
    in_range   = 'x;
    back       = 'x;
    difference = 'x;
    stored_off = 'x;
    if (en_i[0]) begin
      rounded    = HALFWAY ? stored_i : stored_i + signed'(CB'(1 << (B - 1)));
      code       = rounded[CB-1:B] - signed'((CB - B)'(HALFWAY && stored_i == U));
      in_range   = code[CB-B-1:F] == '0 && !(HALFWAY && code[F-1:0] == '1);
      back       = signed'({code[CB-B-1:0], HALFWAY, {B{1'b0}}});
      difference = back - signed'({other_i, other_inexact_i});
      stored_off = back - signed'({stored_i, stored_inexact_i});
    end
  end
  logic unused_bits;
  assign unused_bits = ^{rounded[B-1:0], difference[HB-1], stored_off[HB-1:B+2]};

  logic                 ok_1_q, xsign_1_q, plus_1_q;
  logic [F-1:0]         frac_1_q;
  logic signed [CB-1:0] t_1_q;
  logic signed [B+1:0]  off_1_q;
  always_ff @(posedge clk_i) begin
    if (en_i[0]) begin
      ok_1_q    <= in_range;
      xsign_1_q <= xsign_i;
      plus_1_q  <= CROSS != xsign_i;
      frac_1_q  <= code[F-1:0];
      // Of a candidate in range |t| <= 2U + 2^s + 1 and |off| <= 2^s; of others nothing is used.
      t_1_q     <= (CROSS != xsign_i) ? CB'(difference) : CB'(-difference);
      off_1_q   <= (B + 2)'(stored_off);
    end
  end

  // 2. Slope.
  logic [S-1:0] slope;
  slb_line_slope #(.FRAC_BITS(F), .SLOPE_BITS(S), .SUBPIXEL_BITS(B)) u_slope (.t_i(t_1_q), .slope_o(slope));

  logic                 ok_2_q, xsign_2_q, plus_2_q;
  logic [F-1:0]         frac_2_q;
  logic [S-1:0]         slope_2_q;
  logic signed [CB-1:0] t_2_q;
  logic signed [B+1:0]  off_2_q;
  always_ff @(posedge clk_i) begin
    if (en_i[1]) begin
      ok_2_q    <= ok_1_q;
      xsign_2_q <= xsign_1_q;
      plus_2_q  <= plus_1_q;
      frac_2_q  <= frac_1_q;
      slope_2_q <= slope;
      t_2_q     <= t_1_q;
      off_2_q   <= off_1_q;
    end
  end

  // 3. Whether the line reads back as meant, and how far it is off at its two borders, in 1/(2U·D1) pixel; with F = S in
  // 1/(2U), as D1 is common to both.
  logic reads_back;
  if (F == S && CROSS) begin : gen_halfway_bit
    logic signed [F+1:0] at_zero;  // code of the crossing of M = 0: frac - σ·slope
    logic                halfway;
    assign at_zero    = xsign_2_q ? signed'({2'b00, frac_2_q}) + signed'({2'b00, slope_2_q})
                                  : signed'({2'b00, frac_2_q}) - signed'({2'b00, slope_2_q});
    assign halfway    = frac_2_q != '1 && at_zero[F+1:F] == 2'b00 && at_zero[F-1:0] != '1;
    assign reads_back = halfway == HALFWAY;
  end else begin : gen_no_halfway_bit
    logic unused_sign;
    assign unused_sign = xsign_2_q;
    assign reads_back  = 1'b1;
  end

  logic signed [EB-1:0] e1, e2_raw, e2, sum;
  logic [EB-1:0]        e1_abs, e2_abs, sum_abs, larger;
  always_comb begin
    e1      = 'x;
    e2_raw  = 'x;
    e2      = 'x;
    sum     = 'x;
    e1_abs  = 'x;
    e2_abs  = 'x;
    sum_abs = 'x;
    larger  = 'x;
    if (en_i[2]) begin
      if (F == S) begin
        e1     = EB'(off_2_q);
        e2_raw = EB'(t_2_q) - signed'(EB'(slope_2_q) << (B + 1));
      end else begin
        e1     = (EB'(off_2_q) <<< S) - EB'(off_2_q);
        e2_raw = (EB'(t_2_q) <<< S) - EB'(t_2_q) - signed'(((EB'(slope_2_q) << F) - EB'(slope_2_q)) << (B + 1));
      end
      e2      = plus_2_q ? e2_raw : -e2_raw;
      sum     = e1 + e2;
      e1_abs  = e1[EB-1] ? EB'(-e1) : EB'(e1);
      e2_abs  = e2[EB-1] ? EB'(-e2) : EB'(e2);
      sum_abs = sum[EB-1] ? EB'(-sum) : EB'(sum);
      larger  = (e1_abs > e2_abs) ? e1_abs : e2_abs;
    end
  end

  always_ff @(posedge clk_i) begin
    if (en_i[2]) begin
      ok_o    <= ok_2_q && reads_back;
      frac_o  <= frac_2_q;
      slope_o <= slope_2_q;
      score_o <= (larger > sum_abs) ? larger : sum_abs;
    end
  end

endmodule
