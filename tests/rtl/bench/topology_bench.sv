// SPDX-License-Identifier: Apache-2.0
// Topology mode behind its front end, without decoder and offset mode: commands as the decoder would hand them over.

module topology_bench #(
  parameter int unsigned VOXEL_BITS       = 8,
  parameter int unsigned VOXEL_FRAC_BITS  = 2,
  parameter int unsigned NORMAL_BITS      = 9,
  parameter int unsigned MATRIX_FRAC_BITS = 22,
  parameter int unsigned DEPTH_BITS       = 20,
  parameter int unsigned PLANE_LOG2       = 9,
  parameter bit          EN_PERSPECTIVE   = 1'b0,
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
  output logic [3:0]                                 perspective_events_o,  // of quads, then of voxels
  output topology_pkg::topology_events_t             events_o
);

  localparam int unsigned PLACE     = gnomon_pkg::place_bits(PLANE_LOG2);
  localparam int unsigned CLEARANCE = gnomon_pkg::clearance_bits(EN_PERSPECTIVE, DEPTH_BITS);

  logic                                  stall, front_idle, place_valid, place_behind, place_saturated, two_sided, sorted;
  logic                                  moved_valid, moved_sorted, moved_behind, outside_cone, facing_away;
  logic [gnomon_pkg::ITEM_KIND_BITS-1:0] item_kind, place_kind, moved_kind;
  logic [CLEARANCE-1:0]                  clearance;
  logic [gnomon_pkg::SHIFT_BITS-1:0]     delta_shift;
  logic [gnomon_pkg::MARGIN_BITS-1:0]    margin_squared;
  logic [DEPTH_BITS-1:0]                 delta_max, place_depth, moved_clearance, moved_depth, moved_delta_max;
  logic signed [PLACE-1:0]               place_u, place_v, moved_u, moved_v;
  gnomon_pkg::slopes_t                   slopes;
  assign item_ready_o = !stall;
  vpu_front #(
    .VOXEL_BITS(VOXEL_BITS), .VOXEL_FRAC_BITS(VOXEL_FRAC_BITS), .NORMAL_BITS(NORMAL_BITS),
    .MATRIX_FRAC_BITS(MATRIX_FRAC_BITS), .DEPTH_BITS(DEPTH_BITS), .PLANE_LOG2(PLANE_LOG2), .EN_VPU_OFFSET(1'b0),
    .EN_VPU_TOPOLOGY(1'b1), .EN_PERSPECTIVE(EN_PERSPECTIVE)
  ) u_front (
    .clk_i, .rst_ni, .register_write_i, .register_index_i, .delta_shift_o(delta_shift),
    .margin_squared_o(margin_squared), .delta_max_o(delta_max), .en_i(!stall), .item_valid_i, .word_i,
    .kind_i(item_kind), .two_sided_i(two_sided), .sorted_i(sorted), .clearance_i(clearance), .idle_o(front_idle),
    .valid_o(place_valid), .kind_o(place_kind), .behind_o(place_behind), .u_fine_o(place_u), .v_fine_o(place_v),
    .depth_o(place_depth), .saturated_o(place_saturated), .moved_valid_o(moved_valid), .moved_kind_o(moved_kind),
    .sorted_o(moved_sorted), .clearance_o(moved_clearance), .moved_behind_o(moved_behind),
    .outside_cone_o(outside_cone), .facing_away_o(facing_away), .u_moved_o(moved_u), .v_moved_o(moved_v),
    .depth_moved_o(moved_depth), .slopes_o(slopes), .item_delta_max_o(moved_delta_max)
  );
  // Memories on chip here.
  logic [3*cache_pkg::WANT-1:0] cache_want;
  logic [3*cache_pkg::EVENTS-1:0]        cache_events;
  logic                                  unused_cache;
  assign unused_cache = ^{cache_want, cache_events};
  topology #(
    .DEPTH_BITS(DEPTH_BITS), .PLANE_LOG2(PLANE_LOG2), .EN_PERSPECTIVE(EN_PERSPECTIVE), .SUB_BITS(SUB_BITS),
    .SPAN_LOG2(SPAN_LOG2), .NODES_LOG2(NODES_LOG2), .QUADS_LOG2(QUADS_LOG2), .MEM_LATENCY(MEM_LATENCY),
    .MEM_STALL_SEED(MEM_STALL_SEED)
  ) u_topology (
    .clk_i, .rst_ni, .start_i, .header_i(word_i), .kind_o(item_kind), .two_sided_o(two_sided), .sorted_o(sorted),
    .clearance_o(clearance), .stall_o(stall), .front_idle_i(front_idle), .valid_i(place_valid), .kind_i(place_kind),
    .behind_i(place_behind), .u_fine_i(place_u), .v_fine_i(place_v), .depth_i(place_depth),
    .saturated_i(place_saturated), .moved_valid_i(moved_valid), .moved_kind_i(moved_kind), .sorted_i(moved_sorted),
    .clearance_i(moved_clearance), .moved_behind_i(moved_behind), .outside_cone_i(outside_cone),
    .facing_away_i(facing_away), .u_moved_i(moved_u), .v_moved_i(moved_v), .depth_moved_i(moved_depth),
    .result_valid_o, .result_ready_i, .result_o, .idle_o, .step_o, .wait_o, .clipped_o,
    .quad_behind_o(perspective_events_o[3]), .quad_straddling_o(perspective_events_o[2]),
    .behind_o(perspective_events_o[1]), .outside_cone_o(perspective_events_o[0]), .events_o,
    .cache_want_o(cache_want), .cache_give_i('0), .cache_events_o(cache_events)
  );

  logic unused_offset_mode;
  assign unused_offset_mode = ^{delta_shift, margin_squared, delta_max, slopes, moved_delta_max};

endmodule
