// SPDX-License-Identifier: Apache-2.0
// Lets no edge that stays inside its pixel take a place behind: such an edge only brings its first vertex to a chain, so
// the vertex is kept and goes along with the next edge of the loop. The last edge of a loop always passes. Combinational
// but for what is kept.

`include "assertions.svh"

module slb_edge_fold #(
  parameter int unsigned DEPTH_BITS    = 20,
  parameter int unsigned PLANE_LOG2    = 8,
  parameter int unsigned SUBPIXEL_BITS = 10,
  // Derived; not to be overridden.
  parameter int unsigned W = PLANE_LOG2 + 2 + SUBPIXEL_BITS
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  input  logic                     valid_i,
  output logic                     ready_o,
  input  logic [W-1:0]             x0_i, y0_i, x1_i, y1_i,
  input  logic [DEPTH_BITS-1:0]    depth0_i, depth1_i,
  input  logic                     first_i, last_i,
  // The edge goes on past this module; beside it goes what the kept ones bring.
  output logic                     valid_o,
  input  logic                     ready_i,
  output logic                     first_o,                        // of its loop, with those kept
  output logic [SUBPIXEL_BITS-1:0] chain_x_frac_o, chain_y_frac_o,  // first of the vertices that join the chain
  output logic [DEPTH_BITS-1:0]    chain_depth_o                   // largest depth of the edges kept
);

  localparam int unsigned S = SUBPIXEL_BITS;
  localparam int unsigned D = DEPTH_BITS;

  logic         kept_q, first_q;
  logic [S-1:0] x_frac_q, y_frac_q;
  logic [D-1:0] depth_q;

  logic one_pixel, keep, unused_fractions;
  assign one_pixel = x0_i[W-1:S] == x1_i[W-1:S] && y0_i[W-1:S] == y1_i[W-1:S];
  assign unused_fractions = ^{x1_i[S-1:0], y1_i[S-1:0]};
  assign keep      = one_pixel && !last_i;
  assign valid_o   = valid_i && !keep;
  assign ready_o   = keep || ready_i;

  assign first_o        = kept_q ? first_q : first_i;
  assign chain_x_frac_o = (kept_q && !mutations_pkg::SLB_FORGET_KEPT) ? x_frac_q : x0_i[S-1:0];
  assign chain_y_frac_o = kept_q ? y_frac_q : y0_i[S-1:0];
  assign chain_depth_o  = kept_q ? depth_q : '0;

  logic [D-1:0] depth;  // of this edge, if it is kept
  assign depth = (depth1_i > depth0_i) ? depth1_i : depth0_i;

  always_ff @(posedge clk_i) begin
    if (!rst_ni)                 kept_q <= 1'b0;
    else if (valid_i && ready_o) kept_q <= keep;
  end
  always_ff @(posedge clk_i) begin
    if (valid_i && keep) begin
      first_q  <= first_o;
      x_frac_q <= chain_x_frac_o;
      y_frac_q <= chain_y_frac_o;
      depth_q  <= (depth > chain_depth_o) ? depth : chain_depth_o;
    end
  end

  `GNOMON_ASSERT(a_loops_apart, !(valid_i && first_i) || !kept_q)

endmodule
