// SPDX-License-Identifier: Apache-2.0
// Event counters of a unit, 64 bits each; every event at most once a cycle. Number 0 is the highest bit of the events: the
// first field of a packed structure.

module event_counters #(
  parameter int unsigned COUNT       = 1,
  parameter bit          EN_SNAPSHOT = 1'b0   // the last snapshot is read instead of the moment
) (
  input  logic             clk_i,
  input  logic             rst_ni,
  input  logic             snapshot_i,
  input  logic [COUNT-1:0] events_i,
  input  logic [6:0]       number_i,
  output logic [63:0]      value_o    // 0 where there is no such counter
);

  logic [COUNT*64-1:0] values_q, shown;  // the first in the low bits
  for (genvar i = 0; i < COUNT; i++) begin : gen_counters
    always_ff @(posedge clk_i) begin
      if (!rst_ni)                  values_q[i*64+:64] <= '0;
      else if (events_i[COUNT-1-i]) values_q[i*64+:64] <= values_q[i*64+:64] + 64'd1;
    end
  end

  counter_snapshot #(.WIDTH(COUNT * 64), .EN_SNAPSHOT(EN_SNAPSHOT)) u_snapshot (
    .clk_i, .rst_ni, .snapshot_i, .values_i(values_q), .shown_o(shown)
  );

  logic       exists;
  logic [6:0] number;
  assign exists  = number_i < 7'(COUNT);
  assign number  = exists ? number_i : '0;
  assign value_o = exists ? shown[32'(number)*64+:64] : 64'd0;

endmodule
