// SPDX-License-Identifier: Apache-2.0
// Delays a value by a fixed number of cycles; 0 is a wire. Not reset: whatever travels beside it says when it is valid.

module delay_line #(
  parameter int unsigned WIDTH  = 1,
  parameter int unsigned CYCLES = 1
) (
  input  logic             clk_i,
  input  logic [WIDTH-1:0] data_i,
  output logic [WIDTH-1:0] data_o
);

  if (CYCLES == 0) begin : gen_wire
    logic unused_clk;
    assign unused_clk = clk_i;
    assign data_o     = data_i;
  end else begin : gen_registers
    logic [CYCLES*WIDTH-1:0] data_q;  // the youngest in the low bits
    always_ff @(posedge clk_i) data_q <= (CYCLES * WIDTH)'({data_q, data_i});
    assign data_o = data_q[(CYCLES-1)*WIDTH+:WIDTH];
  end

endmodule
