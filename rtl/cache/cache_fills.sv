// SPDX-License-Identifier: Apache-2.0
// Lines that are to come: for each miss, whether memory has its line at all; if so it is asked for, and waits here until
// the request that wants it is served. Misses are served in their order, lines come in any.

`include "assertions.svh"

module cache_fills #(
  parameter int unsigned LINE_BITS = 14,
  parameter int unsigned ID_BITS   = 4   // 2^ID_BITS of them
) (
  input  logic                       clk_i,
  input  logic                       rst_ni,
  // A miss.
  input  logic                       miss_i,        // only with room
  input  logic [LINE_BITS-1:0]       miss_line_i,
  output logic                       room_o,
  // Was the line ever written? Answers in order.
  output logic                       ask_valid_o,
  input  logic                       ask_ready_i,
  output logic [LINE_BITS-1:0]       ask_line_o,
  output logic [ID_BITS-1:0]         ask_id_o,
  input  logic                       told_valid_i,  // always taken
  input  logic [ID_BITS-1:0]         told_id_i,
  input  logic                       told_touched_i,
  // Line port.
  output logic                       read_valid_o,
  input  logic                       read_ready_i,
  output logic [LINE_BITS-1:0]       read_line_o,
  output logic [ID_BITS-1:0]         read_id_o,
  input  logic                       data_valid_i,
  input  logic [ID_BITS-1:0]         data_id_i,
  input  logic [cache_pkg::LINE-1:0] data_i,
  // The oldest miss.
  output logic                       known_o,       // its line is here
  input  logic                       use_i,         // its request is served ...
  output logic [cache_pkg::LINE-1:0] line_o         // ... and has its line a cycle later
);

  logic [ID_BITS:0]     new_q, ask_q, use_q;  // one bit more than an id tells all from none
  logic [ID_BITS-1:0]   new_id, ask_id, use_id;
  logic [LINE_BITS-1:0] lines_q [1 << ID_BITS];
  assign new_id = new_q[ID_BITS-1:0];
  assign ask_id = ask_q[ID_BITS-1:0];
  assign use_id = use_q[ID_BITS-1:0];
  assign room_o = (new_q ^ use_q) != (ID_BITS + 1)'(1 << ID_BITS);

  assign ask_valid_o = ask_q != new_q;
  assign ask_line_o  = lines_q[ask_id];
  assign ask_id_o    = ask_id;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      new_q <= '0;
      ask_q <= '0;
      use_q <= '0;
    end else begin
      if (miss_i)                     new_q <= new_q + 1'b1;
      if (ask_valid_o && ask_ready_i) ask_q <= ask_q + 1'b1;
      if (use_i)                      use_q <= use_q + 1'b1;
    end
  end
  always_ff @(posedge clk_i) begin
    if (miss_i) lines_q[new_id] <= miss_line_i;
  end

  // ---- Lines that memory has ----
  logic to_read_ready;
  stream_fifo #(.WIDTH(ID_BITS), .DEPTH_LOG2(ID_BITS)) u_to_read (
    .clk_i, .rst_ni, .valid_i(told_valid_i && told_touched_i), .ready_o(to_read_ready), .data_i(told_id_i),
    .valid_o(read_valid_o), .ready_i(read_ready_i), .data_o(read_id_o)
  );
  assign read_line_o = lines_q[read_id_o];

  // ---- What is known of the misses ----
  logic [(1<<ID_BITS)-1:0]    known_q, zero_q;
  logic [cache_pkg::LINE-1:0] data_q [1 << ID_BITS];
  logic [cache_pkg::LINE-1:0] line_q;
  logic                       line_zero_q;
  assign known_o = known_q[use_id];
  assign line_o  = line_zero_q ? '0 : line_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      known_q <= '0;
    end else begin
      if (told_valid_i && !told_touched_i) known_q[told_id_i] <= 1'b1;
      if (data_valid_i)                    known_q[data_id_i] <= 1'b1;
      if (use_i)                           known_q[use_id]    <= 1'b0;
    end
  end
  always_ff @(posedge clk_i) begin
    if (told_valid_i) zero_q[told_id_i] <= !told_touched_i;
    if (use_i) line_zero_q <= zero_q[use_id];
  end
  always_ff @(posedge clk_i) begin
    if (data_valid_i) data_q[data_id_i] <= data_i;
  end
  always_ff @(posedge clk_i) begin
    if (use_i) line_q <= data_q[use_id];
  end

  `GNOMON_ASSERT(a_miss_has_room, !miss_i || room_o)
  `GNOMON_ASSERT(a_use_is_known, !use_i || known_o)
  `GNOMON_ASSERT(a_all_can_be_asked, !told_valid_i || to_read_ready)
  `GNOMON_ASSERT(a_data_was_asked, !data_valid_i || (!known_q[data_id_i] && !zero_q[data_id_i]))
  `GNOMON_ASSERT_STREAM(a_read_stable, read_valid_o, read_ready_i, {read_line_o, read_id_o})

endmodule
