// SPDX-License-Identifier: Apache-2.0
// Front end of the silhouette-line buffer: from the vertices of loops to chains and to crossings of y = j (docs/slb.md;
// the ports are described in rtl/slb/README.md, the pipeline in "Implementation: front end").
//
//   vertices ─► slb_edge_loop ─► slb_edge_fold ─► slb_edge_divide ─► slb_edge_place ─► slb_walker ─┬─► queue ─► wind
//                                                                                                  ▼
//                        chain ◄─ queue ◄─ slb_chain_op ◄─ slb_chain_builder ◄─ 2 slb_line_encoder ─┘

`include "assertions.svh"

module slb_outline #(
  parameter int unsigned FRAC_BITS     = 7,
  parameter int unsigned SLOPE_BITS    = 7,
  parameter int unsigned DEPTH_BITS    = 20,
  parameter int unsigned PLANE_LOG2    = 8,
  parameter int unsigned SUBPIXEL_BITS = 10,
  parameter int unsigned ROUNDING      = 0,
  parameter int unsigned DIVIDERS      = 2,
  // Derived; not to be overridden.
  parameter int unsigned C = PLANE_LOG2 + 2,
  parameter int unsigned W = C + SUBPIXEL_BITS,
  parameter int unsigned L = 4 + FRAC_BITS + SLOPE_BITS
) (
  input  logic                  clk_i,
  input  logic                  rst_ni,
  input  logic                  in_valid_i,
  output logic                  in_ready_o,
  input  logic                  in_close_i,
  input  logic [W-1:0]          in_x_i, in_y_i,
  input  logic [DEPTH_BITS-1:0] in_depth_i,
  output logic                  chain_valid_o,
  input  logic                  chain_ready_i,
  output logic signed [C-1:0]   chain_column_o, chain_row_o,
  output logic [1:0]            chain_op_o,
  output logic [L-1:0]          chain_a_o, chain_b_o,
  output logic                  chain_corner_o,
  output logic [DEPTH_BITS-1:0] chain_depth_o,
  output logic                  wind_valid_o,
  input  logic                  wind_ready_i,
  output logic signed [C-1:0]   wind_column_o, wind_row_o,
  output logic                  wind_up_o,
  output logic                  event_vertex_o, event_repeated_o, event_loop_o, event_short_o,
  output logic                  event_tiny_o,
  output logic [63:0]           event_tiny_area2_o,
  output logic                  event_crossing_o,
  output logic                  idle_o
);

  localparam int unsigned F = FRAC_BITS;
  localparam int unsigned S = SUBPIXEL_BITS;
  localparam int unsigned D = DEPTH_BITS;
  localparam int unsigned K = F + S;

  // Edges.
  logic         loop_valid, loop_ready, loop_first, loop_last, loop_idle;
  logic [W-1:0] loop_x0, loop_y0, loop_x1, loop_y1;
  logic [D-1:0] loop_depth0, loop_depth1;
  slb_edge_loop #(.DEPTH_BITS(D), .PLANE_LOG2(PLANE_LOG2), .SUBPIXEL_BITS(S)) u_loop (
    .clk_i, .rst_ni, .in_valid_i, .in_ready_o, .in_close_i, .in_x_i, .in_y_i, .in_depth_i,
    .edge_valid_o(loop_valid), .edge_ready_i(loop_ready), .edge_x0_o(loop_x0), .edge_y0_o(loop_y0),
    .edge_x1_o(loop_x1), .edge_y1_o(loop_y1), .edge_depth0_o(loop_depth0), .edge_depth1_o(loop_depth1),
    .edge_first_o(loop_first), .edge_last_o(loop_last), .event_vertex_o, .event_repeated_o, .event_loop_o,
    .event_short_o, .event_tiny_o, .event_tiny_area2_o, .idle_o(loop_idle)
  );

  localparam int unsigned FOLD = 2 * S + D;
  logic            fold_valid, fold_ready, fold_first;
  logic [FOLD-1:0] fold_beside;
  slb_edge_fold #(.DEPTH_BITS(D), .PLANE_LOG2(PLANE_LOG2), .SUBPIXEL_BITS(S)) u_fold (
    .clk_i, .rst_ni, .valid_i(loop_valid), .ready_o(loop_ready), .x0_i(loop_x0), .y0_i(loop_y0), .x1_i(loop_x1),
    .y1_i(loop_y1), .depth0_i(loop_depth0), .depth1_i(loop_depth1), .first_i(loop_first), .last_i(loop_last),
    .valid_o(fold_valid), .ready_i(fold_ready), .first_o(fold_first), .chain_x_frac_o(fold_beside[D+S+:S]),
    .chain_y_frac_o(fold_beside[D+:S]), .chain_depth_o(fold_beside[0+:D])
  );

  logic            div_valid, div_ready, div_first, div_last, div_idle;
  logic [W-1:0]    div_x0, div_y0, div_x1, div_y1, div_ahead_r, div_step_r, div_depth_r;
  logic [D-1:0]    div_depth0, div_depth1, div_depth_q;
  logic [K-1:0]    div_ahead_q, div_step_q;
  logic [FOLD-1:0] div_beside;
  slb_edge_divide #(
    .FRAC_BITS(F), .DEPTH_BITS(D), .PLANE_LOG2(PLANE_LOG2), .SUBPIXEL_BITS(S), .DIVIDERS(DIVIDERS),
    .BESIDE(FOLD)
  ) u_divide (
    .clk_i, .rst_ni, .valid_i(fold_valid), .ready_o(fold_ready), .x0_i(loop_x0), .y0_i(loop_y0), .x1_i(loop_x1),
    .y1_i(loop_y1), .depth0_i(loop_depth0), .depth1_i(loop_depth1), .first_i(fold_first), .last_i(loop_last),
    .beside_i(fold_beside), .valid_o(div_valid), .ready_i(div_ready), .x0_o(div_x0), .y0_o(div_y0),
    .x1_o(div_x1), .y1_o(div_y1), .beside_o(div_beside), .depth0_o(div_depth0), .depth1_o(div_depth1),
    .first_o(div_first), .last_o(div_last), .ahead_q_o(div_ahead_q), .step_q_o(div_step_q), .ahead_r_o(div_ahead_r),
    .step_r_o(div_step_r), .depth_q_o(div_depth_q), .depth_r_o(div_depth_r), .idle_o(div_idle)
  );

  logic                edge_valid, edge_ready, edge_first, edge_last, edge_idle;
  logic signed [W:0]   edge_dx, edge_dy;
  logic [W-1:0]        edge_den, edge_ahead_r, edge_step_r, edge_depth_r;
  logic                edge_y_major, edge_forward, edge_negative, edge_level, edge_sloped, edge_rising;
  logic [S-1:0]        edge_x_frac, edge_y_frac;
  logic signed [C-1:0] edge_major, edge_minor, edge_minor_end;
  logic [C-1:0]        edge_remaining;
  logic [C:0]          edge_crossings;
  logic signed [C:0]   edge_ahead_cell, edge_step_cell;
  logic [K-1:0]        edge_ahead_k, edge_step_k;
  logic [K:0]          edge_slope;
  logic [D-1:0]        edge_depth0, edge_depth1, edge_depth_q;
  logic [D:0]          edge_depth_first;
  logic [S-1:0]        edge_chain_x_frac, edge_chain_y_frac;
  logic [D-1:0]        edge_chain_depth;
  slb_edge_place #(
    .FRAC_BITS(F), .DEPTH_BITS(D), .PLANE_LOG2(PLANE_LOG2), .SUBPIXEL_BITS(S), .BESIDE(FOLD)
  ) u_place (
    .clk_i, .rst_ni, .valid_i(div_valid), .ready_o(div_ready), .x0_i(div_x0), .y0_i(div_y0), .x1_i(div_x1),
    .y1_i(div_y1), .depth0_i(div_depth0), .depth1_i(div_depth1), .first_i(div_first), .last_i(div_last),
    .beside_i(div_beside), .beside_o({edge_chain_x_frac, edge_chain_y_frac, edge_chain_depth}),
    .ahead_q_i(div_ahead_q), .step_q_i(div_step_q), .ahead_r_i(div_ahead_r), .step_r_i(div_step_r),
    .depth_q_i(div_depth_q), .depth_r_i(div_depth_r), .valid_o(edge_valid), .ready_i(edge_ready),
    .first_o(edge_first), .last_o(edge_last), .dx_o(edge_dx), .dy_o(edge_dy), .den_o(edge_den),
    .y_major_o(edge_y_major), .forward_o(edge_forward), .negative_o(edge_negative), .level_o(edge_level),
    .x_frac_o(edge_x_frac), .y_frac_o(edge_y_frac), .major_o(edge_major), .minor_o(edge_minor),
    .minor_end_o(edge_minor_end), .remaining_o(edge_remaining), .crossings_o(edge_crossings),
    .ahead_cell_o(edge_ahead_cell), .step_cell_o(edge_step_cell), .ahead_k_o(edge_ahead_k), .step_k_o(edge_step_k),
    .ahead_r_o(edge_ahead_r), .step_r_o(edge_step_r), .slope_o(edge_slope), .sloped_o(edge_sloped),
    .rising_o(edge_rising), .depth0_o(edge_depth0), .depth1_o(edge_depth1), .depth_first_o(edge_depth_first),
    .depth_q_o(edge_depth_q), .depth_r_o(edge_depth_r), .idle_o(edge_idle)
  );

  // Steps. One may be made while the winding queue has room and fewer chains are under way than the chain queue holds,
  // so that nothing behind the walker is ever held back.
  localparam int unsigned QUEUE_LOG2 = 4;
  logic [QUEUE_LOG2:0] under_way_q;  // crossings whose chain has not left; the exit put aside is one of them
  logic                go, wind_valid, wind_ready, wind_up;
  logic signed [C-1:0] wind_column, wind_row;
  assign go = wind_ready && !under_way_q[QUEUE_LOG2];

  logic                step_valid, step_crossing, step_first, step_loop_first, step_loop_last, walk_idle;
  logic [1:0]          step_side;
  logic signed [C-1:0] step_column, step_row;
  logic signed [W:0]   step_dx, step_dy;
  logic [S-1:0]        step_first_x, step_first_y, step_last_x, step_last_y;
  logic [D-1:0]        step_depth_left, step_depth_entered;
  logic                step_y_major, step_forward, step_negative, step_level;
  logic [K:0]          step_slope;
  logic [K+3:0]        step_left_low, step_left_high, step_entered_low, step_entered_high;
  slb_walker #(.FRAC_BITS(F), .DEPTH_BITS(D), .PLANE_LOG2(PLANE_LOG2), .SUBPIXEL_BITS(S)) u_walker (
    .clk_i, .rst_ni, .edge_valid_i(edge_valid), .edge_ready_o(edge_ready), .edge_first_i(edge_first),
    .edge_last_i(edge_last), .edge_dx_i(edge_dx), .edge_dy_i(edge_dy), .edge_den_i(edge_den),
    .edge_y_major_i(edge_y_major), .edge_forward_i(edge_forward), .edge_negative_i(edge_negative),
    .edge_level_i(edge_level), .edge_x_frac_i(edge_x_frac), .edge_y_frac_i(edge_y_frac),
    .edge_chain_x_frac_i(edge_chain_x_frac), .edge_chain_y_frac_i(edge_chain_y_frac),
    .edge_chain_depth_i(edge_chain_depth), .edge_major_i(edge_major),
    .edge_minor_i(edge_minor), .edge_minor_end_i(edge_minor_end), .edge_remaining_i(edge_remaining),
    .edge_crossings_i(edge_crossings), .edge_ahead_cell_i(edge_ahead_cell), .edge_step_cell_i(edge_step_cell),
    .edge_ahead_k_i(edge_ahead_k), .edge_step_k_i(edge_step_k), .edge_ahead_r_i(edge_ahead_r),
    .edge_step_r_i(edge_step_r), .edge_slope_i(edge_slope), .edge_sloped_i(edge_sloped), .edge_rising_i(edge_rising),
    .edge_depth0_i(edge_depth0), .edge_depth1_i(edge_depth1), .edge_depth_first_i(edge_depth_first),
    .edge_depth_q_i(edge_depth_q), .edge_depth_r_i(edge_depth_r), .go_i(go), .crossing_o(event_crossing_o),
    .wind_valid_o(wind_valid), .wind_column_o(wind_column), .wind_row_o(wind_row), .wind_up_o(wind_up),
    .step_valid_o(step_valid), .step_crossing_o(step_crossing), .step_first_o(step_first),
    .step_loop_first_o(step_loop_first), .step_loop_last_o(step_loop_last), .step_side_o(step_side),
    .step_column_o(step_column), .step_row_o(step_row), .step_dx_o(step_dx), .step_dy_o(step_dy),
    .step_first_x_o(step_first_x), .step_first_y_o(step_first_y),
    .step_last_x_o(step_last_x), .step_last_y_o(step_last_y), .step_depth_left_o(step_depth_left),
    .step_depth_entered_o(step_depth_entered), .step_y_major_o(step_y_major), .step_forward_o(step_forward),
    .step_negative_o(step_negative), .step_level_o(step_level), .step_slope_o(step_slope),
    .step_left_low_o(step_left_low), .step_left_high_o(step_left_high), .step_entered_low_o(step_entered_low),
    .step_entered_high_o(step_entered_high), .idle_o(walk_idle)
  );

  stream_fifo #(.WIDTH(2 * C + 1), .DEPTH_LOG2(2)) u_wind_queue (
    .clk_i, .rst_ni, .valid_i(wind_valid), .ready_o(wind_ready), .data_i({wind_column, wind_row, wind_up}),
    .valid_o(wind_valid_o), .ready_i(wind_ready_i), .data_o({wind_column_o, wind_row_o, wind_up_o})
  );

  // Lines: of the pixel entered, and, with an edge's first crossing, of the pixel left. Five stages; what else a step
  // says waits beside them.
  localparam int unsigned STAGES = 5;
  logic [STAGES-1:0] lines_valid_q;                 // steps in the stages
  logic [STAGES-1:0] entered_en, left_en;           // those with lines
  logic [STAGES-2:0] entered_valid_q, left_valid_q;
  assign entered_en = {entered_valid_q, step_valid && step_crossing};
  assign left_en    = {left_valid_q, step_valid && step_crossing && step_first};
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      lines_valid_q   <= '0;
      entered_valid_q <= '0;
      left_valid_q    <= '0;
    end else begin
      lines_valid_q   <= {lines_valid_q[STAGES-2:0], step_valid};
      entered_valid_q <= entered_en[STAGES-2:0];
      left_valid_q    <= left_en[STAGES-2:0];
    end
  end

  logic [L-1:0] line_left, line_entered;
  slb_line_encoder #(.FRAC_BITS(F), .SLOPE_BITS(SLOPE_BITS), .SUBPIXEL_BITS(S), .ROUNDING(ROUNDING)) u_left (
    .clk_i, .rst_ni, .en_i(left_en), .low_i(step_left_low), .high_i(step_left_high), .y_major_i(step_y_major),
    .forward_i(step_forward), .negative_i(step_negative), .level_i(step_level), .slope_i(step_slope),
    .line_o(line_left)
  );
  slb_line_encoder #(.FRAC_BITS(F), .SLOPE_BITS(SLOPE_BITS), .SUBPIXEL_BITS(S), .ROUNDING(ROUNDING)) u_entered (
    .clk_i, .rst_ni, .en_i(entered_en), .low_i(step_entered_low), .high_i(step_entered_high),
    .y_major_i(step_y_major), .forward_i(step_forward), .negative_i(step_negative), .level_i(step_level),
    .slope_i(step_slope), .line_o(line_entered)
  );

  localparam int unsigned BESIDE = 4 + 2 + 2 * C + 2 * (W + 1) + 4 * S + 2 * D;
  logic                ready_beside, valid_beside;
  logic                joined_crossing, joined_first, joined_loop_first, joined_loop_last;
  logic [1:0]          joined_side;
  logic signed [C-1:0] joined_column, joined_row;
  logic signed [W:0]   joined_dx, joined_dy;
  logic [S-1:0]        joined_first_x, joined_first_y, joined_last_x, joined_last_y;
  logic [D-1:0]        joined_depth_left, joined_depth_entered;
  stream_fifo #(.WIDTH(BESIDE), .DEPTH_LOG2(3)) u_beside (
    .clk_i, .rst_ni, .valid_i(step_valid), .ready_o(ready_beside),
    .data_i({step_crossing, step_first, step_loop_first, step_loop_last, step_side, step_column, step_row, step_dx,
             step_dy, step_first_x, step_first_y, step_last_x, step_last_y, step_depth_left, step_depth_entered}),
    .valid_o(valid_beside), .ready_i(lines_valid_q[STAGES-1]),
    .data_o({joined_crossing, joined_first, joined_loop_first, joined_loop_last, joined_side, joined_column, joined_row,
             joined_dx, joined_dy, joined_first_x, joined_first_y, joined_last_x, joined_last_y, joined_depth_left,
             joined_depth_entered})
  );

  // Chains.
  logic                built_valid, built_vertex, built_idle;
  logic signed [C-1:0] built_column, built_row;
  logic [1:0]          built_entry_side, built_exit_side;
  logic [L-1:0]        built_a, built_b;
  logic signed [W:0]   built_entry_dx, built_entry_dy, built_exit_dx, built_exit_dy;
  logic [S-1:0]        built_first_x, built_first_y, built_last_x, built_last_y;
  logic [D-1:0]        built_depth;
  slb_chain_builder #(
    .FRAC_BITS(F), .SLOPE_BITS(SLOPE_BITS), .DEPTH_BITS(D), .PLANE_LOG2(PLANE_LOG2), .SUBPIXEL_BITS(S)
  ) u_builder (
    .clk_i, .rst_ni, .step_valid_i(lines_valid_q[STAGES-1]), .step_crossing_i(joined_crossing),
    .step_first_i(joined_first), .step_loop_first_i(joined_loop_first), .step_loop_last_i(joined_loop_last),
    .step_side_i(joined_side), .step_column_i(joined_column), .step_row_i(joined_row), .step_dx_i(joined_dx),
    .step_dy_i(joined_dy), .step_first_x_i(joined_first_x), .step_first_y_i(joined_first_y),
    .step_last_x_i(joined_last_x), .step_last_y_i(joined_last_y),
    .step_depth_left_i(joined_depth_left), .step_depth_entered_i(joined_depth_entered),
    .step_line_left_i(line_left), .step_line_entered_i(line_entered), .chain_valid_o(built_valid),
    .chain_column_o(built_column), .chain_row_o(built_row), .chain_entry_side_o(built_entry_side),
    .chain_exit_side_o(built_exit_side), .chain_a_o(built_a), .chain_b_o(built_b), .chain_entry_dx_o(built_entry_dx),
    .chain_entry_dy_o(built_entry_dy), .chain_exit_dx_o(built_exit_dx), .chain_exit_dy_o(built_exit_dy),
    .chain_vertex_o(built_vertex), .chain_first_x_o(built_first_x), .chain_first_y_o(built_first_y),
    .chain_last_x_o(built_last_x), .chain_last_y_o(built_last_y), .chain_depth_o(built_depth), .idle_o(built_idle)
  );

  logic                op_valid, op_ready, op_corner, op_idle;
  logic signed [C-1:0] op_column, op_row;
  logic [1:0]          op_op;
  logic [L-1:0]        op_a, op_b;
  logic [D-1:0]        op_depth;
  slb_chain_op #(
    .FRAC_BITS(F), .SLOPE_BITS(SLOPE_BITS), .DEPTH_BITS(D), .PLANE_LOG2(PLANE_LOG2), .SUBPIXEL_BITS(S)
  ) u_op (
    .clk_i, .rst_ni, .valid_i(built_valid), .column_i(built_column), .row_i(built_row),
    .entry_side_i(built_entry_side), .exit_side_i(built_exit_side), .a_i(built_a), .b_i(built_b),
    .entry_dx_i(built_entry_dx), .entry_dy_i(built_entry_dy), .exit_dx_i(built_exit_dx), .exit_dy_i(built_exit_dy),
    .vertex_i(built_vertex), .first_x_i(built_first_x), .first_y_i(built_first_y), .last_x_i(built_last_x),
    .last_y_i(built_last_y), .depth_i(built_depth), .valid_o(op_valid), .column_o(op_column), .row_o(op_row),
    .op_o(op_op), .a_o(op_a), .b_o(op_b), .corner_o(op_corner), .depth_o(op_depth), .idle_o(op_idle)
  );

  stream_fifo #(.WIDTH(2 * C + 3 + 2 * L + D), .DEPTH_LOG2(QUEUE_LOG2)) u_chain_queue (
    .clk_i, .rst_ni, .valid_i(op_valid), .ready_o(op_ready),
    .data_i({op_column, op_row, op_op, op_a, op_b, op_corner, op_depth}),
    .valid_o(chain_valid_o), .ready_i(chain_ready_i),
    .data_o({chain_column_o, chain_row_o, chain_op_o, chain_a_o, chain_b_o, chain_corner_o, chain_depth_o})
  );

  logic chain_leaves;
  assign chain_leaves = chain_valid_o && chain_ready_i;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) under_way_q <= '0;
    else         under_way_q <= under_way_q + (QUEUE_LOG2 + 1)'(event_crossing_o) - (QUEUE_LOG2 + 1)'(chain_leaves);
  end

  assign idle_o = loop_idle && div_idle && edge_idle && walk_idle && lines_valid_q == '0 && built_idle && op_idle &&
                  !chain_valid_o && !wind_valid_o;

  // What is promised to the parts that cannot be held back.
  `GNOMON_ASSERT(a_wind_taken, !wind_valid || wind_ready)
  `GNOMON_ASSERT(a_beside_lines, (!step_valid || ready_beside) && (!lines_valid_q[STAGES-1] || valid_beside))
  `GNOMON_ASSERT(a_chain_taken, !op_valid || op_ready)

endmodule
