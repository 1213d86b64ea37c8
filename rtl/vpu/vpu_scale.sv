// SPDX-License-Identifier: Apache-2.0
// sat((value << left) >> SHIFT): a number is normalised by the shift of its divisor. Combinational.

module vpu_scale #(
  parameter int unsigned IN_BITS  = 37,
  parameter int unsigned LEFT_MAX = 13,   // the largest `left_i`
  parameter int unsigned SHIFT    = 13,
  parameter int unsigned OUT_BITS = 25
) (
  input  logic signed [IN_BITS-1:0]                value_i,
  input  logic [gnomon_pkg::NORMALISE_BITS-1:0]    left_i,
  output logic signed [OUT_BITS-1:0]               value_o
);

  localparam int unsigned WIDE = IN_BITS + LEFT_MAX;  // nothing is shifted out
  logic signed [WIDE-1:0] wide;
  assign wide = WIDE'(value_i) <<< left_i;
  vpu_saturate #(.IN_BITS(WIDE), .SHIFT(SHIFT), .OUT_BITS(OUT_BITS)) u_saturate (.value_i(wide), .value_o);

endmodule
