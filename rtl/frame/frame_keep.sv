// SPDX-License-Identifier: Apache-2.0
// Takes the states of a resolve pass to the frame buffer, to the results, or both. States come in the order in which the
// voxels went into the pass, so that a queue of places beside the pass is all there is to it. Words that no place waits for
// go on as they are.

`include "assertions.svh"

module frame_keep #(
  parameter int unsigned INDEX_BITS = 18,
  parameter int unsigned QUEUE_LOG2 = 6     // voxels under way; fewer than the pass holds would slow it down
) (
  input  logic                             clk_i,
  input  logic                             rst_ni,
  // A voxel is taken by the pass; only while there is room.
  input  logic                             voxel_valid_i,
  output logic                             voxel_ready_o,
  input  logic [INDEX_BITS-1:0]            index_i,
  input  logic [frame_pkg::PLACE_BITS-1:0] place_i,
  input  logic                             keep_i,
  input  logic                             quiet_i,
  // Its state, in order; the word itself goes past this module.
  input  logic                             state_valid_i,
  output logic                             state_ready_o,
  input  logic [1:0]                       state_i,
  // The word goes on to the results.
  output logic                             told_valid_o,
  input  logic                             told_ready_i,
  // The state goes to the frame buffer.
  output logic                             update_valid_o,
  input  logic                             update_ready_i,
  output logic [INDEX_BITS-1:0]            update_index_o,
  output frame_pkg::operand_t              update_operand_o,
  output logic                             idle_o
);

  logic                             waits, keep_flag, quiet_flag, keep, quiet;
  logic [frame_pkg::PLACE_BITS-1:0] place;
  stream_fifo #(.WIDTH(INDEX_BITS + frame_pkg::PLACE_BITS + 2), .DEPTH_LOG2(QUEUE_LOG2)) u_queue (
    .clk_i, .rst_ni, .valid_i(voxel_valid_i), .ready_o(voxel_ready_o), .data_i({index_i, place_i, keep_i, quiet_i}),
    .valid_o(waits), .ready_i(state_valid_i && state_ready_o), .data_o({update_index_o, place, keep_flag, quiet_flag})
  );
  assign keep  = waits && keep_flag;
  assign quiet = waits && quiet_flag;

  // Each side takes the word when it can, and only once; the word moves on when both have.
  logic kept_q, told_q, kept, told;
  assign update_valid_o         = state_valid_i && keep && (!kept_q || mutations_pkg::FRAME_KEEP_AGAIN);
  assign update_operand_o.place = place;
  assign update_operand_o.state = state_i;
  assign told_valid_o           = state_valid_i && !quiet && !told_q;
  assign kept                   = !keep || kept_q || update_ready_i;
  assign told                   = quiet || told_q || told_ready_i;
  assign state_ready_o          = kept && told;
  always_ff @(posedge clk_i) begin
    if (!rst_ni || !state_valid_i || state_ready_o) begin
      kept_q <= 1'b0;
      told_q <= 1'b0;
    end else begin
      kept_q <= kept;
      told_q <= told;
    end
  end

  assign idle_o = !waits;

  `GNOMON_ASSERT(a_voxel_has_room, !voxel_valid_i || voxel_ready_o)
  `GNOMON_ASSERT_STREAM(a_told_stable, told_valid_o, told_ready_i, 1'b1)
  `GNOMON_ASSERT_STREAM(a_update_stable, update_valid_o, update_ready_i, {update_index_o, update_operand_o})

endmodule
