// SPDX-License-Identifier: Apache-2.0
// AXI4-Lite slave for 32-bit registers: turns accesses into one write or one look at a time. Writes with missing strobes,
// addresses that are not a multiple of 4 and registers that do not exist are answered by SLVERR.

`include "assertions.svh"

module axil_slave (
  input  logic        clk_i,
  input  logic        rst_ni,
  input  logic        s_axil_awvalid_i,
  output logic        s_axil_awready_o,
  input  logic [11:0] s_axil_awaddr_i,
  input  logic        s_axil_wvalid_i,
  output logic        s_axil_wready_o,
  input  logic [31:0] s_axil_wdata_i,
  input  logic [3:0]  s_axil_wstrb_i,
  output logic        s_axil_bvalid_o,
  input  logic        s_axil_bready_i,
  output logic [1:0]  s_axil_bresp_o,
  input  logic        s_axil_arvalid_i,
  output logic        s_axil_arready_o,
  input  logic [11:0] s_axil_araddr_i,
  output logic        s_axil_rvalid_o,
  input  logic        s_axil_rready_i,
  output logic [31:0] s_axil_rdata_o,
  output logic [1:0]  s_axil_rresp_o,
  // Registers: combinational answers.
  output logic        write_o,         // a good write happens in this cycle, if the register is known
  output logic [11:0] write_offset_o,
  output logic [31:0] write_data_o,
  input  logic        write_known_i,
  output logic [11:0] read_offset_o,
  input  logic [31:0] read_data_i,
  input  logic        read_known_i
);

  localparam logic [1:0] OKAY   = 2'b00;
  localparam logic [1:0] SLVERR = 2'b10;

  // ---- Writes: address and data are kept until both are there and the answer before is taken ----
  logic        aw_valid_q, w_valid_q, b_valid_q, whole_q, give_b, write_good;
  logic [11:0] aw_q;
  logic [31:0] w_q;
  logic [1:0]  b_q;
  assign s_axil_awready_o = !aw_valid_q;
  assign s_axil_wready_o  = !w_valid_q;
  assign s_axil_bvalid_o  = b_valid_q;
  assign s_axil_bresp_o   = b_q;
  assign give_b           = aw_valid_q && w_valid_q && (!b_valid_q || s_axil_bready_i);
  assign write_good       = whole_q && aw_q[1:0] == 2'b00;
  assign write_o          = give_b && write_good;
  assign write_offset_o   = aw_q;
  assign write_data_o     = w_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      aw_valid_q <= 1'b0;
      w_valid_q  <= 1'b0;
      b_valid_q  <= 1'b0;
    end else begin
      if (s_axil_awvalid_i && s_axil_awready_o) aw_valid_q <= 1'b1;
      else if (give_b)                          aw_valid_q <= 1'b0;
      if (s_axil_wvalid_i && s_axil_wready_o)   w_valid_q <= 1'b1;
      else if (give_b)                          w_valid_q <= 1'b0;
      if (give_b)                               b_valid_q <= 1'b1;
      else if (s_axil_bready_i)                 b_valid_q <= 1'b0;
    end
  end
  always_ff @(posedge clk_i) begin
    if (s_axil_awready_o) aw_q <= s_axil_awaddr_i;
    if (s_axil_wready_o) begin
      w_q     <= s_axil_wdata_i;
      whole_q <= s_axil_wstrb_i == 4'b1111;
    end
    if (give_b) b_q <= (write_good && write_known_i) ? OKAY : SLVERR;
  end

  // ---- Reads ----
  logic        ar_valid_q, r_valid_q, give_r, read_good;
  logic [11:0] ar_q;
  logic [31:0] r_data_q;
  logic [1:0]  r_q;
  assign s_axil_arready_o = !ar_valid_q;
  assign s_axil_rvalid_o  = r_valid_q;
  assign s_axil_rdata_o   = r_data_q;
  assign s_axil_rresp_o   = r_q;
  assign give_r           = ar_valid_q && (!r_valid_q || s_axil_rready_i);
  assign read_good        = read_known_i && ar_q[1:0] == 2'b00;
  assign read_offset_o    = ar_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      ar_valid_q <= 1'b0;
      r_valid_q  <= 1'b0;
    end else begin
      if (s_axil_arvalid_i && s_axil_arready_o) ar_valid_q <= 1'b1;
      else if (give_r)                          ar_valid_q <= 1'b0;
      if (give_r)                               r_valid_q <= 1'b1;
      else if (s_axil_rready_i)                 r_valid_q <= 1'b0;
    end
  end
  always_ff @(posedge clk_i) begin
    if (s_axil_arready_o) ar_q <= s_axil_araddr_i;
    if (give_r) begin
      r_data_q <= read_good ? read_data_i : '0;
      r_q      <= read_good ? OKAY : SLVERR;
    end
  end

  `GNOMON_ASSERT_STREAM(a_written_stable, s_axil_bvalid_o, s_axil_bready_i, s_axil_bresp_o)
  `GNOMON_ASSERT_STREAM(a_read_stable, s_axil_rvalid_o, s_axil_rready_i, {s_axil_rdata_o, s_axil_rresp_o})

endmodule
