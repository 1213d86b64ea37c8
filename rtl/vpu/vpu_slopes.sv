// SPDX-License-Identifier: Apache-2.0
// The normalised gradients of the margin test: magnitudes, then shift and saturation. Two stages.

module vpu_slopes #(
  parameter int unsigned UV_G = 34,
  parameter int unsigned F_G  = 42
) (
  input  logic                                      clk_i,
  input  logic                                      en_i,
  input  logic [gnomon_pkg::SHIFT_BITS-1:0]         facing_shift_i, tilt_shift_i,
  input  logic signed [UV_G-1:0]                    g_u_i, g_v_i,
  input  logic signed [F_G-1:0]                     g_f_i,
  output gnomon_pkg::slopes_t                       slopes_o
);

  localparam int unsigned NORM = gnomon_pkg::GRADIENT_NORM_BITS;

  logic [UV_G-2:0] size_u_q, size_v_q;  // |g| < 2^(width-1): a bit less
  logic [F_G-2:0]  size_f_q;
  logic [UV_G-1:0] size_u, size_v;
  logic [F_G-1:0]  size_f;
  assign size_u = g_u_i[UV_G-1] ? -g_u_i : g_u_i;
  assign size_v = g_v_i[UV_G-1] ? -g_v_i : g_v_i;
  assign size_f = g_f_i[F_G-1] ? -g_f_i : g_f_i;

  logic [NORM-1:0] facing, tilt_u, tilt_v;
  vpu_normalise #(.IN_BITS(F_G - 1), .OUT_BITS(NORM)) u_facing (
    .value_i(size_f_q), .shift_i(facing_shift_i), .value_o(facing)
  );
  vpu_normalise #(.IN_BITS(UV_G - 1), .OUT_BITS(NORM)) u_tilt_u (
    .value_i(size_u_q), .shift_i(tilt_shift_i), .value_o(tilt_u)
  );
  vpu_normalise #(.IN_BITS(UV_G - 1), .OUT_BITS(NORM)) u_tilt_v (
    .value_i(size_v_q), .shift_i(tilt_shift_i), .value_o(tilt_v)
  );

  always_ff @(posedge clk_i) begin
    if (en_i) begin
      size_u_q <= size_u[UV_G-2:0];
      size_v_q <= size_v[UV_G-2:0];
      size_f_q <= size_f[F_G-2:0];
      slopes_o <= {facing, tilt_u, tilt_v};
    end
  end

  logic unused_sizes;
  assign unused_sizes = ^{size_u[UV_G-1], size_v[UV_G-1], size_f[F_G-1]};

endmodule
