// SPDX-License-Identifier: Apache-2.0
// a0·b0 + a1·b1 + a2·b2 + c, exact, in two stages: registered products, registered sum. The caller registers the
// operands, so that every multiplier has registers on both sides.

module vpu_dot3 #(
  parameter int unsigned A_BITS   = 24,
  parameter int unsigned B_BITS   = 11,
  parameter int unsigned C_BITS   = 35,
  parameter int unsigned SUM_BITS = 37   // holds every sum: the caller's bit-growth argument
) (
  input  logic                       clk_i,
  input  logic                       en_i,
  input  logic signed [A_BITS-1:0]   a0_i, a1_i, a2_i,
  input  logic signed [B_BITS-1:0]   b0_i, b1_i, b2_i,
  input  logic signed [C_BITS-1:0]   c_i,
  output logic signed [SUM_BITS-1:0] sum_o
);

  localparam int unsigned PRODUCT_BITS = A_BITS + B_BITS;  // (-2^(A-1))·(-2^(B-1)) = 2^(A+B-2) fits

  logic signed [PRODUCT_BITS-1:0] product0_q, product1_q, product2_q;

  always_ff @(posedge clk_i) begin
    if (en_i) begin
      product0_q <= PRODUCT_BITS'(a0_i) * PRODUCT_BITS'(b0_i);
      product1_q <= PRODUCT_BITS'(a1_i) * PRODUCT_BITS'(b1_i);
      product2_q <= PRODUCT_BITS'(a2_i) * PRODUCT_BITS'(b2_i);
      sum_o      <= SUM_BITS'(product0_q) + SUM_BITS'(product1_q) + SUM_BITS'(product2_q) + SUM_BITS'(c_i);
    end
  end

endmodule
