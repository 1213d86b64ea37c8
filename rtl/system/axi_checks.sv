// SPDX-License-Identifier: Apache-2.0
// Assertions on an AXI master's ports: what is offered stays, bursts are whole beats of INCR within 4 KiB, as many beats as
// their address said. Nothing but assertions: synthesis leaves it empty.

`include "assertions.svh"

module axi_checks #(
  parameter int unsigned AXI_DATA_BITS = 64
) (
  input logic                       clk_i,
  input logic                       rst_ni,
  input system_pkg::axi_address_t   ar_i,
  input logic                       arready_i,
  input system_pkg::axi_address_t   aw_i,
  input logic                       awready_i,
  input logic                       wvalid_i,
  input logic                       wready_i,
  input logic [AXI_DATA_BITS-1:0]   wdata_i,
  input logic [AXI_DATA_BITS/8-1:0] wstrb_i,
  input logic                       wlast_i
);

  localparam int unsigned BYTES_LOG2 = $clog2(AXI_DATA_BITS / 8);

  // Bytes from the page's start to the burst's end.
  logic [16:0] ar_end, aw_end;
  assign ar_end = {5'd0, ar_i.addr[11:0]} + ((17'(ar_i.len) + 17'd1) << BYTES_LOG2);
  assign aw_end = {5'd0, aw_i.addr[11:0]} + ((17'(aw_i.len) + 17'd1) << BYTES_LOG2);

  // Beats of the burst whose address is offered or was taken last: data do not come before their address here.
  logic [7:0] beat_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni)                  beat_q <= '0;
    else if (wvalid_i && wready_i) beat_q <= wlast_i ? '0 : beat_q + 8'd1;
  end
  logic [7:0] len_q, len;
  always_ff @(posedge clk_i) if (aw_i.valid) len_q <= aw_i.len;
  assign len = aw_i.valid ? aw_i.len : len_q;

  `GNOMON_ASSERT_STREAM(a_ar_stable, ar_i.valid, arready_i, ar_i)
  `GNOMON_ASSERT_STREAM(a_aw_stable, aw_i.valid, awready_i, aw_i)
  `GNOMON_ASSERT_STREAM(a_w_stable, wvalid_i, wready_i, {wdata_i, wstrb_i, wlast_i})
  `GNOMON_ASSERT(a_ar_within_page, !ar_i.valid || ar_end <= 17'd4096)
  `GNOMON_ASSERT(a_aw_within_page, !aw_i.valid || aw_end <= 17'd4096)
  `GNOMON_ASSERT(a_ar_whole_beats, !ar_i.valid || (ar_i.size == 3'(BYTES_LOG2) && ar_i.addr[BYTES_LOG2-1:0] == '0))
  `GNOMON_ASSERT(a_aw_whole_beats, !aw_i.valid || (aw_i.size == 3'(BYTES_LOG2) && aw_i.addr[BYTES_LOG2-1:0] == '0))
  `GNOMON_ASSERT(a_ar_incr, !ar_i.valid || ar_i.burst == system_pkg::INCR)
  `GNOMON_ASSERT(a_aw_incr, !aw_i.valid || aw_i.burst == system_pkg::INCR)
  `GNOMON_ASSERT(a_w_last, !wvalid_i || wlast_i == (beat_q == len))

`ifdef SYNTHESIS
  logic unused_ports;
  assign unused_ports = ^{ar_i, arready_i, aw_i, awready_i};
`endif

endmodule
