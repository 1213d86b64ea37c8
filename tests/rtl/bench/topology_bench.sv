// SPDX-License-Identifier: Apache-2.0
// Topology mode behind its front end, without decoder and offset mode: commands as the decoder would hand them over.

module topology_bench #(
  parameter int unsigned VOXEL_BITS       = 8,
  parameter int unsigned VOXEL_FRAC_BITS  = 2,
  parameter int unsigned NORMAL_BITS      = 9,
  parameter int unsigned MATRIX_FRAC_BITS = 22,
  parameter int unsigned DEPTH_BITS       = 20,
  parameter int unsigned PLANE_LOG2       = 9,
  parameter int unsigned SUB_BITS         = 4,
  parameter int unsigned SPAN_LOG2        = 4,
  parameter int unsigned NODES_LOG2       = 20,
  parameter int unsigned QUADS_LOG2       = 18,
  parameter int unsigned MEM_LATENCY      = 1,
  parameter int unsigned MEM_STALL_SEED   = 0
) (
  input  logic                                       clk_i,
  input  logic                                       rst_ni,
  input  logic                                       register_write_i,
  input  logic [gnomon_pkg::REGISTER_INDEX_BITS-1:0] register_index_i,
  input  logic                                       start_i,
  input  logic                                       item_valid_i,
  output logic                                       item_ready_o,
  input  logic [63:0]                                word_i,           // header, item, or value of a register
  output logic                                       result_valid_o,
  input  logic                                       result_ready_i,
  output logic [63:0]                                result_o,
  output logic                                       idle_o,
  output logic                                       step_o,
  output logic                                       wait_o,
  output logic                                       clipped_o,
  output topology_pkg::topology_events_t             events_o
);

  localparam int unsigned P      = VOXEL_BITS + VOXEL_FRAC_BITS;
  localparam int unsigned UV_ACC = gnomon_pkg::uv_acc_bits(MATRIX_FRAC_BITS, P);
  localparam int unsigned UV_G   = gnomon_pkg::uv_gradient_bits(MATRIX_FRAC_BITS, NORMAL_BITS);
  localparam int unsigned D_G    = gnomon_pkg::depth_gradient_bits(DEPTH_BITS, P, NORMAL_BITS);
  localparam int unsigned UV_SUM = gnomon_pkg::uv_offset_bits(MATRIX_FRAC_BITS, P, NORMAL_BITS);
  localparam int unsigned D_SUM  = gnomon_pkg::depth_offset_bits(DEPTH_BITS, P, NORMAL_BITS);
  localparam int unsigned TAG    = DEPTH_BITS + 1;

  logic                                    stall, front_idle, valid, two_sided, saturated, facing_away, off_plane;
  logic [gnomon_pkg::ITEM_KIND_BITS-1:0]   item_kind, kind;
  logic [TAG-1:0]                          item_tag, tag;
  logic [gnomon_pkg::SHIFT_BITS-1:0]       facing_shift, tilt_shift, delta_shift;
  logic [gnomon_pkg::MARGIN_BITS-1:0]      margin_squared;
  logic [DEPTH_BITS-1:0]                   delta_max;
  logic signed [UV_ACC-1:0]                u_acc, v_acc;
  logic [2*PLANE_LOG2-1:0]                 index;
  logic [gnomon_pkg::DEPTH_FIELD_BITS-1:0] depth;
  logic signed [UV_G-1:0]                  g_u, g_v;
  logic signed [D_G-1:0]                   g_d;
  logic signed [UV_SUM-1:0]                u_sum, v_sum;
  logic signed [D_SUM-1:0]                 d_sum;
  assign item_ready_o = !stall;
  vpu_front #(
    .VOXEL_BITS(VOXEL_BITS), .VOXEL_FRAC_BITS(VOXEL_FRAC_BITS), .NORMAL_BITS(NORMAL_BITS),
    .MATRIX_FRAC_BITS(MATRIX_FRAC_BITS), .DEPTH_BITS(DEPTH_BITS), .PLANE_LOG2(PLANE_LOG2), .TAG_BITS(TAG)
  ) u_front (
    .clk_i, .rst_ni, .register_write_i, .register_index_i, .en_i(!stall), .item_valid_i, .word_i, .kind_i(item_kind),
    .two_sided_i(two_sided), .tag_i(item_tag), .idle_o(front_idle), .facing_shift_o(facing_shift),
    .tilt_shift_o(tilt_shift), .delta_shift_o(delta_shift), .margin_squared_o(margin_squared),
    .delta_max_o(delta_max), .valid_o(valid), .kind_o(kind), .tag_o(tag), .u_acc_o(u_acc), .v_acc_o(v_acc),
    .off_plane_o(off_plane), .index_o(index), .depth_o(depth), .saturated_o(saturated), .g_u_o(g_u), .g_v_o(g_v),
    .g_d_o(g_d), .facing_away_o(facing_away), .u_sum_o(u_sum), .v_sum_o(v_sum), .d_sum_o(d_sum)
  );
  topology #(
    .VOXEL_BITS(VOXEL_BITS), .VOXEL_FRAC_BITS(VOXEL_FRAC_BITS), .NORMAL_BITS(NORMAL_BITS),
    .MATRIX_FRAC_BITS(MATRIX_FRAC_BITS), .DEPTH_BITS(DEPTH_BITS), .PLANE_LOG2(PLANE_LOG2), .SUB_BITS(SUB_BITS),
    .SPAN_LOG2(SPAN_LOG2), .NODES_LOG2(NODES_LOG2), .QUADS_LOG2(QUADS_LOG2), .MEM_LATENCY(MEM_LATENCY),
    .MEM_STALL_SEED(MEM_STALL_SEED)
  ) u_topology (
    .clk_i, .rst_ni, .start_i, .header_i(word_i), .kind_o(item_kind), .two_sided_o(two_sided), .tag_o(item_tag),
    .en_i(!stall), .stall_o(stall), .front_idle_i(front_idle), .valid_i(valid), .kind_i(kind), .tag_i(tag),
    .u_acc_i(u_acc), .v_acc_i(v_acc), .depth_i(depth[DEPTH_BITS-1:0]), .saturated_i(saturated),
    .facing_away_i(facing_away), .u_sum_i(u_sum), .v_sum_i(v_sum), .d_sum_i(d_sum), .result_valid_o, .result_ready_i,
    .result_o, .idle_o, .step_o, .wait_o, .clipped_o, .events_o
  );

  logic unused_offset_mode;
  assign unused_offset_mode = ^{
    facing_shift, tilt_shift, delta_shift, margin_squared, delta_max, off_plane, index, depth >> DEPTH_BITS, g_u, g_v, g_d
  };

endmodule
