// SPDX-License-Identifier: Apache-2.0
// op and corner bit of a finished chain (docs/slb.md, "op", "Corner bit"). Signs of three cross products; a chain a cycle,
// three cycles latency, never held back.

module slb_chain_op #(
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
  // As slb_chain_builder gives them.
  input  logic                     valid_i,
  input  logic signed [C-1:0]      column_i, row_i,
  input  logic [1:0]               entry_side_i, exit_side_i,
  input  logic [L-1:0]             a_i, b_i,
  input  logic signed [W:0]        entry_dx_i, entry_dy_i, exit_dx_i, exit_dy_i,
  input  logic                     vertex_i,
  input  logic [SUBPIXEL_BITS-1:0] first_x_i, first_y_i, last_x_i, last_y_i,
  input  logic [DEPTH_BITS-1:0]    depth_i,
  // Three cycles later.
  output logic                     valid_o,
  output logic signed [C-1:0]      column_o, row_o,
  output logic [1:0]               op_o,
  output logic [L-1:0]             a_o, b_o,  // b is 0 with op 0
  output logic                     corner_o,
  output logic [DEPTH_BITS-1:0]    depth_o,
  output logic                     idle_o
);

  localparam int unsigned S    = SUBPIXEL_BITS;
  localparam int unsigned BESIDE = 2 * C + 2 * L + DEPTH_BITS + 4;  // what only passes through

  logic [2:0] valid_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else         valid_q <= {valid_q[1:0], valid_i};
  end

  // 1. From the first vertex to the last, and the products of the turn.
  logic signed [S:0]       across_x_q, across_y_q;
  logic signed [W:0]       entry_dx_q, entry_dy_q, exit_dx_q, exit_dy_q;
  logic signed [2*W+1:0]   turn_plus_q, turn_minus_q;
  logic                    vertex_1_q;
  logic [BESIDE-1:0]       beside_1_q;
  always_ff @(posedge clk_i) begin
    if (valid_i) begin
      across_x_q   <= signed'({1'b0, last_x_i}) - signed'({1'b0, first_x_i});
      across_y_q   <= signed'({1'b0, last_y_i}) - signed'({1'b0, first_y_i});
      entry_dx_q   <= entry_dx_i;
      entry_dy_q   <= entry_dy_i;
      exit_dx_q    <= exit_dx_i;
      exit_dy_q    <= exit_dy_i;
      turn_plus_q  <= (2*W+2)'(entry_dx_i) * (2*W+2)'(exit_dy_i);
      turn_minus_q <= (2*W+2)'(entry_dy_i) * (2*W+2)'(exit_dx_i);
      vertex_1_q   <= vertex_i;
      beside_1_q   <= {entry_side_i, exit_side_i, column_i, row_i, a_i, b_i, depth_i};
    end
  end

  // 2. o1: the last vertex against the entry edge; o2: the first vertex against the exit edge; turn.
  localparam int unsigned O = W + S + 3;
  logic signed [O-1:0]     o1, o2;
  logic signed [2*W+2:0]   turn;
  logic                    same_way;  // where turn = 0
  always_comb begin
    o1       = 'x;
    o2       = 'x;
    turn     = 'x;
    same_way = 'x;
    if (valid_q[0]) begin
      o1       = O'(entry_dx_q) * O'(across_y_q) - O'(entry_dy_q) * O'(across_x_q);
      o2       = O'(exit_dy_q) * O'(across_x_q) - O'(exit_dx_q) * O'(across_y_q);
      turn     = (2*W+3)'(turn_plus_q) - (2*W+3)'(turn_minus_q);
      same_way = (entry_dx_q != '0) ? entry_dx_q[W] == exit_dx_q[W] : entry_dy_q[W] == exit_dy_q[W];
    end
  end

  logic              left_q, right_q;  // o1, o2 >= 0 or <= 0, not both 0
  logic              turn_left_q, turn_right_q, same_way_q, vertex_2_q;
  logic [BESIDE-1:0] beside_2_q;
  always_ff @(posedge clk_i) begin
    if (valid_q[0]) begin
      left_q       <= o1 >= 0 && o2 >= 0 && (o1 != 0 || o2 != 0);
      right_q      <= o1 <= 0 && o2 <= 0 && (o1 != 0 || o2 != 0);
      turn_left_q  <= turn > 0;
      turn_right_q <= turn < 0;
      same_way_q   <= same_way;
      vertex_2_q   <= vertex_1_q;
      beside_2_q   <= beside_1_q;
    end
  end

  // 3. op and corner bit.
  localparam logic [1:0] ONE = 2'd0, AND = 2'd1, OR = 2'd2;
  logic [1:0]            op, entry_side, exit_side;
  logic [C-1:0]          column, row;
  logic [L-1:0]          a, b;
  logic [DEPTH_BITS-1:0] depth;
  assign {entry_side, exit_side, column, row, a, b, depth} = beside_2_q;
  always_comb begin
    if (!vertex_2_q)       op = ONE;
    else if (left_q)       op = AND;
    else if (right_q)      op = OR;
    else if (turn_left_q)  op = AND;
    else if (turn_right_q) op = OR;
    else if (same_way_q || mutations_pkg::SLB_NO_SPIKES) op = ONE;
    else                   op = AND;  // a spike
  end
  always_ff @(posedge clk_i) begin
    if (valid_q[1]) begin
      column_o <= column;
      row_o    <= row;
      op_o     <= op;
      a_o      <= a;
      b_o      <= (op == ONE) ? '0 : b;
      corner_o <= (exit_side == entry_side) ? op == OR && !mutations_pkg::SLB_CORNER_BY_SIDES : exit_side > entry_side;
      depth_o  <= depth;
    end
  end
  assign valid_o = valid_q[2];
  assign idle_o  = valid_q == '0;

endmodule
