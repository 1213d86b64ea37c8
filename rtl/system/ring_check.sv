// SPDX-License-Identifier: Apache-2.0
// Whether the registers describe a ring: its size in range, its base aligned to it, no more in it than its places.
// Combinational.

module ring_check #(
  parameter int unsigned PLACE_LOG2 = 3,    // bytes of a place
  parameter int unsigned LOG2_MIN   = 1,
  parameter int unsigned LOG2_MAX   = 16
) (
  input  system_pkg::ring_t ring_i,
  output logic              good_o
);

  logic [31:0] places, bytes_minus1, filled;
  assign places       = 32'd1 << ring_i.log2;
  assign bytes_minus1 = (places << PLACE_LOG2) - 32'd1;
  assign filled       = ring_i.head - ring_i.tail;
  assign good_o       = ring_i.log2 >= 5'(LOG2_MIN) && ring_i.log2 <= 5'(LOG2_MAX) &&
                        (ring_i.base[31:0] & bytes_minus1) == '0 && filled <= places;

  logic unused_base;
  assign unused_base = ^ring_i.base[63:32];

endmodule
