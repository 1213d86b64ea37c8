// SPDX-License-Identifier: Apache-2.0
// Joins steps to chains (docs/slb.md, "Chains"): a step in, at most one chain out, a cycle later, never held back. Three
// records: the chain being built, the exit put aside of the loop's first pixel, and the chain that the two make at the
// loop's end. That one leaves a cycle after the loop's last step, when the next loop's first step has no chain to send.

`include "assertions.svh"

module slb_chain_builder #(
  parameter int unsigned FRAC_BITS     = 7,
  parameter int unsigned SLOPE_BITS    = 7,
  parameter int unsigned DEPTH_BITS    = 20,
  parameter int unsigned PLANE_LOG2    = 8,
  parameter int unsigned SUBPIXEL_BITS = 10,
  // Derived; not to be overridden.
  parameter int unsigned C = PLANE_LOG2 + 2,
  parameter int unsigned W = C + SUBPIXEL_BITS,
  parameter int unsigned L = 4 + FRAC_BITS + SLOPE_BITS
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  // Steps, as slb_walker gives them, with their lines.
  input  logic                     step_valid_i,
  input  logic                     step_crossing_i, step_first_i, step_loop_first_i, step_loop_last_i,
  input  logic [1:0]               step_side_i,
  input  logic signed [C-1:0]      step_column_i, step_row_i,
  input  logic signed [W:0]        step_dx_i, step_dy_i,
  input  logic [SUBPIXEL_BITS-1:0] step_first_x_i, step_first_y_i, step_last_x_i, step_last_y_i,
  input  logic [DEPTH_BITS-1:0]    step_depth_left_i, step_depth_entered_i,
  input  logic [L-1:0]             step_line_left_i, step_line_entered_i,
  // Chains, from entry to exit.
  output logic                     chain_valid_o,
  output logic signed [C-1:0]      chain_column_o, chain_row_o,
  output logic [1:0]               chain_entry_side_o, chain_exit_side_o,
  output logic [L-1:0]             chain_a_o, chain_b_o,
  output logic signed [W:0]        chain_entry_dx_o, chain_entry_dy_o, chain_exit_dx_o, chain_exit_dy_o,
  output logic                     chain_vertex_o,               // there is one at least
  output logic [SUBPIXEL_BITS-1:0] chain_first_x_o, chain_first_y_o, chain_last_x_o, chain_last_y_o,
  output logic [DEPTH_BITS-1:0]    chain_depth_o,
  output logic                     idle_o
);

  localparam int unsigned S = SUBPIXEL_BITS;
  localparam int unsigned D = DEPTH_BITS;
  // Parts of a record: how a chain came in, how it went out, a vertex.
  localparam int unsigned ENTRY  = 2 + L + 2 * (W + 1);  // side, line A, dx, dy
  localparam int unsigned EXIT   = 2 + L + 2 * (W + 1);  // side, line B, dx, dy
  localparam int unsigned VERTEX = 2 * S;                // x, y

  // The chain being built.
  logic                entered_q, vertex_q;  // it has an entry, a vertex
  logic [ENTRY-1:0]    entry_q;
  logic [VERTEX-1:0]   first_q, last_q;
  logic [D-1:0]        depth_q;
  logic signed [C-1:0] column_q, row_q;      // of its pixel; meaningless without an entry
  // Put aside at the loop's first crossing; meaningless before.
  logic [EXIT-1:0]     aside_exit_q;
  logic [VERTEX-1:0]   aside_first_q, aside_last_q;
  logic [D-1:0]        aside_depth_q;

  // The chain as it stands in the pixel that the step leaves: an edge's first step brings vertices.
  logic                entered, vertex;
  logic [VERTEX-1:0]   first, last;
  logic [D-1:0]        depth, depth_before;
  logic [EXIT-1:0]     exit_part;
  assign entered      = entered_q && !step_loop_first_i;
  assign vertex       = step_first_i || vertex_q;
  assign first        = (step_first_i && (!vertex_q || step_loop_first_i)) ? {step_first_x_i, step_first_y_i} : first_q;
  assign last         = step_first_i ? {step_last_x_i, step_last_y_i} : last_q;
  assign depth_before = step_loop_first_i ? '0 : depth_q;
  assign depth        = (step_first_i && step_depth_left_i > depth_before) ? step_depth_left_i : depth_before;
  assign exit_part    = {step_side_i, step_line_left_i, step_dx_i, step_dy_i};

  // And in the pixel where the step ends.
  logic                now_vertex;
  logic [ENTRY-1:0]    now_entry;
  logic [D-1:0]        now_depth;
  logic signed [C-1:0] now_column, now_row;
  assign now_vertex  = vertex && !step_crossing_i;
  assign now_entry   = step_crossing_i ? {step_side_i ^ 2'd2, step_line_entered_i, step_dx_i, step_dy_i} : entry_q;
  assign now_depth   = step_crossing_i ? step_depth_entered_i : depth;
  assign now_column  = step_crossing_i ? step_column_i : column_q;
  assign now_row     = step_crossing_i ? step_row_i : row_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      entered_q <= 1'b0;
      vertex_q  <= 1'b0;
    end else if (step_valid_i) begin
      entered_q <= entered || step_crossing_i;
      vertex_q  <= now_vertex;
    end
  end
  always_ff @(posedge clk_i) begin
    if (step_valid_i) begin
      entry_q  <= now_entry;
      first_q  <= first;
      last_q   <= last;
      depth_q  <= now_depth;
      column_q <= now_column;
      row_q    <= now_row;
      if (step_crossing_i && !entered) begin
        aside_exit_q  <= exit_part;
        aside_first_q <= first;
        aside_last_q  <= last;
        aside_depth_q <= depth;
      end
    end
  end

  // The chain around the loop's first vertex, which is always in it: in with the last edges, out with the first ones.
  // A tiny loop has none.
  logic                closing_q, send;
  logic [ENTRY-1:0]    closing_entry_q;
  logic [EXIT-1:0]     closing_exit_q;
  logic [VERTEX-1:0]   closing_first_q, closing_last_q;
  logic [D-1:0]        closing_depth_q;
  logic signed [C-1:0] closing_column_q, closing_row_q;
  assign send = step_valid_i && step_crossing_i && entered;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      closing_q     <= 1'b0;
      chain_valid_o <= 1'b0;
    end else begin
      closing_q     <= step_valid_i && step_loop_last_i && entered;
      chain_valid_o <= send || closing_q;
    end
  end
  always_ff @(posedge clk_i) begin
    if (step_valid_i && step_loop_last_i) begin
      closing_entry_q  <= now_entry;
      closing_exit_q   <= aside_exit_q;
      closing_first_q  <= now_vertex ? first : aside_first_q;
      closing_last_q   <= aside_last_q;
      closing_depth_q  <= (now_depth > aside_depth_q || mutations_pkg::SLB_FORGET_ASIDE) ? now_depth : aside_depth_q;
      closing_column_q <= now_column;
      closing_row_q    <= now_row;
    end
    if (send || closing_q) begin
      {chain_entry_side_o, chain_a_o, chain_entry_dx_o, chain_entry_dy_o} <= closing_q ? closing_entry_q : entry_q;
      {chain_exit_side_o, chain_b_o, chain_exit_dx_o, chain_exit_dy_o}    <= closing_q ? closing_exit_q : exit_part;
      {chain_first_x_o, chain_first_y_o}                                  <= closing_q ? closing_first_q : first;
      {chain_last_x_o, chain_last_y_o}                                    <= closing_q ? closing_last_q : last;
      chain_vertex_o                                                      <= closing_q || vertex;
      chain_depth_o                                                       <= closing_q ? closing_depth_q : depth;
      chain_column_o                                                      <= closing_q ? closing_column_q : column_q;
      chain_row_o                                                         <= closing_q ? closing_row_q : row_q;
    end
  end

  assign idle_o = !closing_q && !chain_valid_o;

  `GNOMON_ASSERT(a_one_chain, !(send && closing_q))

endmodule
