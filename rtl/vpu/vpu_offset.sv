// SPDX-License-Identifier: Apache-2.0
// The offset point's entry (u', v') and depth code d', and beside it the normalised gradients for the margin test. Two
// stages: magnitudes, beside the products of the offset point; floors and saturation.

module vpu_offset #(
  parameter int unsigned POSITION_BITS    = 10,
  parameter int unsigned NORMAL_BITS      = 9,
  parameter int unsigned MATRIX_FRAC_BITS = 22,
  parameter int unsigned DEPTH_BITS       = 20,
  parameter int unsigned PLANE_LOG2       = 9,
  // Derived; not to be overridden.
  parameter int unsigned UV_G   = gnomon_pkg::uv_gradient_bits(MATRIX_FRAC_BITS, NORMAL_BITS),
  parameter int unsigned D_G    = gnomon_pkg::depth_gradient_bits(DEPTH_BITS, POSITION_BITS, NORMAL_BITS),
  parameter int unsigned UV_SUM = gnomon_pkg::uv_offset_bits(MATRIX_FRAC_BITS, POSITION_BITS, NORMAL_BITS),
  parameter int unsigned D_SUM  = gnomon_pkg::depth_offset_bits(DEPTH_BITS, POSITION_BITS, NORMAL_BITS)
) (
  input  logic                                          clk_i,
  input  logic                                          en_i,
  input  logic [gnomon_pkg::SHIFT_BITS-1:0]             facing_shift_i, tilt_shift_i,
  // First stage.
  input  logic signed [UV_G-1:0]                        g_u_i, g_v_i,
  input  logic signed [D_G-1:0]                         g_d_i,
  // Second stage.
  input  logic signed [UV_SUM-1:0]                      u_sum_i, v_sum_i,
  input  logic signed [D_SUM-1:0]                       d_sum_i,
  output logic                                          off_plane_o,
  output logic [2*PLANE_LOG2-1:0]                       index_o,
  output logic [gnomon_pkg::DEPTH_FIELD_BITS-1:0]       depth_o,
  output logic [gnomon_pkg::GRADIENT_NORM_BITS-1:0]     facing_o, tilt_u_o, tilt_v_o  // g_dn, g_un, g_vn
);

  localparam int unsigned NORM  = gnomon_pkg::GRADIENT_NORM_BITS;
  localparam int unsigned DEPTH = gnomon_pkg::DEPTH_FIELD_BITS;

  // ---- First stage: magnitudes ----
  logic [UV_G-2:0] size_u_q, size_v_q;  // |g| < 2^(width-1): a bit less
  logic [D_G-2:0]  size_d_q;
  logic [UV_G-1:0] size_u, size_v;
  logic [D_G-1:0]  size_d;
  assign size_u = g_u_i[UV_G-1] ? -g_u_i : g_u_i;
  assign size_v = g_v_i[UV_G-1] ? -g_v_i : g_v_i;
  assign size_d = g_d_i[D_G-1] ? -g_d_i : g_d_i;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      size_u_q <= size_u[UV_G-2:0];
      size_v_q <= size_v[UV_G-2:0];
      size_d_q <= size_d[D_G-2:0];
    end
  end

  // ---- Second stage: entry, depth code, normalised gradients ----
  logic                    off_plane, unused_saturated;  // only the project pass flags saturation
  logic [2*PLANE_LOG2-1:0] index;
  logic [DEPTH-1:0]        depth;
  vpu_locate #(
    .UV_BITS     (UV_SUM),
    .UV_FRAC_BITS(MATRIX_FRAC_BITS),
    .D_BITS      (D_SUM),
    .D_FRAC_BITS (gnomon_pkg::depth_frac_bits(POSITION_BITS) - POSITION_BITS),
    .DEPTH_BITS  (DEPTH_BITS),
    .PLANE_LOG2  (PLANE_LOG2)
  ) u_locate (
    .u_i(u_sum_i), .v_i(v_sum_i), .d_i(d_sum_i),
    .off_plane_o(off_plane), .index_o(index), .depth_o(depth), .saturated_o(unused_saturated)
  );

  logic [NORM-1:0] facing, tilt_u, tilt_v;
  vpu_normalise #(.IN_BITS(D_G - 1), .OUT_BITS(NORM)) u_facing (
    .value_i(size_d_q), .shift_i(facing_shift_i), .value_o(facing)
  );
  vpu_normalise #(.IN_BITS(UV_G - 1), .OUT_BITS(NORM)) u_tilt_u (
    .value_i(size_u_q), .shift_i(tilt_shift_i), .value_o(tilt_u)
  );
  vpu_normalise #(.IN_BITS(UV_G - 1), .OUT_BITS(NORM)) u_tilt_v (
    .value_i(size_v_q), .shift_i(tilt_shift_i), .value_o(tilt_v)
  );

  always_ff @(posedge clk_i) begin
    if (en_i) begin
      off_plane_o <= off_plane;
      index_o     <= index;
      depth_o     <= depth;
      facing_o    <= facing;
      tilt_u_o    <= tilt_u;
      tilt_v_o    <= tilt_v;
    end
  end

  logic unused_sizes;
  assign unused_sizes = ^{size_u[UV_G-1], size_v[UV_G-1], size_d[D_G-1]};

endmodule
