// SPDX-License-Identifier: Apache-2.0
// From a fixed-point depth to its code: floor, then saturation to 0..2^DEPTH_BITS - 2. Combinational; the only place
// where the unit narrows a depth.

module vpu_code #(
  parameter int unsigned IN_BITS    = 46,
  parameter int unsigned FRAC_BITS  = 14,
  parameter int unsigned DEPTH_BITS = 20
) (
  input  logic signed [IN_BITS-1:0] depth_i,
  output logic [DEPTH_BITS-1:0]     code_o,
  output logic                      saturated_o
);

  localparam int unsigned CODE_BITS = gnomon_pkg::max_of(IN_BITS - FRAC_BITS, DEPTH_BITS + 1);

  localparam logic signed [IN_BITS-1:0] FAULT = mutations_pkg::ROUND_DEPTH ? IN_BITS'(1) << (FRAC_BITS - 1) : '0;

  logic signed [CODE_BITS-1:0] code;
  logic                        below, above;
  assign code        = CODE_BITS'((depth_i + FAULT) >>> FRAC_BITS);  // no value changes by the cast
  assign below       = code[CODE_BITS-1];
  assign above       = !below && (code[CODE_BITS-1:DEPTH_BITS] != '0 || code[DEPTH_BITS-1:0] == '1);
  assign saturated_o = below || above;
  always_comb begin
    if (below)      code_o = '0;
    else if (above) code_o = {{(DEPTH_BITS - 1){1'b1}}, 1'b0};
    else            code_o = code[DEPTH_BITS-1:0];
  end

endmodule
