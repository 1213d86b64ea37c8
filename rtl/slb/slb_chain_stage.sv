// SPDX-License-Identifier: Apache-2.0
// Chains on their way from the walk to the plane: those off the plane are left out, the others learn how they stand to the
// pixel's centre. One register stage, one chain a cycle.

`include "assertions.svh"

module slb_chain_stage #(
  parameter int unsigned FRAC_BITS  = 7,
  parameter int unsigned SLOPE_BITS = 7,
  parameter int unsigned DEPTH_BITS = 20,
  parameter int unsigned PLANE_LOG2 = 8,
  parameter int unsigned ROUNDING   = 0,
  // Derived; not to be overridden.
  parameter int unsigned LINE      = slb_pkg::line_bits(FRAC_BITS, SLOPE_BITS),
  parameter int unsigned CELL_BITS = PLANE_LOG2 + 2
) (
  input  logic                        clk_i,
  input  logic                        rst_ni,
  input  logic                        chain_valid_i,
  output logic                        chain_ready_o,
  input  logic signed [CELL_BITS-1:0] chain_column_i,
  input  logic signed [CELL_BITS-1:0] chain_row_i,
  input  logic [1:0]                  chain_op_i,
  input  logic [LINE-1:0]             chain_a_i,
  input  logic [LINE-1:0]             chain_b_i,
  input  logic                        chain_corner_i,
  input  logic [DEPTH_BITS-1:0]       chain_depth_i,
  output logic                        valid_o,
  input  logic                        ready_i,
  output logic [2*PLANE_LOG2-1:0]     index_o,
  output logic [1:0]                  op_o,
  output logic [LINE-1:0]             a_o,
  output logic [LINE-1:0]             b_o,
  output logic [LINE-1:0]             join_o,      // what it becomes as the second chain of a fragment
  output logic                        contains_o,  // it contains the centre
  output logic                        corner_o,
  output logic [DEPTH_BITS-1:0]       depth_o,
  output logic                        given_o,     // event: a chain goes on to the plane
  output logic                        off_plane_o  // event: a chain is left out
);

  localparam int unsigned P = PLANE_LOG2;

  logic in_a, in_b, contains, on_plane, take;
  slb_line_centre #(.FRAC_BITS(FRAC_BITS), .SLOPE_BITS(SLOPE_BITS), .ROUNDING(ROUNDING)) u_a (
    .valid_i(chain_valid_i), .line_i(chain_a_i), .contains_o(in_a)
  );
  slb_line_centre #(.FRAC_BITS(FRAC_BITS), .SLOPE_BITS(SLOPE_BITS), .ROUNDING(ROUNDING)) u_b (
    .valid_i(chain_valid_i), .line_i(chain_b_i), .contains_o(in_b)
  );
  always_comb begin
    case (chain_op_i)
      slb_pkg::FRAGMENT_AND: contains = in_a && in_b;
      slb_pkg::FRAGMENT_OR:  contains = in_a || in_b;
      default:               contains = in_a;
    endcase
  end

  logic valid_q;
  assign on_plane      = chain_column_i[CELL_BITS-1:P] == '0 && chain_row_i[CELL_BITS-1:P] == '0;
  assign chain_ready_o = !valid_q || ready_i;
  assign take          = chain_valid_i && chain_ready_o;
  assign given_o       = take && on_plane;
  assign off_plane_o   = take && !on_plane;
  assign valid_o       = valid_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni)            valid_q <= 1'b0;
    else if (chain_ready_o) valid_q <= given_o;
  end
  always_ff @(posedge clk_i) begin
    if (take) begin
      index_o    <= {chain_row_i[P-1:0], chain_column_i[P-1:0]};
      op_o       <= chain_op_i;
      a_o        <= chain_a_i;
      b_o        <= chain_b_i;
      join_o     <= (in_a == contains || mutations_pkg::SLB_FIRST_LINE) ? chain_a_i : chain_b_i;
      contains_o <= contains;
      corner_o   <= chain_corner_i;
      depth_o    <= chain_depth_i;
    end
  end

  `GNOMON_ASSERT_STREAM(a_output_stable, valid_o, ready_i, {index_o, op_o, a_o, b_o, corner_o, depth_o})

endmodule
