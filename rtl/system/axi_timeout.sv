// SPDX-License-Identifier: Apache-2.0
// A fault once nothing has moved on the bus for so many cycles while something should.

module axi_timeout (
  input  logic               clk_i,
  input  logic               rst_ni,
  input  logic               watch_i,     // a transaction is asked for or under way
  input  logic               moved_i,     // a channel moves
  input  logic [31:0]        limit_i,     // cycles; 0: for ever
  input  logic [63:0]        address_i,
  output system_pkg::fault_t fault_o
);

  logic [31:0] passed_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni || !watch_i || moved_i) passed_q <= '0;
    else if (!(&passed_q))              passed_q <= passed_q + 32'd1;
  end
  assign fault_o.valid   = watch_i && !moved_i && limit_i != '0 && passed_q >= limit_i && !mutations_pkg::AXI_NO_TIMEOUT;
  assign fault_o.code    = 8'(gnomon_registers_pkg::GNOMON_ERROR_CODE_IS_TIMEOUT);
  assign fault_o.address = address_i;

endmodule
