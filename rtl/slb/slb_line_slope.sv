// SPDX-License-Identifier: Apache-2.0
// slope(t) = min(D1, max(0, floor(t/(2U)·D1 + 1/2))) (docs/slb.md, "Line of the edge in the current pixel"): the slope's
// code of a minor difference t in 1/(2U) pixel. No divider: with F = S a shift, else a division by the constant 2^F - 1.
// Combinational.

module slb_line_slope #(
  parameter int unsigned FRAC_BITS     = 7,
  parameter int unsigned SLOPE_BITS    = 7,
  parameter int unsigned SUBPIXEL_BITS = 10,
  // Derived; not to be overridden.
  parameter int unsigned T = FRAC_BITS + SUBPIXEL_BITS + 3
) (
  input  logic signed [T-1:0]   t_i,       // |t| <= 2U + 2^s + 1
  output logic [SLOPE_BITS-1:0] slope_o
);

  localparam int unsigned F = FRAC_BITS;
  localparam int unsigned S = SLOPE_BITS;
  localparam int unsigned B = SUBPIXEL_BITS;

  // Rounds to nearest, ties up; then saturates.
  if (F == S) begin : gen_shift
    logic signed [T-1:0] rounded;  // t + 2^s < 2^(T-1)
    logic signed [F+1:0] code;
    assign rounded = t_i + signed'(T'(1 << B));
    assign code    = rounded[T-1:B+1];
    assign slope_o = (code < 0) ? '0 : code[F] ? '1 : code[F-1:0];
    logic unused_fraction;
    assign unused_fraction = ^rounded[B:0];
  end else begin : gen_divide
    localparam int unsigned P = T + S;        // t·D1 + U
    localparam int unsigned N = P - (B + 1);  // = F + S + 2, one of them the sign
    localparam logic signed [P-1:0] U = P'(((1 << F) - 1) << B);
    logic signed [P-1:0] product;
    logic [N-1:0]        n;
    assign product = (P'(t_i) <<< S) - P'(t_i) + U;
    assign n       = product[P-1] ? '0 : product[P-1:B+1];
    logic unused_fraction;
    assign unused_fraction = ^product[B:0];

    // n = a·2^F + b: floor(n/D0) = a + floor((a + b)/D0). Six rounds bring any n below 2^F for F >= 3, S <= 9; what is
    // left is D0 itself or less.
    localparam int unsigned ROUNDS = 6;
    function automatic logic [N-1:0] divide(logic [N-1:0] dividend);
      logic [N-1:0] left;
      left   = dividend;
      divide = '0;
      for (int unsigned i = 0; i < ROUNDS; i++) begin
        divide = divide + (left >> F);
        left   = (left >> F) + N'(left[F-1:0]);
      end
      if (left == N'((1 << F) - 1)) divide = divide + N'(1);
    endfunction

    logic [N-1:0] quotient;
    assign quotient = divide(n);
    assign slope_o  = (quotient[N-1:S] != '0) ? '1 : quotient[S-1:0];
  end

endmodule
