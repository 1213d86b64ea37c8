// SPDX-License-Identifier: Apache-2.0
// sat(value >> SHIFT): floor, then saturation to OUT_BITS, all two's complement. Combinational.

module vpu_saturate #(
  parameter int unsigned IN_BITS  = 37,
  parameter int unsigned SHIFT    = 10,
  parameter int unsigned OUT_BITS = 23
) (
  input  logic signed [IN_BITS-1:0]  value_i,
  output logic signed [OUT_BITS-1:0] value_o
);

  // Holds every value, and has a bit above the narrowed one's sign to look at.
  localparam int unsigned WIDE = gnomon_pkg::max_of(IN_BITS, OUT_BITS + 1);

  logic signed [WIDE-1:0] wide;
  logic                   fits;
  assign wide    = WIDE'(value_i) >>> SHIFT;  // no value changes by the cast
  assign fits    = wide[WIDE-1:OUT_BITS-1] == '0 || wide[WIDE-1:OUT_BITS-1] == '1;
  assign value_o = fits ? wide[OUT_BITS-1:0] : {wide[WIDE-1], {(OUT_BITS - 1){!wide[WIDE-1]}}};

endmodule
