// SPDX-License-Identifier: Apache-2.0
// Sum or difference of two positions cell + (k + r/den)/U (docs/slb.md, "Positions"): carries from r by den, from k by U.
// b's k may be U itself, as a quotient can be. Combinational.

module slb_walk_sum #(
  parameter int unsigned W         = 20,
  parameter int unsigned K         = 17,
  parameter int unsigned CELL_BITS = 11,
  parameter int unsigned UNIT      = 130048
) (
  input  logic                        valid_i,     // else the sum means nothing
  input  logic                        subtract_i,
  input  logic [W-1:0]                den_i,
  input  logic signed [CELL_BITS-1:0] a_cell_i,
  input  logic [K-1:0]                a_k_i,
  input  logic [W-1:0]                a_r_i,
  input  logic signed [CELL_BITS-1:0] b_cell_i,
  input  logic [K-1:0]                b_k_i,
  input  logic [W-1:0]                b_r_i,
  output logic signed [CELL_BITS-1:0] cell_o,
  output logic [K-1:0]                k_o,
  output logic [W-1:0]                r_o
);

  localparam logic signed [K+1:0] U = (K + 2)'(UNIT);

  logic signed [W+1:0] den, r;
  logic signed [K+1:0] k;
  logic                r_over, r_under, k_over, k_under;

  always_comb begin
    den     = 'x;
    r       = 'x;
    k       = 'x;
    r_under = 'x;
    r_over  = 'x;
    k_under = 'x;
    k_over  = 'x;
    r_o     = 'x;
    k_o     = 'x;
    cell_o  = 'x;
    if (valid_i) begin
      den     = {2'b00, den_i};
      r       = subtract_i ? signed'({2'b00, a_r_i}) - signed'({2'b00, b_r_i})
                           : signed'({2'b00, a_r_i}) + signed'({2'b00, b_r_i});
      r_under = r < 0;
      r_over  = r >= den;
      r_o     = r_under ? W'(r + den) : r_over ? W'(r - den) : r[W-1:0];

      k       = subtract_i ? signed'({2'b00, a_k_i}) - signed'({2'b00, b_k_i}) - signed'((K + 2)'(r_under))
                           : signed'({2'b00, a_k_i}) + signed'({2'b00, b_k_i}) + signed'((K + 2)'(r_over));
      k_under = k < 0;
      k_over  = k >= U;
      k_o     = k_under ? K'(k + U) : k_over ? K'(k - U) : k[K-1:0];

      cell_o  = (subtract_i ? a_cell_i - b_cell_i : a_cell_i + b_cell_i)
                + signed'(CELL_BITS'(k_over)) - signed'(CELL_BITS'(k_under));
    end
  end

endmodule
