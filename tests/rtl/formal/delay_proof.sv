// SPDX-License-Identifier: Apache-2.0
// Proof harness of vpu_delay: whatever comes in and whenever it moves, what leaves is what a shift register of the same
// length holds.

module delay_proof #(
  parameter int unsigned CYCLES = 3
) (
  input logic       clk_i,
  input logic       en_i,
  input logic [1:0] data_i
);

  // Reset in the first cycle, none after.
  logic running_q = 1'b0;
  always_ff @(posedge clk_i) running_q <= 1'b1;

  logic [1:0] data;
  vpu_delay #(.WIDTH(2), .CYCLES(CYCLES)) u_delay (.clk_i, .rst_ni(running_q), .en_i, .data_i, .data_o(data));

  logic [2*CYCLES-1:0] words_q;  // the youngest in the low bits
  logic [CYCLES-1:0]   known_q;
  always_ff @(posedge clk_i) begin
    if (!running_q) known_q <= '0;
    else if (en_i)  known_q <= {known_q[CYCLES-2:0], 1'b1};
    if (en_i) words_q <= {words_q[2*CYCLES-3:0], data_i};
  end

  always_ff @(posedge clk_i) begin
    if (running_q) begin
      a_same_word: assert (!known_q[CYCLES-1] || data == words_q[2*CYCLES-1-:2]);
      c_comes_round: cover (known_q[CYCLES-1] && data == 2'd2);
    end
  end

endmodule
