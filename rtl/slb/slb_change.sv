// SPDX-License-Identifier: Apache-2.0
// Changes a winding sum by one, kept to -127..127. Combinational: the modify function of a read-modify-write.

module slb_change (
  input  logic [slb_pkg::CHANGE_BITS-1:0] sum_i,
  input  logic                            down_i,       // +1 going down, -1 going up
  output logic [slb_pkg::CHANGE_BITS-1:0] sum_o,
  output logic                            saturated_o   // the change does not fit and is left out
);

  localparam int unsigned C = slb_pkg::CHANGE_BITS;

  // 129 is -127.
  assign saturated_o = (down_i ? sum_i == C'(127) : sum_i == C'(129)) && !mutations_pkg::SLB_WRAP_WINDING;
  assign sum_o       = down_i ? sum_i + C'(1) : sum_i - C'(1);

endmodule
