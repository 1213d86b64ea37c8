// SPDX-License-Identifier: Apache-2.0
// PUT_QUADS from projected corners on: quads, a queue that evens out boxes of different sizes, the linker, and the
// writes of nodes once the old heads are known.

`include "assertions.svh"

module topology_put #(
  parameter int unsigned DEPTH_BITS  = 20,
  parameter int unsigned PLANE_LOG2  = 9,
  parameter int unsigned SUB_BITS    = 4,
  parameter int unsigned SPAN_LOG2   = 4,
  parameter int unsigned NODES_LOG2  = 20,
  parameter int unsigned QUADS_LOG2  = 18,
  parameter int unsigned ROOM_LOG2   = 3,   // nodes on their way to their memory, 2^n
  // Derived; not to be overridden.
  parameter int unsigned COORDINATE = PLANE_LOG2 + SUB_BITS + 2,
  parameter int unsigned HEAD   = topology_pkg::head_bits(DEPTH_BITS, NODES_LOG2),
  parameter int unsigned NODE   = topology_pkg::node_bits(DEPTH_BITS, NODES_LOG2, QUADS_LOG2),
  parameter int unsigned RECORD = topology_pkg::record_bits(SUB_BITS, SPAN_LOG2)
) (
  input  logic                         clk_i,
  input  logic                         rst_ni,
  input  logic                         clear_i,         // numbers of quads and nodes begin again; only while idle
  input  logic                         corner_valid_i,
  output logic                         corner_ready_o,
  input  logic                         behind_i,
  input  logic signed [COORDINATE-1:0] u_i, v_i,
  input  logic [DEPTH_BITS-1:0]        depth_i,
  input  logic                         saturated_i,
  // List heads.
  output logic                         update_valid_o,
  input  logic                         update_ready_i,
  output logic [2*PLANE_LOG2-1:0]      update_index_o,
  output logic [NODE-1:0]              update_operand_o,
  input  logic                         modify_valid_i,
  input  logic                         modify_present_i,
  input  logic [HEAD-1:0]              modify_head_i,
  input  logic [NODE-1:0]              modify_operand_i,
  output logic [HEAD-1:0]              modify_head_o,
  // Nodes and quad records.
  output logic                         node_valid_o,
  input  logic                         node_ready_i,
  output logic [NODES_LOG2-1:0]        node_index_o,
  output logic [NODE-1:0]              node_o,
  output logic                         record_valid_o,
  input  logic                         record_ready_i,
  output logic [QUADS_LOG2-1:0]        record_index_o,
  output logic [RECORD-1:0]            record_o,
  output logic                         idle_o,          // also between the corners of a quad
  // Events.
  output logic                         put_o, clipped_o, missed_o, too_large_o, saturated_o, behind_o, straddling_o,
  output logic                         linked_o, dropped_o
);

  // ---- Quads ----
  localparam int unsigned QUAD       = 1 + QUADS_LOG2 + DEPTH_BITS + 4 * PLANE_LOG2 + RECORD;
  localparam int unsigned QUEUE_LOG2 = 3;
  logic                  quad_valid, quad_ready, quad_idle, next_valid, next_ready, storable, next_storable;
  logic [QUADS_LOG2-1:0] number, next_number;
  logic [DEPTH_BITS-1:0] far, next_far;
  logic [PLANE_LOG2-1:0] u_low, u_high, v_low, v_high, next_u_low, next_u_high, next_v_low, next_v_high;
  logic [RECORD-1:0]     record, next_record;
  topology_quad #(
    .DEPTH_BITS(DEPTH_BITS), .PLANE_LOG2(PLANE_LOG2), .SUB_BITS(SUB_BITS), .SPAN_LOG2(SPAN_LOG2),
    .QUADS_LOG2(QUADS_LOG2)
  ) u_quad (
    .clk_i, .rst_ni, .clear_i, .corner_valid_i, .corner_ready_o, .behind_i, .u_i, .v_i, .depth_i, .saturated_i,
    .quad_valid_o(quad_valid), .quad_ready_i(quad_ready), .storable_o(storable), .number_o(number), .far_o(far),
    .u_low_o(u_low), .u_high_o(u_high), .v_low_o(v_low), .v_high_o(v_high), .record_o(record), .idle_o(quad_idle),
    .put_o, .clipped_o, .missed_o, .too_large_o, .saturated_o, .behind_o, .straddling_o
  );
  stream_fifo #(.WIDTH(QUAD), .DEPTH_LOG2(QUEUE_LOG2)) u_queue (
    .clk_i, .rst_ni, .valid_i(quad_valid), .ready_o(quad_ready),
    .data_i({storable, number, far, u_low, u_high, v_low, v_high, record}),
    .valid_o(next_valid), .ready_i(next_ready),
    .data_o({next_storable, next_number, next_far, next_u_low, next_u_high, next_v_low, next_v_high, next_record})
  );

  // ---- Entries. Nodes on their way take no more room than there is: an update never waits once it is taken ----
  logic [ROOM_LOG2:0] nodes_q;  // linked entries whose node is not written yet
  logic               node_room, node_given;
  assign node_room  = !nodes_q[ROOM_LOG2];
  assign node_given = node_valid_o && node_ready_i;
  always_ff @(posedge clk_i) begin
    if (!rst_ni)                      nodes_q <= '0;
    else if (linked_o && !node_given) nodes_q <= nodes_q + 1'b1;
    else if (!linked_o && node_given) nodes_q <= nodes_q - 1'b1;
  end
  topology_linker #(
    .DEPTH_BITS(DEPTH_BITS), .PLANE_LOG2(PLANE_LOG2), .NODES_LOG2(NODES_LOG2), .QUADS_LOG2(QUADS_LOG2),
    .RECORD(RECORD)
  ) u_linker (
    .clk_i, .rst_ni, .clear_i, .quad_valid_i(next_valid), .quad_ready_o(next_ready), .storable_i(next_storable),
    .number_i(next_number), .far_i(next_far), .u_low_i(next_u_low), .u_high_i(next_u_high), .v_low_i(next_v_low),
    .v_high_i(next_v_high), .record_i(next_record), .record_valid_o, .record_ready_i, .record_index_o, .record_o,
    .node_room_i(node_room), .update_valid_o, .update_ready_i, .update_index_o, .update_operand_o, .linked_o,
    .dropped_o
  );

  // ---- Nodes ----
  logic                  node_write, nodes_ready;
  logic [NODES_LOG2-1:0] node_index;
  logic [NODE-1:0]       node;
  topology_link #(.DEPTH_BITS(DEPTH_BITS), .NODES_LOG2(NODES_LOG2), .QUADS_LOG2(QUADS_LOG2)) u_link (
    .present_i(modify_present_i), .head_i(modify_head_i), .operand_i(modify_operand_i), .head_o(modify_head_o),
    .node_write_o(node_write), .node_index_o(node_index), .node_o(node)
  );
  stream_fifo #(.WIDTH(NODES_LOG2 + NODE), .DEPTH_LOG2(ROOM_LOG2)) u_nodes (
    .clk_i, .rst_ni, .valid_i(modify_valid_i && node_write), .ready_o(nodes_ready), .data_i({node_index, node}),
    .valid_o(node_valid_o), .ready_i(node_ready_i), .data_o({node_index_o, node_o})
  );

  assign idle_o = quad_idle && !next_valid && nodes_q == '0;

  `GNOMON_ASSERT(a_node_has_room, nodes_ready || !(modify_valid_i && node_write))

endmodule
