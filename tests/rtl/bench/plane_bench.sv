// SPDX-License-Identifier: Apache-2.0
// The plane memory with the modify function of the project pass, its ports flattened for a test.

module plane_bench #(
  parameter int unsigned INDEX_BITS   = 8,
  parameter int unsigned READ_LATENCY = 1
) (
  input  logic                  clk_i,
  input  logic                  rst_ni,
  input  logic                  update_valid_i,
  output logic                  update_ready_o,
  input  logic [INDEX_BITS-1:0] update_index_i,
  input  logic [23:0]           update_depth_i,
  output logic                  wrote_o,
  input  logic                  read0_valid_i,
  output logic                  read0_ready_o,
  input  logic [INDEX_BITS-1:0] read0_index_i,
  input  logic [31:0]           read0_tag_i,
  output logic                  entry0_valid_o,
  input  logic                  entry0_ready_i,
  output logic [24:0]           entry0_o,
  output logic [31:0]           entry0_tag_o,
  input  logic                  read1_valid_i,
  output logic                  read1_ready_o,
  input  logic [INDEX_BITS-1:0] read1_index_i,
  input  logic [31:0]           read1_tag_i,
  output logic                  entry1_valid_o,
  input  logic                  entry1_ready_i,
  output logic [24:0]           entry1_o,
  output logic [31:0]           entry1_tag_o,
  input  logic                  clear_valid_i,
  output logic                  clear_ready_o,
  output logic                  clear_last_o,
  output logic                  idle_o
);

  gnomon_pkg::plane_entry_t entry, entry0, entry1;
  logic [23:0]              operand, depth;
  logic                     write;
  assign entry0_o = entry0;
  assign entry1_o = entry1;

  vpu_nearest u_nearest (.entry_i(entry), .depth_i(operand), .write_o(write), .depth_o(depth));

  plane_memory #(
    .INDEX_BITS(INDEX_BITS), .OPERAND_BITS(24), .TAG0_BITS(32), .TAG1_BITS(32), .READ_LATENCY(READ_LATENCY)
  ) u_plane (
    .clk_i, .rst_ni, .update_valid_i, .update_ready_o, .update_index_i, .update_operand_i(update_depth_i),
    .modify_entry_o(entry), .modify_operand_o(operand), .modify_write_i(write), .modify_depth_i(depth), .wrote_o,
    .read0_valid_i, .read0_ready_o, .read0_index_i, .read0_tag_i, .entry0_valid_o, .entry0_ready_i, .entry0_o(entry0),
    .entry0_tag_o, .read1_valid_i, .read1_ready_o, .read1_index_i, .read1_tag_i, .entry1_valid_o, .entry1_ready_i,
    .entry1_o(entry1), .entry1_tag_o, .clear_valid_i, .clear_ready_o, .clear_last_o, .idle_o
  );

endmodule
