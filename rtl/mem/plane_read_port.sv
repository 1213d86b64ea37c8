// SPDX-License-Identifier: Apache-2.0
// Read port of a memory: {index, tag} in, {entry, tag} out, in order. The tag queue bounds the reads under way, so that
// the entry queue always has room for what the RAM brings.

`include "assertions.svh"

module plane_read_port #(
  parameter int unsigned INDEX_BITS   = 18,
  parameter int unsigned TAG_BITS     = 24,
  parameter int unsigned ENTRY_BITS   = 25,
  parameter int unsigned READ_LATENCY = 1
) (
  input  logic                  clk_i,
  input  logic                  rst_ni,
  input  logic                  request_valid_i,
  output logic                  request_ready_o,
  input  logic [INDEX_BITS-1:0] request_index_i,
  input  logic [TAG_BITS-1:0]   request_tag_i,
  // Port of the RAM; `ram_free_i` says that it can be had in this cycle.
  input  logic                  ram_free_i,
  output logic                  ram_read_o,
  output logic [INDEX_BITS-1:0] ram_index_o,
  input  logic [ENTRY_BITS-1:0] ram_entry_i,
  output logic                  response_valid_o,
  input  logic                  response_ready_i,
  output logic [ENTRY_BITS-1:0] response_entry_o,
  output logic [TAG_BITS-1:0]   response_tag_o,
  output logic                  idle_o
);

  // A read at one a cycle keeps READ_LATENCY in the RAM, one in the entry queue; two to spare.
  localparam int unsigned DEPTH_LOG2 = $clog2(READ_LATENCY + 3);

  logic tag_ready, tag_valid;
  stream_fifo #(.WIDTH(TAG_BITS), .DEPTH_LOG2(DEPTH_LOG2)) u_tags (
    .clk_i,
    .rst_ni,
    .valid_i(request_valid_i && ram_free_i),
    .ready_o(tag_ready),
    .data_i (request_tag_i),
    .valid_o(tag_valid),
    .ready_i(response_valid_o && response_ready_i),
    .data_o (response_tag_o)
  );

  assign request_ready_o = tag_ready && ram_free_i;
  assign ram_read_o      = request_valid_i && request_ready_o;
  assign ram_index_o     = request_index_i;

  logic [READ_LATENCY-1:0] reading_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) reading_q <= '0;
    else         reading_q <= READ_LATENCY'({reading_q, ram_read_o});
  end

  logic entry_ready;
  stream_fifo #(.WIDTH(ENTRY_BITS), .DEPTH_LOG2(DEPTH_LOG2)) u_entries (
    .clk_i,
    .rst_ni,
    .valid_i(reading_q[READ_LATENCY-1]),
    .ready_o(entry_ready),
    .data_i (ram_entry_i),
    .valid_o(response_valid_o),
    .ready_i(response_ready_i),
    .data_o (response_entry_o)
  );

  assign idle_o = !tag_valid;

  `GNOMON_ASSERT(a_entry_has_room, !reading_q[READ_LATENCY-1] || entry_ready)
  `GNOMON_ASSERT(a_entry_has_tag, !response_valid_o || tag_valid)

endmodule
