// SPDX-License-Identifier: Apache-2.0
// The plane in memory with the modify function of the project pass, behind a line port; its ports flattened for a test.

module plane_cache_bench #(
  parameter int unsigned INDEX_BITS    = 12,
  parameter int unsigned SIZE_LOG2     = 10,
  parameter int unsigned LINE_IDS_LOG2 = 4
) (
  input  logic                  clk_i,
  input  logic                  rst_ni,
  input  logic                  update_valid_i,
  output logic                  update_ready_o,
  input  logic [INDEX_BITS-1:0] update_index_i,
  input  logic [23:0]           update_depth_i,
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
  output logic                  idle_o,
  output logic [5:0]            events_o,   // hit, hit beside, miss, fill, write-back, wait for a fill
  output logic                  wrote_o,
  output cache_pkg::port_want_t lines_o,
  input  cache_pkg::port_give_t lines_i
);

  gnomon_pkg::plane_entry_t entry, entry0, entry1;
  logic [23:0]              operand, depth;
  logic                     write;
  cache_pkg::want_t         want;
  cache_pkg::give_t         give;
  cache_pkg::events_t       events;
  assign entry0_o = entry0;
  assign entry1_o = entry1;
  assign events_o = events;

  vpu_nearest u_nearest (.entry_i(entry), .depth_i(operand), .write_o(write), .depth_o(depth));

  plane_cache #(
    .INDEX_BITS(INDEX_BITS), .OPERAND_BITS(24), .TAG0_BITS(32), .TAG1_BITS(32), .SIZE_LOG2(SIZE_LOG2),
    .FIRST_LINE(64), .LINE_IDS_LOG2(LINE_IDS_LOG2)
  ) u_plane (
    .clk_i, .rst_ni, .update_valid_i, .update_ready_o, .update_index_i, .update_operand_i(update_depth_i),
    .modify_entry_o(entry), .modify_operand_o(operand), .modify_write_i(write), .modify_depth_i(depth), .wrote_o,
    .read0_valid_i, .read0_ready_o, .read0_index_i, .read0_tag_i, .entry0_valid_o, .entry0_ready_i, .entry0_o(entry0),
    .entry0_tag_o, .read1_valid_i, .read1_ready_o, .read1_index_i, .read1_tag_i, .entry1_valid_o, .entry1_ready_i,
    .entry1_o(entry1), .entry1_tag_o, .clear_valid_i, .clear_ready_o, .idle_o, .want_o(want), .give_i(give),
    .events_o(events)
  );
  cache_port #(.CLIENTS(1), .LINE_IDS_LOG2(LINE_IDS_LOG2)) u_port (
    .clk_i, .rst_ni, .base_i(52'h8_0010), .want_i(want), .give_o(give), .port_o(lines_o), .port_i(lines_i)
  );

endmodule
