// SPDX-License-Identifier: Apache-2.0
// A plane coordinate of a corner: floor to sub-entries, then saturation to two planes on either side. Combinational.

module topology_corner #(
  parameter int unsigned ACC_BITS         = 37,
  parameter int unsigned MATRIX_FRAC_BITS = 22,
  parameter int unsigned PLANE_LOG2       = 9,
  parameter int unsigned SUB_BITS         = 4,
  // Derived; not to be overridden.
  parameter int unsigned COORDINATE = PLANE_LOG2 + SUB_BITS + 2
) (
  input  logic signed [ACC_BITS-1:0]   acc_i,
  output logic signed [COORDINATE-1:0] sub_o
);

  localparam int unsigned SHIFT = MATRIX_FRAC_BITS - SUB_BITS;
  // Holds every sum, and has a bit above the narrowed one's sign to look at.
  localparam int unsigned WIDE  = gnomon_pkg::max_of(ACC_BITS, COORDINATE + 1);

  logic signed [WIDE-1:0] wide;
  logic                   fits;
  assign wide = WIDE'(acc_i) >>> SHIFT;  // floor; no value changes by the cast
  assign fits = wide[WIDE-1:COORDINATE-1] == '0 || wide[WIDE-1:COORDINATE-1] == '1;

  // Saturation to -2^(COORDINATE-1)..2^(COORDINATE-1) - 1.
  assign sub_o = fits ? wide[COORDINATE-1:0] : {wide[WIDE-1], {(COORDINATE - 1){!wide[WIDE-1]}}};

endmodule
