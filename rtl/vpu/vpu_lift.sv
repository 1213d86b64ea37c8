// SPDX-License-Identifier: Apache-2.0
// The offset point A' = A + factor·N. First stage: the steps OFFSET_FACTOR·g; second, for a directional light: its place
// on the plane and its depth code, along the beam of A.

module vpu_lift #(
  parameter int unsigned POSITION_BITS    = 10,
  parameter int unsigned NORMAL_BITS      = 9,
  parameter int unsigned MATRIX_FRAC_BITS = 22,
  parameter int unsigned DEPTH_BITS       = 20,
  parameter int unsigned PLANE_LOG2       = 9,
  parameter int unsigned T_S              = 32,   // width of the third row's step
  // Derived; not to be overridden.
  parameter int unsigned UV_ACC = gnomon_pkg::uv_acc_bits(MATRIX_FRAC_BITS, POSITION_BITS),
  parameter int unsigned UV_G   = gnomon_pkg::uv_gradient_bits(MATRIX_FRAC_BITS, NORMAL_BITS),
  parameter int unsigned UV_S   = gnomon_pkg::step_bits(UV_G),
  parameter int unsigned D_AS   = gnomon_pkg::depth_acc_bits(DEPTH_BITS, POSITION_BITS) - POSITION_BITS,
  parameter int unsigned T_GS   = T_S - gnomon_pkg::step_bits(0),
  parameter int unsigned PLACE  = gnomon_pkg::place_bits(PLANE_LOG2)
) (
  input  logic                                      clk_i,
  input  logic                                      en_i,
  input  logic [gnomon_pkg::OFFSET_FACTOR_BITS-1:0] factor_i,
  input  logic signed [UV_G-1:0]                    g_u_i, g_v_i,
  input  logic signed [T_GS-1:0]                    g_t_i,              // depth: without its low P bits (floor)
  // First stage.
  output logic signed [UV_S-1:0]                    u_step_o, v_step_o,
  output logic signed [T_S-1:0]                     t_step_o,
  // Beside it: the place of A; its depth has 4 fraction bits.
  input  logic signed [UV_ACC-1:0]                  u_acc_i, v_acc_i,
  input  logic signed [D_AS-1:0]                    d_acc_i,
  // Second stage.
  output logic signed [PLACE-1:0]                   u_moved_o, v_moved_o,
  output logic [DEPTH_BITS-1:0]                     depth_moved_o
);

  localparam int unsigned FACTOR = gnomon_pkg::OFFSET_FACTOR_BITS + 1;  // unsigned factor with a sign bit
  localparam int unsigned FRAC   = gnomon_pkg::OFFSET_FRAC_BITS;

  // ---- First stage: products, floor ----
  logic signed [FACTOR-1:0]      factor;
  logic signed [UV_G+FACTOR-1:0] product_u_q, product_v_q;
  logic signed [T_GS+FACTOR-1:0] product_t_q;
  assign factor = {1'b0, factor_i};
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      product_u_q <= (UV_G + FACTOR)'(factor) * (UV_G + FACTOR)'(g_u_i);
      product_v_q <= (UV_G + FACTOR)'(factor) * (UV_G + FACTOR)'(g_v_i);
      product_t_q <= (T_GS + FACTOR)'(factor) * (T_GS + FACTOR)'(g_t_i);
    end
  end
  assign u_step_o = UV_S'(product_u_q >>> FRAC);
  assign v_step_o = UV_S'(product_v_q >>> FRAC);
  assign t_step_o = T_S'(product_t_q >>> FRAC);

  // ---- Second stage: sums (a bit more than the wider of the two addends), floor, saturation ----
  localparam int unsigned UV_SUM = gnomon_pkg::max_of(UV_ACC, UV_S) + 1;
  localparam int unsigned D_SUM  = gnomon_pkg::max_of(D_AS, T_S) + 1;
  localparam int unsigned FINE   = MATRIX_FRAC_BITS - gnomon_pkg::PLACE_FRAC_BITS;
  logic signed [UV_SUM-1:0] u_sum, v_sum;
  logic signed [D_SUM-1:0]  d_sum;
  logic signed [PLACE-1:0]  u_moved, v_moved;
  logic [DEPTH_BITS-1:0]    depth_moved;
  logic                     unused_saturated;  // only what is projected flags saturation
  assign u_sum = UV_SUM'(u_acc_i) + UV_SUM'(u_step_o);
  assign v_sum = UV_SUM'(v_acc_i) + UV_SUM'(v_step_o);
  assign d_sum = D_SUM'(d_acc_i) + D_SUM'(t_step_o);
  vpu_saturate #(.IN_BITS(UV_SUM), .SHIFT(FINE), .OUT_BITS(PLACE)) u_fine_u (.value_i(u_sum), .value_o(u_moved));
  vpu_saturate #(.IN_BITS(UV_SUM), .SHIFT(FINE), .OUT_BITS(PLACE)) u_fine_v (.value_i(v_sum), .value_o(v_moved));
  vpu_code #(.IN_BITS(D_SUM), .FRAC_BITS(gnomon_pkg::KEY_FRAC_BITS), .DEPTH_BITS(DEPTH_BITS)) u_code (
    .depth_i(d_sum), .code_o(depth_moved), .saturated_o(unused_saturated)
  );
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      u_moved_o     <= u_moved;
      v_moved_o     <= v_moved;
      depth_moved_o <= depth_moved;
    end
  end

endmodule
