// SPDX-License-Identifier: Apache-2.0
// Results in the order of the voxels: voxels wait in a queue, those that are walked for until their walk is done. Gives
// out the numbers of walks, in order too.

`include "assertions.svh"

module topology_order #(
  parameter int unsigned WALKS_LOG2     = 6,
  parameter bit          EN_PERSPECTIVE = 1'b0
) (
  input  logic                           clk_i,
  input  logic                           rst_ni,
  // A voxel; one that is walked for is taken only if a number is free.
  input  logic                           voxel_valid_i,
  output logic                           voxel_ready_o,
  input  logic                           unreached_i, behind_i,  // nothing else is set then
  input  logic                           facing_away_i, off_plane_i, uncertain_i, walked_i, dropped_i,
  output logic                           walk_free_o,
  output logic [WALKS_LOG2-1:0]          walk_o,        // number of the next walk
  // A walk is done.
  input  logic                           done_i,
  input  logic [WALKS_LOG2-1:0]          done_walk_i,
  input  topology_pkg::walk_t            done_result_i,
  output logic                           result_valid_o,
  input  logic                           result_ready_i,
  output topology_pkg::topology_result_t result_o,
  output logic                           idle_o
);

  localparam int unsigned W          = WALKS_LOG2;
  localparam int unsigned ORDER_LOG2 = W + 2;  // voxels that need no walk take little room
  localparam int unsigned WALK       = 1 + topology_pkg::NUMBER_BITS + 2 * topology_pkg::COUNT_BITS;

  localparam int unsigned WAITS = EN_PERSPECTIVE ? 7 : 5;  // bits of a voxel that waits
  logic [WAITS-1:0] waits, waiting;
  logic unreached, behind, order_valid, facing_away, off_plane, uncertain, walked, dropped, give;
  assign waits[4:0] = {facing_away_i, off_plane_i, uncertain_i, walked_i, dropped_i};
  assign {facing_away, off_plane, uncertain, walked, dropped} = waiting[4:0];
  if (EN_PERSPECTIVE) begin : gen_reach
    assign waits[6:5]          = {unreached_i, behind_i};
    assign {unreached, behind} = waiting[6:5];
  end else begin : gen_no_reach
    assign {unreached, behind} = '0;
    logic unused_reach;
    assign unused_reach = unreached_i ^ behind_i;
  end
  stream_fifo #(.WIDTH(WAITS), .DEPTH_LOG2(ORDER_LOG2)) u_order (
    .clk_i, .rst_ni, .valid_i(voxel_valid_i), .ready_o(voxel_ready_o), .data_i(waits), .valid_o(order_valid),
    .ready_i(give), .data_o(waiting)
  );

  // ---- Walks, by number: a ring ----
  logic [W:0]          next_q, oldest_q;  // one bit more than a number tells all from none
  logic [(1 << W)-1:0] done_q;
  logic [WALK-1:0]     results_q [1 << W];
  logic                begin_walk, end_walk;
  assign walk_free_o = (next_q ^ oldest_q) != (W + 1)'(1 << W);
  assign walk_o      = next_q[W-1:0];
  assign begin_walk  = voxel_valid_i && voxel_ready_o && walked_i;
  assign end_walk    = give && walked;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      next_q   <= '0;
      oldest_q <= '0;
      done_q   <= '0;
    end else begin
      if (begin_walk) next_q <= next_q + 1'b1;
      if (end_walk) begin
        oldest_q                <= oldest_q + 1'b1;
        done_q[oldest_q[W-1:0]] <= 1'b0;
      end
      if (done_i) done_q[done_walk_i] <= 1'b1;
    end
  end
  always_ff @(posedge clk_i) begin
    if (done_i) results_q[done_walk_i] <= done_result_i;
  end

  // ---- Result ----
  topology_pkg::walk_t walk;
  logic                shadow;
  assign walk           = results_q[oldest_q[W-1:0]];
  assign result_valid_o = order_valid && (!walked || done_q[oldest_q[W-1:0]]);
  assign give           = result_valid_o && result_ready_i;
  assign shadow         = unreached || facing_away || (walked && walk.hit) || dropped;
  always_comb begin
    result_o.code        = topology_pkg::RESULT_TOPOLOGY_STATE;
    result_o.state       = shadow ? gnomon_pkg::STATE_SHADOW : gnomon_pkg::STATE_LIT;
    result_o.facing_away = facing_away;
    result_o.off_plane   = off_plane;
    result_o.uncertain   = uncertain;
    result_o.hit         = walked && walk.hit;
    result_o.fallback    = behind || (dropped && !result_o.hit);
    result_o.unreached   = unreached;
    result_o.quad        = walked ? walk.quad : '1;
    result_o.visited     = walked ? walk.visited : '0;
    result_o.tested      = walked ? walk.tested : '0;
  end
  assign idle_o = !order_valid;

  `GNOMON_ASSERT(a_walk_is_free, !begin_walk || walk_free_o)
  `GNOMON_ASSERT(a_done_once, !done_i || !done_q[done_walk_i])
  `GNOMON_ASSERT(a_unreached_is_all, !voxel_valid_i || !unreached_i || !(facing_away_i || off_plane_i || uncertain_i))
  `GNOMON_ASSERT(a_dropped_is_uncertain, !voxel_valid_i || !dropped_i || uncertain_i)
  `GNOMON_ASSERT_STREAM(a_result_stable, result_valid_o, result_ready_i, result_o)

endmodule
