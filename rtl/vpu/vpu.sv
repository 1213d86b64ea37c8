// SPDX-License-Identifier: Apache-2.0
// Voxel projection unit: takes voxel items, keeps the nearest depth of each plane entry (project pass) or answers each
// voxel with its state (resolve pass). One item a cycle; docs/vpu.md has the definition and the pipeline.

`include "assertions.svh"

module vpu #(
  parameter int unsigned VOXEL_BITS       = 8,
  parameter int unsigned VOXEL_FRAC_BITS  = 2,
  parameter int unsigned NORMAL_BITS      = 9,
  parameter int unsigned MATRIX_FRAC_BITS = 22,
  parameter int unsigned DEPTH_BITS       = 20,
  parameter int unsigned PLANE_LOG2       = 9,
  parameter bit          EN_VPU_OFFSET    = 1'b1
) (
  input  logic                                       clk_i,
  input  logic                                       rst_ni,
  // Register writes; only while idle.
  input  logic                                       register_write_i,
  input  logic [gnomon_pkg::REGISTER_INDEX_BITS-1:0] register_index_i,
  input  logic [63:0]                                register_value_i,
  // Voxel items, all of one pass until idle.
  input  logic                                       item_valid_i,
  output logic                                       item_ready_o,
  input  logic [63:0]                                item_i,
  input  logic                                       item_resolve_i,
  input  logic                                       item_two_sided_i,
  output logic                                       idle_o,          // no item under way
  // Update port of the plane.
  output logic                                       update_valid_o,
  input  logic                                       update_ready_i,
  output logic [2*PLANE_LOG2-1:0]                    update_index_o,
  output logic [gnomon_pkg::DEPTH_FIELD_BITS-1:0]    update_operand_o,
  input  gnomon_pkg::plane_entry_t                   modify_entry_i,
  input  logic [gnomon_pkg::DEPTH_FIELD_BITS-1:0]    modify_operand_i,
  output logic                                       modify_write_o,
  output logic [gnomon_pkg::DEPTH_FIELD_BITS-1:0]    modify_depth_o,
  // Read ports of the plane.
  output logic                                       read0_valid_o,
  input  logic                                       read0_ready_i,
  output logic [2*PLANE_LOG2-1:0]                    read0_index_o,
  output gnomon_pkg::own_tag_t                       read0_tag_o,
  input  logic                                       entry0_valid_i,
  output logic                                       entry0_ready_o,
  input  gnomon_pkg::plane_entry_t                   entry0_i,
  input  gnomon_pkg::own_tag_t                       entry0_tag_i,
  output logic                                       read1_valid_o,
  input  logic                                       read1_ready_i,
  output logic [2*PLANE_LOG2-1:0]                    read1_index_o,
  output gnomon_pkg::offset_tag_t                    read1_tag_o,
  input  logic                                       entry1_valid_i,
  output logic                                       entry1_ready_o,
  input  gnomon_pkg::plane_entry_t                   entry1_i,
  input  gnomon_pkg::offset_tag_t                    entry1_tag_i,
  // VOXEL_STATE results.
  output logic                                       result_valid_o,
  input  logic                                       result_ready_i,
  output gnomon_pkg::voxel_result_t                  result_o,
  // Events of the project pass, one cycle a voxel.
  output logic                                       projected_o,
  output logic                                       off_plane_o,
  output logic                                       saturated_o
);

  localparam int unsigned P      = VOXEL_BITS + VOXEL_FRAC_BITS;
  localparam int unsigned UV_M   = gnomon_pkg::uv_coefficient_bits(MATRIX_FRAC_BITS);
  localparam int unsigned UV_1   = gnomon_pkg::uv_constant_bits(MATRIX_FRAC_BITS, P);
  localparam int unsigned UV_ACC = gnomon_pkg::uv_acc_bits(MATRIX_FRAC_BITS, P);
  localparam int unsigned D_M    = gnomon_pkg::depth_coefficient_bits(DEPTH_BITS, P);
  localparam int unsigned D_1    = gnomon_pkg::depth_constant_bits(DEPTH_BITS, P);
  localparam int unsigned D_ACC  = gnomon_pkg::depth_acc_bits(DEPTH_BITS, P);

  // ---- Registers ----
  logic signed [UV_M-1:0]                    ux, uy, uz, vx, vy, vz;
  logic signed [UV_1-1:0]                    u1, v1;
  logic signed [D_M-1:0]                     dx, dy, dz;
  logic signed [D_1-1:0]                     d1;
  logic [gnomon_pkg::OFFSET_FACTOR_BITS-1:0] offset_factor;
  logic [gnomon_pkg::SHIFT_BITS-1:0]         facing_shift, tilt_shift, delta_shift;
  logic [gnomon_pkg::MARGIN_BITS-1:0]        margin_squared;
  logic [DEPTH_BITS-1:0]                     delta_max;
  vpu_registers #(.POSITION_BITS(P), .MATRIX_FRAC_BITS(MATRIX_FRAC_BITS), .DEPTH_BITS(DEPTH_BITS)) u_registers (
    .clk_i, .rst_ni, .write_i(register_write_i), .index_i(register_index_i), .value_i(register_value_i),
    .ux_o(ux), .uy_o(uy), .uz_o(uz), .u1_o(u1), .vx_o(vx), .vy_o(vy), .vz_o(vz), .v1_o(v1),
    .dx_o(dx), .dy_o(dy), .dz_o(dz), .d1_o(d1), .offset_factor_o(offset_factor), .facing_shift_o(facing_shift),
    .tilt_shift_o(tilt_shift), .delta_shift_o(delta_shift), .margin_squared_o(margin_squared),
    .delta_max_o(delta_max)
  );

  // ---- Control: stages 0 to 3 (and 4, 5 of the resolve pass) move together or not at all ----
  logic [3:0] valid_q, resolve_q, two_sided_q;  // bit s: stage s
  logic       en, take, give, update_stall, read_stall;

  // Items under way; with the count at its end no item is taken, so that it never wraps whatever the memory's latency.
  localparam int unsigned COUNT_BITS = 10;
  logic [COUNT_BITS-1:0] count_q;
  logic                  count_full;
  assign count_full   = count_q == '1;
  assign en           = !update_stall && !read_stall;
  assign item_ready_o = en && !count_full;
  assign take         = item_valid_i && item_ready_o;
  assign idle_o       = count_q == '0;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_q <= '0;
      count_q <= '0;
    end else begin
      if (en) valid_q <= {valid_q[2:0], take};
      if (take && !give)      count_q <= count_q + 1'b1;
      else if (!take && give) count_q <= count_q - 1'b1;
    end
  end
  always_ff @(posedge clk_i) begin
    if (en) begin
      resolve_q   <= {resolve_q[2:0], item_resolve_i};
      two_sided_q <= {two_sided_q[2:0], item_two_sided_i};
    end
  end

  // ---- Stage 0: fields; stages 1 to 3: projection ----
  logic [P-1:0]                  x, y, z;
  logic signed [NORMAL_BITS-1:0] nx, ny, nz;
  vpu_unpack #(.POSITION_BITS(P), .NORMAL_BITS(NORMAL_BITS)) u_unpack (
    .clk_i, .en_i(en), .item_i, .x_o(x), .y_o(y), .z_o(z), .nx_o(nx), .ny_o(ny), .nz_o(nz)
  );

  logic signed [UV_ACC-1:0]                u_acc, v_acc;
  logic signed [D_ACC-1:0]                 d_acc;
  logic                                    off_plane, saturated;
  logic [2*PLANE_LOG2-1:0]                 index;
  logic [gnomon_pkg::DEPTH_FIELD_BITS-1:0] depth;
  vpu_project #(
    .POSITION_BITS(P), .MATRIX_FRAC_BITS(MATRIX_FRAC_BITS), .DEPTH_BITS(DEPTH_BITS), .PLANE_LOG2(PLANE_LOG2)
  ) u_project (
    .clk_i, .en_i(en), .x_i(x), .y_i(y), .z_i(z), .ux_i(ux), .uy_i(uy), .uz_i(uz), .u1_i(u1),
    .vx_i(vx), .vy_i(vy), .vz_i(vz), .v1_i(v1), .dx_i(dx), .dy_i(dy), .dz_i(dz), .d1_i(d1),
    .u_acc_o(u_acc), .v_acc_o(v_acc), .d_acc_o(d_acc), .off_plane_o(off_plane), .index_o(index), .depth_o(depth),
    .saturated_o(saturated)
  );

  // ---- Project pass: stage 3 offers its depth to the plane ----
  logic project3;
  assign project3         = valid_q[3] && !resolve_q[3];
  assign update_valid_o   = project3 && !off_plane;
  assign update_index_o   = index;
  assign update_operand_o = depth;
  assign update_stall     = update_valid_o && !update_ready_i;
  vpu_nearest u_nearest (
    .entry_i(modify_entry_i), .depth_i(modify_operand_i), .write_o(modify_write_o), .depth_o(modify_depth_o)
  );

  assign projected_o = project3 && en;
  assign off_plane_o = projected_o && off_plane;
  assign saturated_o = projected_o && !off_plane && saturated;
  assign give        = projected_o || (result_valid_o && result_ready_i);

  // ---- Resolve pass ----
  if (EN_VPU_OFFSET) begin : gen_resolve
    vpu_resolve #(
      .POSITION_BITS(P), .NORMAL_BITS(NORMAL_BITS), .MATRIX_FRAC_BITS(MATRIX_FRAC_BITS), .DEPTH_BITS(DEPTH_BITS),
      .PLANE_LOG2(PLANE_LOG2)
    ) u_resolve (
      .clk_i, .rst_ni, .en_i(en), .stall_o(read_stall),
      .ux_i(ux), .uy_i(uy), .uz_i(uz), .vx_i(vx), .vy_i(vy), .vz_i(vz), .dx_i(dx), .dy_i(dy), .dz_i(dz),
      .offset_factor_i(offset_factor), .facing_shift_i(facing_shift), .tilt_shift_i(tilt_shift),
      .delta_shift_i(delta_shift), .margin_squared_i(margin_squared), .delta_max_i(delta_max),
      .nx_i(nx), .ny_i(ny), .nz_i(nz), .two_sided_i(two_sided_q[2]), .valid_i(valid_q[3] && resolve_q[3]),
      .u_acc_i(u_acc), .v_acc_i(v_acc), .d_acc_i(d_acc), .off_plane_i(off_plane), .index_i(index), .depth_i(depth),
      .read0_valid_o, .read0_ready_i, .read0_index_o, .read0_tag_o,
      .entry0_valid_i, .entry0_ready_o, .entry0_i, .entry0_tag_i,
      .read1_valid_o, .read1_ready_i, .read1_index_o, .read1_tag_o,
      .entry1_valid_i, .entry1_ready_o, .entry1_i, .entry1_tag_i,
      .result_valid_o, .result_ready_i, .result_o
    );
  end else begin : gen_no_resolve
    assign read_stall     = 1'b0;
    assign read0_valid_o  = 1'b0;
    assign read0_index_o  = '0;
    assign read0_tag_o    = '0;
    assign entry0_ready_o = 1'b1;
    assign read1_valid_o  = 1'b0;
    assign read1_index_o  = '0;
    assign read1_tag_o    = '0;
    assign entry1_ready_o = 1'b1;
    assign result_valid_o = 1'b0;
    assign result_o       = '0;

    logic unused_resolve;
    assign unused_resolve = ^{
      nx, ny, nz, u_acc, v_acc, d_acc, offset_factor, facing_shift, tilt_shift, delta_shift, margin_squared, delta_max,
      read0_ready_i, read1_ready_i, entry0_valid_i, entry0_i, entry0_tag_i, entry1_valid_i, entry1_i, entry1_tag_i,
      result_ready_i, two_sided_q[2]
    };
  end

  logic unused_two_sided;
  assign unused_two_sided = two_sided_q[3];

  `GNOMON_ASSERT_STREAM(a_update_stable, update_valid_o, update_ready_i, {update_index_o, update_operand_o})
  `GNOMON_ASSERT(a_write_while_idle, !register_write_i || idle_o)

endmodule
