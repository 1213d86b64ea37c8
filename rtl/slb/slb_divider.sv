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

  logic [Q-1:0] valid_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else         valid_q <= {valid_q[Q-2:0], valid_i};
  end

  // A register a stage, each by itself: an array would be copied as a whole in simulation.
  for (genvar i = 0; i < Q; i++) begin : gen_stages
    logic [N+Q-1:0]      state, state_q;  // remainder above, dividend and quotient below
    logic [N-1:0]        den, den_q;
    logic [TAG_BITS-1:0] tag, tag_q;
    logic                valid;
    if (i == 0) begin : gen_first
      assign valid = valid_i;
      assign state = dividend_i;
      assign den   = den_i;
      assign tag   = tag_i;
    end else begin : gen_next
      assign valid = valid_q[i-1];
      assign state = gen_stages[i-1].state_q;
      assign den   = gen_stages[i-1].den_q;
      assign tag   = gen_stages[i-1].tag_q;
    end
    always_ff @(posedge clk_i) begin
      if (valid) begin
        state_q <= divide_step(state, den);
        den_q   <= den;
        tag_q   <= tag;
      end
    end
    if (i == Q - 1) begin : gen_last
      logic unused_den;
      assign unused_den = ^den_q;
    end
  end

  assign valid_o                   = valid_q[Q-1];
  assign {remainder_o, quotient_o} = gen_stages[Q-1].state_q;
  assign tag_o                     = gen_stages[Q-1].tag_q;

  `GNOMON_ASSERT(a_quotient_fits, !valid_i || dividend_i[N+Q-1:Q] < den_i)

endmodule
