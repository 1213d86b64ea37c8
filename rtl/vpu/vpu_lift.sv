// SPDX-License-Identifier: Apache-2.0
// The offset point A' = A + factor·N, projected along the beam of A, before it is narrowed to an entry or to sub-entries:
// registered products, then sums. One stage; the caller registers what it makes of the sums.

module vpu_lift #(
  parameter int unsigned POSITION_BITS    = 10,
  parameter int unsigned NORMAL_BITS      = 9,
  parameter int unsigned MATRIX_FRAC_BITS = 22,
  parameter int unsigned DEPTH_BITS       = 20,
  // Derived; not to be overridden.
  parameter int unsigned UV_ACC = gnomon_pkg::uv_acc_bits(MATRIX_FRAC_BITS, POSITION_BITS),
  parameter int unsigned D_ACC  = gnomon_pkg::depth_acc_bits(DEPTH_BITS, POSITION_BITS),
  parameter int unsigned UV_G   = gnomon_pkg::uv_gradient_bits(MATRIX_FRAC_BITS, NORMAL_BITS),
  parameter int unsigned D_G    = gnomon_pkg::depth_gradient_bits(DEPTH_BITS, POSITION_BITS, NORMAL_BITS),
  parameter int unsigned UV_SUM = gnomon_pkg::uv_offset_bits(MATRIX_FRAC_BITS, POSITION_BITS, NORMAL_BITS),
  parameter int unsigned D_SUM  = gnomon_pkg::depth_offset_bits(DEPTH_BITS, POSITION_BITS, NORMAL_BITS)
) (
  input  logic                                      clk_i,
  input  logic                                      en_i,
  input  logic [gnomon_pkg::OFFSET_FACTOR_BITS-1:0] factor_i,
  input  logic signed [UV_ACC-1:0]                  u_acc_i, v_acc_i,
  input  logic signed [D_ACC-1:0]                   d_acc_i,
  input  logic signed [UV_G-1:0]                    g_u_i, g_v_i,
  input  logic signed [D_G-1:0]                     g_d_i,
  output logic signed [UV_SUM-1:0]                  u_sum_o, v_sum_o,  // MATRIX_FRAC_BITS fraction bits
  output logic signed [D_SUM-1:0]                   d_sum_o            // 4 fraction bits
);

  localparam int unsigned FACTOR = gnomon_pkg::OFFSET_FACTOR_BITS + 1;  // unsigned factor with a sign bit
  localparam int unsigned FRAC   = gnomon_pkg::OFFSET_FRAC_BITS;

  // The depth is worked on with 4 fraction bits: both of its parts drop P bits first.
  localparam int unsigned D_GS       = D_G - POSITION_BITS;
  localparam int unsigned D_AS       = D_ACC - POSITION_BITS;
  localparam int unsigned UV_PRODUCT = UV_G + FACTOR;
  localparam int unsigned D_PRODUCT  = D_GS + FACTOR;

  logic signed [FACTOR-1:0] factor;
  logic signed [D_GS-1:0]   g_ds;
  assign factor = {1'b0, factor_i};
  assign g_ds   = D_GS'(g_d_i >>> POSITION_BITS);  // floor; the P bits dropped make room for the cast

  logic signed [UV_PRODUCT-1:0] product_u_q, product_v_q;
  logic signed [D_PRODUCT-1:0]  product_d_q;
  logic signed [UV_ACC-1:0]     u_acc_q, v_acc_q;
  logic signed [D_AS-1:0]       d_acc_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      product_u_q <= UV_PRODUCT'(factor) * UV_PRODUCT'(g_u_i);
      product_v_q <= UV_PRODUCT'(factor) * UV_PRODUCT'(g_v_i);
      product_d_q <= D_PRODUCT'(factor) * D_PRODUCT'(g_ds);
      u_acc_q     <= u_acc_i;
      v_acc_q     <= v_acc_i;
      d_acc_q     <= D_AS'(d_acc_i >>> POSITION_BITS);  // floor
    end
  end

  // Growth: one bit more than the wider of the two addends.
  assign u_sum_o = UV_SUM'(u_acc_q) + UV_SUM'(product_u_q >>> FRAC);  // floor
  assign v_sum_o = UV_SUM'(v_acc_q) + UV_SUM'(product_v_q >>> FRAC);  // floor
  assign d_sum_o = D_SUM'(d_acc_q) + D_SUM'(product_d_q >>> FRAC);    // floor

endmodule
