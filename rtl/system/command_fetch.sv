// SPDX-License-Identifier: Apache-2.0
// Fetches a descriptor's command words ahead of the units: bursts that do not cross a multiple of 512 bytes, several under
// way, each asked for only when the queue has room for it. A queue of beats, taken apart into words behind it.

`include "assertions.svh"

module command_fetch #(
  parameter int unsigned AXI_DATA_BITS = 64
) (
  input  logic                      clk_i,
  input  logic                      rst_ni,
  // A descriptor's words; only while not busy.
  input  logic                      start_i,
  input  logic [63:3]               address_i,
  input  logic [31:0]               words_i,      // not 0
  output logic                      busy_o,       // words are left to give
  output logic                      waiting_o,    // for the bus
  // Bursts.
  output system_pkg::command_want_t want_o,
  input  system_pkg::read_give_t    read_i,
  input  logic                      beat_last_i,  // of its burst
  input  logic [AXI_DATA_BITS-1:0]  beat_i,
  // Words.
  output logic                      word_valid_o,
  input  logic                      word_ready_i,
  output logic [63:0]               word_o
);

  localparam int unsigned LANES_LOG2 = $clog2(AXI_DATA_BITS / 64);  // words of a beat
  localparam int unsigned LANE_BITS  = (LANES_LOG2 == 0) ? 1 : LANES_LOG2;
  localparam int unsigned BURST      = system_pkg::COMMAND_BURST_LOG2;
  localparam int unsigned QUEUE_LOG2 = BURST + $clog2(system_pkg::COMMAND_BURSTS) - LANES_LOG2;
  localparam int unsigned BEAT_BITS  = BURST - LANES_LOG2;          // of a burst's beat
  localparam int unsigned COUNT_BITS = $clog2(system_pkg::COMMAND_BURSTS + 1);

  // ---- Bursts ----
  logic [63:3]         next_q, oldest_q;
  logic [31:0]         unasked_q, ungiven_q;
  logic [COUNT_BITS-1:0] bursts_q;
  logic [QUEUE_LOG2:0] room_q;                       // beats
  logic [BURST:0]      to_edge, words, beats;
  logic [BEAT_BITS-1:0] first_beat, last_beat;
  logic [BURST-1:0]    last_word;
  logic                asking, ask, beat_taken, pop;
  assign to_edge    = mutations_pkg::AXI_CROSS_PAGES ? (BURST + 1)'(1 << BURST)
                                                     : (BURST + 1)'(1 << BURST) - {1'b0, next_q[3+:BURST]};
  assign words      = (unasked_q < 32'(to_edge)) ? unasked_q[BURST:0] : to_edge;
  assign last_word  = next_q[3+:BURST] + words[BURST-1:0] - 1'b1;
  assign first_beat = next_q[3+LANES_LOG2+:BEAT_BITS];
  assign last_beat  = last_word[LANES_LOG2+:BEAT_BITS];
  assign beats      = mutations_pkg::AXI_CROSS_PAGES ? words : (BURST + 1)'(BEAT_BITS'(last_beat - first_beat)) + 1'b1;

  assign asking         = unasked_q != '0 && bursts_q != COUNT_BITS'(system_pkg::COMMAND_BURSTS) &&
                          32'(room_q) >= 32'(beats);
  assign ask            = asking && read_i.ready;
  assign beat_taken     = read_i.beat && beat_last_i;
  assign want_o.valid   = asking;
  assign want_o.active  = bursts_q != '0 || asking;
  assign want_o.address = next_q;
  assign want_o.words   = words;
  assign want_o.oldest  = {(bursts_q != '0) ? oldest_q : next_q, 3'd0};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      unasked_q <= '0;
      ungiven_q <= '0;
      bursts_q  <= '0;
      room_q    <= (QUEUE_LOG2 + 1)'(1 << QUEUE_LOG2);
    end else begin
      if (start_i)  unasked_q <= words_i;
      else if (ask) unasked_q <= unasked_q - 32'(words);
      if (start_i)                          ungiven_q <= words_i;
      else if (word_valid_o && word_ready_i) ungiven_q <= ungiven_q - 32'd1;
      bursts_q <= bursts_q + COUNT_BITS'(ask) - COUNT_BITS'(beat_taken);
      room_q   <= room_q - (ask ? (QUEUE_LOG2 + 1)'(beats) : '0) + (QUEUE_LOG2 + 1)'(pop);
    end
  end
  always_ff @(posedge clk_i) begin
    if (start_i)  next_q <= address_i;
    else if (ask) next_q <= next_q + 61'(words);
    // A burst after the first begins at a multiple of 512 bytes.
    if (start_i)         oldest_q <= address_i;
    else if (beat_taken) oldest_q <= {oldest_q[63:3+BURST] + 1'b1, {BURST{1'b0}}};
  end

  // ---- Beats, then words: the address of the next word says where in its beat it lies ----
  logic                     beat_valid, beat_room;
  logic [AXI_DATA_BITS-1:0] beat;
  stream_fifo #(.WIDTH(AXI_DATA_BITS), .DEPTH_LOG2(QUEUE_LOG2)) u_queue (
    .clk_i, .rst_ni, .valid_i(read_i.beat), .ready_o(beat_room), .data_i(beat_i),
    .valid_o(beat_valid), .ready_i(pop), .data_o(beat)
  );
  logic [LANE_BITS-1:0] lane_q;
  always_ff @(posedge clk_i) begin
    if (start_i)                           lane_q <= address_i[3+:LANE_BITS];
    else if (word_valid_o && word_ready_i) lane_q <= lane_q + 1'b1;
  end
  if (LANES_LOG2 == 0) begin : gen_word
    assign word_o = beat;
    assign pop    = word_valid_o && word_ready_i;
    logic unused_lane;
    assign unused_lane = ^lane_q;
  end else begin : gen_lanes
    assign word_o = beat[32'(lane_q)*64+:64];
    assign pop    = word_valid_o && word_ready_i && (lane_q == '1 || ungiven_q == 32'd1);
  end
  assign word_valid_o = beat_valid && ungiven_q != '0;
  assign busy_o       = ungiven_q != '0;
  assign waiting_o    = busy_o && !beat_valid;

  logic unused_word;
  assign unused_word = ^last_word;

  `GNOMON_ASSERT(a_room_for_every_beat, !read_i.beat || beat_room)
  `GNOMON_ASSERT(a_burst_is_under_way, !read_i.beat || bursts_q != '0)
  `GNOMON_ASSERT_STREAM(a_word_stable, word_valid_o, word_ready_i, word_o)
  `GNOMON_ASSERT_STREAM(a_request_stable, want_o.valid, read_i.ready, {want_o.address, want_o.words})

endmodule
