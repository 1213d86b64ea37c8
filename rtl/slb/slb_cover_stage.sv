// SPDX-License-Identifier: Apache-2.0
// Samples of COVER on their way to the plane: those off it, or in a row that FILL did not sweep, end here. One register
// stage, one sample a cycle.

`include "assertions.svh"

module slb_cover_stage #(
  parameter int unsigned DEPTH_BITS = 20,
  parameter int unsigned PLANE_LOG2 = 8
) (
  input  logic                    clk_i,
  input  logic                    rst_ni,
  input  logic                    item_valid_i,
  output logic                    item_ready_o,
  input  logic [63:0]             item_i,
  input  logic [DEPTH_BITS-1:0]   margin_i,      // of the item's command
  // Rows swept.
  input  logic                    touched_i,
  input  logic [PLANE_LOG2-1:0]   first_row_i,
  input  logic [PLANE_LOG2-1:0]   last_row_i,
  output logic                    valid_o,
  input  logic                    ready_i,
  output logic [2*PLANE_LOG2-1:0] index_o,
  output logic [DEPTH_BITS-1:0]   depth_o,       // the farthest that the sheet reaches in the pixel
  output logic [DEPTH_BITS-1:0]   front_o,       // nowhere nearer
  output logic [DEPTH_BITS-1:0]   margin_o
);

  localparam int unsigned P = PLANE_LOG2;
  localparam int unsigned C = PLANE_LOG2 + 2;
  localparam int unsigned D = DEPTH_BITS;

  logic [C-1:0] column, row;
  logic         on_plane, swept, valid_q;
  assign {row, column} = item_i[2*C-1:0];
  assign on_plane      = row[C-1:P] == '0 && column[C-1:P] == '0;
  assign swept         = (touched_i && row[P-1:0] >= first_row_i && row[P-1:0] <= last_row_i) ||
                         mutations_pkg::SLB_COVER_ALL_ROWS;

  // Saturating at 0; 2^range - 1 has up to 31 bits.
  logic [30:0] depth, reach, front;
  assign depth = 31'(item_i[2*C+:D]);
  assign reach = ~({31{1'b1}} << item_i[2*C+D+:slb_pkg::RANGE_BITS]);
  assign front = (depth > reach) ? depth - reach : '0;

  assign item_ready_o = !valid_q || ready_i;
  assign valid_o      = valid_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni)           valid_q <= 1'b0;
    else if (item_ready_o) valid_q <= item_valid_i && on_plane && swept;
  end
  always_ff @(posedge clk_i) begin
    if (item_ready_o && item_valid_i) begin
      index_o  <= {row[P-1:0], column[P-1:0]};
      depth_o  <= item_i[2*C+:D];
      front_o  <= front[D-1:0];
      margin_o <= margin_i;
    end
  end

  logic unused_item;
  assign unused_item = ^{item_i[63:2*C+D+slb_pkg::RANGE_BITS], front[30:D]};

  `GNOMON_ASSERT_STREAM(a_output_stable, valid_o, ready_i, {index_o, depth_o, front_o, margin_o})

endmodule
