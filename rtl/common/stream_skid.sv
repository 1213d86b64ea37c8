// SPDX-License-Identifier: Apache-2.0
// Skid buffer: one register and one spare, so that both valid and ready leave a flip-flop and one word a cycle passes.
// Latency one cycle.

`include "assertions.svh"

module stream_skid #(
  parameter int unsigned WIDTH = 64
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

  logic             valid_q, spare_valid_q;
  logic [WIDTH-1:0] data_q, spare_q;

  assign ready_o = !spare_valid_q || mutations_pkg::SKID_OVERRUN;
  assign valid_o = valid_q;
  assign data_o  = data_q;

  logic take, advance;
  assign take    = valid_i && ready_o;
  assign advance = ready_i || !valid_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_q       <= 1'b0;
      spare_valid_q <= 1'b0;
    end else if (advance) begin
      valid_q       <= spare_valid_q || take;
      spare_valid_q <= 1'b0;
    end else if (take) begin
      spare_valid_q <= 1'b1;
    end
  end

  always_ff @(posedge clk_i) begin
    if (advance) data_q <= spare_valid_q ? spare_q : data_i;
    if (take)    spare_q <= data_i;
  end

  `GNOMON_ASSERT_STREAM(a_output_stable, valid_o, ready_i, data_o)
  `GNOMON_ASSERT(a_spare_behind_register, !spare_valid_q || valid_q)

endmodule
