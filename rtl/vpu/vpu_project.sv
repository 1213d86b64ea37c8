// SPDX-License-Identifier: Apache-2.0
// Projection of a voxel: (u, v, d) = M·p, then entry and depth code. Three stages after the registered position: products,
// sums, entry. The exact sums leave beside the entry for the offset test.

module vpu_project #(
  parameter int unsigned POSITION_BITS    = 10,
  parameter int unsigned MATRIX_FRAC_BITS = 22,
  parameter int unsigned DEPTH_BITS       = 20,
  parameter int unsigned PLANE_LOG2       = 9,
  // Derived; not to be overridden.
  parameter int unsigned UV_M   = gnomon_pkg::uv_coefficient_bits(MATRIX_FRAC_BITS),
  parameter int unsigned UV_1   = gnomon_pkg::uv_constant_bits(MATRIX_FRAC_BITS, POSITION_BITS),
  parameter int unsigned UV_ACC = gnomon_pkg::uv_acc_bits(MATRIX_FRAC_BITS, POSITION_BITS),
  parameter int unsigned D_M    = gnomon_pkg::depth_coefficient_bits(DEPTH_BITS, POSITION_BITS),
  parameter int unsigned D_1    = gnomon_pkg::depth_constant_bits(DEPTH_BITS, POSITION_BITS),
  parameter int unsigned D_ACC  = gnomon_pkg::depth_acc_bits(DEPTH_BITS, POSITION_BITS)
) (
  input  logic                                    clk_i,
  input  logic                                    en_i,
  input  logic [POSITION_BITS-1:0]                x_i, y_i, z_i,
  input  logic signed [UV_M-1:0]                  ux_i, uy_i, uz_i,
  input  logic signed [UV_1-1:0]                  u1_i,
  input  logic signed [UV_M-1:0]                  vx_i, vy_i, vz_i,
  input  logic signed [UV_1-1:0]                  v1_i,
  input  logic signed [D_M-1:0]                   dx_i, dy_i, dz_i,
  input  logic signed [D_1-1:0]                   d1_i,
  output logic signed [UV_ACC-1:0]                u_acc_o, v_acc_o,
  output logic signed [D_ACC-1:0]                 d_acc_o,
  output logic                                    off_plane_o,
  output logic [2*PLANE_LOG2-1:0]                 index_o,
  output logic [gnomon_pkg::DEPTH_FIELD_BITS-1:0] depth_o,
  output logic                                    saturated_o
);

  localparam int unsigned B = POSITION_BITS + 1;  // unsigned position with a sign bit

  logic signed [B-1:0] x, y, z;
  assign x = {1'b0, x_i};
  assign y = {1'b0, y_i};
  assign z = {1'b0, z_i};

  // Growth: |m| <= 2^(f+1), p < 2^P, |m1| <= 2^(f+P+2): the sum is below 3·2^(f+P+1) + 2^(f+P+2) < 2^(f+P+4).
  logic signed [UV_ACC-1:0] u_acc, v_acc;
  vpu_dot3 #(.A_BITS(UV_M), .B_BITS(B), .C_BITS(UV_1), .SUM_BITS(UV_ACC)) u_dot_u (
    .clk_i, .en_i, .a0_i(ux_i), .a1_i(uy_i), .a2_i(uz_i), .b0_i(x), .b1_i(y), .b2_i(z), .c_i(u1_i), .sum_o(u_acc)
  );
  vpu_dot3 #(.A_BITS(UV_M), .B_BITS(B), .C_BITS(UV_1), .SUM_BITS(UV_ACC)) u_dot_v (
    .clk_i, .en_i, .a0_i(vx_i), .a1_i(vy_i), .a2_i(vz_i), .b0_i(x), .b1_i(y), .b2_i(z), .c_i(v1_i), .sum_o(v_acc)
  );
  // Growth: |m| <= 2^(D+P+1), |m1| <= 2^(D+P+7): below 3·2^(D+2P+1) + 2^(D+P+7) < 2^(D+2P+5) for P >= 4.
  logic signed [D_ACC-1:0] d_acc;
  vpu_dot3 #(.A_BITS(D_M), .B_BITS(B), .C_BITS(D_1), .SUM_BITS(D_ACC)) u_dot_d (
    .clk_i, .en_i, .a0_i(dx_i), .a1_i(dy_i), .a2_i(dz_i), .b0_i(x), .b1_i(y), .b2_i(z), .c_i(d1_i), .sum_o(d_acc)
  );

  logic                                    off_plane, saturated;
  logic [2*PLANE_LOG2-1:0]                 index;
  logic [gnomon_pkg::DEPTH_FIELD_BITS-1:0] depth;
  vpu_locate #(
    .UV_BITS     (UV_ACC),
    .UV_FRAC_BITS(MATRIX_FRAC_BITS),
    .D_BITS      (D_ACC),
    .D_FRAC_BITS (gnomon_pkg::depth_frac_bits(POSITION_BITS)),
    .DEPTH_BITS  (DEPTH_BITS),
    .PLANE_LOG2  (PLANE_LOG2)
  ) u_locate (
    .u_i(u_acc), .v_i(v_acc), .d_i(d_acc),
    .off_plane_o(off_plane), .index_o(index), .depth_o(depth), .saturated_o(saturated)
  );

  always_ff @(posedge clk_i) begin
    if (en_i) begin
      u_acc_o     <= u_acc;
      v_acc_o     <= v_acc;
      d_acc_o     <= d_acc;
      off_plane_o <= off_plane;
      index_o     <= index;
      depth_o     <= depth;
      saturated_o <= saturated;
    end
  end

endmodule
