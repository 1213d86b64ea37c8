// SPDX-License-Identifier: Apache-2.0
// Puts result words into the result ring: gathers them into 64-byte lines, counts those whose writes are answered
// (docs/system.md, "Results").

`include "assertions.svh"

module result_dma (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  input  logic                     stopped_i,
  input  system_pkg::ring_t        ring_i,
  input  logic                     flush_i,      // no more results without more commands: write what is gathered
  // Results.
  input  logic                     result_valid_i,
  output logic                     result_ready_o,
  input  logic [63:0]              result_i,
  // Writes: words of a line.
  output system_pkg::result_want_t want_o,
  output logic [511:0]             data_o,
  input  system_pkg::write_give_t  write_i,
  // State.
  output logic [3:0]               head_step_o,  // so many more words lie in memory
  output logic                     empty_o,      // nothing gathered, nothing under way
  output logic                     blocked_o,    // a result waits for a place in the ring
  output logic                     full_o,       // it begins to
  output logic                     waiting_o     // for the bus
);

  localparam int unsigned UNDER_WAY_BITS = system_pkg::RESULT_BURSTS_LOG2 + 4;  // words

  // ---- Places: head .. under way .. gathered .. next ----
  logic [3:0]                gathered_q;      // words, 0..8
  logic [UNDER_WAY_BITS-1:0] under_way_q;     // words
  logic [31:0]               first_place, next_place, filled, places;
  logic                      room, take, send_q, sent;
  assign places      = 32'd1 << ring_i.log2;
  assign first_place = ring_i.head + 32'(under_way_q);
  assign next_place  = first_place + 32'(gathered_q);
  assign filled      = next_place - ring_i.tail;
  assign room        = filled < places;

  // ---- Gather: a line's end sends it, as do a flush and a full ring ----
  logic [511:0] data_q;
  logic [2:0]   slot;
  logic         line_end;
  assign slot           = next_place[2:0];
  assign line_end       = slot == 3'd7;
  assign sent           = want_o.valid && write_i.ready;
  assign result_ready_o = room && (!send_q || sent);
  assign take           = result_valid_i && result_ready_o;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      gathered_q <= '0;
      send_q     <= 1'b0;
    end else begin
      gathered_q <= (sent ? 4'd0 : gathered_q) + 4'(take);
      if (take)      send_q <= line_end;
      else if (sent) send_q <= 1'b0;
      else           send_q <= send_q || (gathered_q != '0 && (flush_i || !room));
    end
  end
  for (genvar i = 0; i < 8; i++) begin : gen_slots
    always_ff @(posedge clk_i) if (take && slot == 3'(i)) data_q[i*64+:64] <= result_i;
  end

  // ---- Writes: their sizes wait for their answers ----
  logic       size_room, size_valid;
  logic [3:0] size;
  stream_fifo #(.WIDTH(4), .DEPTH_LOG2(system_pkg::RESULT_BURSTS_LOG2)) u_sizes (
    .clk_i, .rst_ni, .valid_i(sent), .ready_o(size_room), .data_i(gathered_q),
    .valid_o(size_valid), .ready_i(write_i.written), .data_o(size)
  );
  logic [31:0] mask, first_in_ring, head_in_ring;
  assign mask          = places - 32'd1;
  assign first_in_ring = first_place & mask;
  assign head_in_ring  = ring_i.head & mask;
  assign want_o.valid  = send_q && size_room;
  assign want_o.line   = ring_i.base[63:6] | 58'(first_in_ring[31:3]);  // the base is aligned to the ring
  assign want_o.first  = first_in_ring[2:0];
  assign want_o.last   = first_in_ring[2:0] + gathered_q[2:0] - 3'd1;
  assign data_o        = data_q;
  assign want_o.oldest = ring_i.base | {29'd0, head_in_ring, 3'd0};
  assign want_o.active = send_q || under_way_q != '0;

  logic answered;
  assign answered    = write_i.written && size_valid;
  assign head_step_o = mutations_pkg::RESULTS_COUNT_EARLY ? (sent ? gathered_q : 4'd0)
                                                          : ((answered && !stopped_i) ? size : 4'd0);
  always_ff @(posedge clk_i) begin
    if (!rst_ni) under_way_q <= '0;
    else         under_way_q <= under_way_q + (sent ? UNDER_WAY_BITS'(gathered_q) : '0) - UNDER_WAY_BITS'(head_step_o);
  end

  // ---- State ----
  logic blocked_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) blocked_q <= 1'b0;
    else         blocked_q <= blocked_o;
  end
  assign blocked_o = result_valid_i && !room;
  assign full_o    = blocked_o && !blocked_q && !stopped_i;
  assign waiting_o = result_valid_i && room && !result_ready_o;
  assign empty_o   = gathered_q == '0 && under_way_q == '0;

  logic unused_base;
  assign unused_base = ^ring_i.base[5:0];

  `GNOMON_ASSERT(a_within_a_line, 4'(want_o.first) + gathered_q <= 4'd8)
  `GNOMON_ASSERT(a_answer_expected, !write_i.written || size_valid)
  `GNOMON_ASSERT_STREAM(a_write_stable, want_o.valid, write_i.ready, {want_o.line, want_o.first, want_o.last})

endmodule
