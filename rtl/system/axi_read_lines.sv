// SPDX-License-Identifier: Apache-2.0
// Lines that are read for the cache: beats of any order and interleaved, gathered by id; whole lines handed over one at a
// time.

`include "assertions.svh"

module axi_read_lines #(
  parameter int unsigned AXI_DATA_BITS = 64
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  input  logic                     start_i,          // a read goes out
  input  logic [63:6]              address_i,
  input  logic [2:0]               id_i,
  input  logic                     beat_valid_i,     // always taken
  input  logic                     beat_last_i,
  input  logic [2:0]               beat_id_i,
  input  logic [AXI_DATA_BITS-1:0] beat_i,
  output logic [63:0]              beat_address_o,   // of the line it belongs to
  output logic                     active_o,         // reads are under way
  output logic [63:0]              oldest_o,         // address of that with the lowest id
  output logic                     line_data_valid_o,
  input  logic                     line_data_ready_i,
  output logic [2:0]               line_data_id_o,
  output logic [511:0]             line_data_o
);

  localparam int unsigned LINES = system_pkg::LINES;
  localparam int unsigned BEATS = 512 / AXI_DATA_BITS;
  localparam int unsigned BEAT_BITS = (BEATS == 1) ? 1 : $clog2(BEATS);

  // ---- Lines by id ----
  logic [LINES-1:0]     pending_q, whole_q, given;
  logic [LINES*58-1:0]  address_q;
  logic [LINES*512-1:0] data_q;
  for (genvar i = 0; i < LINES; i++) begin : gen_lines
    logic                 mine;
    logic [BEAT_BITS-1:0] beat_q;
    assign mine = beat_valid_i && beat_id_i == 3'(i);
    always_ff @(posedge clk_i) begin
      if (!rst_ni) begin
        pending_q[i] <= 1'b0;
        whole_q[i]   <= 1'b0;
        beat_q       <= '0;
      end else begin
        if (start_i && id_i == 3'(i))  pending_q[i] <= 1'b1;
        else if (mine && beat_last_i)  pending_q[i] <= 1'b0;
        if (mine && beat_last_i)       whole_q[i] <= 1'b1;
        else if (given[i])             whole_q[i] <= 1'b0;
        if (mine)                      beat_q <= beat_last_i ? '0 : beat_q + 1'b1;
      end
    end
    always_ff @(posedge clk_i) if (start_i && id_i == 3'(i)) address_q[i*58+:58] <= address_i;
    for (genvar j = 0; j < BEATS; j++) begin : gen_beats
      always_ff @(posedge clk_i) begin
        if (mine && beat_q == BEAT_BITS'(j)) data_q[i*512+j*AXI_DATA_BITS+:AXI_DATA_BITS] <= beat_i;
      end
    end
  end

  // ---- One at a time, lowest id first; the choice is kept until it is taken ----
  logic       chosen_q, choose;
  logic [2:0] id_q, next_id;
  always_comb begin
    next_id = '0;
    for (int i = LINES - 1; i >= 0; i--) if (whole_q[i]) next_id = 3'(i);
  end
  assign choose = !chosen_q && whole_q != '0;
  always_ff @(posedge clk_i) begin
    if (!rst_ni)                chosen_q <= 1'b0;
    else if (choose)            chosen_q <= 1'b1;
    else if (line_data_ready_i) chosen_q <= 1'b0;
  end
  always_ff @(posedge clk_i) if (choose) id_q <= next_id;
  assign line_data_valid_o = chosen_q;
  assign line_data_id_o    = id_q;
  assign line_data_o       = data_q[32'(id_q)*512+:512];
  assign given             = (chosen_q && line_data_ready_i) ? LINES'(1) << id_q : '0;

  // ---- Addresses for errors ----
  logic [2:0] oldest;
  always_comb begin
    oldest = '0;
    for (int i = LINES - 1; i >= 0; i--) if (pending_q[i]) oldest = 3'(i);
  end
  assign active_o       = pending_q != '0;
  assign oldest_o       = {address_q[32'(oldest)*58+:58], 6'd0};
  assign beat_address_o = {address_q[32'(beat_id_i)*58+:58], 6'd0};

  `GNOMON_ASSERT(a_one_read_an_id, !start_i || !(pending_q[id_i] || whole_q[id_i]))
  `GNOMON_ASSERT(a_beat_expected, !beat_valid_i || pending_q[beat_id_i])
  `GNOMON_ASSERT_STREAM(a_line_stable, line_data_valid_o, line_data_ready_i, {line_data_id_o, line_data_o})

endmodule
