// SPDX-License-Identifier: Apache-2.0
// What is shown of counters: the values of the moment, or with EN_SNAPSHOT those of the cycle of the last snapshot (0
// before the first).

module counter_snapshot #(
  parameter int unsigned WIDTH       = 64,
  parameter bit          EN_SNAPSHOT = 1'b0
) (
  input  logic             clk_i,
  input  logic             rst_ni,
  input  logic             snapshot_i,
  input  logic [WIDTH-1:0] values_i,
  output logic [WIDTH-1:0] shown_o
);

  if (EN_SNAPSHOT) begin : gen_kept
    logic [WIDTH-1:0] kept_q;
    always_ff @(posedge clk_i) begin
      if (!rst_ni)         kept_q <= '0;
      else if (snapshot_i) kept_q <= values_i;
    end
    assign shown_o = kept_q;
  end else begin : gen_moment
    logic unused_inputs;
    assign unused_inputs = ^{clk_i, rst_ni, snapshot_i};
    assign shown_o       = values_i;
  end

endmodule
