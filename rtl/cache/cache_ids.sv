// SPDX-License-Identifier: Apache-2.0
// Gives out the ids of the line port, one way, and remembers for whom.

`include "assertions.svh"

module cache_ids #(
  parameter int unsigned WIDTH   = 4,
  parameter int unsigned ID_BITS = 3
) (
  input  logic               clk_i,
  input  logic               rst_ni,
  input  logic               take_i,  // only while one is free
  input  logic [WIDTH-1:0]   data_i,  // to be remembered
  output logic               free_o,
  output logic [ID_BITS-1:0] id_o,    // the next one
  input  logic               back_i,  // an id comes back
  input  logic [ID_BITS-1:0] back_id_i,
  output logic [WIDTH-1:0]   back_data_o
);

  localparam int unsigned COUNT = 1 << ID_BITS;

  logic [COUNT-1:0] busy_q;
  logic [WIDTH-1:0] data_q [COUNT];
  assign free_o      = busy_q != '1;
  assign back_data_o = data_q[back_id_i];
  always_comb begin
    id_o = '0;
    for (int i = COUNT - 1; i >= 0; i--) begin
      if (!busy_q[i]) id_o = ID_BITS'(i);
    end
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      busy_q <= '0;
    end else begin
      if (take_i) busy_q[id_o]      <= 1'b1;
      if (back_i) busy_q[back_id_i] <= 1'b0;
    end
  end
  always_ff @(posedge clk_i) begin
    if (take_i) data_q[id_o] <= data_i;
  end

  `GNOMON_ASSERT(a_take_a_free_one, !take_i || free_o)
  `GNOMON_ASSERT(a_back_was_taken, !back_i || busy_q[back_id_i])

endmodule
