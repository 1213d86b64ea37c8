// SPDX-License-Identifier: Apache-2.0
// A line against a point of its pixel, without division (docs/slb.md, "Query"): the two terms whose difference
//   V = (2 m D0 - (2 frac + h) one) D1 - 2 sigma slope D0 (M - cross one)
// has the sign of the side. Combinational; who uses it compares them, a cycle later where the clock wants it.

module slb_line_terms #(
  parameter int unsigned FRAC_BITS  = 7,
  parameter int unsigned SLOPE_BITS = 7,
  parameter int unsigned POINT_BITS = 11,    // fraction bits of the point: one = 2^POINT_BITS
  parameter int unsigned ROUNDING   = 0,
  // Derived; not to be overridden. Every product fits: |V| < 2^(F + S + POINT_BITS + 3).
  parameter int unsigned LINE = slb_pkg::line_bits(FRAC_BITS, SLOPE_BITS),
  parameter int unsigned TERM = FRAC_BITS + SLOPE_BITS + POINT_BITS + 4
) (
  input  logic                   valid_i,   // else the terms mean nothing
  input  logic [LINE-1:0]        line_i,
  input  logic [POINT_BITS-1:0]  x_i,
  input  logic [POINT_BITS-1:0]  y_i,
  output logic signed [TERM-1:0] offset_o,  // (2 m D0 - (2 frac + h) one) D1
  output logic signed [TERM-1:0] rise_o,    // 2 sigma slope D0 (M - cross one)
  output logic                   inner_o
);

  localparam int unsigned F = FRAC_BITS;
  localparam int unsigned S = SLOPE_BITS;
  localparam bit          PUBLISHED = ROUNDING != 0;

  logic                         y_major, negative, at_one, halfway;
  logic [F-1:0]                 stored, frac;
  logic [S-1:0]                 slope;
  logic [POINT_BITS-1:0]        minor_at, major_at;
  logic signed [TERM-1:0]       minor_d0, distance, product_d0;
  logic signed [POINT_BITS:0]   major_distance;
  logic signed [POINT_BITS+S:0] product;
  always_comb begin
    {y_major, negative, at_one, inner_o, stored, slope} = line_i;
    minor_at       = '0;
    major_at       = '0;
    frac           = '0;
    halfway        = 1'b0;
    minor_d0       = '0;
    distance       = '0;
    major_distance = '0;
    product        = '0;
    product_d0     = '0;
    offset_o       = 'x;
    rise_o         = 'x;
    if (valid_i) begin
      minor_at = y_major ? x_i : y_i;
      major_at = y_major ? y_i : x_i;
      frac     = (PUBLISHED && negative) ? ~stored : stored;  // D0 - frac
      // The halfway bit: frac < D0, and the code of the crossing of M = 0, frac + slope where the slope is negative, is in
      // range too.
      if (!PUBLISHED && F == S) begin
        halfway = at_one && stored != '1 &&
                  (negative ? (F + 1)'(stored) + (F + 1)'(slope) < (F + 1)'((1 << F) - 1) : stored >= F'(slope));
      end

      // Multiplications by D0 and D1 are a shift and a subtraction.
      minor_d0 = (TERM'(minor_at) << (F + 1)) - (TERM'(minor_at) << 1);
      distance = minor_d0 - (TERM'({frac, halfway}) << POINT_BITS);
      offset_o = (distance <<< S) - distance;

      // M - cross one lies in -one..one - 1, the product in POINT_BITS + S + 1 bits with its sign.
      major_distance = {at_one, major_at};
      product        = (POINT_BITS + S + 1)'(major_distance) * signed'((POINT_BITS + S + 1)'(slope));
      product_d0     = (TERM'(product) <<< (F + 1)) - (TERM'(product) <<< 1);
      rise_o         = negative ? -product_d0 : product_d0;
    end
  end

endmodule
