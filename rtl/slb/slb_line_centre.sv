// SPDX-License-Identifier: Apache-2.0
// Whether a line's inner side, its border included, contains the pixel's centre. Combinational.

module slb_line_centre #(
  parameter int unsigned FRAC_BITS  = 7,
  parameter int unsigned SLOPE_BITS = 7,
  parameter int unsigned ROUNDING   = 0,
  // Derived; not to be overridden.
  parameter int unsigned LINE = slb_pkg::line_bits(FRAC_BITS, SLOPE_BITS)
) (
  input  logic            valid_i,
  input  logic [LINE-1:0] line_i,
  output logic            contains_o
);

  localparam int unsigned TERM = FRAC_BITS + SLOPE_BITS + 5;

  logic signed [TERM-1:0] offset, rise;
  logic                   inner;
  slb_line_terms #(.FRAC_BITS(FRAC_BITS), .SLOPE_BITS(SLOPE_BITS), .POINT_BITS(1), .ROUNDING(ROUNDING)) u_terms (
    .valid_i, .line_i, .x_i(1'b1), .y_i(1'b1), .offset_o(offset), .rise_o(rise), .inner_o(inner)
  );
  assign contains_o = inner ? offset >= rise : offset <= rise;

endmodule
