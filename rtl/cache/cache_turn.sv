// SPDX-License-Identifier: Apache-2.0
// Takes turns: of those who want, the next one after the last that was served. Combinational choice.

module cache_turn #(
  parameter int unsigned CLIENTS = 2,
  // Derived; not to be overridden.
  parameter int unsigned WHO     = (CLIENTS <= 1) ? 1 : $clog2(CLIENTS)
) (
  input  logic               clk_i,
  input  logic               rst_ni,
  input  logic [CLIENTS-1:0] wants_i,
  input  logic               take_i,  // who_o is served
  output logic [WHO-1:0]     who_o    // means nothing if nobody wants
);

  // The first at or above the turn, else the first of all.
  logic [WHO-1:0] turn_q;
  always_comb begin
    who_o = '0;
    for (int i = CLIENTS - 1; i >= 0; i--) begin
      if (wants_i[i]) who_o = WHO'(i);
    end
    for (int i = CLIENTS - 1; i >= 0; i--) begin
      if (wants_i[i] && WHO'(i) >= turn_q) begin
        who_o = WHO'(i);
      end
    end
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni)     turn_q <= '0;
    else if (take_i) turn_q <= (who_o == WHO'(CLIENTS - 1)) ? '0 : who_o + 1'b1;
  end

endmodule
