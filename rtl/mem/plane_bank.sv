// SPDX-License-Identifier: Apache-2.0
// One slot of every line of the plane: a RAM with a read port (A) and a port that reads or writes (B), the shape of a true
// dual-port block RAM. A read at A of what B writes in the same cycle gives the old word.

module plane_bank #(
  parameter int unsigned ADDRESS_BITS = 14,
  parameter int unsigned WIDTH        = 32
) (
  input  logic                    clk_i,
  input  logic                    a_read_i,
  input  logic [ADDRESS_BITS-1:0] a_address_i,
  output logic [WIDTH-1:0]        a_word_o,
  input  logic                    b_read_i,
  input  logic                    b_write_i,
  input  logic [ADDRESS_BITS-1:0] b_address_i,
  input  logic [WIDTH-1:0]        b_word_i,
  output logic [WIDTH-1:0]        b_word_o
);

  logic [WIDTH-1:0] words_q [1 << ADDRESS_BITS];

  always_ff @(posedge clk_i) begin
    if (a_read_i) a_word_o <= words_q[a_address_i];
  end

  always_ff @(posedge clk_i) begin
    if (b_write_i)     words_q[b_address_i] <= b_word_i;
    else if (b_read_i) b_word_o <= words_q[b_address_i];
  end

endmodule
