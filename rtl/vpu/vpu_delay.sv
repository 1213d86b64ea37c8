// SPDX-License-Identifier: Apache-2.0
// Delays a value by CYCLES enabled cycles, in a ring of words: few of its bits move. Not reset but for its position;
// whatever travels beside it says when it is valid.

module vpu_delay #(
  parameter int unsigned WIDTH  = 32,
  parameter int unsigned CYCLES = 8   // 2 or more
) (
  input  logic             clk_i,
  input  logic             rst_ni,
  input  logic             en_i,
  input  logic [WIDTH-1:0] data_i,
  output logic [WIDTH-1:0] data_o
);

  localparam int unsigned INDEX = $clog2(CYCLES);
  localparam logic [INDEX-1:0] LAST = INDEX'(CYCLES - 1);

  logic [WIDTH-1:0] words_q [CYCLES];
  logic [INDEX-1:0] index_q;
  assign data_o = words_q[index_q];
  always_ff @(posedge clk_i) begin
    if (!rst_ni)   index_q <= '0;
    else if (en_i) index_q <= (index_q == LAST) ? '0 : index_q + 1'b1;
  end
  always_ff @(posedge clk_i) begin
    if (en_i) words_q[index_q] <= data_i;
  end

endmodule
