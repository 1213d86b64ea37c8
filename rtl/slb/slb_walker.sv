// SPDX-License-Identifier: Apache-2.0
// Walks one edge after the other, a crossing a cycle (docs/slb.md, "State machine", "Depth along an edge"). A step is a
// crossing, or an edge that stays in its pixel; with its last step an edge makes room for the next. Steps go out through
// one register; what the line encoders need of the pixel left and of the pixel entered goes with them.

`include "assertions.svh"

module slb_walker #(
  parameter int unsigned FRAC_BITS     = 7,
  parameter int unsigned DEPTH_BITS    = 20,
  parameter int unsigned PLANE_LOG2    = 8,
  parameter int unsigned SUBPIXEL_BITS = 10,
  // Derived; not to be overridden.
  parameter int unsigned C = PLANE_LOG2 + 2,
  parameter int unsigned W = C + SUBPIXEL_BITS,
  parameter int unsigned K = FRAC_BITS + SUBPIXEL_BITS
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  // Edges, as slb_edge_place gives them.
  input  logic                     edge_valid_i,
  output logic                     edge_ready_o,
  input  logic                     edge_first_i, edge_last_i,
  input  logic signed [W:0]        edge_dx_i, edge_dy_i,
  input  logic [W-1:0]             edge_den_i,
  input  logic                     edge_y_major_i, edge_forward_i, edge_negative_i, edge_level_i,
  input  logic [SUBPIXEL_BITS-1:0] edge_x_frac_i, edge_y_frac_i,
  input  logic [SUBPIXEL_BITS-1:0] edge_chain_x_frac_i, edge_chain_y_frac_i,  // as slb_edge_fold gives them
  input  logic [DEPTH_BITS-1:0]    edge_chain_depth_i,
  input  logic signed [C-1:0]      edge_major_i, edge_minor_i, edge_minor_end_i,
  input  logic [C-1:0]             edge_remaining_i,
  input  logic [C:0]               edge_crossings_i,
  input  logic signed [C:0]        edge_ahead_cell_i, edge_step_cell_i,
  input  logic [K-1:0]             edge_ahead_k_i, edge_step_k_i,
  input  logic [W-1:0]             edge_ahead_r_i, edge_step_r_i,
  input  logic [K:0]               edge_slope_i,
  input  logic                     edge_sloped_i, edge_rising_i,
  input  logic [DEPTH_BITS-1:0]    edge_depth0_i, edge_depth1_i,
  input  logic [DEPTH_BITS:0]      edge_depth_first_i,
  input  logic [DEPTH_BITS-1:0]    edge_depth_q_i,
  input  logic [W-1:0]             edge_depth_r_i,
  // A step may be made in this cycle.
  input  logic                     go_i,
  // Crossings of y = j, in the cycle of the step.
  output logic                     crossing_o,
  output logic                     wind_valid_o,
  output logic signed [C-1:0]      wind_column_o, wind_row_o,
  output logic                     wind_up_o,
  // Steps.
  output logic                     step_valid_o,
  output logic                     step_crossing_o,
  output logic                     step_first_o,                    // of its edge: vertices join the chain
  output logic                     step_loop_first_o, step_loop_last_o,
  output logic [1:0]               step_side_o,                     // by which the pixel is left
  output logic signed [C-1:0]      step_column_o, step_row_o,       // of the pixel entered
  output logic signed [W:0]        step_dx_o, step_dy_o,
  output logic [SUBPIXEL_BITS-1:0] step_first_x_o, step_first_y_o, step_last_x_o, step_last_y_o,  // the ends of those
  output logic [DEPTH_BITS-1:0]    step_depth_left_o, step_depth_entered_o,
  // The edge and its positions on M = 0 and M = 1, relative to the pixel: {cell 3, k, inexact 1}.
  output logic                     step_y_major_o, step_forward_o, step_negative_o, step_level_o,
  output logic [K:0]               step_slope_o,
  output logic [K+3:0]             step_left_low_o, step_left_high_o,
  output logic [K+3:0]             step_entered_low_o, step_entered_high_o,
  output logic                     idle_o
);

  localparam int unsigned S    = SUBPIXEL_BITS;
  localparam int unsigned D    = DEPTH_BITS;
  localparam int unsigned UNIT = ((1 << FRAC_BITS) - 1) << S;

  // The edge under way: what stays, and what moves.
  logic                valid_q, start_q, loop_first_q, loop_last_q;
  logic signed [W:0]   dx_q, dy_q;
  logic [W-1:0]        den_q;
  logic                y_major_q, forward_q, negative_q, level_q;
  logic [S-1:0]        x_frac_q, y_frac_q, chain_x_frac_q, chain_y_frac_q;
  logic [D-1:0]        chain_depth_q;
  logic signed [C-1:0] minor_end_q;
  logic signed [C:0]   step_cell_q;
  logic [K-1:0]        step_k_q;
  logic [W-1:0]        step_r_q;
  logic [K:0]          slope_q;
  logic signed [C-1:0] major_q, minor_q;
  logic [C-1:0]        remaining_q;
  logic [C:0]          crossings_q;
  logic signed [C:0]   ahead_cell_q, behind_cell_q;
  logic [K-1:0]        ahead_k_q, behind_k_q;
  logic [W-1:0]        ahead_r_q;
  logic                behind_inexact_q;

  // Where this step goes.
  logic signed [C:0] current, target;
  logic              adjust, to_minor, to_major, minor_up;
  assign adjust   = !y_major_q && !level_q && !negative_q && !mutations_pkg::SLB_NO_ADJUST;
  assign current  = {minor_q[C-1], minor_q};
  assign target   = (remaining_q == '0) ? {minor_end_q[C-1], minor_end_q}
                    : ahead_cell_q - signed'((C + 1)'(adjust && ahead_k_q == '0 && ahead_r_q == '0));
  assign to_minor = current != target;
  assign minor_up = target > current;
  assign to_major = !to_minor && remaining_q != '0;

  logic step, last;
  assign step         = valid_q && go_i;
  assign last         = crossings_q[C:1] == '0;  // at most one border left
  assign edge_ready_o = !valid_q || (step && last);
  assign crossing_o   = step && (to_minor || to_major);

  logic signed [C-1:0] major_n, minor_n;
  assign minor_n = !to_minor ? minor_q : minor_up ? minor_q + C'(1) : minor_q - C'(1);
  assign major_n = !to_major ? major_q : forward_q ? major_q + C'(1) : major_q - C'(1);

  // Positions on the borders of the pixel entered.
  logic signed [C:0] sum_cell, ahead_cell_n, behind_cell_n;
  logic [K-1:0]      sum_k, ahead_k_n, behind_k_n;
  logic [W-1:0]      sum_r, ahead_r_n;
  logic              behind_inexact_n;
  slb_walk_sum #(.W(W), .K(K), .CELL_BITS(C + 1), .UNIT(UNIT)) u_ahead (
    .valid_i(step && to_major), .subtract_i(1'b0), .den_i(den_q), .a_cell_i(ahead_cell_q), .a_k_i(ahead_k_q), .a_r_i(ahead_r_q),
    .b_cell_i(step_cell_q), .b_k_i(step_k_q), .b_r_i(mutations_pkg::SLB_DRIFT ? '0 : step_r_q), .cell_o(sum_cell),
    .k_o(sum_k), .r_o(sum_r)
  );
  always_comb begin
    ahead_cell_n     = to_major ? sum_cell : ahead_cell_q;
    ahead_k_n        = to_major ? sum_k : ahead_k_q;
    ahead_r_n        = to_major ? sum_r : ahead_r_q;
    behind_cell_n    = to_major ? ahead_cell_q : behind_cell_q;
    behind_k_n       = to_major ? ahead_k_q : behind_k_q;
    behind_inexact_n = to_major ? ahead_r_q != '0 : behind_inexact_q;
  end

  // The position behind a new edge's first vertex.
  logic signed [C:0] start_cell;
  logic [K-1:0]      start_k;
  logic [W-1:0]      start_r;
  slb_walk_sum #(.W(W), .K(K), .CELL_BITS(C + 1), .UNIT(UNIT)) u_behind (
    .valid_i(edge_valid_i), .subtract_i(1'b1), .den_i(edge_den_i), .a_cell_i(edge_ahead_cell_i), .a_k_i(edge_ahead_k_i),
    .a_r_i(edge_ahead_r_i), .b_cell_i(edge_step_cell_i), .b_k_i(edge_step_k_i), .b_r_i(edge_step_r_i),
    .cell_o(start_cell), .k_o(start_k), .r_o(start_r)
  );

  logic [D-1:0] depth_left, depth_entered;
  slb_walk_depth #(.DEPTH_BITS(D), .W(W)) u_depth (
    .clk_i, .load_i(edge_valid_i && edge_ready_o), .advance_i(step && to_major), .next_i(to_major),
    .sloped_i(edge_sloped_i), .rising_i(edge_rising_i), .depth0_i(edge_depth0_i), .depth1_i(edge_depth1_i),
    .first_i(edge_depth_first_i), .q_i(edge_depth_q_i), .r_i(edge_depth_r_i), .den_i(edge_den_i), .den_q_i(den_q),
    .depth_o(depth_left), .depth_next_o(depth_entered)
  );

  always_ff @(posedge clk_i) begin
    if (!rst_ni)           valid_q <= 1'b0;
    else if (edge_ready_o) valid_q <= edge_valid_i;
  end
  always_ff @(posedge clk_i) begin
    if (edge_valid_i && edge_ready_o) begin
      start_q          <= 1'b1;
      loop_first_q     <= edge_first_i;
      loop_last_q      <= edge_last_i;
      dx_q             <= edge_dx_i;
      dy_q             <= edge_dy_i;
      den_q            <= edge_den_i;
      y_major_q        <= edge_y_major_i;
      forward_q        <= edge_forward_i;
      negative_q       <= edge_negative_i;
      level_q          <= edge_level_i;
      x_frac_q         <= edge_x_frac_i;
      y_frac_q         <= edge_y_frac_i;
      chain_x_frac_q   <= edge_chain_x_frac_i;
      chain_y_frac_q   <= edge_chain_y_frac_i;
      chain_depth_q    <= edge_chain_depth_i;
      minor_end_q      <= edge_minor_end_i;
      step_cell_q      <= edge_step_cell_i;
      step_k_q         <= edge_step_k_i;
      step_r_q         <= edge_step_r_i;
      slope_q          <= edge_slope_i;
      major_q          <= edge_major_i;
      minor_q          <= edge_minor_i;
      remaining_q      <= edge_remaining_i;
      crossings_q      <= edge_crossings_i;
      ahead_cell_q     <= edge_ahead_cell_i;
      ahead_k_q        <= edge_ahead_k_i;
      ahead_r_q        <= edge_ahead_r_i;
      behind_cell_q    <= start_cell;
      behind_k_q       <= start_k;
      behind_inexact_q <= start_r != '0;
    end else if (step) begin
      start_q          <= 1'b0;
      major_q          <= major_n;
      minor_q          <= minor_n;
      remaining_q      <= remaining_q - C'(to_major);
      crossings_q      <= crossings_q - (C + 1)'(1);
      ahead_cell_q     <= ahead_cell_n;
      ahead_k_q        <= ahead_k_n;
      ahead_r_q        <= ahead_r_n;
      behind_cell_q    <= behind_cell_n;
      behind_k_q       <= behind_k_n;
      behind_inexact_q <= behind_inexact_n;
    end
  end

  // Sides: 0 bottom, 1 right, 2 top, 3 left.
  logic       vertical, rises;
  logic [1:0] side;
  assign vertical = y_major_q == to_major;  // the border is y = j
  assign rises    = to_minor ? minor_up : forward_q;
  assign side     = vertical ? {rises, 1'b0} : {!rises, 1'b1};

  logic signed [C-1:0] row;
  assign row           = y_major_q ? major_q : minor_q;
  assign wind_valid_o  = crossing_o && vertical;
  assign wind_column_o = y_major_q ? minor_q : major_q;
  assign wind_row_o    = rises ? row + C'(1) : row;
  assign wind_up_o     = rises;

  // On the borders of a pixel that the edge touches, cell - current is within -2..2.
  function automatic logic [K+3:0] relative(logic signed [C:0] cell_of, logic [K-1:0] k, logic inexact,
                                            logic signed [C-1:0] pixel);
    relative = {3'(cell_of - {pixel[C-1], pixel}), k, inexact};
  endfunction
  logic [K+3:0] left_behind, left_ahead, entered_behind, entered_ahead;
  always_comb begin
    left_behind    = 'x;
    left_ahead     = 'x;
    entered_behind = 'x;
    entered_ahead  = 'x;
    if (step) begin
      left_behind    = relative(behind_cell_q, behind_k_q, behind_inexact_q, minor_q);
      left_ahead     = relative(ahead_cell_q, ahead_k_q, ahead_r_q != '0, minor_q);
      entered_behind = relative(behind_cell_n, behind_k_n, behind_inexact_n, minor_n);
      entered_ahead  = relative(ahead_cell_n, ahead_k_n, ahead_r_n != '0, minor_n);
    end
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) step_valid_o <= 1'b0;
    else         step_valid_o <= step;
  end
  always_ff @(posedge clk_i) begin
    if (step) begin
      step_crossing_o      <= crossing_o;
      step_first_o         <= start_q;
      step_loop_first_o    <= start_q && loop_first_q;
      step_loop_last_o     <= last && loop_last_q;
      step_side_o          <= side;
      step_column_o        <= y_major_q ? minor_n : major_n;
      step_row_o           <= y_major_q ? major_n : minor_n;
      step_dx_o            <= dx_q;
      step_dy_o            <= dy_q;
      step_first_x_o       <= chain_x_frac_q;
      step_first_y_o       <= chain_y_frac_q;
      step_last_x_o        <= x_frac_q;
      step_last_y_o        <= y_frac_q;
      step_depth_left_o    <= (chain_depth_q > depth_left) ? chain_depth_q : depth_left;
      step_depth_entered_o <= depth_entered;
      step_y_major_o       <= y_major_q;
      step_forward_o       <= forward_q;
      step_negative_o      <= negative_q;
      step_level_o         <= level_q;
      step_slope_o         <= slope_q;
      step_left_low_o      <= forward_q ? left_behind : left_ahead;
      step_left_high_o     <= forward_q ? left_ahead : left_behind;
      step_entered_low_o   <= forward_q ? entered_behind : entered_ahead;
      step_entered_high_o  <= forward_q ? entered_ahead : entered_behind;
    end
  end

  assign idle_o = !valid_q && !step_valid_o;

  // The count of borders and the walk itself agree where the edge ends.
  `GNOMON_ASSERT(a_borders_counted, !valid_q || (to_minor || to_major) == (crossings_q != '0))
  `GNOMON_ASSERT(a_neighbour, !(valid_q && to_minor) || target == current + (C + 1)'(1) || target == current - (C + 1)'(1))

endmodule
