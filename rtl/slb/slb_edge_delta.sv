// SPDX-License-Identifier: Apache-2.0
// What an edge's end points say at once (docs/slb.md, "Walk of one edge"): differences, major axis, signs, distance to
// the first major border. Combinational.

module slb_edge_delta #(
  parameter int unsigned W             = 20,
  parameter int unsigned SUBPIXEL_BITS = 10
) (
  input  logic [W-1:0]           x0_i, y0_i, x1_i, y1_i,
  output logic signed [W:0]      dx_o, dy_o,
  output logic                   y_major_o,
  output logic                   forward_o,     // the major coordinate grows
  output logic                   falling_o,     // the minor coordinate falls
  output logic                   level_o,       // the minor coordinate stays
  output logic [W-1:0]           den_o,         // |major difference|; 0 only where a loop's last edge has no length
  output logic [W-1:0]           minor_abs_o,   // |minor difference| <= den
  output logic [SUBPIXEL_BITS:0] distance_o     // to the first major border ahead, 0..2^s
);

  localparam int unsigned S = SUBPIXEL_BITS;

  assign dx_o = signed'({x1_i[W-1], x1_i}) - signed'({x0_i[W-1], x0_i});
  assign dy_o = signed'({y1_i[W-1], y1_i}) - signed'({y0_i[W-1], y0_i});

  // |difference| < 2^W
  logic [W-1:0] x_abs, y_abs;
  assign x_abs = dx_o[W] ? W'(-dx_o) : dx_o[W-1:0];
  assign y_abs = dy_o[W] ? W'(-dy_o) : dy_o[W-1:0];

  assign y_major_o   = x_abs <= y_abs;
  assign forward_o   = y_major_o ? !dy_o[W] : !dx_o[W];
  assign falling_o   = y_major_o ? dx_o[W] : dy_o[W];
  assign level_o     = minor_abs_o == '0;
  assign den_o       = y_major_o ? y_abs : x_abs;
  assign minor_abs_o = y_major_o ? x_abs : y_abs;

  logic [S:0] offset;  // of the first vertex above the border below it
  assign offset     = {1'b0, y_major_o ? y0_i[S-1:0] : x0_i[S-1:0]};
  assign distance_o = forward_o ? {1'b1, {S{1'b0}}} - offset : offset;

endmodule
