// SPDX-License-Identifier: Apache-2.0
// Grants one of several users by priority, user 0 first; one that has waited for more than PATIENCE grants of others goes
// first once.

module fair_grant #(
  parameter int unsigned USERS    = 2,
  parameter int unsigned PATIENCE = 64
) (
  input  logic             clk_i,
  input  logic             rst_ni,
  input  logic [USERS-1:0] valid_i,
  input  logic             take_i,    // whoever is granted goes
  output logic [USERS-1:0] grant_o    // at most one
);

  localparam int unsigned WAIT_BITS = $clog2(PATIENCE + 2);

  logic [USERS-1:0] overdue, candidates;
  for (genvar i = 0; i < USERS; i++) begin : gen_users
    logic [WAIT_BITS-1:0] waited_q;
    assign overdue[i] = valid_i[i] && waited_q > WAIT_BITS'(PATIENCE);
    always_ff @(posedge clk_i) begin
      if (!rst_ni || !valid_i[i])                      waited_q <= '0;
      else if (take_i && grant_o[i])                   waited_q <= '0;
      else if (take_i && |grant_o && !overdue[i])      waited_q <= waited_q + 1'b1;
    end
  end
  assign candidates = (|overdue) ? overdue : valid_i;
  assign grant_o    = candidates & (~candidates + 1'b1);

endmodule
