// SPDX-License-Identifier: Apache-2.0
// Last step of edge set-up (docs/slb.md, "Set-up: two quotients"): from an edge and its quotients to what the walker
// starts with. One register; the walker subtracts `step` from `ahead` itself when it takes the edge.

`include "assertions.svh"

module slb_edge_place #(
  parameter int unsigned FRAC_BITS     = 7,
  parameter int unsigned DEPTH_BITS    = 20,
  parameter int unsigned PLANE_LOG2    = 8,
  parameter int unsigned SUBPIXEL_BITS = 10,
  parameter int unsigned BESIDE        = 1,
  // Derived; not to be overridden.
  parameter int unsigned C = PLANE_LOG2 + 2,
  parameter int unsigned W = C + SUBPIXEL_BITS,
  parameter int unsigned K = FRAC_BITS + SUBPIXEL_BITS
) (
  input  logic                         clk_i,
  input  logic                         rst_ni,
  input  logic                         valid_i,
  output logic                         ready_o,
  input  logic [W-1:0]                 x0_i, y0_i, x1_i, y1_i,
  input  logic [DEPTH_BITS-1:0]        depth0_i, depth1_i,
  input  logic                         first_i, last_i,
  input  logic [BESIDE-1:0]            beside_i,
  input  logic [K-1:0]                 ahead_q_i, step_q_i,
  input  logic [W-1:0]                 ahead_r_i, step_r_i,
  input  logic [DEPTH_BITS-1:0]        depth_q_i,
  input  logic [W-1:0]                 depth_r_i,
  output logic                         valid_o,
  input  logic                         ready_i,
  output logic                         first_o, last_o,                 // of its loop
  output logic [BESIDE-1:0]            beside_o,
  output logic signed [W:0]            dx_o, dy_o,
  output logic [W-1:0]                 den_o,
  output logic                         y_major_o, forward_o, negative_o, level_o,
  output logic [SUBPIXEL_BITS-1:0]     x_frac_o, y_frac_o,              // of the edge's first vertex
  output logic signed [C-1:0]          major_o, minor_o, minor_end_o,   // pixels
  output logic [C-1:0]                 remaining_o,                     // major borders to cross
  output logic [C:0]                   crossings_o,                     // borders to cross
  output logic signed [C:0]            ahead_cell_o, step_cell_o,
  output logic [K-1:0]                 ahead_k_o, step_k_o,
  output logic [W-1:0]                 ahead_r_o, step_r_o,
  output logic [K:0]                   slope_o,                         // |step| in 1/(2U) pixel, rounded to odd
  output logic                         sloped_o, rising_o,              // depth; not sloped: the larger one holds
  output logic [DEPTH_BITS-1:0]        depth0_o, depth1_o,
  output logic [DEPTH_BITS:0]          depth_first_o,                   // change to the first border, rounded up
  output logic [DEPTH_BITS-1:0]        depth_q_o,
  output logic [W-1:0]                 depth_r_o,
  output logic                         idle_o
);

  localparam int unsigned S    = SUBPIXEL_BITS;
  localparam int unsigned D    = DEPTH_BITS;
  localparam int unsigned UNIT = ((1 << FRAC_BITS) - 1) << S;

  logic              y_major, forward, falling, level;
  logic signed [W:0] dx, dy;
  logic [W-1:0]      den, minor_abs;
  logic [S:0]        distance;
  slb_edge_delta #(.W(W), .SUBPIXEL_BITS(S)) u_delta (
    .valid_i, .x0_i, .y0_i, .x1_i, .y1_i, .dx_o(dx), .dy_o(dy), .y_major_o(y_major), .forward_o(forward), .falling_o(falling),
    .level_o(level), .den_o(den), .minor_abs_o(minor_abs), .distance_o(distance)
  );
  logic unused_minor;
  assign unused_minor = ^minor_abs;

  // |pixel difference| < 2^C
  logic signed [C-1:0] column0, row0, column1, row1;
  logic [C-1:0]        columns, rows;
  assign column0 = x0_i[W-1:S];
  assign row0    = y0_i[W-1:S];
  assign column1 = x1_i[W-1:S];
  assign row1    = y1_i[W-1:S];
  assign columns = (column1 < column0) ? C'(column0 - column1) : C'(column1 - column0);
  assign rows    = (row1 < row0) ? C'(row0 - row1) : C'(row1 - row0);

  // D0 · fraction of the minor coordinate, below U
  logic [S-1:0] minor_frac;
  logic [K-1:0] k0;
  assign minor_frac = y_major ? x0_i[S-1:0] : y0_i[S-1:0];
  assign k0         = (K'(minor_frac) << FRAC_BITS) - K'(minor_frac);

  logic signed [C-1:0] minor0;
  assign minor0 = y_major ? column0 : row0;

  logic signed [C:0] ahead_cell, step_cell;
  logic [K-1:0]      ahead_k, step_k;
  logic [W-1:0]      ahead_r, step_r;
  slb_walk_sum #(.W(W), .K(K), .CELL_BITS(C + 1), .UNIT(UNIT)) u_ahead (
    .valid_i, .subtract_i(falling), .den_i(den), .a_cell_i({minor0[C-1], minor0}), .a_k_i(k0), .a_r_i('0), .b_cell_i('0),
    .b_k_i(ahead_q_i), .b_r_i(ahead_r_i), .cell_o(ahead_cell), .k_o(ahead_k), .r_o(ahead_r)
  );
  slb_walk_sum #(.W(W), .K(K), .CELL_BITS(C + 1), .UNIT(UNIT)) u_step (
    .valid_i, .subtract_i(falling), .den_i(den), .a_cell_i('0), .a_k_i('0), .a_r_i('0), .b_cell_i('0),
    .b_k_i(step_q_i), .b_r_i(step_r_i), .cell_o(step_cell), .k_o(step_k), .r_o(step_r)
  );

  // Rising: ceil((q3 + 1)·distance / 2^s); falling: floor(q3·distance / 2^s). At most 2^D, as distance <= 2^s.
  logic              rising;
  logic [D+S+1:0]    product;
  assign rising  = depth1_i > depth0_i;
  always_comb begin
    product = 'x;
    if (valid_i) begin
      product = ((D+S+2)'(depth_q_i) + (D+S+2)'(rising)) * (D+S+2)'(distance)
                + (rising ? {{(D+2){1'b0}}, {S{1'b1}}} : '0);
    end
  end

  logic valid_q, advance;
  assign advance = !valid_q || ready_i;
  assign ready_o = advance;
  assign valid_o = valid_q;
  assign idle_o  = !valid_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni)      valid_q <= 1'b0;
    else if (advance) valid_q <= valid_i;
  end

  always_ff @(posedge clk_i) begin
    if (advance && valid_i) begin
      first_o       <= first_i;
      last_o        <= last_i;
      beside_o      <= beside_i;
      dx_o          <= dx;
      dy_o          <= dy;
      den_o         <= den;
      y_major_o     <= y_major;
      forward_o     <= forward;
      negative_o    <= !level && falling == forward;
      level_o       <= level;
      x_frac_o      <= x0_i[S-1:0];
      y_frac_o      <= y0_i[S-1:0];
      major_o       <= y_major ? row0 : column0;
      minor_o       <= minor0;
      minor_end_o   <= y_major ? column1 : row1;
      remaining_o   <= y_major ? rows : columns;
      crossings_o   <= (C+1)'(columns) + (C+1)'(rows);
      ahead_cell_o  <= ahead_cell;
      ahead_k_o     <= ahead_k;
      ahead_r_o     <= ahead_r;
      step_cell_o   <= step_cell;
      step_k_o      <= step_k;
      step_r_o      <= step_r;
      slope_o       <= {step_q_i, step_r_i != '0};
      sloped_o      <= depth1_i != depth0_i && den > W'(1 << S);
      rising_o      <= rising;
      depth0_o      <= depth0_i;
      depth1_o      <= depth1_i;
      depth_first_o <= product[D+S:S];
      depth_q_o     <= depth_q_i;
      depth_r_o     <= depth_r_i;
    end
  end
  logic unused_product;
  assign unused_product = ^{product[D+S+1], product[S-1:0]};

endmodule
