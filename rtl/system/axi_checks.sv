// SPDX-License-Identifier: Apache-2.0
// Assertions on an AXI master's ports: what is offered stays, bursts are whole beats of INCR within 4 KiB, as many beats as
// their address said. Nothing but assertions: synthesis leaves it empty.

`include "assertions.svh"

module axi_checks #(
  parameter int unsigned AXI_DATA_BITS = 64,
  parameter int unsigned ID_BITS       = 6
) (
  input logic                       clk_i,
  input logic                       rst_ni,
  input logic                       arvalid_i,
  input logic                       arready_i,
  input logic [ID_BITS-1:0]         arid_i,
  input logic [63:0]                araddr_i,
  input logic [7:0]                 arlen_i,
  input logic [2:0]                 arsize_i,
  input logic [1:0]                 arburst_i,
  input logic                       awvalid_i,
  input logic                       awready_i,
  input logic [ID_BITS-1:0]         awid_i,
  input logic [63:0]                awaddr_i,
  input logic [7:0]                 awlen_i,
  input logic [2:0]                 awsize_i,
  input logic [1:0]                 awburst_i,
  input logic                       wvalid_i,
  input logic                       wready_i,
  input logic [AXI_DATA_BITS-1:0]   wdata_i,
  input logic [AXI_DATA_BITS/8-1:0] wstrb_i,
  input logic                       wlast_i
);

  localparam int unsigned BYTES_LOG2 = $clog2(AXI_DATA_BITS / 8);
  localparam logic [1:0]  INCR       = 2'b01;

  // Bytes from the page's start to the burst's end.
  logic [16:0] ar_end, aw_end;
  assign ar_end = {5'd0, araddr_i[11:0]} + ((17'(arlen_i) + 17'd1) << BYTES_LOG2);
  assign aw_end = {5'd0, awaddr_i[11:0]} + ((17'(awlen_i) + 17'd1) << BYTES_LOG2);

  // Beats of the burst whose address is offered or was taken last: data do not come before their address here.
  logic [7:0] beat_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni)                  beat_q <= '0;
    else if (wvalid_i && wready_i) beat_q <= wlast_i ? '0 : beat_q + 8'd1;
  end
  logic [7:0] len_q, len;
  always_ff @(posedge clk_i) if (awvalid_i) len_q <= awlen_i;
  assign len = awvalid_i ? awlen_i : len_q;

  `GNOMON_ASSERT_STREAM(a_ar_stable, arvalid_i, arready_i, {arid_i, araddr_i, arlen_i, arsize_i, arburst_i})
  `GNOMON_ASSERT_STREAM(a_aw_stable, awvalid_i, awready_i, {awid_i, awaddr_i, awlen_i, awsize_i, awburst_i})
  `GNOMON_ASSERT_STREAM(a_w_stable, wvalid_i, wready_i, {wdata_i, wstrb_i, wlast_i})
  `GNOMON_ASSERT(a_ar_within_page, !arvalid_i || ar_end <= 17'd4096)
  `GNOMON_ASSERT(a_aw_within_page, !awvalid_i || aw_end <= 17'd4096)
  `GNOMON_ASSERT(a_ar_whole_beats, !arvalid_i || (arsize_i == 3'(BYTES_LOG2) && araddr_i[BYTES_LOG2-1:0] == '0))
  `GNOMON_ASSERT(a_aw_whole_beats, !awvalid_i || (awsize_i == 3'(BYTES_LOG2) && awaddr_i[BYTES_LOG2-1:0] == '0))
  `GNOMON_ASSERT(a_ar_incr, !arvalid_i || arburst_i == INCR)
  `GNOMON_ASSERT(a_aw_incr, !awvalid_i || awburst_i == INCR)
  `GNOMON_ASSERT(a_w_last, !wvalid_i || wlast_i == (beat_q == len))

`ifdef SYNTHESIS
  logic unused_ports;
  assign unused_ports = ^{arready_i, awready_i};
`endif

endmodule
