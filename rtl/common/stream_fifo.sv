// SPDX-License-Identifier: Apache-2.0
// First-in first-out queue of 2^DEPTH_LOG2 words. A word is seen at the output the cycle after it was taken; a full
// queue takes no word, even while one leaves, so that ready does not depend on the other side.

`include "assertions.svh"

module stream_fifo #(
  parameter int unsigned WIDTH      = 64,
  parameter int unsigned DEPTH_LOG2 = 2
) (
  input  logic             clk_i,
  input  logic             rst_ni,
  input  logic             valid_i,
  output logic             ready_o,
  input  logic [WIDTH-1:0] data_i,
  output logic             valid_o,
  input  logic             ready_i,
  output logic [WIDTH-1:0] data_o
);

  localparam int unsigned DEPTH = 1 << DEPTH_LOG2;

  logic [WIDTH-1:0]      words_q [DEPTH];
  logic [DEPTH_LOG2:0]   write_q, read_q;  // one bit more than an address tells full from empty
  logic                  full, take, give;

  assign full    = (write_q ^ read_q) == (DEPTH_LOG2 + 1)'(DEPTH);
  assign ready_o = !full;
  assign valid_o = write_q != read_q;
  assign data_o  = words_q[read_q[DEPTH_LOG2-1:0]];
  assign take    = valid_i && ready_o;
  assign give    = valid_o && ready_i;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      write_q <= '0;
      read_q  <= '0;
    end else begin
      if (take) write_q <= write_q + 1'b1;
      if (give) read_q  <= read_q + 1'b1;
    end
  end

  always_ff @(posedge clk_i) begin
    if (take) words_q[write_q[DEPTH_LOG2-1:0]] <= data_i;
  end

  `GNOMON_ASSERT_STREAM(a_output_stable, valid_o, ready_i, data_o)
  `GNOMON_ASSERT(a_never_above_depth, (DEPTH_LOG2 + 1)'(write_q - read_q) <= (DEPTH_LOG2 + 1)'(DEPTH))

endmodule
