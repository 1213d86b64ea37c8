// SPDX-License-Identifier: Apache-2.0
// Registers of the VPU. Each keeps the low bits of the word written to it; widths and meanings are in docs/vpu.md.

module vpu_registers #(
  parameter int unsigned POSITION_BITS    = 10,
  parameter int unsigned MATRIX_FRAC_BITS = 22,
  parameter int unsigned DEPTH_BITS       = 20,
  // Derived; not to be overridden.
  parameter int unsigned UV_M = gnomon_pkg::uv_coefficient_bits(MATRIX_FRAC_BITS),
  parameter int unsigned UV_1 = gnomon_pkg::uv_constant_bits(MATRIX_FRAC_BITS, POSITION_BITS),
  parameter int unsigned D_M  = gnomon_pkg::depth_coefficient_bits(DEPTH_BITS, POSITION_BITS),
  parameter int unsigned D_1  = gnomon_pkg::depth_constant_bits(DEPTH_BITS, POSITION_BITS)
) (
  input  logic                                       clk_i,
  input  logic                                       rst_ni,
  input  logic                                       write_i,
  input  logic [gnomon_pkg::REGISTER_INDEX_BITS-1:0] index_i,
  input  logic [63:0]                                value_i,
  output logic signed [UV_M-1:0] ux_o, uy_o, uz_o,
  output logic signed [UV_1-1:0] u1_o,
  output logic signed [UV_M-1:0] vx_o, vy_o, vz_o,
  output logic signed [UV_1-1:0] v1_o,
  output logic signed [D_M-1:0]  dx_o, dy_o, dz_o,
  output logic signed [D_1-1:0]  d1_o,
  output logic [gnomon_pkg::OFFSET_FACTOR_BITS-1:0] offset_factor_o,
  output logic [gnomon_pkg::SHIFT_BITS-1:0]         facing_shift_o, tilt_shift_o, delta_shift_o,
  output logic [gnomon_pkg::MARGIN_BITS-1:0]        margin_squared_o,
  output logic [DEPTH_BITS-1:0]                     delta_max_o
);

  // Narrowing: the low bits of the word, as the register's definition says.
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      ux_o             <= '0;
      uy_o             <= '0;
      uz_o             <= '0;
      u1_o             <= '0;
      vx_o             <= '0;
      vy_o             <= '0;
      vz_o             <= '0;
      v1_o             <= '0;
      dx_o             <= '0;
      dy_o             <= '0;
      dz_o             <= '0;
      d1_o             <= '0;
      offset_factor_o  <= '0;
      facing_shift_o   <= '0;
      tilt_shift_o     <= '0;
      delta_shift_o    <= '0;
      margin_squared_o <= '0;
      delta_max_o      <= '0;
    end else if (write_i) begin
      case (index_i)
        gnomon_pkg::REG_MATRIX_UX:      ux_o             <= value_i[UV_M-1:0];
        gnomon_pkg::REG_MATRIX_UY:      uy_o             <= value_i[UV_M-1:0];
        gnomon_pkg::REG_MATRIX_UZ:      uz_o             <= value_i[UV_M-1:0];
        gnomon_pkg::REG_MATRIX_U1:      u1_o             <= value_i[UV_1-1:0];
        gnomon_pkg::REG_MATRIX_VX:      vx_o             <= value_i[UV_M-1:0];
        gnomon_pkg::REG_MATRIX_VY:      vy_o             <= value_i[UV_M-1:0];
        gnomon_pkg::REG_MATRIX_VZ:      vz_o             <= value_i[UV_M-1:0];
        gnomon_pkg::REG_MATRIX_V1:      v1_o             <= value_i[UV_1-1:0];
        gnomon_pkg::REG_MATRIX_DX:      dx_o             <= value_i[D_M-1:0];
        gnomon_pkg::REG_MATRIX_DY:      dy_o             <= value_i[D_M-1:0];
        gnomon_pkg::REG_MATRIX_DZ:      dz_o             <= value_i[D_M-1:0];
        gnomon_pkg::REG_MATRIX_D1:      d1_o             <= value_i[D_1-1:0];
        gnomon_pkg::REG_OFFSET_FACTOR:  offset_factor_o  <= value_i[gnomon_pkg::OFFSET_FACTOR_BITS-1:0];
        gnomon_pkg::REG_FACING_SHIFT:   facing_shift_o   <= value_i[gnomon_pkg::SHIFT_BITS-1:0];
        gnomon_pkg::REG_TILT_SHIFT:     tilt_shift_o     <= value_i[gnomon_pkg::SHIFT_BITS-1:0];
        gnomon_pkg::REG_DELTA_SHIFT:    delta_shift_o    <= value_i[gnomon_pkg::SHIFT_BITS-1:0];
        gnomon_pkg::REG_MARGIN_SQUARED: margin_squared_o <= value_i[gnomon_pkg::MARGIN_BITS-1:0];
        gnomon_pkg::REG_DELTA_MAX:      delta_max_o      <= value_i[DEPTH_BITS-1:0];
        default: ;  // the decoder lets no other index through
      endcase
    end
  end

  logic unused_value;
  assign unused_value = ^value_i[63:D_1];

endmodule
