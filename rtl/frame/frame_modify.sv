// SPDX-License-Identifier: Apache-2.0
// The frame buffer's modify function: the last state of a voxel counts. Combinational.

module frame_modify (
  input  logic                             present_i,     // else the brick reads as zeros
  input  logic [frame_pkg::BRICK_BITS-1:0] brick_i,
  input  frame_pkg::operand_t              operand_i,
  output logic [frame_pkg::BRICK_BITS-1:0] brick_o,
  output logic                             overwritten_o  // the voxel was not empty
);

  logic [frame_pkg::BRICK_BITS-1:0] old;
  logic [frame_pkg::STATE_BITS-1:0] old_state;
  assign old           = present_i ? brick_i : '0;
  assign old_state     = old[{operand_i.place, 1'b0}+:2];
  assign overwritten_o = old_state != frame_pkg::STATE_EMPTY;

  always_comb begin
    brick_o = old;
    if (!(mutations_pkg::FRAME_FIRST_STATE && overwritten_o)) brick_o[{operand_i.place, 1'b0}+:2] = operand_i.state;
  end

endmodule
