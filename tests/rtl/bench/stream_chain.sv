// SPDX-License-Identifier: Apache-2.0
// The stream cells one behind the other: skid buffer, random gate, queue, skid buffer.

module stream_chain (
  input  logic        clk_i,
  input  logic        rst_ni,
  input  logic        valid_i,
  output logic        ready_o,
  input  logic [31:0] data_i,
  output logic        valid_o,
  input  logic        ready_i,
  output logic [31:0] data_o
);

  logic        a_valid, a_ready, b_valid, b_ready, c_valid, c_ready;
  logic [31:0] a_data, c_data;

  stream_skid #(.WIDTH(32)) u_first (
    .clk_i, .rst_ni, .valid_i, .ready_o, .data_i, .valid_o(a_valid), .ready_i(a_ready), .data_o(a_data)
  );
  stall_gate #(.SEED(16'h1234)) u_gate (
    .clk_i, .rst_ni, .valid_i(a_valid), .ready_o(a_ready), .valid_o(b_valid), .ready_i(b_ready)
  );
  stream_fifo #(.WIDTH(32), .DEPTH_LOG2(2)) u_queue (
    .clk_i, .rst_ni, .valid_i(b_valid), .ready_o(b_ready), .data_i(a_data),
    .valid_o(c_valid), .ready_i(c_ready), .data_o(c_data)
  );
  stream_skid #(.WIDTH(32)) u_last (
    .clk_i, .rst_ni, .valid_i(c_valid), .ready_o(c_ready), .data_i(c_data), .valid_o, .ready_i, .data_o
  );

endmodule
