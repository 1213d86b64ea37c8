// SPDX-License-Identifier: Apache-2.0
// Pipelined divider: one quotient bit a stage, one division a cycle, QUOTIENT_BITS cycles latency. The quotient must fit,
// that is dividend >> QUOTIENT_BITS < den. A tag travels along.

`include "assertions.svh"

module slb_divider #(
  parameter int unsigned DEN_BITS      = 20,
  parameter int unsigned QUOTIENT_BITS = 17,
  parameter int unsigned TAG_BITS      = 7
) (
  input  logic                              clk_i,
  input  logic                              rst_ni,
  input  logic                              valid_i,
  input  logic [DEN_BITS+QUOTIENT_BITS-1:0] dividend_i,
  input  logic [DEN_BITS-1:0]               den_i,
  input  logic [TAG_BITS-1:0]               tag_i,
  output logic                              valid_o,
  output logic [QUOTIENT_BITS-1:0]          quotient_o,
  output logic [DEN_BITS-1:0]               remainder_o,
  output logic [TAG_BITS-1:0]               tag_o
);

  localparam int unsigned N = DEN_BITS;
  localparam int unsigned Q = QUOTIENT_BITS;

  // One step: the remainder, doubled, takes the next bit of the dividend; the quotient's bit takes that bit's place.
  function automatic logic [N+Q-1:0] divide_step(logic [N+Q-1:0] state, logic [N-1:0] den);
    logic fits;
    fits        = state[N+Q-1:Q-1] >= {1'b0, den};  // the difference is below den, so its top bit is 0
    divide_step = {state[N+Q-2:Q-1] - (fits ? den : '0), state[Q-2:0], fits};
  endfunction

  logic [Q-1:0]                    valid_q;
  (* mem2reg *) logic [N+Q-1:0]      state_q [Q];  // remainder above, dividend and quotient below
  (* mem2reg *) logic [N-1:0]        den_q   [Q];
  (* mem2reg *) logic [TAG_BITS-1:0] tag_q   [Q];

  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else         valid_q <= {valid_q[Q-2:0], valid_i};
  end
  always_ff @(posedge clk_i) begin
    if (valid_i) begin
      state_q[0] <= divide_step(dividend_i, den_i);
      den_q[0]   <= den_i;
      tag_q[0]   <= tag_i;
    end
    for (int unsigned i = 1; i < Q; i++) begin
      if (valid_q[i-1]) begin
        state_q[i] <= divide_step(state_q[i-1], den_q[i-1]);
        den_q[i]   <= den_q[i-1];
        tag_q[i]   <= tag_q[i-1];
      end
    end
  end

  assign valid_o                   = valid_q[Q-1];
  assign {remainder_o, quotient_o} = state_q[Q-1];
  assign tag_o                     = tag_q[Q-1];

  `GNOMON_ASSERT(a_quotient_fits, !valid_i || dividend_i[N+Q-1:Q] < den_i)

endmodule
