// SPDX-License-Identifier: Apache-2.0
// Projection of a voxel: three rows of M·p, exact. Two stages after the registered position: products, sums. The third row
// is depth or, in perspective, w.

module vpu_project #(
  parameter int unsigned POSITION_BITS    = 10,
  parameter int unsigned MATRIX_FRAC_BITS = 22,
  parameter int unsigned T_M              = 32,   // widths of the third row
  parameter int unsigned T_1              = 38,
  parameter int unsigned T_ACC            = 46,
  // Derived; not to be overridden.
  parameter int unsigned UV_M   = gnomon_pkg::uv_coefficient_bits(MATRIX_FRAC_BITS),
  parameter int unsigned UV_1   = gnomon_pkg::uv_constant_bits(MATRIX_FRAC_BITS, POSITION_BITS),
  parameter int unsigned UV_ACC = gnomon_pkg::uv_acc_bits(MATRIX_FRAC_BITS, POSITION_BITS)
) (
  input  logic                     clk_i,
  input  logic                     en_i,
  input  logic [POSITION_BITS-1:0] x_i, y_i, z_i,
  input  logic signed [UV_M-1:0]   ux_i, uy_i, uz_i,
  input  logic signed [UV_1-1:0]   u1_i,
  input  logic signed [UV_M-1:0]   vx_i, vy_i, vz_i,
  input  logic signed [UV_1-1:0]   v1_i,
  input  logic signed [T_M-1:0]    tx_i, ty_i, tz_i,
  input  logic signed [T_1-1:0]    t1_i,
  output logic signed [UV_ACC-1:0] u_acc_o, v_acc_o,
  output logic signed [T_ACC-1:0]  t_acc_o
);

  localparam int unsigned B = POSITION_BITS + 1;  // unsigned position with a sign bit

  logic signed [B-1:0] x, y, z;
  assign x = {1'b0, x_i};
  assign y = {1'b0, y_i};
  assign z = {1'b0, z_i};

  // Growth: |m| <= 2^(f+1), p < 2^P, |m1| <= 2^(f+P+2): the sum is below 3·2^(f+P+1) + 2^(f+P+2) < 2^(f+P+4); w likewise.
  vpu_dot3 #(.A_BITS(UV_M), .B_BITS(B), .C_BITS(UV_1), .SUM_BITS(UV_ACC)) u_dot_u (
    .clk_i, .en_i, .a0_i(ux_i), .a1_i(uy_i), .a2_i(uz_i), .b0_i(x), .b1_i(y), .b2_i(z), .c_i(u1_i), .sum_o(u_acc_o)
  );
  vpu_dot3 #(.A_BITS(UV_M), .B_BITS(B), .C_BITS(UV_1), .SUM_BITS(UV_ACC)) u_dot_v (
    .clk_i, .en_i, .a0_i(vx_i), .a1_i(vy_i), .a2_i(vz_i), .b0_i(x), .b1_i(y), .b2_i(z), .c_i(v1_i), .sum_o(v_acc_o)
  );
  // Growth: |m| <= 2^(D+P+1), |m1| <= 2^(D+P+7): below 3·2^(D+2P+1) + 2^(D+P+7) < 2^(D+2P+5) for P >= 4.
  vpu_dot3 #(.A_BITS(T_M), .B_BITS(B), .C_BITS(T_1), .SUM_BITS(T_ACC)) u_dot_t (
    .clk_i, .en_i, .a0_i(tx_i), .a1_i(ty_i), .a2_i(tz_i), .b0_i(x), .b1_i(y), .b2_i(z), .c_i(t1_i), .sum_o(t_acc_o)
  );

endmodule
