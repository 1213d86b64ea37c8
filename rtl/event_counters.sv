// SPDX-License-Identifier: Apache-2.0
// Event counters of a unit, 64 bits each; every event at most once a cycle. Number 0 is the highest bit of the events: the
// first field of a packed structure.

module event_counters #(
  parameter int unsigned COUNT = 1
) (
  input  logic             clk_i,
  input  logic             rst_ni,
  input  logic [COUNT-1:0] events_i,
  input  logic [6:0]       number_i,
  output logic [63:0]      value_o    // 0 where there is no such counter
);

  logic [COUNT*64-1:0] values_q;  // the first in the low bits
  for (genvar i = 0; i < COUNT; i++) begin : gen_counters
    always_ff @(posedge clk_i) begin
      if (!rst_ni)                  values_q[i*64+:64] <= '0;
      else if (events_i[COUNT-1-i]) values_q[i*64+:64] <= values_q[i*64+:64] + 64'd1;
    end
  end

  logic       exists;
  logic [6:0] number;
  assign exists  = number_i < 7'(COUNT);
  assign number  = exists ? number_i : '0;
  assign value_o = exists ? values_q[32'(number)*64+:64] : 64'd0;

endmodule
