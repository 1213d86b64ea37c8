// SPDX-License-Identifier: Apache-2.0
// The one AXI4 master: reads, writes, their timeout, and the checks of its ports.

module axi_master #(
  parameter int unsigned AXI_DATA_BITS = 64,
  parameter bit          EN_LINES      = 1'b0,  // the cache's line port is used
  parameter int unsigned LINE_IDS_LOG2 = 4
) (
  input  logic                         clk_i,
  input  logic                         rst_ni,
  input  logic                         core_rst_ni,
  input  logic                         may_start_i,
  input  logic                         epoch_i,
  input  logic                         give_up_i,
  input  logic [31:0]                  timeout_i,
  output logic                         pending_o,
  output logic                         late_o,
  output logic                         active_o,  // a transaction is asked for or under way
  output logic                         moved_o,   // a channel moves
  output system_pkg::fault_t           read_fault_o,
  output system_pkg::fault_t           write_fault_o,
  output system_pkg::fault_t           timeout_fault_o,
  // Users.
  input  system_pkg::descriptor_want_t descriptor_i,
  output system_pkg::read_give_t       descriptor_o,
  output system_pkg::write_give_t      completion_o,
  input  system_pkg::command_want_t    command_i,
  output system_pkg::read_give_t       command_o,
  output logic [AXI_DATA_BITS-1:0]     beat_o,    // of descriptors and commands
  output logic                         beat_last_o,
  input  system_pkg::result_want_t     result_i,
  input  logic [511:0]                 result_data_i,
  output system_pkg::write_give_t      result_o,
  // Line port of the cache.
  input  cache_pkg::port_want_t        lines_i,
  output cache_pkg::port_give_t        lines_o,
  // AXI. Answers are always taken: room for them is there before the request goes out.
  output system_pkg::axi_address_t     ar_o,
  input  logic                         arready_i,
  input  system_pkg::axi_answer_t      r_i,
  input  logic                         rlast_i,
  input  logic [AXI_DATA_BITS-1:0]     rdata_i,
  output system_pkg::axi_address_t     aw_o,
  input  logic                         awready_i,
  output logic                         wvalid_o,
  input  logic                         wready_i,
  output logic [AXI_DATA_BITS-1:0]     wdata_o,
  output logic [AXI_DATA_BITS/8-1:0]   wstrb_o,
  output logic                         wlast_o,
  input  system_pkg::axi_answer_t      b_i
);

  logic        read_pending, read_late, read_active, write_pending, write_late, write_active;
  logic [63:0] read_address, write_address;
  axi_read #(.AXI_DATA_BITS(AXI_DATA_BITS), .EN_LINES(EN_LINES), .LINE_IDS_LOG2(LINE_IDS_LOG2)) u_read (
    .clk_i, .rst_ni, .core_rst_ni, .may_start_i, .epoch_i, .give_up_i, .pending_o(read_pending), .late_o(read_late),
    .descriptor_i, .descriptor_o, .command_i, .command_o, .beat_o, .beat_last_o, .lines_i,
    .line_read_ready_o(lines_o.read_ready), .line_data_valid_o(lines_o.data_valid), .line_data_id_o(lines_o.data_id),
    .line_data_o(lines_o.data), .ar_o, .arready_i, .r_i, .rlast_i, .rdata_i, .active_o(read_active),
    .active_address_o(read_address), .fault_o(read_fault_o)
  );
  axi_write #(.AXI_DATA_BITS(AXI_DATA_BITS), .EN_LINES(EN_LINES), .LINE_IDS_LOG2(LINE_IDS_LOG2)) u_write (
    .clk_i, .rst_ni, .core_rst_ni, .may_start_i, .epoch_i, .give_up_i, .pending_o(write_pending), .late_o(write_late),
    .result_i, .result_data_i, .result_o, .completion_i(descriptor_i), .completion_o, .lines_i,
    .line_write_ready_o(lines_o.write_ready), .line_written_valid_o(lines_o.written_valid),
    .line_written_id_o(lines_o.written_id), .aw_o, .awready_i, .wvalid_o, .wready_i, .wdata_o, .wstrb_o, .wlast_o, .b_i,
    .active_o(write_active), .active_address_o(write_address), .fault_o(write_fault_o)
  );
  assign pending_o = read_pending || write_pending;
  assign late_o    = read_late || write_late;
  assign active_o  = read_active || write_active;

  assign moved_o = (ar_o.valid && arready_i) || r_i.valid || (aw_o.valid && awready_i) || (wvalid_o && wready_i) ||
                   b_i.valid;
  axi_timeout u_timeout (
    .clk_i, .rst_ni, .watch_i(active_o && may_start_i), .moved_i(moved_o), .limit_i(timeout_i),
    .address_i(read_active ? read_address : write_address), .fault_o(timeout_fault_o)
  );

  axi_checks #(.AXI_DATA_BITS(AXI_DATA_BITS)) u_checks (
    .clk_i, .rst_ni, .ar_i(ar_o), .arready_i, .aw_i(aw_o), .awready_i, .wvalid_i(wvalid_o), .wready_i, .wdata_i(wdata_o),
    .wstrb_i(wstrb_o), .wlast_i(wlast_o)
  );

endmodule
