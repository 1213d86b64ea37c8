// SPDX-License-Identifier: Apache-2.0
// Shows the constants, words and registers of the SystemVerilog sources to a test, which compares them with the C++ codec.

module package_probe #(
  parameter int unsigned VOXEL_BITS       = 8,
  parameter int unsigned VOXEL_FRAC_BITS  = 2,
  parameter int unsigned NORMAL_BITS      = 9,
  parameter int unsigned MATRIX_FRAC_BITS = 22,
  parameter int unsigned DEPTH_BITS       = 20,
  parameter int unsigned PLANE_LOG2       = 9
) (
  input  logic        clk_i,
  input  logic        rst_ni,
  // Constants by number; the test has the same list.
  input  logic [7:0]  constant_i,
  output logic [63:0] constant_o,
  // A header word in fields.
  input  logic [63:0] header_i,
  output logic [7:0]  header_op_o,
  output logic [7:0]  header_flags_o,
  output logic [15:0] header_count_o,
  output logic [31:0] header_arg_o,
  // Result words from fields.
  input  logic [10:0] sticky_i,
  input  logic [31:0] tag_i,
  output logic [63:0] fence_o,
  input  logic [23:0] index_i,
  input  logic        present_i,
  input  logic [23:0] depth_i,
  output logic [63:0] plane_entry_o,
  input  logic [7:0]  error_i,
  input  logic [31:0] command_index_i,
  output logic [63:0] error_o,
  input  logic [1:0]  state_i,
  input  logic        facing_away_i,
  input  logic        off_plane_i,
  input  logic        uncertain_i,
  input  logic        offset_empty_i,
  input  logic        beyond_max_i,
  input  logic [23:0] nearest_i,
  input  logic [23:0] delta_i,
  output logic [63:0] voxel_o,
  input  logic [5:0]  answer_i,     // shadow, by_full, by_lines, has_fragment, overflow, off_plane
  input  logic [7:0]  object_i,
  input  logic [15:0] number_i,
  output logic [63:0] answer_o,
  input  logic [7:0]  words_i,
  output logic [63:0] slb_entry_o,
  // A voxel item in fields, a cycle later.
  input  logic [63:0] item_i,
  output logic [31:0] x_o, y_o, z_o,
  output logic signed [31:0] nx_o, ny_o, nz_o,
  // Registers: written with a word, read back with their width's sign or zeros in front.
  input  logic        register_write_i,
  input  logic [4:0]  register_index_i,
  input  logic [63:0] register_value_i,
  output logic [63:0] register_o
);

  always_comb begin
    case (constant_i)
      8'd0:  constant_o = 64'(gnomon_pkg::OP_NOP);
      8'd1:  constant_o = 64'(gnomon_pkg::OP_SET_REGISTERS);
      8'd2:  constant_o = 64'(gnomon_pkg::OP_CLEAR_PLANE);
      8'd3:  constant_o = 64'(gnomon_pkg::OP_FENCE);
      8'd4:  constant_o = 64'(gnomon_pkg::OP_READ_PLANE);
      8'd5:  constant_o = 64'(gnomon_pkg::OP_PROJECT_VOXELS);
      8'd6:  constant_o = 64'(gnomon_pkg::OP_RESOLVE_VOXELS);
      8'd7:  constant_o = 64'(gnomon_pkg::FENCE_CLEAR_STICKY);
      8'd8:  constant_o = 64'(gnomon_pkg::RESOLVE_TWO_SIDED);
      8'd9:  constant_o = 64'(gnomon_pkg::PLAIN_REGISTERS);
      8'd10: constant_o = 64'(gnomon_pkg::ERROR_UNKNOWN_OP);
      8'd11: constant_o = 64'(gnomon_pkg::ERROR_FEATURE_ABSENT);
      8'd12: constant_o = 64'(gnomon_pkg::ERROR_BAD_REGISTER);
      8'd13: constant_o = 64'(gnomon_pkg::ERROR_BAD_ARGUMENT);
      8'd14: constant_o = 64'(gnomon_pkg::ERROR_RESERVED_FLAG);
      8'd15: constant_o = 64'(gnomon_pkg::STATE_LIT);
      8'd16: constant_o = 64'(gnomon_pkg::STATE_SHADOW);
      8'd17: constant_o = 64'(gnomon_pkg::OP_SLB_CLEAR);
      8'd18: constant_o = 64'(gnomon_pkg::OP_BEGIN_OBJECT);
      8'd19: constant_o = 64'(gnomon_pkg::OP_LOOP);
      8'd20: constant_o = 64'(gnomon_pkg::OP_FILL);
      8'd21: constant_o = 64'(gnomon_pkg::OP_COVER);
      8'd22: constant_o = 64'(gnomon_pkg::OP_END_OBJECT);
      8'd23: constant_o = 64'(gnomon_pkg::OP_QUERY);
      8'd24: constant_o = 64'(gnomon_pkg::OP_READ_ENTRIES);
      8'd25: constant_o = 64'(gnomon_pkg::BEGIN_FLAT);
      8'd26: constant_o = 64'(gnomon_pkg::LOOP_MORE);
      8'd27: constant_o = 64'(gnomon_pkg::ERROR_BAD_SEQUENCE);
      8'd28: constant_o = 64'(gnomon_pkg::SLB_COUNTER_COUNT);
      8'd29: constant_o = 64'(gnomon_pkg::COUNTER_SLB);
      8'd30: constant_o = 64'(gnomon_pkg::COUNTER_CYCLES);
      8'd31: constant_o = 64'(gnomon_pkg::PASS_QUERY);
      8'd32: constant_o = 64'(gnomon_pkg::REGISTER_COUNT);
      8'd33: constant_o = 64'(gnomon_pkg::PERSPECTIVE_COUNTER_COUNT);
      8'd34: constant_o = 64'(gnomon_pkg::COUNTER_PERSPECTIVE);
      default: constant_o = '0;
    endcase
  end

  gnomon_pkg::header_t header;
  assign header         = header_i;
  assign header_op_o    = header.op;
  assign header_flags_o = header.flags;
  assign header_count_o = header.count;
  assign header_arg_o   = header.arg;

  gnomon_pkg::fence_result_t       fence;
  gnomon_pkg::plane_entry_result_t plane_entry;
  gnomon_pkg::error_result_t       error;
  gnomon_pkg::voxel_result_t       voxel;
  gnomon_pkg::slb_answer_t         answer;
  gnomon_pkg::slb_entry_result_t   slb_entry;
  always_comb begin
    fence                          = '0;
    fence.code                     = gnomon_pkg::RESULT_FENCE;
    fence.sticky.error_seen        = sticky_i[0];
    fence.sticky.off_plane         = sticky_i[1];
    fence.sticky.depth_saturated   = sticky_i[2];
    fence.sticky.behind_light      = sticky_i[5];
    fence.sticky.line_overflow     = sticky_i[8];
    fence.sticky.object_overflow   = sticky_i[9];
    fence.sticky.winding_saturated = sticky_i[10];
    fence.tag                      = tag_i;
    plane_entry         = '0;
    plane_entry.code    = gnomon_pkg::RESULT_PLANE_ENTRY;
    plane_entry.index   = index_i;
    plane_entry.present = present_i;
    plane_entry.depth   = depth_i;
    error               = '0;
    error.code          = gnomon_pkg::RESULT_ERROR;
    error.error         = error_i;
    error.command_index = command_index_i;
    voxel              = '0;
    voxel.code         = gnomon_pkg::RESULT_VOXEL_STATE;
    voxel.state        = state_i;
    voxel.facing_away  = facing_away_i;
    voxel.off_plane    = off_plane_i;
    voxel.uncertain    = uncertain_i;
    voxel.offset_empty = offset_empty_i;
    voxel.beyond_max   = beyond_max_i;
    voxel.nearest      = nearest_i;
    voxel.delta        = delta_i;
    answer             = '0;
    answer.code        = gnomon_pkg::RESULT_SLB_ANSWER;
    answer.object_id   = object_i;
    answer.number      = number_i;
    {answer.shadow, answer.by_full, answer.by_lines, answer.has_fragment, answer.overflow, answer.off_plane} = answer_i;
    slb_entry          = '0;
    slb_entry.code     = gnomon_pkg::RESULT_SLB_ENTRY;
    slb_entry.index    = index_i;
    slb_entry.words    = words_i;
  end
  assign answer_o      = answer;
  assign slb_entry_o   = slb_entry;
  logic unused_sticky;
  assign unused_sticky = ^{sticky_i[7:6], sticky_i[4:3]};
  assign fence_o       = fence;
  assign plane_entry_o = plane_entry;
  assign error_o       = error;
  assign voxel_o       = voxel;

  localparam int unsigned P = VOXEL_BITS + VOXEL_FRAC_BITS;
  logic [P-1:0]                  x, y, z;
  logic signed [NORMAL_BITS-1:0] nx, ny, nz;
  vpu_unpack #(.POSITION_BITS(P), .NORMAL_BITS(NORMAL_BITS)) u_unpack (
    .clk_i, .en_i(1'b1), .item_i, .x_o(x), .y_o(y), .z_o(z), .nx_o(nx), .ny_o(ny), .nz_o(nz)
  );
  assign x_o  = 32'(x);
  assign y_o  = 32'(y);
  assign z_o  = 32'(z);
  assign nx_o = 32'(nx);
  assign ny_o = 32'(ny);
  assign nz_o = 32'(nz);

  logic signed [gnomon_pkg::uv_coefficient_bits(MATRIX_FRAC_BITS)-1:0] ux, uy, uz, vx, vy, vz;
  logic signed [gnomon_pkg::uv_constant_bits(MATRIX_FRAC_BITS, P)-1:0] u1, v1;
  logic signed [gnomon_pkg::depth_coefficient_bits(DEPTH_BITS, P)-1:0] dx, dy, dz;
  logic signed [gnomon_pkg::depth_constant_bits(DEPTH_BITS, P)-1:0]    d1;
  logic [gnomon_pkg::OFFSET_FACTOR_BITS-1:0]                           offset_factor;
  logic [gnomon_pkg::SHIFT_BITS-1:0]                                   facing_shift, tilt_shift, delta_shift;
  logic [gnomon_pkg::MARGIN_BITS-1:0]                                  margin_squared;
  logic [DEPTH_BITS-1:0]                                               delta_max;
  vpu_registers #(.POSITION_BITS(P), .MATRIX_FRAC_BITS(MATRIX_FRAC_BITS), .DEPTH_BITS(DEPTH_BITS)) u_registers (
    .clk_i, .rst_ni, .write_i(register_write_i), .index_i(register_index_i), .value_i(register_value_i),
    .ux_o(ux), .uy_o(uy), .uz_o(uz), .u1_o(u1), .vx_o(vx), .vy_o(vy), .vz_o(vz), .v1_o(v1),
    .dx_o(dx), .dy_o(dy), .dz_o(dz), .d1_o(d1), .offset_factor_o(offset_factor), .facing_shift_o(facing_shift),
    .tilt_shift_o(tilt_shift), .delta_shift_o(delta_shift), .margin_squared_o(margin_squared),
    .delta_max_o(delta_max)
  );
  logic                                                                perspective, cone;
  logic signed [gnomon_pkg::uv_coefficient_bits(MATRIX_FRAC_BITS)-1:0] wx, wy, wz;
  logic signed [gnomon_pkg::uv_constant_bits(MATRIX_FRAC_BITS, P)-1:0] w1;
  logic [gnomon_pkg::near_bits(P)-1:0]                                 w_near;
  logic signed [PLANE_LOG2+1:0]                                        centre_u, centre_v;
  logic [gnomon_pkg::key_bits(DEPTH_BITS)-1:0]                         key_limit, key_scale;
  logic signed [gnomon_pkg::light_bits(P)-1:0]                         light_x, light_y, light_z;
  logic [gnomon_pkg::cone_bits(PLANE_LOG2)-1:0]                        cone_squared;
  vpu_perspective_registers #(
    .POSITION_BITS(P), .MATRIX_FRAC_BITS(MATRIX_FRAC_BITS), .DEPTH_BITS(DEPTH_BITS), .PLANE_LOG2(PLANE_LOG2)
  ) u_perspective_registers (
    .clk_i, .rst_ni, .write_i(register_write_i), .index_i(register_index_i), .value_i(register_value_i),
    .perspective_o(perspective), .cone_o(cone), .wx_o(wx), .wy_o(wy), .wz_o(wz), .w1_o(w1), .w_near_o(w_near),
    .centre_u_o(centre_u), .centre_v_o(centre_v), .key_limit_o(key_limit), .key_scale_o(key_scale),
    .light_x_o(light_x), .light_y_o(light_y), .light_z_o(light_z), .cone_squared_o(cone_squared)
  );
  always_comb begin
    case (register_index_i)
      gnomon_pkg::REG_MATRIX_UX:      register_o = 64'(ux);
      gnomon_pkg::REG_MATRIX_UY:      register_o = 64'(uy);
      gnomon_pkg::REG_MATRIX_UZ:      register_o = 64'(uz);
      gnomon_pkg::REG_MATRIX_U1:      register_o = 64'(u1);
      gnomon_pkg::REG_MATRIX_VX:      register_o = 64'(vx);
      gnomon_pkg::REG_MATRIX_VY:      register_o = 64'(vy);
      gnomon_pkg::REG_MATRIX_VZ:      register_o = 64'(vz);
      gnomon_pkg::REG_MATRIX_V1:      register_o = 64'(v1);
      gnomon_pkg::REG_MATRIX_DX:      register_o = 64'(dx);
      gnomon_pkg::REG_MATRIX_DY:      register_o = 64'(dy);
      gnomon_pkg::REG_MATRIX_DZ:      register_o = 64'(dz);
      gnomon_pkg::REG_MATRIX_D1:      register_o = 64'(d1);
      gnomon_pkg::REG_OFFSET_FACTOR:  register_o = 64'(offset_factor);
      gnomon_pkg::REG_FACING_SHIFT:   register_o = 64'(facing_shift);
      gnomon_pkg::REG_TILT_SHIFT:     register_o = 64'(tilt_shift);
      gnomon_pkg::REG_DELTA_SHIFT:    register_o = 64'(delta_shift);
      gnomon_pkg::REG_MARGIN_SQUARED: register_o = 64'(margin_squared);
      gnomon_pkg::REG_DELTA_MAX:      register_o = 64'(delta_max);
      gnomon_pkg::REG_PROJECTION:     register_o = 64'({cone, perspective});
      gnomon_pkg::REG_MATRIX_WX:      register_o = 64'(wx);
      gnomon_pkg::REG_MATRIX_WY:      register_o = 64'(wy);
      gnomon_pkg::REG_MATRIX_WZ:      register_o = 64'(wz);
      gnomon_pkg::REG_MATRIX_W1:      register_o = 64'(w1);
      gnomon_pkg::REG_W_NEAR:         register_o = 64'(w_near);
      gnomon_pkg::REG_CENTRE_U:       register_o = 64'(centre_u);
      gnomon_pkg::REG_CENTRE_V:       register_o = 64'(centre_v);
      gnomon_pkg::REG_KEY_LIMIT:      register_o = 64'(key_limit);
      gnomon_pkg::REG_KEY_SCALE:      register_o = 64'(key_scale);
      gnomon_pkg::REG_LIGHT_X:        register_o = 64'(light_x);
      gnomon_pkg::REG_LIGHT_Y:        register_o = 64'(light_y);
      gnomon_pkg::REG_LIGHT_Z:        register_o = 64'(light_z);
      gnomon_pkg::REG_CONE_SQUARED:   register_o = 64'(cone_squared);
      default:                        register_o = '0;
    endcase
  end

endmodule
