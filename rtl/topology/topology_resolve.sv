// SPDX-License-Identifier: Apache-2.0
// RESOLVE_TOPOLOGY from the lifted point on: the beam, the read of its entry's head, then a result or a walk.

`include "assertions.svh"

module topology_resolve #(
  parameter int unsigned POSITION_BITS    = 10,
  parameter int unsigned NORMAL_BITS      = 9,
  parameter int unsigned MATRIX_FRAC_BITS = 22,
  parameter int unsigned DEPTH_BITS       = 20,
  parameter int unsigned PLANE_LOG2       = 9,
  parameter int unsigned SUB_BITS         = 4,
  parameter int unsigned SPAN_LOG2        = 4,
  parameter int unsigned NODES_LOG2       = 20,
  parameter int unsigned QUADS_LOG2       = 18,
  parameter int unsigned WALKS_LOG2       = 6,
  // Derived; not to be overridden.
  parameter int unsigned UV_SUM   = gnomon_pkg::uv_offset_bits(MATRIX_FRAC_BITS, POSITION_BITS, NORMAL_BITS),
  parameter int unsigned D_SUM    = gnomon_pkg::depth_offset_bits(DEPTH_BITS, POSITION_BITS, NORMAL_BITS),
  parameter int unsigned PLACE    = PLANE_LOG2 + SUB_BITS,
  parameter int unsigned HEAD     = topology_pkg::head_bits(DEPTH_BITS, NODES_LOG2),
  parameter int unsigned HEAD_TAG = 3 + DEPTH_BITS + 2 * PLACE,
  parameter int unsigned NODE     = topology_pkg::node_bits(DEPTH_BITS, NODES_LOG2, QUADS_LOG2),
  parameter int unsigned NODE_TAG = 2 * topology_pkg::COUNT_BITS + WALKS_LOG2,
  parameter int unsigned RECORD     = topology_pkg::record_bits(SUB_BITS, SPAN_LOG2),
  parameter int unsigned RECORD_TAG = NODE_TAG + 1 + NODES_LOG2 + QUADS_LOG2
) (
  input  logic                                      clk_i,
  input  logic                                      rst_ni,
  input  logic                                      en_i,     // the pipeline up to the read moves
  // Stage 3: a voxel, whether it faces away, its arguments; stage 4: its lifted point.
  input  logic                                      valid_i,
  input  logic                                      facing_away_i,
  input  logic                                      sorted_i,
  input  logic [DEPTH_BITS-1:0]                     clearance_i,
  input  logic signed [UV_SUM-1:0]                  u_sum_i, v_sum_i,
  input  logic signed [D_SUM-1:0]                   d_sum_i,
  output logic                                      idle_o,   // but for reads under way
  // List heads.
  output logic                                      read_valid_o,
  input  logic                                      read_ready_i,
  output logic [2*PLANE_LOG2-1:0]                   read_index_o,
  output logic [HEAD_TAG-1:0]                       read_tag_o,
  input  logic                                      head_valid_i,
  output logic                                      head_ready_o,
  input  logic                                      head_present_i,
  input  logic [HEAD-1:0]                           head_i,
  input  logic [HEAD_TAG-1:0]                       head_tag_i,
  // Nodes.
  output logic                                      ask_valid_o,
  input  logic                                      ask_ready_i,
  output logic [NODES_LOG2-1:0]                     ask_index_o,
  output logic [NODE_TAG-1:0]                       ask_tag_o,
  input  logic                                      node_valid_i,
  output logic                                      node_ready_o,
  input  logic [NODE-1:0]                           node_i,
  input  logic [NODE_TAG-1:0]                       node_tag_i,
  // Quad records.
  output logic                                      fetch_valid_o,
  input  logic                                      fetch_ready_i,
  output logic [QUADS_LOG2-1:0]                     fetch_index_o,
  output logic [RECORD_TAG-1:0]                     fetch_tag_o,
  input  logic                                      record_valid_i,
  input  logic [RECORD-1:0]                         record_i,
  input  logic [RECORD_TAG-1:0]                     record_tag_i,
  // TOPOLOGY_STATE results.
  output logic                                      result_valid_o,
  input  logic                                      result_ready_i,
  output topology_pkg::topology_result_t            result_o,
  // Events.
  output logic                                      visited_o,
  output logic                                      tested_o
);

  localparam int unsigned D = DEPTH_BITS;

  // ---- Stages 4 and 5 ----
  logic             off_plane;
  logic [PLACE-1:0] u, v;
  logic [D-1:0]     depth;
  topology_lift #(
    .POSITION_BITS(POSITION_BITS), .NORMAL_BITS(NORMAL_BITS), .MATRIX_FRAC_BITS(MATRIX_FRAC_BITS), .DEPTH_BITS(D),
    .PLANE_LOG2(PLANE_LOG2), .SUB_BITS(SUB_BITS)
  ) u_lift (
    .clk_i, .en_i, .u_sum_i, .v_sum_i, .d_sum_i, .off_plane_o(off_plane), .u_o(u), .v_o(v), .depth_o(depth)
  );
  logic         valid4_q, valid5_q, facing_away4_q, facing_away5_q, sorted4_q, sorted5_q;
  logic [D-1:0] clearance4_q, clearance5_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid4_q <= 1'b0;
      valid5_q <= 1'b0;
    end else if (en_i) begin
      valid4_q <= valid_i;
      valid5_q <= valid4_q;
    end
  end
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      facing_away4_q <= facing_away_i;
      sorted4_q      <= sorted_i;
      clearance4_q   <= clearance_i;
      facing_away5_q <= facing_away4_q;
      sorted5_q      <= sorted4_q;
      clearance5_q   <= clearance4_q;
    end
  end

  // ---- Head read. far + clearance < d_a is far < limit; of a voxel that needs no look, any head will do ----
  logic [D-1:0] limit;
  assign limit        = (depth > clearance5_q) ? depth - clearance5_q : '0;
  assign read_valid_o = valid5_q;
  assign read_index_o = {v[PLACE-1:SUB_BITS], u[PLACE-1:SUB_BITS]};
  assign read_tag_o   = {facing_away5_q, off_plane, sorted5_q, limit, v, u};

  // ---- The head is known ----
  logic                  dropped, linked, head_facing, head_off, head_sorted, uncertain, walked;
  logic [D-1:0]          nearest, head_limit;
  logic [NODES_LOG2-1:0] first;
  logic [PLACE-1:0]      head_u, head_v;
  assign {dropped, linked, nearest, first}                           = head_i;
  assign {head_facing, head_off, head_sorted, head_limit, head_v, head_u} = head_tag_i;
  assign uncertain = !head_facing && !head_off && head_present_i && nearest < head_limit;
  assign walked    = uncertain && linked;

  logic                  walk_ready, walk_free, order_ready, order_idle, may_walk, done;
  logic [WALKS_LOG2-1:0] walk, done_walk;
  topology_pkg::walk_t   done_result;
  assign may_walk     = !walked || (walk_free && walk_ready);
  assign head_ready_o = order_ready && may_walk;
  topology_order #(.WALKS_LOG2(WALKS_LOG2)) u_order (
    .clk_i, .rst_ni, .voxel_valid_i(head_valid_i && may_walk), .voxel_ready_o(order_ready),
    .facing_away_i(head_facing), .off_plane_i(head_off && !head_facing), .uncertain_i(uncertain), .walked_i(walked),
    .dropped_i(uncertain && dropped), .walk_free_o(walk_free), .walk_o(walk), .done_i(done), .done_walk_i(done_walk),
    .done_result_i(done_result), .result_valid_o, .result_ready_i, .result_o, .idle_o(order_idle)
  );
  topology_walker #(
    .DEPTH_BITS(D), .PLANE_LOG2(PLANE_LOG2), .SUB_BITS(SUB_BITS), .SPAN_LOG2(SPAN_LOG2), .NODES_LOG2(NODES_LOG2),
    .QUADS_LOG2(QUADS_LOG2), .WALKS_LOG2(WALKS_LOG2)
  ) u_walker (
    .clk_i, .rst_ni, .walk_valid_i(head_valid_i && walked && walk_free && order_ready), .walk_ready_o(walk_ready),
    .walk_i(walk), .first_i(first), .u_i(head_u), .v_i(head_v), .limit_i(head_limit), .sorted_i(head_sorted),
    .ask_valid_o, .ask_ready_i, .ask_index_o, .ask_tag_o, .node_valid_i, .node_ready_o, .node_i, .node_tag_i,
    .fetch_valid_o, .fetch_ready_i, .fetch_index_o, .fetch_tag_o, .record_valid_i, .record_i, .record_tag_i,
    .done_o(done), .done_walk_o(done_walk), .done_result_o(done_result), .visited_o, .tested_o
  );

  assign idle_o = !valid4_q && !valid5_q && order_idle;  // and no head is being read

  `GNOMON_ASSERT_STREAM(a_read_stable, read_valid_o, read_ready_i, {read_index_o, read_tag_o})
  `GNOMON_ASSERT(a_list_or_dropped, !(head_valid_i && uncertain) || linked || dropped)

endmodule
