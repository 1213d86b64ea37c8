// SPDX-License-Identifier: Apache-2.0
// Lines that are read for the cache: beats of any order and interleaved, gathered by id; whole lines handed over one at a
// time, and always taken.

`include "assertions.svh"

module axi_read_lines #(
  parameter int unsigned AXI_DATA_BITS = 64,
  parameter int unsigned LINE_IDS_LOG2 = 4
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  input  logic                     start_i,         // a read goes out
  input  logic [57:0]              line_i,          // address / 64
  input  logic [LINE_IDS_LOG2-1:0] id_i,
  input  logic                     beat_valid_i,    // always taken
  input  logic                     beat_last_i,
  input  logic [LINE_IDS_LOG2-1:0] beat_id_i,
  input  logic [AXI_DATA_BITS-1:0] beat_i,
  output logic [63:0]              beat_address_o,  // of the line it belongs to
  output logic                     active_o,        // reads are under way
  output logic [63:0]              oldest_o,        // address of that with the lowest id
  output logic                     valid_o,
  output logic [LINE_IDS_LOG2-1:0] id_o,
  output logic [511:0]             data_o
);

  localparam int unsigned ID        = LINE_IDS_LOG2;
  localparam int unsigned LINES     = 1 << ID;
  localparam int unsigned BEATS     = 512 / AXI_DATA_BITS;
  localparam int unsigned BEAT_BITS = (BEATS == 1) ? 1 : $clog2(BEATS);

  // ---- Lines by id ----
  logic [LINES-1:0]           pending_q, whole_q, given;
  logic [LINES*BEAT_BITS-1:0] beats_q;
  logic [BEAT_BITS-1:0]       beat;
  logic [57:0]                lines_q [LINES];
  assign beat = beats_q[32'(beat_id_i)*BEAT_BITS+:BEAT_BITS];
  for (genvar i = 0; i < LINES; i++) begin : gen_lines
    logic mine;
    assign mine = beat_valid_i && beat_id_i == ID'(i);
    always_ff @(posedge clk_i) begin
      if (!rst_ni) begin
        pending_q[i] <= 1'b0;
        whole_q[i]   <= 1'b0;
        beats_q[i*BEAT_BITS+:BEAT_BITS] <= '0;
      end else begin
        if (start_i && id_i == ID'(i)) pending_q[i] <= 1'b1;
        else if (mine && beat_last_i)  pending_q[i] <= 1'b0;
        if (mine && beat_last_i)       whole_q[i] <= 1'b1;
        else if (given[i])             whole_q[i] <= 1'b0;
        if (mine) beats_q[i*BEAT_BITS+:BEAT_BITS] <= beat_last_i ? '0 : beat + 1'b1;
      end
    end
  end
  always_ff @(posedge clk_i) if (start_i) lines_q[id_i] <= line_i;

  // ---- Their data: a memory for each beat of a line ----
  logic [ID-1:0] id_q;
  for (genvar j = 0; j < BEATS; j++) begin : gen_beats
    logic [AXI_DATA_BITS-1:0] part_q [LINES];
    always_ff @(posedge clk_i) if (beat_valid_i && beat == BEAT_BITS'(j)) part_q[beat_id_i] <= beat_i;
    assign data_o[j*AXI_DATA_BITS+:AXI_DATA_BITS] = part_q[id_q];
  end

  // ---- One at a time, lowest id first ----
  logic          chosen_q, choose;
  logic [ID-1:0] next_id;
  always_comb begin
    next_id = '0;
    for (int i = LINES - 1; i >= 0; i--) if (whole_q[i]) next_id = ID'(i);
  end
  assign choose = !chosen_q && whole_q != '0;
  always_ff @(posedge clk_i) chosen_q <= rst_ni && choose;
  always_ff @(posedge clk_i) if (choose) id_q <= next_id;
  assign valid_o = chosen_q;
  assign id_o    = id_q;
  assign given   = chosen_q ? LINES'(1) << id_q : '0;

  // ---- Addresses for errors ----
  logic [ID-1:0] oldest;
  always_comb begin
    oldest = '0;
    for (int i = LINES - 1; i >= 0; i--) if (pending_q[i]) oldest = ID'(i);
  end
  assign active_o       = pending_q != '0;
  assign oldest_o       = {lines_q[oldest], 6'd0};
  assign beat_address_o = {lines_q[beat_id_i], 6'd0};

  `GNOMON_ASSERT(a_one_read_an_id, !start_i || !(pending_q[id_i] || whole_q[id_i]))
  `GNOMON_ASSERT(a_beat_expected, !beat_valid_i || pending_q[beat_id_i])

endmodule
