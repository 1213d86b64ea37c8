// SPDX-License-Identifier: Apache-2.0
// Which lines of the cache are on their way to memory: addresses for errors and timeouts.

`include "assertions.svh"

module axi_write_lines #(
  parameter int unsigned LINE_IDS_LOG2 = 4
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  input  logic                     start_i,
  input  logic [57:0]              line_i,             // address / 64
  input  logic [LINE_IDS_LOG2-1:0] id_i,
  input  logic                     written_i,
  input  logic [LINE_IDS_LOG2-1:0] written_id_i,
  output logic [63:0]              written_address_o,  // of that id
  output logic                     active_o,
  output logic [63:0]              oldest_o            // address of the lowest id under way
);

  localparam int unsigned ID    = LINE_IDS_LOG2;
  localparam int unsigned LINES = 1 << ID;

  logic [LINES-1:0] pending_q;
  logic [57:0]      lines_q [LINES];
  for (genvar i = 0; i < LINES; i++) begin : gen_lines
    always_ff @(posedge clk_i) begin
      if (!rst_ni)                                  pending_q[i] <= 1'b0;
      else if (start_i && id_i == ID'(i))           pending_q[i] <= 1'b1;
      else if (written_i && written_id_i == ID'(i)) pending_q[i] <= 1'b0;
    end
  end
  always_ff @(posedge clk_i) if (start_i) lines_q[id_i] <= line_i;

  logic [ID-1:0] oldest;
  always_comb begin
    oldest = '0;
    for (int i = LINES - 1; i >= 0; i--) if (pending_q[i]) oldest = ID'(i);
  end
  assign active_o          = pending_q != '0;
  assign oldest_o          = {lines_q[oldest], 6'd0};
  assign written_address_o = {lines_q[written_id_i], 6'd0};

  `GNOMON_ASSERT(a_one_write_an_id, !start_i || !pending_q[id_i])
  `GNOMON_ASSERT(a_answer_expected, !written_i || pending_q[written_id_i])

endmodule
