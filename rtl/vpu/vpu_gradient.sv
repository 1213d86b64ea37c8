// SPDX-License-Identifier: Apache-2.0
// Gradient of the normal in the plane's coordinates, M·n without the constants, and the facing test: three stages after
// the registered normal: products, sums, facing.

module vpu_gradient #(
  parameter int unsigned POSITION_BITS    = 10,
  parameter int unsigned NORMAL_BITS      = 9,
  parameter int unsigned MATRIX_FRAC_BITS = 22,
  parameter int unsigned DEPTH_BITS       = 20,
  // Derived; not to be overridden.
  parameter int unsigned UV_M = gnomon_pkg::uv_coefficient_bits(MATRIX_FRAC_BITS),
  parameter int unsigned D_M  = gnomon_pkg::depth_coefficient_bits(DEPTH_BITS, POSITION_BITS),
  parameter int unsigned UV_G = gnomon_pkg::uv_gradient_bits(MATRIX_FRAC_BITS, NORMAL_BITS),
  parameter int unsigned D_G  = gnomon_pkg::depth_gradient_bits(DEPTH_BITS, POSITION_BITS, NORMAL_BITS)
) (
  input  logic                          clk_i,
  input  logic                          en_i,
  input  logic signed [NORMAL_BITS-1:0] nx_i, ny_i, nz_i,
  input  logic signed [UV_M-1:0]        ux_i, uy_i, uz_i,
  input  logic signed [UV_M-1:0]        vx_i, vy_i, vz_i,
  input  logic signed [D_M-1:0]         dx_i, dy_i, dz_i,
  input  logic                          two_sided_i,    // beside the sums: two stages after the normal
  output logic signed [UV_G-1:0]        g_u_o, g_v_o,   // of the normal that faces the light, if two-sided
  output logic signed [D_G-1:0]         g_d_o,
  output logic                          facing_away_o
);

  // Growth: |m| <= 2^(f+1), |n| <= 2^(N-1): below 3·2^(f+N) < 2^(f+N+2), also when negated.
  logic signed [UV_G-1:0] g_u, g_v;
  vpu_dot3 #(.A_BITS(UV_M), .B_BITS(NORMAL_BITS), .C_BITS(1), .SUM_BITS(UV_G)) u_dot_u (
    .clk_i, .en_i, .a0_i(ux_i), .a1_i(uy_i), .a2_i(uz_i), .b0_i(nx_i), .b1_i(ny_i), .b2_i(nz_i), .c_i(1'b0),
    .sum_o(g_u)
  );
  vpu_dot3 #(.A_BITS(UV_M), .B_BITS(NORMAL_BITS), .C_BITS(1), .SUM_BITS(UV_G)) u_dot_v (
    .clk_i, .en_i, .a0_i(vx_i), .a1_i(vy_i), .a2_i(vz_i), .b0_i(nx_i), .b1_i(ny_i), .b2_i(nz_i), .c_i(1'b0),
    .sum_o(g_v)
  );
  // Growth: |m| <= 2^(D+P+1): below 3·2^(D+P+N) < 2^(D+P+N+2).
  logic signed [D_G-1:0] g_d;
  vpu_dot3 #(.A_BITS(D_M), .B_BITS(NORMAL_BITS), .C_BITS(1), .SUM_BITS(D_G)) u_dot_d (
    .clk_i, .en_i, .a0_i(dx_i), .a1_i(dy_i), .a2_i(dz_i), .b0_i(nx_i), .b1_i(ny_i), .b2_i(nz_i), .c_i(1'b0),
    .sum_o(g_d)
  );

  logic positive, flip;
  assign positive = !g_d[D_G-1] && g_d != '0;
  assign flip     = two_sided_i && positive;

  always_ff @(posedge clk_i) begin
    if (en_i) begin
      g_u_o         <= flip ? -g_u : g_u;
      g_v_o         <= flip ? -g_v : g_v;
      g_d_o         <= flip ? -g_d : g_d;
      facing_away_o <= !flip && !g_d[D_G-1];  // g_d >= 0 and not turned round
    end
  end

endmodule
