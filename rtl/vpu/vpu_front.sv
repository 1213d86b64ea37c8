// SPDX-License-Identifier: Apache-2.0
// Front end of the projection unit, shared by its modes: registers, fields of an item, its place on the plane, and for a
// voxel to resolve the gradient of its normal and its offset point. Everything that multiplies by the matrix is here.
// Stages 0 to 4 move together, when the mode behind says so; an item a cycle.

module vpu_front #(
  parameter int unsigned VOXEL_BITS       = 8,
  parameter int unsigned VOXEL_FRAC_BITS  = 2,
  parameter int unsigned NORMAL_BITS      = 9,
  parameter int unsigned MATRIX_FRAC_BITS = 22,
  parameter int unsigned DEPTH_BITS       = 20,
  parameter int unsigned PLANE_LOG2       = 9,
  parameter bit          RESOLVES         = 1'b1,  // some mode resolves voxels: without, no gradient and no offset point
  parameter int unsigned TAG_BITS         = 1,
  // Derived; not to be overridden.
  parameter int unsigned P      = VOXEL_BITS + VOXEL_FRAC_BITS,
  parameter int unsigned UV_ACC = gnomon_pkg::uv_acc_bits(MATRIX_FRAC_BITS, P),
  parameter int unsigned UV_G   = gnomon_pkg::uv_gradient_bits(MATRIX_FRAC_BITS, NORMAL_BITS),
  parameter int unsigned D_G    = gnomon_pkg::depth_gradient_bits(DEPTH_BITS, P, NORMAL_BITS),
  parameter int unsigned UV_SUM = gnomon_pkg::uv_offset_bits(MATRIX_FRAC_BITS, P, NORMAL_BITS),
  parameter int unsigned D_SUM  = gnomon_pkg::depth_offset_bits(DEPTH_BITS, P, NORMAL_BITS)
) (
  input  logic                                       clk_i,
  input  logic                                       rst_ni,
  // Register writes of `word_i`; only while nothing is under way.
  input  logic                                       register_write_i,
  input  logic [gnomon_pkg::REGISTER_INDEX_BITS-1:0] register_index_i,
  // A voxel item is taken when `en_i`. What goes with it: pass, two-sided flag, and a tag of the mode behind.
  input  logic                                       en_i,
  input  logic                                       item_valid_i,
  input  logic [63:0]                                word_i,
  input  logic [gnomon_pkg::ITEM_KIND_BITS-1:0]      kind_i,
  input  logic                                       two_sided_i,
  input  logic [TAG_BITS-1:0]                        tag_i,
  output logic                                       idle_o,         // nothing in stages 0 to 3
  // Registers of the margin test.
  output logic [gnomon_pkg::SHIFT_BITS-1:0]          facing_shift_o, tilt_shift_o, delta_shift_o,
  output logic [gnomon_pkg::MARGIN_BITS-1:0]         margin_squared_o,
  output logic [DEPTH_BITS-1:0]                      delta_max_o,
  // Stage 3: the item on the plane.
  output logic                                       valid_o,
  output logic [gnomon_pkg::ITEM_KIND_BITS-1:0]      kind_o,
  output logic [TAG_BITS-1:0]                        tag_o,
  output logic signed [UV_ACC-1:0]                   u_acc_o, v_acc_o,
  output logic                                       off_plane_o,
  output logic [2*PLANE_LOG2-1:0]                    index_o,
  output logic [gnomon_pkg::DEPTH_FIELD_BITS-1:0]    depth_o,
  output logic                                       saturated_o,
  // Stage 3: the gradient of its normal, turned to the light if two-sided.
  output logic signed [UV_G-1:0]                     g_u_o, g_v_o,
  output logic signed [D_G-1:0]                      g_d_o,
  output logic                                       facing_away_o,
  // Stage 4: the offset point, still to be narrowed.
  output logic signed [UV_SUM-1:0]                   u_sum_o, v_sum_o,
  output logic signed [D_SUM-1:0]                    d_sum_o
);

  localparam int unsigned UV_M  = gnomon_pkg::uv_coefficient_bits(MATRIX_FRAC_BITS);
  localparam int unsigned UV_1  = gnomon_pkg::uv_constant_bits(MATRIX_FRAC_BITS, P);
  localparam int unsigned D_M   = gnomon_pkg::depth_coefficient_bits(DEPTH_BITS, P);
  localparam int unsigned D_1   = gnomon_pkg::depth_constant_bits(DEPTH_BITS, P);
  localparam int unsigned D_ACC = gnomon_pkg::depth_acc_bits(DEPTH_BITS, P);

  // ---- Registers ----
  logic signed [UV_M-1:0]                    ux, uy, uz, vx, vy, vz;
  logic signed [UV_1-1:0]                    u1, v1;
  logic signed [D_M-1:0]                     dx, dy, dz;
  logic signed [D_1-1:0]                     d1;
  logic [gnomon_pkg::OFFSET_FACTOR_BITS-1:0] offset_factor;
  vpu_registers #(.POSITION_BITS(P), .MATRIX_FRAC_BITS(MATRIX_FRAC_BITS), .DEPTH_BITS(DEPTH_BITS)) u_registers (
    .clk_i, .rst_ni, .write_i(register_write_i), .index_i(register_index_i), .value_i(word_i),
    .ux_o(ux), .uy_o(uy), .uz_o(uz), .u1_o(u1), .vx_o(vx), .vy_o(vy), .vz_o(vz), .v1_o(v1),
    .dx_o(dx), .dy_o(dy), .dz_o(dz), .d1_o(d1), .offset_factor_o(offset_factor), .facing_shift_o,
    .tilt_shift_o, .delta_shift_o, .margin_squared_o, .delta_max_o
  );

  // ---- What travels along, stage 0 in the low bits ----
  localparam int unsigned ALONG = TAG_BITS + gnomon_pkg::ITEM_KIND_BITS;
  logic [3:0]         valid_q;
  logic [4*ALONG-1:0] along_q;
  logic [2:0]         two_sided_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni)   valid_q <= '0;
    else if (en_i) valid_q <= {valid_q[2:0], item_valid_i};
  end
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      along_q     <= {along_q[3*ALONG-1:0], tag_i, kind_i};
      two_sided_q <= {two_sided_q[1:0], two_sided_i};
    end
  end
  assign idle_o          = valid_q == '0;
  assign valid_o         = valid_q[3];
  assign {tag_o, kind_o} = along_q[3*ALONG+:ALONG];

  // ---- Stage 0: fields; stages 1 to 3: projection ----
  logic [P-1:0]                  x, y, z;
  logic signed [NORMAL_BITS-1:0] nx, ny, nz;
  logic signed [D_ACC-1:0]       d_acc;
  vpu_unpack #(.POSITION_BITS(P), .NORMAL_BITS(NORMAL_BITS)) u_unpack (
    .clk_i, .en_i, .item_i(word_i), .x_o(x), .y_o(y), .z_o(z), .nx_o(nx), .ny_o(ny), .nz_o(nz)
  );
  vpu_project #(
    .POSITION_BITS(P), .MATRIX_FRAC_BITS(MATRIX_FRAC_BITS), .DEPTH_BITS(DEPTH_BITS), .PLANE_LOG2(PLANE_LOG2)
  ) u_project (
    .clk_i, .en_i, .x_i(x), .y_i(y), .z_i(z), .ux_i(ux), .uy_i(uy), .uz_i(uz), .u1_i(u1),
    .vx_i(vx), .vy_i(vy), .vz_i(vz), .v1_i(v1), .dx_i(dx), .dy_i(dy), .dz_i(dz), .d1_i(d1),
    .u_acc_o, .v_acc_o, .d_acc_o(d_acc), .off_plane_o, .index_o, .depth_o, .saturated_o
  );

  // ---- Stages 1 to 3: gradient of the normal; stage 4: offset point ----
  if (RESOLVES) begin : gen_resolve
    vpu_gradient #(
      .POSITION_BITS(P), .NORMAL_BITS(NORMAL_BITS), .MATRIX_FRAC_BITS(MATRIX_FRAC_BITS), .DEPTH_BITS(DEPTH_BITS)
    ) u_gradient (
      .clk_i, .en_i, .nx_i(nx), .ny_i(ny), .nz_i(nz), .ux_i(ux), .uy_i(uy), .uz_i(uz), .vx_i(vx), .vy_i(vy),
      .vz_i(vz), .dx_i(dx), .dy_i(dy), .dz_i(dz), .two_sided_i(two_sided_q[2]), .g_u_o, .g_v_o, .g_d_o, .facing_away_o
    );
    vpu_lift #(
      .POSITION_BITS(P), .NORMAL_BITS(NORMAL_BITS), .MATRIX_FRAC_BITS(MATRIX_FRAC_BITS), .DEPTH_BITS(DEPTH_BITS)
    ) u_lift (
      .clk_i, .en_i, .factor_i(offset_factor), .u_acc_i(u_acc_o), .v_acc_i(v_acc_o), .d_acc_i(d_acc), .g_u_i(g_u_o),
      .g_v_i(g_v_o), .g_d_i(g_d_o), .u_sum_o, .v_sum_o, .d_sum_o
    );
  end else begin : gen_no_resolve
    assign g_u_o         = '0;
    assign g_v_o         = '0;
    assign g_d_o         = '0;
    assign facing_away_o = 1'b0;
    assign u_sum_o       = '0;
    assign v_sum_o       = '0;
    assign d_sum_o       = '0;
    logic unused_resolve;
    assign unused_resolve = ^{nx, ny, nz, d_acc, offset_factor, two_sided_q[2]};
  end

endmodule
