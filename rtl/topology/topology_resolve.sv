// SPDX-License-Identifier: Apache-2.0
// RESOLVE_TOPOLOGY from the lifted point on: the beam, the read of its entry's head, then a result or a walk.

`include "assertions.svh"

module topology_resolve #(
  parameter int unsigned DEPTH_BITS       = 20,
  parameter int unsigned PLANE_LOG2       = 9,
  parameter bit          EN_PERSPECTIVE   = 1'b0,
  parameter int unsigned SUB_BITS         = 4,
  parameter int unsigned SPAN_LOG2        = 4,
  parameter int unsigned NODES_LOG2       = 20,
  parameter int unsigned QUADS_LOG2       = 18,
  parameter int unsigned WALKS_LOG2       = 6,
  // Derived; not to be overridden.
  parameter int unsigned FINE     = gnomon_pkg::place_bits(PLANE_LOG2),
  parameter int unsigned PLACE    = PLANE_LOG2 + SUB_BITS,
  parameter int unsigned HEAD     = topology_pkg::head_bits(DEPTH_BITS, NODES_LOG2),
  parameter int unsigned HEAD_TAG = topology_pkg::head_tag_bits(EN_PERSPECTIVE, DEPTH_BITS, PLACE),
  parameter int unsigned NODE     = topology_pkg::node_bits(DEPTH_BITS, NODES_LOG2, QUADS_LOG2),
  parameter int unsigned NODE_TAG = 2 * topology_pkg::COUNT_BITS + WALKS_LOG2,
  parameter int unsigned RECORD     = topology_pkg::record_bits(SUB_BITS, SPAN_LOG2),
  parameter int unsigned RECORD_TAG = NODE_TAG + 1 + NODES_LOG2 + QUADS_LOG2
) (
  input  logic                                      clk_i,
  input  logic                                      rst_ni,
  // A voxel with its lifted point.
  input  logic                                      valid_i,
  input  logic                                      behind_i,
  input  logic                                      outside_cone_i,
  input  logic                                      facing_away_i,
  input  logic                                      sorted_i,
  input  logic [DEPTH_BITS-1:0]                     clearance_i,
  input  logic signed [FINE-1:0]                    u_moved_i, v_moved_i,
  input  logic [DEPTH_BITS-1:0]                     depth_moved_i,
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

  // ---- The beam, floored to sub-entries ----
  localparam int unsigned DROP = gnomon_pkg::PLACE_FRAC_BITS - SUB_BITS;
  logic             off_plane, unused_fraction;
  logic [PLACE-1:0] u, v;
  assign u               = u_moved_i[DROP+:PLACE];
  assign v               = v_moved_i[DROP+:PLACE];
  assign off_plane       = u_moved_i[FINE-1:DROP+PLACE] != '0 || v_moved_i[FINE-1:DROP+PLACE] != '0;
  assign unused_fraction = ^{u_moved_i[DROP-1:0], v_moved_i[DROP-1:0]};

  // ---- Head read. far + clearance < d_a is far < limit; of a voxel that needs no look, any head will do ----
  logic [D-1:0] limit;
  assign limit        = (depth_moved_i > clearance_i) ? depth_moved_i - clearance_i : '0;
  assign read_valid_o = valid_i;
  assign read_index_o = {v[PLACE-1:SUB_BITS], u[PLACE-1:SUB_BITS]};
  assign read_tag_o[D+2*PLACE+2:0] = {facing_away_i, off_plane, sorted_i, limit, v, u};

  // ---- What the light does not reach ----
  logic head_unreached, head_behind;
  if (EN_PERSPECTIVE) begin : gen_reach
    assign read_tag_o[HEAD_TAG-1-:2]     = {behind_i || outside_cone_i, behind_i};
    assign {head_unreached, head_behind} = head_tag_i[HEAD_TAG-1-:2];
  end else begin : gen_no_reach
    assign {head_unreached, head_behind} = '0;
    logic unused_reach;
    assign unused_reach = behind_i ^ outside_cone_i;
  end

  // ---- The head is known ----
  logic                  dropped, linked, head_facing, head_off, head_sorted, uncertain, walked;
  logic [D-1:0]          nearest, head_limit;
  logic [NODES_LOG2-1:0] first;
  logic [PLACE-1:0]      head_u, head_v;
  assign {dropped, linked, nearest, first}                           = head_i;
  assign {head_facing, head_off, head_sorted, head_limit, head_v, head_u} = head_tag_i[D+2*PLACE+2:0];
  assign uncertain = !head_unreached && !head_facing && !head_off && head_present_i && nearest < head_limit;
  assign walked    = uncertain && linked;

  logic                  walk_ready, walk_free, order_ready, order_idle, may_walk, done;
  logic [WALKS_LOG2-1:0] walk, done_walk;
  topology_pkg::walk_t   done_result;
  assign may_walk     = !walked || (walk_free && walk_ready);
  assign head_ready_o = order_ready && may_walk;
  topology_order #(.WALKS_LOG2(WALKS_LOG2), .EN_PERSPECTIVE(EN_PERSPECTIVE)) u_order (
    .clk_i, .rst_ni, .voxel_valid_i(head_valid_i && may_walk), .voxel_ready_o(order_ready),
    .unreached_i(head_unreached), .behind_i(head_behind), .facing_away_i(head_facing && !head_unreached),
    .off_plane_i(head_off && !head_facing && !head_unreached), .uncertain_i(uncertain), .walked_i(walked),
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

  assign idle_o = order_idle;  // and no head is being read

  `GNOMON_ASSERT_STREAM(a_read_stable, read_valid_o, read_ready_i, {read_index_o, read_tag_o})
  `GNOMON_ASSERT(a_list_or_dropped, !(head_valid_i && uncertain) || linked || dropped)

endmodule
