// SPDX-License-Identifier: Apache-2.0
// A long queue in a RAM whose words come a cycle after they are asked for; a few of them wait read ahead at its output.

`include "assertions.svh"

module cache_queue #(
  parameter int unsigned WIDTH      = 64,
  parameter int unsigned DEPTH_LOG2 = 8
) (
  input  logic             clk_i,
  input  logic             rst_ni,
  input  logic             valid_i,
  output logic             ready_o,
  input  logic [WIDTH-1:0] data_i,
  output logic             valid_o,
  input  logic             ready_i,
  output logic [WIDTH-1:0] data_o,
  output logic             empty_o   // nothing in the RAM, nothing at the output
);

  localparam int unsigned AHEAD_LOG2 = 2;

  logic [WIDTH-1:0]      words_q [1 << DEPTH_LOG2];
  logic [WIDTH-1:0]      word_q;
  logic [DEPTH_LOG2:0]   write_q, read_q;
  logic [AHEAD_LOG2:0]   ahead_q;  // read and not yet given
  logic                  full, take, read, reading_q, give, room;

  assign full    = (write_q ^ read_q) == (DEPTH_LOG2 + 1)'(1 << DEPTH_LOG2);
  assign ready_o = !full;
  assign take    = valid_i && ready_o;
  assign read    = write_q != read_q && !ahead_q[AHEAD_LOG2];
  assign give    = valid_o && ready_i;
  assign empty_o = write_q == read_q && ahead_q == '0;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      write_q   <= '0;
      read_q    <= '0;
      ahead_q   <= '0;
      reading_q <= 1'b0;
    end else begin
      reading_q <= read;
      if (take) write_q <= write_q + 1'b1;
      if (read) read_q  <= read_q + 1'b1;
      if (read && !give)      ahead_q <= ahead_q + 1'b1;
      else if (!read && give) ahead_q <= ahead_q - 1'b1;
    end
  end
  always_ff @(posedge clk_i) begin
    if (take) words_q[write_q[DEPTH_LOG2-1:0]] <= data_i;
  end
  always_ff @(posedge clk_i) begin
    if (read) word_q <= words_q[read_q[DEPTH_LOG2-1:0]];
  end

  stream_fifo #(.WIDTH(WIDTH), .DEPTH_LOG2(AHEAD_LOG2)) u_ahead (
    .clk_i, .rst_ni, .valid_i(reading_q), .ready_o(room), .data_i(word_q), .valid_o, .ready_i, .data_o
  );

  `GNOMON_ASSERT(a_word_has_room, !reading_q || room)

endmodule
