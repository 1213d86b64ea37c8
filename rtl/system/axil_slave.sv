// SPDX-License-Identifier: Apache-2.0
// AXI4-Lite slave for 32-bit registers: turns accesses into one write or one look at a time. Writes with missing strobes,
// addresses that are not a multiple of 4 and registers that do not exist are answered by SLVERR.

`include "assertions.svh"

module axil_slave (
  input  logic                   clk_i,
  input  logic                   rst_ni,
  input  system_pkg::axil_want_t axil_i,
  output system_pkg::axil_give_t axil_o,
  // Registers: combinational answers.
  output logic                   write_o,  // a good write happens in this cycle, if the register is known
  output logic [11:0]            write_offset_o,
  output logic [31:0]            write_data_o,
  input  logic                   write_known_i,
  output logic [11:0]            read_offset_o,
  input  logic [31:0]            read_data_i,
  input  logic                   read_known_i
);

  localparam logic [1:0] OKAY   = 2'b00;
  localparam logic [1:0] SLVERR = 2'b10;

  // ---- Writes: address and data are kept until both are there and the answer before is taken ----
  logic        aw_valid_q, w_valid_q, b_valid_q, whole_q, give_b, write_good;
  logic [11:0] aw_q;
  logic [31:0] w_q;
  logic [1:0]  b_q;
  assign axil_o.awready = !aw_valid_q;
  assign axil_o.wready  = !w_valid_q;
  assign axil_o.bvalid  = b_valid_q;
  assign axil_o.bresp   = b_q;
  assign give_b         = aw_valid_q && w_valid_q && (!b_valid_q || axil_i.bready);
  assign write_good     = whole_q && aw_q[1:0] == 2'b00;
  assign write_o        = give_b && write_good;
  assign write_offset_o = aw_q;
  assign write_data_o   = w_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      aw_valid_q <= 1'b0;
      w_valid_q  <= 1'b0;
      b_valid_q  <= 1'b0;
    end else begin
      if (axil_i.awvalid && axil_o.awready) aw_valid_q <= 1'b1;
      else if (give_b)                          aw_valid_q <= 1'b0;
      if (axil_i.wvalid && axil_o.wready)   w_valid_q <= 1'b1;
      else if (give_b)                          w_valid_q <= 1'b0;
      if (give_b)                               b_valid_q <= 1'b1;
      else if (axil_i.bready)                 b_valid_q <= 1'b0;
    end
  end
  always_ff @(posedge clk_i) begin
    if (axil_o.awready) aw_q <= axil_i.awaddr;
    if (axil_o.wready) begin
      w_q     <= axil_i.wdata;
      whole_q <= axil_i.wstrb == 4'b1111;
    end
    if (give_b) b_q <= (write_good && write_known_i) ? OKAY : SLVERR;
  end

  // ---- Reads ----
  logic        ar_valid_q, r_valid_q, give_r, read_good;
  logic [11:0] ar_q;
  logic [31:0] r_data_q;
  logic [1:0]  r_q;
  assign axil_o.arready = !ar_valid_q;
  assign axil_o.rvalid  = r_valid_q;
  assign axil_o.rdata   = r_data_q;
  assign axil_o.rresp   = r_q;
  assign give_r         = ar_valid_q && (!r_valid_q || axil_i.rready);
  assign read_good      = read_known_i && ar_q[1:0] == 2'b00;
  assign read_offset_o  = ar_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      ar_valid_q <= 1'b0;
      r_valid_q  <= 1'b0;
    end else begin
      if (axil_i.arvalid && axil_o.arready) ar_valid_q <= 1'b1;
      else if (give_r)                          ar_valid_q <= 1'b0;
      if (give_r)                               r_valid_q <= 1'b1;
      else if (axil_i.rready)                 r_valid_q <= 1'b0;
    end
  end
  always_ff @(posedge clk_i) begin
    if (axil_o.arready) ar_q <= axil_i.araddr;
    if (give_r) begin
      r_data_q <= read_good ? read_data_i : '0;
      r_q      <= read_good ? OKAY : SLVERR;
    end
  end

  `GNOMON_ASSERT_STREAM(a_written_stable, axil_o.bvalid, axil_i.bready, axil_o.bresp)
  `GNOMON_ASSERT_STREAM(a_read_stable, axil_o.rvalid, axil_i.rready, {axil_o.rdata, axil_o.rresp})

endmodule
