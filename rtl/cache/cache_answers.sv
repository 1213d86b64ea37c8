// SPDX-License-Identifier: Apache-2.0
// Answers of a cache on their way to a unit. A place is reserved when a request is served, so that its answer has room.

`include "assertions.svh"

module cache_answers #(
  parameter int unsigned WIDTH = 64
) (
  input  logic             clk_i,
  input  logic             rst_ni,
  input  logic             expect_i,  // an answer will come; only with room
  output logic             room_o,
  input  logic             valid_i,
  input  logic [WIDTH-1:0] data_i,
  output logic             valid_o,
  input  logic             ready_i,
  output logic [WIDTH-1:0] data_o,
  output logic             none_o     // none here, none expected
);

  localparam int unsigned DEPTH_LOG2 = 2;  // three are under way at one a cycle

  logic [DEPTH_LOG2:0] used_q;
  logic                ready, give;
  assign room_o = !used_q[DEPTH_LOG2];
  assign none_o = used_q == '0;
  assign give   = valid_o && ready_i;
  always_ff @(posedge clk_i) begin
    if (!rst_ni)                used_q <= '0;
    else if (expect_i && !give) used_q <= used_q + 1'b1;
    else if (!expect_i && give) used_q <= used_q - 1'b1;
  end

  stream_fifo #(.WIDTH(WIDTH), .DEPTH_LOG2(DEPTH_LOG2)) u_answers (
    .clk_i, .rst_ni, .valid_i, .ready_o(ready), .data_i, .valid_o, .ready_i, .data_o
  );

  `GNOMON_ASSERT(a_answer_has_room, !valid_i || ready)
  `GNOMON_ASSERT(a_expect_with_room, !expect_i || room_o)

endmodule
