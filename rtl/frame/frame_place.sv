// SPDX-License-Identifier: Apache-2.0
// Where the state of a voxel item lies: its brick and the place in it (docs/frame-buffer.md, "Memory"). Combinational.

module frame_place #(
  parameter int unsigned VOXEL_BITS      = 8,
  parameter int unsigned VOXEL_FRAC_BITS = 2,
  parameter int unsigned LAYERS_LOG2     = 0,
  // Derived; not to be overridden.
  parameter int unsigned INDEX = frame_pkg::index_bits(VOXEL_BITS, LAYERS_LOG2)
) (
  input  logic [63:0]                      item_i,
  input  logic [frame_pkg::LAYER_BITS-1:0] layer_i,
  output logic [INDEX-1:0]                 index_o,
  output logic [frame_pkg::PLACE_BITS-1:0] place_o
);

  localparam int unsigned V = VOXEL_BITS;
  localparam int unsigned F = VOXEL_FRAC_BITS;
  localparam int unsigned P = V + F;

  // The fraction is dropped: floor.
  logic [V-1:0] x, y, z;
  assign x = item_i[F+:V];
  assign y = item_i[P+F+:V];
  assign z = item_i[2*P+F+:V];

  assign index_o = INDEX'({layer_i, z[V-1:2], y[V-1:2], x[V-1:2]});  // layers that do not exist are an error
  assign place_o = {z[1:0], y[1:0], x[1:0]};

  logic unused_item;
  assign unused_item = ^item_i;

endmodule
