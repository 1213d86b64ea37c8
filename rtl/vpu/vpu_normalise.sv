// SPDX-License-Identifier: Apache-2.0
// min(value >> shift, 2^OUT_BITS - 1): floor of a magnitude, then saturation. Combinational.

module vpu_normalise #(
  parameter int unsigned IN_BITS  = 34,
  parameter int unsigned OUT_BITS = 16
) (
  input  logic [IN_BITS-1:0]                value_i,
  input  logic [gnomon_pkg::SHIFT_BITS-1:0] shift_i,
  output logic [OUT_BITS-1:0]               value_o
);

  logic [IN_BITS-1:0] shifted;
  assign shifted = value_i >> shift_i;
  assign value_o = (shifted[IN_BITS-1:OUT_BITS] != '0) ? '1 : shifted[OUT_BITS-1:0];

endmodule
