// SPDX-License-Identifier: Apache-2.0
// What an edge's end points say at once (docs/slb.md, "Walk of one edge"): differences, major axis, signs, distance to
// the first major border. Combinational.

module slb_edge_delta #(
  parameter int unsigned W             = 20,
  parameter int unsigned SUBPIXEL_BITS = 10
) (
  input  logic                   valid_i,       // else nothing that comes out means anything
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

  logic [W-1:0] x_abs, y_abs;  // |difference| < 2^W
  logic [S:0]   offset;        // of the first vertex above the border below it
  always_comb begin
    dx_o        = 'x;
    dy_o        = 'x;
    x_abs       = 'x;
    y_abs       = 'x;
    y_major_o   = 'x;
    forward_o   = 'x;
    falling_o   = 'x;
    den_o       = 'x;
    minor_abs_o = 'x;
    level_o     = 'x;
    offset      = 'x;
    distance_o  = 'x;
    if (valid_i) begin
      dx_o        = signed'({x1_i[W-1], x1_i}) - signed'({x0_i[W-1], x0_i});
      dy_o        = signed'({y1_i[W-1], y1_i}) - signed'({y0_i[W-1], y0_i});
      x_abs       = dx_o[W] ? W'(-dx_o) : dx_o[W-1:0];
      y_abs       = dy_o[W] ? W'(-dy_o) : dy_o[W-1:0];
      y_major_o   = x_abs <= y_abs;
      forward_o   = y_major_o ? !dy_o[W] : !dx_o[W];
      falling_o   = y_major_o ? dx_o[W] : dy_o[W];
      den_o       = y_major_o ? y_abs : x_abs;
      minor_abs_o = y_major_o ? x_abs : y_abs;
      level_o     = minor_abs_o == '0;
      offset      = {1'b0, y_major_o ? y0_i[S-1:0] : x0_i[S-1:0]};
      distance_o  = forward_o ? {1'b1, {S{1'b0}}} - offset : offset;
    end
  end

endmodule
