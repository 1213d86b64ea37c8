// SPDX-License-Identifier: Apache-2.0
// What works on voxels and quads: the front end of the projection unit, its offset mode, its topology mode with lists of
// its own, and the frame buffer, which keeps the states that either finds. The depth plane is core_plane's.

`include "assertions.svh"

module core_voxels #(
  parameter int unsigned VOXEL_BITS       = 8,
  parameter int unsigned VOXEL_FRAC_BITS  = 2,
  parameter int unsigned NORMAL_BITS      = 9,
  parameter int unsigned MATRIX_FRAC_BITS = 22,
  parameter int unsigned DEPTH_BITS       = 20,
  parameter int unsigned PLANE_LOG2       = 9,
  parameter bit          EN_VPU_OFFSET    = 1'b1,
  parameter bit          EN_PERSPECTIVE   = 1'b0,
  parameter bit          EN_VPU_TOPOLOGY  = 1'b0,
  parameter int unsigned SUB_BITS         = 4,
  parameter int unsigned SPAN_LOG2        = 4,
  parameter int unsigned NODES_LOG2       = 20,
  parameter int unsigned QUADS_LOG2       = 18,
  parameter bit          EN_FRAME_BUFFER  = 1'b0,
  parameter int unsigned FRAME_LAYERS_LOG2 = 0,
  parameter int unsigned LATENCY          = 1,   // cycles of a read of a plane's RAM
  parameter int unsigned CACHE_LOG2       = 0,
  parameter int unsigned LINE_IDS_LOG2    = 4,
  parameter int unsigned LISTS_LINE       = 0,   // where topology mode's memories begin
  parameter int unsigned MEM_STALL_SEED   = 0,
  // Derived; not to be overridden.
  parameter int unsigned INDEX = 2 * PLANE_LOG2,
  parameter int unsigned DEPTH = gnomon_pkg::DEPTH_FIELD_BITS,
  parameter int unsigned TAG0  = gnomon_pkg::own_tag_bits(EN_PERSPECTIVE)
) (
  input  logic                                       clk_i,
  input  logic                                       rst_ni,
  input  logic [63:0]                                word_i,            // register, item or header
  input  logic                                       register_write_i,
  input  logic [gnomon_pkg::REGISTER_INDEX_BITS-1:0] register_index_i,
  // Items of the projection unit, of topology mode and of the frame buffer.
  input  logic                                       item_valid_i,
  output logic                                       item_ready_o,
  input  logic                                       item_resolve_i, item_two_sided_i,
  output logic                                       vpu_idle_o,
  input  logic                                       topology_start_i, topology_item_valid_i,
  output logic                                       topology_item_ready_o, topology_idle_o, topology_step_o,
  output logic                                       topology_wait_o,
  input  logic                                       frame_start_i, frame_item_valid_i, frame_item_last_i,
  output logic                                       frame_item_ready_o, frame_idle_o, frame_step_o, frame_wait_o,
  // The plane.
  output logic                                       update_valid_o,
  input  logic                                       update_ready_i,
  output logic [INDEX-1:0]                           update_index_o,
  output logic [DEPTH-1:0]                           update_operand_o,
  input  gnomon_pkg::plane_entry_t                   modify_entry_i,
  input  logic [DEPTH-1:0]                           modify_operand_i,
  output logic                                       modify_write_o,
  output logic [DEPTH-1:0]                           modify_depth_o,
  output logic                                       read0_valid_o,
  input  logic                                       read0_ready_i,
  output logic [INDEX-1:0]                           read0_index_o,
  output logic [TAG0-1:0]                            read0_tag_o,
  input  logic                                       entry0_valid_i,
  output logic                                       entry0_ready_o,
  input  gnomon_pkg::plane_entry_t                   entry0_i,
  input  logic [TAG0-1:0]                            entry0_tag_i,
  output logic                                       read1_valid_o,
  input  logic                                       read1_ready_i,
  output logic [INDEX-1:0]                           read1_index_o,
  output gnomon_pkg::offset_tag_t                    read1_tag_o,
  input  logic                                       entry1_valid_i,
  output logic                                       entry1_ready_o,
  input  gnomon_pkg::plane_entry_t                   entry1_i,
  input  gnomon_pkg::offset_tag_t                    entry1_tag_i,
  // Results: states, or words of READ_LISTS; those of the frame buffer.
  output logic                                       told_valid_o,
  output logic [63:0]                                told_o,
  output logic                                       frame_valid_o,
  output frame_pkg::frame_states_t                   frame_result_o,
  input  logic                                       result_ready_i,
  // Its caches' part of the line port.
  output logic [3*cache_pkg::WANT-1:0]               lists_want_o,
  input  logic [3*cache_pkg::GIVE-1:0]               lists_give_i,
  output logic [3*cache_pkg::EVENTS-1:0]             lists_events_o,
  // Events; of the first kind, those of voxels.
  output gnomon_pkg::events_t                        events_o,
  output gnomon_pkg::perspective_events_t            perspective_events_o,
  output topology_pkg::topology_events_t             topology_events_o,
  output frame_pkg::frame_events_t                   frame_events_o,
  output logic                                       saturated_o, clipped_o, behind_light_o  // sticky flags
);

  // State words of a resolve pass, on their way to the frame buffer and to the results; and words of READ_LISTS, which it
  // lets through.
  logic                      frame_room, topology_valid, vpu_valid, state_valid, state_ready;
  logic [63:0]               topology_result;
  gnomon_pkg::voxel_result_t vpu_result;

  // An item goes on where the frame buffer has room for its place.
  logic item_ready, item_valid, topology_item_valid;  // of the two modes
  logic front_en, vpu_stall, topology_stall;
  assign front_en              = !vpu_stall && !topology_stall;
  assign item_valid            = item_valid_i && frame_room;
  assign topology_item_valid   = topology_item_valid_i && frame_room;
  assign item_ready_o          = item_ready && frame_room;
  assign topology_item_ready_o = front_en && frame_room;

  // ---- Front end of the projection unit: both modes' items, one kind at a time, up to their places on the plane ----
  localparam int unsigned PLACE     = gnomon_pkg::place_bits(PLANE_LOG2);
  localparam int unsigned CLEARANCE = gnomon_pkg::clearance_bits(EN_PERSPECTIVE, DEPTH_BITS);
  logic                                  front_idle;
  logic [gnomon_pkg::ITEM_KIND_BITS-1:0] vpu_kind, topology_kind, place_kind, moved_kind;
  logic                                  topology_two_sided, topology_sorted, place_valid, place_behind, place_saturated;
  logic [CLEARANCE-1:0]                  topology_clearance;
  logic [gnomon_pkg::SHIFT_BITS-1:0]     delta_shift;
  logic [gnomon_pkg::MARGIN_BITS-1:0]    margin_squared;
  logic [DEPTH_BITS-1:0]                 delta_max, place_depth, moved_clearance, moved_depth, moved_delta_max;
  logic signed [PLACE-1:0]               place_u, place_v, moved_u, moved_v;
  logic                                  moved_valid, moved_sorted, moved_behind, outside_cone, facing_away;
  gnomon_pkg::slopes_t                   slopes;
  assign vpu_kind = item_resolve_i ? gnomon_pkg::ITEM_OFFSET : gnomon_pkg::ITEM_PROJECT;
  vpu_front #(
    .VOXEL_BITS(VOXEL_BITS), .VOXEL_FRAC_BITS(VOXEL_FRAC_BITS), .NORMAL_BITS(NORMAL_BITS),
    .MATRIX_FRAC_BITS(MATRIX_FRAC_BITS), .DEPTH_BITS(DEPTH_BITS), .PLANE_LOG2(PLANE_LOG2), .EN_VPU_OFFSET(EN_VPU_OFFSET),
    .EN_VPU_TOPOLOGY(EN_VPU_TOPOLOGY), .EN_PERSPECTIVE(EN_PERSPECTIVE)
  ) u_front (
    .clk_i, .rst_ni, .register_write_i, .register_index_i, .delta_shift_o(delta_shift), .margin_squared_o(margin_squared),
    .delta_max_o(delta_max), .en_i(front_en), .item_valid_i((item_valid && item_ready) || topology_item_valid), .word_i,
    .kind_i(topology_item_valid ? topology_kind : vpu_kind),
    .two_sided_i(topology_item_valid ? topology_two_sided : item_two_sided_i), .sorted_i(topology_sorted),
    .clearance_i(topology_clearance), .idle_o(front_idle), .valid_o(place_valid), .kind_o(place_kind),
    .behind_o(place_behind), .u_fine_o(place_u), .v_fine_o(place_v), .depth_o(place_depth), .saturated_o(place_saturated),
    .moved_valid_o(moved_valid), .moved_kind_o(moved_kind), .sorted_o(moved_sorted), .clearance_o(moved_clearance),
    .moved_behind_o(moved_behind), .outside_cone_o(outside_cone), .facing_away_o(facing_away), .u_moved_o(moved_u),
    .v_moved_o(moved_v), .depth_moved_o(moved_depth), .slopes_o(slopes), .item_delta_max_o(moved_delta_max)
  );

  if (EN_VPU_TOPOLOGY) begin : gen_topology
    topology #(
      .DEPTH_BITS(DEPTH_BITS), .PLANE_LOG2(PLANE_LOG2), .EN_PERSPECTIVE(EN_PERSPECTIVE), .SUB_BITS(SUB_BITS),
      .SPAN_LOG2(SPAN_LOG2), .NODES_LOG2(NODES_LOG2), .QUADS_LOG2(QUADS_LOG2), .MEM_LATENCY(LATENCY),
      .MEM_STALL_SEED(MEM_STALL_SEED), .CACHE_LOG2(CACHE_LOG2), .LINE_IDS_LOG2(LINE_IDS_LOG2), .FIRST_LINE(LISTS_LINE)
    ) u_topology (
      .clk_i, .rst_ni, .start_i(topology_start_i), .header_i(word_i), .kind_o(topology_kind),
      .two_sided_o(topology_two_sided), .sorted_o(topology_sorted), .clearance_o(topology_clearance),
      .stall_o(topology_stall), .front_idle_i(front_idle), .valid_i(place_valid), .kind_i(place_kind),
      .behind_i(place_behind), .u_fine_i(place_u), .v_fine_i(place_v), .depth_i(place_depth),
      .saturated_i(place_saturated), .moved_valid_i(moved_valid), .moved_kind_i(moved_kind), .sorted_i(moved_sorted),
      .clearance_i(moved_clearance), .moved_behind_i(moved_behind), .outside_cone_i(outside_cone),
      .facing_away_i(facing_away), .u_moved_i(moved_u), .v_moved_i(moved_v), .depth_moved_i(moved_depth),
      .result_valid_o(topology_valid), .result_ready_i(state_ready), .result_o(topology_result), .idle_o(topology_idle_o),
      .step_o(topology_step_o), .wait_o(topology_wait_o), .clipped_o, .quad_behind_o(perspective_events_o.quad_behind),
      .quad_straddling_o(perspective_events_o.quad_straddling), .behind_o(perspective_events_o.topology_behind),
      .outside_cone_o(perspective_events_o.topology_outside_cone), .events_o(topology_events_o),
      .cache_want_o(lists_want_o), .cache_give_i(lists_give_i), .cache_events_o(lists_events_o)
    );
  end else begin : gen_no_topology
    assign topology_kind                              = gnomon_pkg::ITEM_CORNER;
    assign topology_two_sided                         = 1'b0;
    assign topology_sorted                            = 1'b0;
    assign topology_clearance                         = '0;
    assign topology_stall                             = 1'b0;
    assign topology_valid                             = 1'b0;
    assign topology_result                            = '0;
    assign topology_idle_o                            = 1'b1;
    assign topology_step_o                            = 1'b0;
    assign topology_wait_o                            = 1'b0;
    assign clipped_o                                  = 1'b0;
    assign perspective_events_o.quad_behind           = 1'b0;
    assign perspective_events_o.quad_straddling       = 1'b0;
    assign perspective_events_o.topology_behind       = 1'b0;
    assign perspective_events_o.topology_outside_cone = 1'b0;
    assign topology_events_o                          = '0;
    assign lists_want_o                               = '0;
    assign lists_events_o                             = '0;
    logic unused_topology;
    assign unused_topology = ^{lists_give_i, topology_start_i, front_idle, moved_sorted, moved_clearance};
  end

  // ---- States: to the frame buffer, to the results, or both ----
  assign state_valid = topology_valid || vpu_valid;
  assign told_o      = topology_valid ? topology_result : vpu_result;
  if (EN_FRAME_BUFFER) begin : gen_frame
    // No pass holds more: stages and reads of the offset mode; in topology mode the order queue besides, of 2^(W + 2) for
    // 2^W walks.
    localparam int unsigned AHEAD      = (CACHE_LOG2 == 0) ? 0 : 1 << cache_pkg::QUEUE_LOG2;  // requests in a cache
    localparam int unsigned WALKS_LOG2 = (CACHE_LOG2 == 0) ? $clog2(2 * LATENCY + 48) : 8;
    localparam int unsigned QUEUE_LOG2 = EN_VPU_TOPOLOGY ? WALKS_LOG2 + 3 : $clog2(LATENCY + 60 + AHEAD);
    logic voxel_taken;
    assign voxel_taken = (item_valid && item_ready && item_resolve_i) ||
                         (topology_item_valid && front_en && topology_kind == gnomon_pkg::ITEM_BEAM);
    frame #(
      .VOXEL_BITS(VOXEL_BITS), .VOXEL_FRAC_BITS(VOXEL_FRAC_BITS), .LAYERS_LOG2(FRAME_LAYERS_LOG2),
      .QUEUE_LOG2(QUEUE_LOG2), .MEM_LATENCY(LATENCY), .MEM_STALL_SEED(MEM_STALL_SEED)
    ) u_frame (
      .clk_i, .rst_ni, .start_i(frame_start_i), .word_i, .item_valid_i(frame_item_valid_i),
      .item_ready_o(frame_item_ready_o), .item_last_i(frame_item_last_i), .voxel_valid_i(voxel_taken),
      .voxel_ready_o(frame_room), .state_valid_i(state_valid), .state_ready_o(state_ready),
      .state_i(told_o[gnomon_pkg::STATE_LSB+:2]), .told_valid_o, .told_ready_i(result_ready_i),
      .result_valid_o(frame_valid_o), .result_ready_i, .result_o(frame_result_o), .idle_o(frame_idle_o),
      .step_o(frame_step_o), .wait_o(frame_wait_o), .events_o(frame_events_o)
    );
  end else begin : gen_no_frame
    assign frame_item_ready_o = 1'b1;
    assign frame_room         = 1'b1;
    assign state_ready        = result_ready_i;
    assign told_valid_o       = state_valid;
    assign frame_valid_o      = 1'b0;
    assign frame_result_o     = '0;
    assign frame_idle_o       = 1'b1;
    assign frame_step_o       = 1'b0;
    assign frame_wait_o       = 1'b0;
    assign frame_events_o     = '0;
    logic unused_frame;
    assign unused_frame = ^{frame_start_i, frame_item_valid_i, frame_item_last_i};
  end

  // ---- Offset mode ----
  logic projected, off_plane, saturated;
  vpu #(
    .DEPTH_BITS(DEPTH_BITS), .PLANE_LOG2(PLANE_LOG2), .EN_VPU_OFFSET(EN_VPU_OFFSET), .EN_PERSPECTIVE(EN_PERSPECTIVE)
  ) u_vpu (
    .clk_i, .rst_ni, .item_valid_i(item_valid), .item_ready_o(item_ready), .idle_o(vpu_idle_o), .en_i(front_en),
    .stall_o(vpu_stall), .delta_shift_i(delta_shift), .margin_squared_i(margin_squared), .delta_max_i(delta_max),
    .valid_i(place_valid), .kind_i(place_kind), .behind_i(place_behind), .u_fine_i(place_u), .v_fine_i(place_v),
    .depth_i(place_depth), .saturated_i(place_saturated), .moved_valid_i(moved_valid), .moved_kind_i(moved_kind),
    .moved_behind_i(moved_behind), .outside_cone_i(outside_cone), .facing_away_i(facing_away), .u_moved_i(moved_u),
    .v_moved_i(moved_v), .depth_moved_i(moved_depth), .slopes_i(slopes), .item_delta_max_i(moved_delta_max),
    .update_valid_o, .update_ready_i, .update_index_o, .update_operand_o, .modify_entry_i, .modify_operand_i,
    .modify_write_o, .modify_depth_o, .read0_valid_o, .read0_ready_i, .read0_index_o, .read0_tag_o, .entry0_valid_i,
    .entry0_ready_o, .entry0_i, .entry0_tag_i, .read1_valid_o, .read1_ready_i, .read1_index_o, .read1_tag_o,
    .entry1_valid_i, .entry1_ready_o, .entry1_i, .entry1_tag_i, .result_valid_o(vpu_valid), .result_ready_i(state_ready),
    .result_o(vpu_result), .projected_o(projected), .off_plane_o(off_plane), .saturated_o(saturated),
    .behind_o(perspective_events_o.project_behind)
  );

  // ---- Events ----
  logic vpu_given;
  assign vpu_given = vpu_valid && state_ready;
  always_comb begin
    events_o                       = '0;
    events_o.voxel_projected       = projected;
    events_o.project_off_plane     = off_plane;
    events_o.project_saturated     = saturated;
    events_o.voxel_resolved        = vpu_given;
    events_o.resolved_facing_away  = vpu_given && vpu_result.facing_away;
    events_o.resolved_uncertain    = vpu_given && vpu_result.uncertain;
    events_o.resolved_offset_empty = vpu_given && vpu_result.offset_empty;
    events_o.resolved_shadow       = vpu_given && vpu_result.state == gnomon_pkg::STATE_SHADOW;
  end
  assign perspective_events_o.resolved_behind       = vpu_given && vpu_result.unreached && vpu_result.beyond_max;
  assign perspective_events_o.resolved_outside_cone = vpu_given && vpu_result.unreached && !vpu_result.beyond_max;
  // Sticky flags.
  assign saturated_o    = saturated || topology_events_o.quad_saturated;
  assign behind_light_o = perspective_events_o.project_behind || perspective_events_o.quad_behind ||
                          perspective_events_o.quad_straddling;

  `GNOMON_ASSERT(a_one_state_source, 2'(topology_valid) + 2'(frame_valid_o) + 2'(vpu_valid) <= 2'd1)
  `GNOMON_ASSERT(a_write_while_idle, !register_write_i || (vpu_idle_o && topology_idle_o))

endmodule
