// SPDX-License-Identifier: Apache-2.0
// Gradient of the normal in the plane's coordinates, M·n without the constants, and the facing test: products, sums,
// facing. In hardware with the perspective projection a stage more: there N·(A - light) may decide.

module vpu_gradient #(
  parameter int unsigned POSITION_BITS    = 10,
  parameter int unsigned NORMAL_BITS      = 9,
  parameter int unsigned MATRIX_FRAC_BITS = 22,
  parameter bit          EN_PERSPECTIVE   = 1'b0,
  parameter int unsigned T_M              = 32,   // widths of the third row, of its gradient, of the facing value
  parameter int unsigned T_G              = 42,
  parameter int unsigned F_G              = 42,
  // Derived; not to be overridden.
  parameter int unsigned UV_M  = gnomon_pkg::uv_coefficient_bits(MATRIX_FRAC_BITS),
  parameter int unsigned UV_G  = gnomon_pkg::uv_gradient_bits(MATRIX_FRAC_BITS, NORMAL_BITS),
  parameter int unsigned LIGHT = gnomon_pkg::light_bits(POSITION_BITS)
) (
  input  logic                            clk_i,
  input  logic                            en_i,
  input  logic                            perspective_i,  // a register
  input  logic signed [UV_M-1:0]          ux_i, uy_i, uz_i,
  input  logic signed [UV_M-1:0]          vx_i, vy_i, vz_i,
  input  logic signed [T_M-1:0]           tx_i, ty_i, tz_i,
  input  logic signed [LIGHT-1:0]         light_x_i, light_y_i, light_z_i,
  // Stage 0.
  input  logic [POSITION_BITS-1:0]        x_i, y_i, z_i,
  input  logic signed [NORMAL_BITS-1:0]   nx_i, ny_i, nz_i,
  // Stage 2, or 3 with EN_PERSPECTIVE.
  input  logic                            two_sided_i,
  // The stage after: of the normal that faces the light, if two-sided.
  output logic signed [UV_G-1:0]          g_u_o, g_v_o,
  output logic signed [T_G-1:0]           g_t_o,
  output logic signed [F_G-1:0]           g_f_o,          // facing value: g_d
  output logic                            facing_away_o
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
  logic signed [T_G-1:0] g_t;
  vpu_dot3 #(.A_BITS(T_M), .B_BITS(NORMAL_BITS), .C_BITS(1), .SUM_BITS(T_G)) u_dot_t (
    .clk_i, .en_i, .a0_i(tx_i), .a1_i(ty_i), .a2_i(tz_i), .b0_i(nx_i), .b1_i(ny_i), .b2_i(nz_i), .c_i(1'b0),
    .sum_o(g_t)
  );

  logic signed [UV_G-1:0] sum_u, sum_v;
  logic signed [T_G-1:0]  sum_t;
  logic signed [F_G-1:0]  sum_f;
  if (EN_PERSPECTIVE) begin : gen_position
    // b = 8 p + 4 - light, in eighths of an ulp; then b·n. Growth: |b| < 2^(P+11): below 3·2^(P+N+10) < 2^(P+N+12).
    localparam int unsigned B   = LIGHT + 1;
    localparam int unsigned SUM = POSITION_BITS + NORMAL_BITS + 13;
    logic signed [B-1:0]           bx_q, by_q, bz_q;
    logic signed [NORMAL_BITS-1:0] nx_q, ny_q, nz_q;
    logic signed [SUM-1:0]         towards;
    logic signed [UV_G-1:0]        g_u_q, g_v_q;
    logic signed [T_G-1:0]         g_t_q;
    always_ff @(posedge clk_i) begin
      if (en_i) begin
        bx_q  <= B'({1'b0, x_i, 3'd4}) - B'(light_x_i);
        by_q  <= B'({1'b0, y_i, 3'd4}) - B'(light_y_i);
        bz_q  <= B'({1'b0, z_i, 3'd4}) - B'(light_z_i);
        nx_q  <= nx_i;
        ny_q  <= ny_i;
        nz_q  <= nz_i;
        g_u_q <= g_u;
        g_v_q <= g_v;
        g_t_q <= g_t;
      end
    end
    vpu_dot3 #(.A_BITS(B), .B_BITS(NORMAL_BITS), .C_BITS(1), .SUM_BITS(SUM)) u_dot_f (
      .clk_i, .en_i, .a0_i(bx_q), .a1_i(by_q), .a2_i(bz_q), .b0_i(nx_q), .b1_i(ny_q), .b2_i(nz_q), .c_i(1'b0),
      .sum_o(towards)
    );
    assign sum_u = g_u_q;
    assign sum_v = g_v_q;
    assign sum_t = g_t_q;
    assign sum_f = (perspective_i && !mutations_pkg::PERSPECTIVE_FACE_THE_AXIS) ? F_G'(towards) : F_G'(g_t_q);
  end else begin : gen_direction
    assign sum_u = g_u;
    assign sum_v = g_v;
    assign sum_t = g_t;
    assign sum_f = F_G'(g_t);
    logic unused_position;
    assign unused_position = ^{x_i, y_i, z_i, light_x_i, light_y_i, light_z_i, perspective_i};
  end

  logic positive, flip;
  assign positive = !sum_f[F_G-1] && sum_f != '0;
  assign flip     = two_sided_i && positive;

  always_ff @(posedge clk_i) begin
    if (en_i) begin
      g_u_o         <= flip ? -sum_u : sum_u;
      g_v_o         <= flip ? -sum_v : sum_v;
      g_t_o         <= flip ? -sum_t : sum_t;
      g_f_o         <= flip ? -sum_f : sum_f;
      facing_away_o <= !flip && !sum_f[F_G-1];  // g_d >= 0 and not turned round
    end
  end

endmodule
