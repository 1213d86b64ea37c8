// SPDX-License-Identifier: Apache-2.0
// Modify function of the list heads: a quad is pushed in front of an entry's list, or dropped from it. Combinational,
// inside the heads' read-modify-write.

module topology_link #(
  parameter int unsigned DEPTH_BITS = 20,
  parameter int unsigned NODES_LOG2 = 20,
  parameter int unsigned QUADS_LOG2 = 18,
  // Derived; not to be overridden.
  parameter int unsigned HEAD = topology_pkg::head_bits(DEPTH_BITS, NODES_LOG2),
  parameter int unsigned NODE = topology_pkg::node_bits(DEPTH_BITS, NODES_LOG2, QUADS_LOG2)
) (
  input  logic                  present_i,
  input  logic [HEAD-1:0]       head_i,
  input  logic [NODE-1:0]       operand_i,     // {linked, node, far, quad}
  output logic [HEAD-1:0]       head_o,
  output logic                  node_write_o,  // else the quad is dropped
  output logic [NODES_LOG2-1:0] node_index_o,
  output logic [NODE-1:0]       node_o
);

  logic                  stored_dropped, stored_linked, dropped, linked;
  logic [DEPTH_BITS-1:0] stored_near, nearest, far;
  logic [NODES_LOG2-1:0] head;
  logic [QUADS_LOG2-1:0] quad;
  assign {stored_dropped, stored_linked, stored_near, head} = head_i;
  assign {node_write_o, node_index_o, far, quad}            = operand_i;

  // A list of an earlier generation is empty.
  assign dropped = present_i && stored_dropped;
  assign linked  = present_i && stored_linked;
  assign nearest = present_i ? stored_near : '1;

  assign head_o = {
    dropped || (!node_write_o && !mutations_pkg::TOPOLOGY_LOSE_DROPPED), linked || node_write_o,
    (far < nearest || mutations_pkg::TOPOLOGY_NEAR_LAST) ? far : nearest,
    (node_write_o && !(mutations_pkg::TOPOLOGY_KEEP_HEAD && linked)) ? node_index_o : head
  };
  assign node_o = {!linked, head, far, quad};

endmodule
