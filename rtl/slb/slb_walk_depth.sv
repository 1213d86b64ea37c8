// SPDX-License-Identifier: Apache-2.0
// Upper bound of an edge's depth between two major borders (docs/slb.md, "Depth along an edge"). The bound of a pixel
// includes the depths of the edge's ends in it, so that vertices need not be looked at again.

module slb_walk_depth #(
  parameter int unsigned DEPTH_BITS = 20,
  parameter int unsigned W          = 20
) (
  input  logic                  clk_i,
  // A new edge.
  input  logic                  load_i,
  input  logic                  sloped_i, rising_i,
  input  logic [DEPTH_BITS-1:0] depth0_i, depth1_i,
  input  logic [DEPTH_BITS:0]   first_i,
  input  logic [DEPTH_BITS-1:0] q_i,
  input  logic [W-1:0]          r_i,
  input  logic [W-1:0]          den_i,
  // A major border is crossed.
  input  logic                  advance_i,
  input  logic [W-1:0]          den_q_i,       // of the edge under way
  input  logic                  next_i,        // `depth_next_o` is to be beyond the next major border
  output logic [DEPTH_BITS-1:0] depth_o, depth_next_o
);

  localparam int unsigned D = DEPTH_BITS;

  logic                sloped_q, rising_q;
  logic [D-1:0]        end_q, q_q;  // of an edge without slope, `end` is the larger depth
  logic [W-1:0]        r_q, a_q;
  logic signed [D+1:0] ahead_q, behind_q;  // beyond the ends by less than two steps

  logic [W:0]          a;
  logic                carry;
  logic signed [D+1:0] change, ahead_n;
  assign a       = {1'b0, a_q} + {1'b0, r_q};
  assign carry   = a >= {1'b0, den_q_i} && !mutations_pkg::SLB_DEPTH_DRIFT;
  assign change  = signed'({2'b00, q_q}) + signed'((D + 2)'(carry));
  assign ahead_n = rising_q ? ahead_q + change : ahead_q - change;

  always_ff @(posedge clk_i) begin
    if (load_i) begin
      sloped_q <= sloped_i;
      rising_q <= rising_i;
      end_q    <= (sloped_i || rising_i) ? depth1_i : depth0_i;
      q_q      <= q_i;
      r_q      <= r_i;
      a_q      <= rising_i ? den_i - W'(1) : '0;
      behind_q <= {2'b00, depth0_i};
      ahead_q  <= rising_i ? signed'({2'b00, depth0_i}) + signed'({1'b0, first_i})
                           : signed'({2'b00, depth0_i}) - signed'({1'b0, first_i});
    end else if (advance_i) begin
      a_q      <= W'(a - (carry ? {1'b0, den_q_i} : '0));
      behind_q <= ahead_q;
      ahead_q  <= ahead_n;
    end
  end

  // Both results fit D bits: they lie between the depths of the edge's ends.
  function automatic logic [D-1:0] bound(logic sloped, logic rising, logic [D-1:0] depth_end,
                                         logic signed [D+1:0] behind, logic signed [D+1:0] ahead);
    bound = depth_end;
    if (sloped && rising && ahead < signed'({2'b00, depth_end}))   bound = ahead[D-1:0];
    if (sloped && !rising && behind > signed'({2'b00, depth_end})) bound = behind[D-1:0];
  endfunction
  assign depth_o      = bound(sloped_q, rising_q, end_q, behind_q, ahead_q);
  assign depth_next_o = bound(sloped_q, rising_q, end_q, next_i ? ahead_q : behind_q, next_i ? ahead_n : ahead_q);

endmodule
