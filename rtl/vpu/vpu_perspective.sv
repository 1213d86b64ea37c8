// SPDX-License-Identifier: Apache-2.0
// The perspective projection from the homogeneous sums on (docs/vpu.md, "Perspective"): 1/w, then place, depth key and
// offset point of an item a cycle. Stages are numbered as in the front end; a digit before _q is the stage.

module vpu_perspective #(
  parameter int unsigned POSITION_BITS    = 10,
  parameter int unsigned NORMAL_BITS      = 9,
  parameter int unsigned MATRIX_FRAC_BITS = 22,
  parameter int unsigned DEPTH_BITS       = 20,
  parameter int unsigned PLANE_LOG2       = 9,
  // Derived; not to be overridden.
  parameter int unsigned UV_ACC = gnomon_pkg::uv_acc_bits(MATRIX_FRAC_BITS, POSITION_BITS),
  parameter int unsigned STEP   = gnomon_pkg::step_bits(gnomon_pkg::uv_gradient_bits(MATRIX_FRAC_BITS, NORMAL_BITS)),
  parameter int unsigned NEAR   = gnomon_pkg::near_bits(POSITION_BITS),
  parameter int unsigned CENTRE = PLANE_LOG2 + 2,
  parameter int unsigned KEY    = gnomon_pkg::key_bits(DEPTH_BITS),
  parameter int unsigned CONE   = gnomon_pkg::cone_bits(PLANE_LOG2),
  parameter int unsigned PLACE  = gnomon_pkg::place_bits(PLANE_LOG2)
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  input  logic                     en_i,
  // Registers.
  input  logic                     cone_i,
  input  logic [NEAR-1:0]          w_near_i,
  input  logic signed [CENTRE-1:0] centre_u_i, centre_v_i,
  input  logic [KEY-1:0]           key_limit_i, key_scale_i,
  input  logic [CONE-1:0]          cone_squared_i,
  input  logic [DEPTH_BITS-1:0]    delta_max_i,
  // Stage 2: the homogeneous place.
  input  logic signed [UV_ACC-1:0] u_acc_i, v_acc_i, w_acc_i,
  // Stage 3: topology mode's clearance; 0 for all others.
  input  logic [23:0]              clearance_i,
  // Stage 5: the steps of the offset point.
  input  logic signed [STEP-1:0]   u_step_i, v_step_i, w_step_i,
  // Stage 11: the place; meaningless behind.
  output logic                     behind_o,
  output logic signed [PLACE-1:0]  u_fine_o, v_fine_o,
  output logic [DEPTH_BITS-1:0]    depth_o,
  output logic                     saturated_o,
  // Stage 13: the offset point, the clearance in its depth.
  output logic                     moved_behind_o,
  output logic                     outside_cone_o,
  output logic signed [PLACE-1:0]  u_moved_o, v_moved_o,
  output logic [DEPTH_BITS-1:0]    depth_moved_o,
  output logic [DEPTH_BITS-1:0]    delta_max_o
);

  localparam int unsigned P     = POSITION_BITS;
  localparam int unsigned F     = MATRIX_FRAC_BITS;
  localparam int unsigned D     = DEPTH_BITS;
  localparam int unsigned LEFT  = P + 3;               // the largest shift
  localparam int unsigned L     = gnomon_pkg::NORMALISE_BITS;
  localparam int unsigned R     = 24;                  // fraction bits of the reciprocal
  localparam int unsigned RHO   = 22;                  // relative steps, 20 fraction bits
  localparam int unsigned RHO_F = 20;
  localparam int unsigned Q     = PLANE_LOG2 + 16;     // q and x, 12 fraction bits
  localparam int unsigned TURN  = Q + 2;
  localparam int unsigned FULL  = Q + 1;               // u_fine, exact
  localparam int unsigned FINE  = gnomon_pkg::PLACE_FRAC_BITS;

  // ---- Stage 3: in front of the light? By how much is w to be shifted, so that its highest one is bit F + P + 3? ----
  logic signed [P+4:0]      w_high;
  logic [NEAR-1:0]          near;
  logic                     behind;
  logic [L-1:0]             left, left3_q, left4_q, left5_q;
  logic [F+P+3:0]           w3_q;
  logic signed [UV_ACC-1:0] u3_q, v3_q;
  assign w_high = w_acc_i[F+P+4:F];  // floor
  assign near   = (w_near_i == '0) ? NEAR'(1) : w_near_i;
  assign behind = w_high[P+4] || w_high[P+3:0] < near ||
                  (mutations_pkg::PERSPECTIVE_NEAR_OR_EQUAL && w_high[P+3:0] == near);
  always_comb begin
    left = L'(LEFT);
    for (int unsigned i = 0; i <= LEFT; i = i + 1) begin
      if (w_high[i]) left = L'(LEFT - i);
    end
  end

  // ---- Stage 4: mantissa of w; u, v and the clearance with it ----
  localparam int unsigned W_LEFT = F + P + 8;  // 4 zeros below: a short w has 20 bits
  logic [W_LEFT-1:0]   w_left;
  logic [R-1:0]        m4_q;
  logic signed [Q-1:0] q_u, q_v, q_u4_q, q_v4_q;
  logic [31:0]         c_wide;
  logic [RHO-2:0]      q_c4_q;
  assign w_left = {w3_q, 4'd0} << left3_q;
  vpu_scale #(.IN_BITS(UV_ACC), .LEFT_MAX(LEFT), .SHIFT(F + 3 - FINE), .OUT_BITS(Q)) u_scale_u (
    .value_i(u3_q), .left_i(left3_q), .value_o(q_u)
  );
  vpu_scale #(.IN_BITS(UV_ACC), .LEFT_MAX(LEFT), .SHIFT(F + 3 - FINE), .OUT_BITS(Q)) u_scale_v (
    .value_i(v3_q), .left_i(left3_q), .value_o(q_v)
  );
  assign c_wide = {clearance_i, 8'd0} >> (L'(LEFT) - left3_q);  // 2^(8 - k), floor

  always_ff @(posedge clk_i) begin
    if (en_i) begin
      left3_q <= left;
      w3_q    <= w_acc_i[F+P+3:0];
      u3_q    <= u_acc_i;
      v3_q    <= v_acc_i;

      left4_q <= left3_q;
      m4_q    <= w_left[W_LEFT-1-:R];  // floor
      q_u4_q  <= q_u;
      q_v4_q  <= q_v;
      q_c4_q  <= (c_wide[31:RHO-1] != '0) ? '1 : c_wide[RHO-2:0];  // saturation

      left5_q <= left4_q;
    end
  end

  // ---- Stages 5 to 8: reciprocal ----
  logic [R-1:0] r8;
  vpu_reciprocal u_reciprocal (.clk_i, .en_i, .m_i(m4_q), .r_o(r8));

  // ---- Stage 6: steps with the same shift. A bit more to the left, so that none goes to the right by less than 0 ----
  logic signed [Q-1:0]   q_du, q_dv, q_du6_q, q_dv6_q, q_du7_q, q_dv7_q, q_du8_q, q_dv8_q;
  logic signed [RHO-1:0] q_dw, q_dw6_q, q_dw7_q, q_dw8_q;
  vpu_scale #(.IN_BITS(STEP), .LEFT_MAX(LEFT), .SHIFT(F + 3 - FINE), .OUT_BITS(Q)) u_scale_du (
    .value_i(u_step_i), .left_i(left5_q), .value_o(q_du)
  );
  vpu_scale #(.IN_BITS(STEP), .LEFT_MAX(LEFT), .SHIFT(F + 3 - FINE), .OUT_BITS(Q)) u_scale_dv (
    .value_i(v_step_i), .left_i(left5_q), .value_o(q_dv)
  );
  vpu_scale #(.IN_BITS(STEP + 1), .LEFT_MAX(LEFT), .SHIFT(F + P + 4 - RHO_F), .OUT_BITS(RHO)) u_scale_dw (
    .value_i({w_step_i, 1'b0}), .left_i(left5_q), .value_o(q_dw)
  );
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      q_du6_q <= q_du;
      q_dv6_q <= q_dv;
      q_dw6_q <= q_dw;
      q_du7_q <= q_du6_q;
      q_dv7_q <= q_dv6_q;
      q_dw7_q <= q_dw6_q;
      q_du8_q <= q_du7_q;
      q_dv8_q <= q_dv7_q;
      q_dw8_q <= q_dw7_q;
    end
  end
  logic signed [Q-1:0] q_u8, q_v8;
  logic [RHO-2:0]      q_c8;
  logic [L-1:0]        left8, left9_q;
  vpu_delay #(.WIDTH(2 * Q + RHO - 1 + L), .CYCLES(4)) u_wait (
    .clk_i, .rst_ni, .en_i, .data_i({left4_q, q_c4_q, q_v4_q, q_u4_q}), .data_o({left8, q_c8, q_v8, q_u8})
  );

  // ---- Stage 9: everything divided by w (floor) ----
  localparam int unsigned WIDE_Q = Q + R + 1;
  localparam int unsigned WIDE_P = RHO + R + 1;
  localparam int unsigned H_WIDE = KEY + R;
  logic signed [R:0]        r8_signed;
  logic signed [Q-1:0]      x_u9_q, x_v9_q, x_du9_q, x_dv9_q, x_du10_q, x_dv10_q;
  logic signed [RHO-1:0]    rho9_q;
  logic [RHO-2:0]           rho_c9_q;
  logic [H_WIDE-1:0]        h_product;
  logic [KEY+P-1:0]         h9_q;  // the shift by k is still to come
  logic signed [WIDE_Q-1:0] product_u, product_v, product_du, product_dv;
  logic signed [WIDE_P-1:0] product_dw;
  logic [R+RHO-2:0]         product_c;
  assign r8_signed  = {1'b0, r8};
  assign product_u  = WIDE_Q'(q_u8) * WIDE_Q'(r8_signed);
  assign product_v  = WIDE_Q'(q_v8) * WIDE_Q'(r8_signed);
  assign product_du = WIDE_Q'(q_du8_q) * WIDE_Q'(r8_signed);
  assign product_dv = WIDE_Q'(q_dv8_q) * WIDE_Q'(r8_signed);
  assign product_dw = WIDE_P'(q_dw8_q) * WIDE_P'(r8_signed);
  assign product_c  = (R + RHO - 1)'(q_c8) * (R + RHO - 1)'(r8);
  assign h_product  = H_WIDE'(key_scale_i) * H_WIDE'(r8);

  // ---- Stage 10: place; K/w; how much of the step is a turn; squares for the cone ----
  localparam int unsigned SQUARE = 2 * (Q - 4);  // (x >> 4)²: below 2^(SQUARE - 1)
  logic signed [FULL-1:0]     u10_q, v10_q;
  logic signed [TURN-1:0]     turn_u10_q, turn_v10_q;
  logic [KEY+P-1:0]           h_shifted;
  logic [KEY-1:0]             h10_q;
  logic signed [RHO:0]        rho10_q;
  logic [RHO-2:0]             rho_c;
  logic [SQUARE-1:0]          square_u10_q, square_v10_q;
  logic signed [Q+RHO-1:0]    turn_u, turn_v;
  logic signed [Q-5:0]        side_u, side_v;
  assign h_shifted = h9_q >> (L'(LEFT) - left9_q);  // by k, floor
  assign rho_c     = mutations_pkg::PERSPECTIVE_NO_CLEARANCE ? '0 : rho_c9_q;
  assign turn_u    = (Q + RHO)'(x_u9_q) * (Q + RHO)'(rho9_q);
  assign turn_v    = (Q + RHO)'(x_v9_q) * (Q + RHO)'(rho9_q);
  assign side_u    = x_u9_q[Q-1:4];  // floor
  assign side_v    = x_v9_q[Q-1:4];

  // ---- Stage 11: depth; the moved place; the cone ----
  localparam int unsigned MOVED  = Q + 3;
  localparam int unsigned H_STEP = D + 11;
  localparam int unsigned H_TURN = KEY + 1 + RHO + 1;
  logic signed [PLACE-1:0]  u_fine, v_fine;
  logic signed [KEY:0]      key, key11_q;
  logic [D-1:0]             depth;
  logic                     saturated, outside, outside11_q, outside12_q;
  logic signed [MOVED-1:0]  u11_q, v11_q, u12_q, v12_q;
  logic signed [H_TURN-1:0] h_turn;
  logic signed [H_STEP-1:0] h_step11_q;
  logic [D+KEY-1:0]         max_product;
  logic [KEY-5:0]           max11_q;
  assign outside     = (cone_i || mutations_pkg::PERSPECTIVE_CONE_ALWAYS) &&
                       (CONE + 6)'(square_u10_q) + (CONE + 6)'(square_v10_q) > (CONE + 6)'(cone_squared_i);
  assign key         = $signed({1'b0, key_limit_i}) - $signed({1'b0, h10_q});
  assign h_turn      = H_TURN'($signed({1'b0, h10_q})) * H_TURN'(rho10_q);
  assign max_product = (D + KEY)'(delta_max_i) * (D + KEY)'(h10_q);
  vpu_saturate #(.IN_BITS(FULL), .SHIFT(0), .OUT_BITS(PLACE)) u_fine_u (.value_i(u10_q), .value_o(u_fine));
  vpu_saturate #(.IN_BITS(FULL), .SHIFT(0), .OUT_BITS(PLACE)) u_fine_v (.value_i(v10_q), .value_o(v_fine));
  vpu_code #(.IN_BITS(KEY + 1), .FRAC_BITS(gnomon_pkg::KEY_FRAC_BITS), .DEPTH_BITS(D)) u_depth (
    .depth_i(key), .code_o(depth), .saturated_o(saturated)
  );

  // ---- Stage 12: depth of the offset point; stage 13: narrowed ----
  localparam int unsigned KEY_MOVED = D + 12;
  logic signed [KEY_MOVED-1:0] key12_q;
  logic signed [PLACE-1:0]     u_moved, v_moved;
  logic [D-1:0]                depth_moved, max12_q;
  logic                        unused_saturated;  // only what is projected flags saturation
  vpu_saturate #(.IN_BITS(MOVED), .SHIFT(0), .OUT_BITS(PLACE)) u_moved_u (.value_i(u12_q), .value_o(u_moved));
  vpu_saturate #(.IN_BITS(MOVED), .SHIFT(0), .OUT_BITS(PLACE)) u_moved_v (.value_i(v12_q), .value_o(v_moved));
  vpu_code #(.IN_BITS(KEY_MOVED), .FRAC_BITS(gnomon_pkg::KEY_FRAC_BITS), .DEPTH_BITS(D)) u_depth_moved (
    .depth_i(key12_q), .code_o(depth_moved), .saturated_o(unused_saturated)
  );

  always_ff @(posedge clk_i) begin
    if (en_i) begin
      x_u9_q   <= product_u[R+:Q];
      x_v9_q   <= product_v[R+:Q];
      x_du9_q  <= product_du[R+:Q];
      x_dv9_q  <= product_dv[R+:Q];
      rho9_q   <= product_dw[R+:RHO];
      rho_c9_q <= product_c[R+:RHO-1];
      h9_q     <= h_product[H_WIDE-1:R-P];
      left9_q  <= left8;

      u10_q        <= FULL'(x_u9_q) + FULL'($signed({centre_u_i, FINE'(0)}));
      v10_q        <= FULL'(x_v9_q) + FULL'($signed({centre_v_i, FINE'(0)}));
      x_du10_q     <= x_du9_q;
      x_dv10_q     <= x_dv9_q;
      turn_u10_q   <= mutations_pkg::PERSPECTIVE_NO_TURN ? '0 : TURN'(turn_u >>> RHO_F);  // floor
      turn_v10_q   <= TURN'(turn_v >>> RHO_F);
      h10_q        <= (h_shifted[KEY+P-1:KEY] != '0) ? '1 : h_shifted[KEY-1:0];  // saturation
      rho10_q      <= (RHO + 1)'(rho9_q) - (RHO + 1)'($signed({1'b0, rho_c}));
      square_u10_q <= SQUARE'(side_u) * SQUARE'(side_u);
      square_v10_q <= SQUARE'(side_v) * SQUARE'(side_v);

      u_fine_o    <= u_fine;
      v_fine_o    <= v_fine;
      depth_o     <= depth;
      saturated_o <= saturated;
      key11_q     <= key;
      h_step11_q  <= H_STEP'(h_turn >>> RHO_F);  // floor
      u11_q       <= MOVED'(u10_q) + MOVED'(x_du10_q) - MOVED'(turn_u10_q);
      v11_q       <= MOVED'(v10_q) + MOVED'(x_dv10_q) - MOVED'(turn_v10_q);
      outside11_q <= outside;
      max11_q     <= max_product[D+KEY-1:D+4];  // floor

      key12_q     <= KEY_MOVED'(key11_q) + KEY_MOVED'(h_step11_q);
      u12_q       <= u11_q;
      v12_q       <= v11_q;
      outside12_q <= outside11_q;
      max12_q     <= (max11_q[KEY-5:D] != '0) ? '1 : max11_q[D-1:0];  // no delta is above

      u_moved_o      <= u_moved;
      v_moved_o      <= v_moved;
      depth_moved_o  <= depth_moved;
      outside_cone_o <= outside12_q;
      delta_max_o    <= max12_q;
    end
  end

  logic [10:0] behind_q;  // stage 3 in bit 0
  always_ff @(posedge clk_i) begin
    if (en_i) behind_q <= {behind_q[9:0], behind};
  end
  assign behind_o       = behind_q[8];
  assign moved_behind_o = behind_q[10];

  logic unused_bits;
  assign unused_bits = ^{
    w_left, product_u, product_v, product_du, product_dv, product_dw, product_c, h_product, max_product
  };

endmodule
