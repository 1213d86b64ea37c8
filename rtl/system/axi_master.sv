// SPDX-License-Identifier: Apache-2.0
// The one AXI4 master: reads, writes, their timeout, and the checks of its ports.

module axi_master #(
  parameter int unsigned AXI_DATA_BITS = 64,
  parameter bit          EN_LINES      = 1'b0,  // the cache's line port is used
  parameter int unsigned LINE_IDS_LOG2 = 4,
  // Derived; not to be overridden.
  parameter int unsigned ID_BITS       = LINE_IDS_LOG2 + 2
) (
  input  logic                       clk_i,
  input  logic                       rst_ni,
  input  logic                       core_rst_ni,
  input  logic                       may_start_i,
  input  logic                       epoch_i,
  input  logic                       give_up_i,
  input  logic [31:0]                timeout_i,
  output logic                       pending_o,
  output logic                       late_o,
  output logic                       active_o,          // a transaction is asked for or under way
  output logic                       moved_o,           // a channel moves
  output system_pkg::fault_t         read_fault_o,
  output system_pkg::fault_t         write_fault_o,
  output system_pkg::fault_t         timeout_fault_o,
  // Users: see axi_read and axi_write.
  input  logic                       descriptor_valid_i,
  output logic                       descriptor_ready_o,
  input  logic                       descriptor_active_i,
  input  logic [63:4]                descriptor_place_i,
  output logic                       descriptor_beat_o,
  input  logic                       command_valid_i,
  output logic                       command_ready_o,
  input  logic [63:3]                command_address_i,
  input  logic [6:0]                 command_words_i,
  input  logic                       command_active_i,
  input  logic [63:0]                command_oldest_i,
  output logic                       command_beat_o,
  output logic [AXI_DATA_BITS-1:0]   beat_o,
  output logic                       beat_last_o,
  input  logic                       result_valid_i,
  output logic                       result_ready_o,
  input  logic [63:6]                result_line_i,
  input  logic [2:0]                 result_first_i,
  input  logic [2:0]                 result_last_i,
  input  logic [511:0]               result_data_i,
  output logic                       result_written_o,
  input  logic                       result_active_i,
  input  logic [63:0]                result_oldest_i,
  input  logic                       completion_valid_i,
  output logic                       completion_ready_o,
  input  logic [127:0]               completion_i,
  output logic                       completion_written_o,
  input  logic                       completion_active_i,
  // Line port of the cache.
  input  cache_pkg::port_want_t      lines_i,
  output cache_pkg::port_give_t      lines_o,
  // AXI.
  output logic                       m_axi_arvalid_o,
  input  logic                       m_axi_arready_i,
  output logic [ID_BITS-1:0]         m_axi_arid_o,
  output logic [63:0]                m_axi_araddr_o,
  output logic [7:0]                 m_axi_arlen_o,
  output logic [2:0]                 m_axi_arsize_o,
  output logic [1:0]                 m_axi_arburst_o,
  input  logic                       m_axi_rvalid_i,
  output logic                       m_axi_rready_o,
  input  logic [ID_BITS-1:0]         m_axi_rid_i,
  input  logic [AXI_DATA_BITS-1:0]   m_axi_rdata_i,
  input  logic [1:0]                 m_axi_rresp_i,
  input  logic                       m_axi_rlast_i,
  output logic                       m_axi_awvalid_o,
  input  logic                       m_axi_awready_i,
  output logic [ID_BITS-1:0]         m_axi_awid_o,
  output logic [63:0]                m_axi_awaddr_o,
  output logic [7:0]                 m_axi_awlen_o,
  output logic [2:0]                 m_axi_awsize_o,
  output logic [1:0]                 m_axi_awburst_o,
  output logic                       m_axi_wvalid_o,
  input  logic                       m_axi_wready_i,
  output logic [AXI_DATA_BITS-1:0]   m_axi_wdata_o,
  output logic [AXI_DATA_BITS/8-1:0] m_axi_wstrb_o,
  output logic                       m_axi_wlast_o,
  input  logic                       m_axi_bvalid_i,
  output logic                       m_axi_bready_o,
  input  logic [ID_BITS-1:0]         m_axi_bid_i,
  input  logic [1:0]                 m_axi_bresp_i
);

  localparam logic [2:0] SIZE = 3'($clog2(AXI_DATA_BITS / 8));
  localparam logic [1:0] INCR = 2'b01;

  logic        read_pending, read_late, read_active, write_pending, write_late, write_active;
  logic [63:0] read_address, write_address;
  axi_read #(.AXI_DATA_BITS(AXI_DATA_BITS), .EN_LINES(EN_LINES), .LINE_IDS_LOG2(LINE_IDS_LOG2)) u_read (
    .clk_i, .rst_ni, .core_rst_ni, .may_start_i, .epoch_i, .give_up_i, .pending_o(read_pending), .late_o(read_late),
    .descriptor_valid_i, .descriptor_ready_o, .descriptor_active_i, .descriptor_place_i, .descriptor_beat_o,
    .command_valid_i, .command_ready_o, .command_address_i, .command_words_i, .command_active_i, .command_oldest_i,
    .command_beat_o, .beat_o, .beat_last_o, .lines_i, .line_read_ready_o(lines_o.read_ready),
    .line_data_valid_o(lines_o.data_valid), .line_data_id_o(lines_o.data_id), .line_data_o(lines_o.data), .m_axi_arvalid_o,
    .m_axi_arready_i, .m_axi_arid_o, .m_axi_araddr_o, .m_axi_arlen_o, .m_axi_rvalid_i, .m_axi_rid_i, .m_axi_rdata_i,
    .m_axi_rresp_i, .m_axi_rlast_i, .active_o(read_active), .active_address_o(read_address), .fault_o(read_fault_o)
  );
  axi_write #(.AXI_DATA_BITS(AXI_DATA_BITS), .EN_LINES(EN_LINES), .LINE_IDS_LOG2(LINE_IDS_LOG2)) u_write (
    .clk_i, .rst_ni, .core_rst_ni, .may_start_i, .epoch_i, .give_up_i, .pending_o(write_pending), .late_o(write_late),
    .result_valid_i, .result_ready_o, .result_line_i, .result_first_i, .result_last_i, .result_data_i,
    .result_written_o, .result_active_i, .result_oldest_i, .completion_valid_i, .completion_ready_o,
    .completion_place_i(descriptor_place_i), .completion_i, .completion_written_o, .completion_active_i,
    .lines_i, .line_write_ready_o(lines_o.write_ready), .line_written_valid_o(lines_o.written_valid),
    .line_written_id_o(lines_o.written_id), .m_axi_awvalid_o, .m_axi_awready_i, .m_axi_awid_o,
    .m_axi_awaddr_o, .m_axi_awlen_o, .m_axi_wvalid_o, .m_axi_wready_i, .m_axi_wdata_o, .m_axi_wstrb_o, .m_axi_wlast_o,
    .m_axi_bvalid_i, .m_axi_bid_i, .m_axi_bresp_i, .active_o(write_active), .active_address_o(write_address),
    .fault_o(write_fault_o)
  );
  assign m_axi_arsize_o  = SIZE;
  assign m_axi_awsize_o  = SIZE;
  assign m_axi_arburst_o = mutations_pkg::AXI_FIXED_BURST ? 2'b00 : INCR;
  assign m_axi_awburst_o = INCR;
  // Room for answers is there before the request goes out.
  assign m_axi_rready_o  = 1'b1;
  assign m_axi_bready_o  = 1'b1;
  assign pending_o       = read_pending || write_pending;
  assign late_o          = read_late || write_late;
  assign active_o        = read_active || write_active;

  assign moved_o = (m_axi_arvalid_o && m_axi_arready_i) || m_axi_rvalid_i || (m_axi_awvalid_o && m_axi_awready_i) ||
                   (m_axi_wvalid_o && m_axi_wready_i) || m_axi_bvalid_i;
  axi_timeout u_timeout (
    .clk_i, .rst_ni, .watch_i(active_o && may_start_i), .moved_i(moved_o), .limit_i(timeout_i),
    .address_i(read_active ? read_address : write_address), .fault_o(timeout_fault_o)
  );

  axi_checks #(.AXI_DATA_BITS(AXI_DATA_BITS), .ID_BITS(ID_BITS)) u_checks (
    .clk_i, .rst_ni, .arvalid_i(m_axi_arvalid_o), .arready_i(m_axi_arready_i), .arid_i(m_axi_arid_o),
    .araddr_i(m_axi_araddr_o), .arlen_i(m_axi_arlen_o), .arsize_i(m_axi_arsize_o), .arburst_i(m_axi_arburst_o),
    .awvalid_i(m_axi_awvalid_o), .awready_i(m_axi_awready_i), .awid_i(m_axi_awid_o), .awaddr_i(m_axi_awaddr_o),
    .awlen_i(m_axi_awlen_o), .awsize_i(m_axi_awsize_o), .awburst_i(m_axi_awburst_o), .wvalid_i(m_axi_wvalid_o),
    .wready_i(m_axi_wready_i), .wdata_i(m_axi_wdata_o), .wstrb_i(m_axi_wstrb_o), .wlast_i(m_axi_wlast_o)
  );

endmodule
