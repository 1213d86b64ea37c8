// SPDX-License-Identifier: Apache-2.0
// Registers of the perspective projection. Each keeps the low bits of the word written to it; widths and meanings are in
// docs/vpu.md, "Perspective".

module vpu_perspective_registers #(
  parameter int unsigned POSITION_BITS    = 10,
  parameter int unsigned MATRIX_FRAC_BITS = 22,
  parameter int unsigned DEPTH_BITS       = 20,
  parameter int unsigned PLANE_LOG2       = 9,
  // Derived; not to be overridden.
  parameter int unsigned W_M    = gnomon_pkg::uv_coefficient_bits(MATRIX_FRAC_BITS),
  parameter int unsigned W_1    = gnomon_pkg::uv_constant_bits(MATRIX_FRAC_BITS, POSITION_BITS),
  parameter int unsigned NEAR   = gnomon_pkg::near_bits(POSITION_BITS),
  parameter int unsigned CENTRE = PLANE_LOG2 + 2,
  parameter int unsigned KEY    = gnomon_pkg::key_bits(DEPTH_BITS),
  parameter int unsigned LIGHT  = gnomon_pkg::light_bits(POSITION_BITS),
  parameter int unsigned CONE   = gnomon_pkg::cone_bits(PLANE_LOG2)
) (
  input  logic                                       clk_i,
  input  logic                                       rst_ni,
  input  logic                                       write_i,
  input  logic [gnomon_pkg::REGISTER_INDEX_BITS-1:0] index_i,
  input  logic [63:0]                                value_i,
  output logic                                       perspective_o,
  output logic                                       cone_o,
  output logic signed [W_M-1:0]                      wx_o, wy_o, wz_o,
  output logic signed [W_1-1:0]                      w1_o,
  output logic [NEAR-1:0]                            w_near_o,
  output logic signed [CENTRE-1:0]                   centre_u_o, centre_v_o,
  output logic [KEY-1:0]                             key_limit_o, key_scale_o,
  output logic signed [LIGHT-1:0]                    light_x_o, light_y_o, light_z_o,
  output logic [CONE-1:0]                            cone_squared_o
);

  // Narrowing: the low bits of the word, as the register's definition says.
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      perspective_o  <= 1'b0;
      cone_o         <= 1'b0;
      wx_o           <= '0;
      wy_o           <= '0;
      wz_o           <= '0;
      w1_o           <= '0;
      w_near_o       <= '0;
      centre_u_o     <= '0;
      centre_v_o     <= '0;
      key_limit_o    <= '0;
      key_scale_o    <= '0;
      light_x_o      <= '0;
      light_y_o      <= '0;
      light_z_o      <= '0;
      cone_squared_o <= '0;
    end else if (write_i) begin
      case (index_i)
        gnomon_pkg::REG_PROJECTION:   {cone_o, perspective_o} <= value_i[1:0];
        gnomon_pkg::REG_MATRIX_WX:    wx_o           <= value_i[W_M-1:0];
        gnomon_pkg::REG_MATRIX_WY:    wy_o           <= value_i[W_M-1:0];
        gnomon_pkg::REG_MATRIX_WZ:    wz_o           <= value_i[W_M-1:0];
        gnomon_pkg::REG_MATRIX_W1:    w1_o           <= value_i[W_1-1:0];
        gnomon_pkg::REG_W_NEAR:       w_near_o       <= value_i[NEAR-1:0];
        gnomon_pkg::REG_CENTRE_U:     centre_u_o     <= value_i[CENTRE-1:0];
        gnomon_pkg::REG_CENTRE_V:     centre_v_o     <= value_i[CENTRE-1:0];
        gnomon_pkg::REG_KEY_LIMIT:    key_limit_o    <= value_i[KEY-1:0];
        gnomon_pkg::REG_KEY_SCALE:    key_scale_o    <= value_i[KEY-1:0];
        gnomon_pkg::REG_LIGHT_X:      light_x_o      <= value_i[LIGHT-1:0];
        gnomon_pkg::REG_LIGHT_Y:      light_y_o      <= value_i[LIGHT-1:0];
        gnomon_pkg::REG_LIGHT_Z:      light_z_o      <= value_i[LIGHT-1:0];
        gnomon_pkg::REG_CONE_SQUARED: cone_squared_o <= value_i[CONE-1:0];
        default: ;  // of the others
      endcase
    end
  end

  logic unused_value;
  assign unused_value = ^value_i;

endmodule
