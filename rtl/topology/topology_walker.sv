// SPDX-License-Identifier: Apache-2.0
// Walks lists for many beams at once: a node visited and a quad tested a cycle, whatever the memories' latency. A walk
// is a token that goes round: queue ─► node ─► far? ─► quad record ─► test ─► queue. What it needs on its way lies in
// two tables; its end is told at once, in any order.

`include "assertions.svh"

module topology_walker #(
  parameter int unsigned DEPTH_BITS = 20,
  parameter int unsigned PLANE_LOG2 = 9,
  parameter int unsigned SUB_BITS   = 4,
  parameter int unsigned SPAN_LOG2  = 4,
  parameter int unsigned NODES_LOG2 = 20,
  parameter int unsigned QUADS_LOG2 = 18,
  parameter int unsigned WALKS_LOG2 = 6,
  // Derived; not to be overridden.
  parameter int unsigned PLACE      = PLANE_LOG2 + SUB_BITS,
  parameter int unsigned NODE       = topology_pkg::node_bits(DEPTH_BITS, NODES_LOG2, QUADS_LOG2),
  parameter int unsigned RECORD     = topology_pkg::record_bits(SUB_BITS, SPAN_LOG2),
  parameter int unsigned NODE_TAG   = 2 * topology_pkg::COUNT_BITS + WALKS_LOG2,
  parameter int unsigned RECORD_TAG = NODE_TAG + 1 + NODES_LOG2 + QUADS_LOG2
) (
  input  logic                  clk_i,
  input  logic                  rst_ni,
  // A walk begins; its number is free.
  input  logic                  walk_valid_i,
  output logic                  walk_ready_o,
  input  logic [WALKS_LOG2-1:0] walk_i,
  input  logic [NODES_LOG2-1:0] first_i,       // node
  input  logic [PLACE-1:0]      u_i, v_i,      // beam
  input  logic [DEPTH_BITS-1:0] limit_i,       // only quads with far < limit are tested
  input  logic                  sorted_i,      // the first other one ends the walk
  // Nodes.
  output logic                  ask_valid_o,
  input  logic                  ask_ready_i,
  output logic [NODES_LOG2-1:0] ask_index_o,
  output logic [NODE_TAG-1:0]   ask_tag_o,
  input  logic                  node_valid_i,
  output logic                  node_ready_o,
  input  logic [NODE-1:0]       node_i,
  input  logic [NODE_TAG-1:0]   node_tag_i,
  // Quad records; answers are always taken.
  output logic                  fetch_valid_o,
  input  logic                  fetch_ready_i,
  output logic [QUADS_LOG2-1:0] fetch_index_o,
  output logic [RECORD_TAG-1:0] fetch_tag_o,
  input  logic                  record_valid_i,
  input  logic [RECORD-1:0]     record_i,
  input  logic [RECORD_TAG-1:0] record_tag_i,
  // A walk ends.
  output logic                  done_o,
  output logic [WALKS_LOG2-1:0] done_walk_o,
  output topology_pkg::walk_t   done_result_o,
  // Events.
  output logic                  visited_o,
  output logic                  tested_o
);

  localparam int unsigned D      = DEPTH_BITS;
  localparam int unsigned W      = WALKS_LOG2;
  localparam int unsigned COUNT  = topology_pkg::COUNT_BITS;
  localparam int unsigned NUMBER = topology_pkg::NUMBER_BITS;
  localparam int unsigned TOKEN  = NODES_LOG2 + NODE_TAG;  // {node, visited, tested, walk}

  // Counts in a result stick at their last value.
  function automatic logic [COUNT-1:0] one_more(logic [COUNT-1:0] count);
    one_more = (count == '1) ? count : count + 1'b1;
  endfunction

  // ---- Tables, one line a walk: what its beam lets pass, and where it is ----
  logic [D:0]         limits_q [1 << W];
  logic [2*PLACE-1:0] places_q [1 << W];
  logic               begin_walk;
  assign begin_walk = walk_valid_i && walk_ready_o;
  always_ff @(posedge clk_i) begin
    if (begin_walk) limits_q[walk_i] <= {sorted_i, limit_i};
  end
  always_ff @(posedge clk_i) begin
    if (begin_walk) places_q[walk_i] <= {v_i, u_i};
  end

  // ---- Who asks for a node: walks that go on, in turn from two queues, because a test and a node without one may send
  // a walk on in the same cycle; new walks in the gaps, so that old ones are done soon. A choice stands until taken --
  localparam logic [1:0] PICK_NEW    = 2'd0;
  localparam logic [1:0] PICK_TESTED = 2'd1;
  localparam logic [1:0] PICK_OTHER  = 2'd2;
  logic             tested_valid, tested_ready, tested_wants, other_valid, other_ready, other_wants, hold_q;
  logic [1:0]       choice, pick, pick_q;
  logic [TOKEN-1:0] tested_token, tested_next, other_token, other_next, token;
  stream_fifo #(.WIDTH(TOKEN), .DEPTH_LOG2(W)) u_tested (
    .clk_i, .rst_ni, .valid_i(tested_valid), .ready_o(tested_ready), .data_i(tested_token), .valid_o(tested_wants),
    .ready_i(ask_ready_i && pick == PICK_TESTED), .data_o(tested_next)
  );
  stream_fifo #(.WIDTH(TOKEN), .DEPTH_LOG2(W)) u_others (
    .clk_i, .rst_ni, .valid_i(other_valid), .ready_o(other_ready), .data_i(other_token), .valid_o(other_wants),
    .ready_i(ask_ready_i && pick == PICK_OTHER), .data_o(other_next)
  );
  always_comb begin
    if (tested_wants && !(other_wants && pick_q == PICK_TESTED)) choice = PICK_TESTED;
    else if (other_wants)                                        choice = PICK_OTHER;
    else                                                         choice = PICK_NEW;
  end
  assign pick         = hold_q ? pick_q : choice;
  assign ask_valid_o  = tested_wants || other_wants || walk_valid_i;
  assign walk_ready_o = ask_ready_i && pick == PICK_NEW;
  always_comb begin
    case (pick)
      PICK_TESTED: token = tested_next;
      PICK_OTHER:  token = other_next;
      default:     token = {first_i, (2 * COUNT)'(0), walk_i};
    endcase
  end
  assign {ask_index_o, ask_tag_o} = token;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      hold_q <= 1'b0;
      pick_q <= PICK_NEW;
    end else begin
      hold_q <= ask_valid_o && !ask_ready_i;
      pick_q <= pick;
    end
  end

  // ---- A node comes: is its quad to be tested? ----
  logic                  node_last, node_sorted, nearer;
  logic [NODES_LOG2-1:0] node_next;
  logic [D-1:0]          node_far, node_limit;
  logic [QUADS_LOG2-1:0] node_quad;
  logic [COUNT-1:0]      node_visited, node_tested;
  logic [W-1:0]          node_walk;
  assign {node_last, node_next, node_far, node_quad}  = node_i;
  assign {node_visited, node_tested, node_walk}       = node_tag_i;
  assign {node_sorted, node_limit}                    = limits_q[node_walk];
  assign nearer    = node_far < node_limit;  // far + clearance < d_a
  assign visited_o = node_valid_i && node_ready_o;

  localparam int unsigned SEEN = 2 + NODES_LOG2 + QUADS_LOG2 + NODE_TAG;
  logic                  seen_valid, seen_ready, seen_nearer, seen_last;
  logic [NODES_LOG2-1:0] seen_next;
  logic [QUADS_LOG2-1:0] seen_quad;
  logic [COUNT-1:0]      seen_visited, seen_tested;
  logic [W-1:0]          seen_walk;
  stream_skid #(.WIDTH(SEEN)) u_seen (
    .clk_i, .rst_ni, .valid_i(node_valid_i), .ready_o(node_ready_o),
    .data_i({
      nearer, node_last || (node_sorted && !nearer && !mutations_pkg::TOPOLOGY_SORTED_GOES_ON), node_next,
      node_quad, one_more(node_visited), node_tested,
      node_walk
    }),
    .valid_o(seen_valid), .ready_i(seen_ready),
    .data_o({seen_nearer, seen_last, seen_next, seen_quad, seen_visited, seen_tested, seen_walk})
  );

  // ---- ... yes: fetch its record, test it ----
  assign fetch_valid_o = seen_valid && seen_nearer;
  assign fetch_index_o = seen_quad;
  assign fetch_tag_o   = {seen_last, seen_next, seen_quad, seen_visited, one_more(seen_tested), seen_walk};

  logic                  test_valid, test_hit, test_last;
  logic [PLACE-1:0]      test_u, test_v;
  logic [NODES_LOG2-1:0] test_next;
  logic [QUADS_LOG2-1:0] test_quad;
  logic [COUNT-1:0]      test_visited, test_tested;
  logic [W-1:0]          test_walk;
  assign {test_v, test_u} = places_q[record_tag_i[W-1:0]];
  topology_hit #(
    .PLANE_LOG2(PLANE_LOG2), .SUB_BITS(SUB_BITS), .SPAN_LOG2(SPAN_LOG2), .TAG_BITS(RECORD_TAG)
  ) u_hit (
    .clk_i, .rst_ni, .valid_i(record_valid_i), .record_i, .u_i(test_u), .v_i(test_v), .tag_i(record_tag_i),
    .valid_o(test_valid), .hit_o(test_hit),
    .tag_o({test_last, test_next, test_quad, test_visited, test_tested, test_walk})
  );
  assign tested_o = test_valid;

  // ---- On to the next node, or done; ends that a node told without a test wait for a gap ----
  logic             test_done, seen_end, end_valid, end_ready;
  logic [W-1:0]     end_walk;
  logic [COUNT-1:0] end_visited, end_tested;
  assign test_done    = test_valid && ((test_hit && !mutations_pkg::TOPOLOGY_NO_EARLY_EXIT) || test_last);
  assign seen_end     = !seen_nearer && seen_last;
  assign tested_valid = test_valid && !test_done;
  assign tested_token = {test_next, test_visited, test_tested, test_walk};
  assign other_valid  = seen_valid && !seen_nearer && !seen_last;
  assign other_token  = {seen_next, seen_visited, seen_tested, seen_walk};
  stream_fifo #(.WIDTH(NODE_TAG), .DEPTH_LOG2(2)) u_ends (
    .clk_i, .rst_ni, .valid_i(seen_valid && seen_end), .ready_o(end_ready),
    .data_i({seen_visited, seen_tested, seen_walk}), .valid_o(end_valid), .ready_i(!test_done),
    .data_o({end_visited, end_tested, end_walk})
  );
  always_comb begin
    if (seen_nearer)   seen_ready = fetch_ready_i;
    else if (seen_end) seen_ready = end_ready;
    else               seen_ready = 1'b1;
  end

  assign done_o      = test_done || end_valid;
  assign done_walk_o = test_done ? test_walk : end_walk;
  always_comb begin
    done_result_o.hit     = test_done && test_hit;
    done_result_o.quad    = done_result_o.hit ? NUMBER'(test_quad) : '1;
    done_result_o.visited = test_done ? test_visited : end_visited;
    done_result_o.tested  = test_done ? test_tested : end_tested;
  end

  `GNOMON_ASSERT(a_queues_have_room, (tested_ready || !tested_valid) && (other_ready || !other_valid))
  `GNOMON_ASSERT_STREAM(a_ask_stable, ask_valid_o, ask_ready_i, {ask_index_o, ask_tag_o})
  `GNOMON_ASSERT_STREAM(a_fetch_stable, fetch_valid_o, fetch_ready_i, {fetch_index_o, fetch_tag_o})

endmodule
