// SPDX-License-Identifier: Apache-2.0
// Links quads into the lists of the entries of their boxes: one entry a cycle, v outer, u inner, both ascending. The
// quad's record is written beside its first entry; every entry that gets a node takes the next free one.

`include "assertions.svh"

module topology_linker #(
  parameter int unsigned DEPTH_BITS = 20,
  parameter int unsigned PLANE_LOG2 = 9,
  parameter int unsigned NODES_LOG2 = 20,
  parameter int unsigned QUADS_LOG2 = 18,
  parameter int unsigned RECORD     = 72,
  // Derived; not to be overridden. {linked, node, far, quad}
  parameter int unsigned OPERAND = topology_pkg::node_bits(DEPTH_BITS, NODES_LOG2, QUADS_LOG2)
) (
  input  logic                    clk_i,
  input  logic                    rst_ni,
  input  logic                    clear_i,         // all nodes are free; only while idle
  input  logic                    quad_valid_i,
  output logic                    quad_ready_o,
  input  logic                    storable_i,
  input  logic [QUADS_LOG2-1:0]   number_i,
  input  logic [DEPTH_BITS-1:0]   far_i,
  input  logic [PLANE_LOG2-1:0]   u_low_i, u_high_i, v_low_i, v_high_i,
  input  logic [RECORD-1:0]       record_i,
  // Quad records.
  output logic                    record_valid_o,
  input  logic                    record_ready_i,
  output logic [QUADS_LOG2-1:0]   record_index_o,
  output logic [RECORD-1:0]       record_o,
  // List heads.
  input  logic                    node_room_i,     // the node of a linked entry can be written later
  output logic                    update_valid_o,
  input  logic                    update_ready_i,
  output logic [2*PLANE_LOG2-1:0] update_index_o,
  output logic [OPERAND-1:0]      update_operand_o,
  // Events.
  output logic                    linked_o,
  output logic                    dropped_o
);

  logic                  begun_q, swept_q, recorded_q;  // of the quad at the input
  logic [PLANE_LOG2-1:0] u, v, u_q, v_q;
  logic [NODES_LOG2:0]   nodes_q;                       // in use
  logic                  linked, step, last, sweep_done, record_done;

  assign u      = begun_q ? u_q : u_low_i;
  assign v      = begun_q ? v_q : v_low_i;
  assign linked = storable_i && !nodes_q[NODES_LOG2];
  assign last   = u == u_high_i && v == v_high_i;

  assign update_valid_o   = quad_valid_i && !swept_q && (node_room_i || !linked);
  assign update_index_o   = {v, u};
  assign update_operand_o = {linked, nodes_q[NODES_LOG2-1:0], far_i, number_i};
  assign step             = update_valid_o && update_ready_i;

  assign record_valid_o = quad_valid_i && storable_i && !recorded_q;
  assign record_index_o = number_i;
  assign record_o       = record_i;

  assign sweep_done   = swept_q || (step && last);
  assign record_done  = !storable_i || recorded_q || record_ready_i;
  assign quad_ready_o = sweep_done && record_done;

  always_ff @(posedge clk_i) begin
    if (!rst_ni || (quad_valid_i && quad_ready_o)) begin
      begun_q    <= 1'b0;
      swept_q    <= 1'b0;
      recorded_q <= 1'b0;
    end else if (quad_valid_i) begin
      begun_q    <= begun_q || step;
      swept_q    <= sweep_done;
      recorded_q <= record_done;
    end
  end
  always_ff @(posedge clk_i) begin
    if (step) begin
      u_q <= (u == u_high_i) ? u_low_i : u + 1'b1;
      v_q <= (u == u_high_i) ? v + 1'b1 : v;
    end
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni || clear_i)  nodes_q <= '0;
    else if (step && linked) nodes_q <= nodes_q + 1'b1;
  end

  assign linked_o  = step && linked;
  assign dropped_o = step && !linked;

  `GNOMON_ASSERT(a_clear_while_idle, !(clear_i && quad_valid_i))
  `GNOMON_ASSERT_STREAM(a_update_stable, update_valid_o, update_ready_i, {update_index_o, update_operand_o})
  `GNOMON_ASSERT_STREAM(a_record_stable, record_valid_o, record_ready_i, {record_index_o, record_o})

endmodule
