// SPDX-License-Identifier: Apache-2.0
// From fixed-point plane coordinates to an entry and a depth code: floor, range check, saturation. Combinational; the
// only place where the unit narrows a position.

module vpu_locate #(
  parameter int unsigned UV_BITS      = 37,
  parameter int unsigned UV_FRAC_BITS = 22,
  parameter int unsigned D_BITS       = 46,
  parameter int unsigned D_FRAC_BITS  = 14,
  parameter int unsigned DEPTH_BITS   = 20,
  parameter int unsigned PLANE_LOG2   = 9
) (
  input  logic signed [UV_BITS-1:0]               u_i,
  input  logic signed [UV_BITS-1:0]               v_i,
  input  logic signed [D_BITS-1:0]                d_i,
  output logic                                    off_plane_o,
  output logic [2*PLANE_LOG2-1:0]                 index_o,       // meaningless off the plane
  output logic [gnomon_pkg::DEPTH_FIELD_BITS-1:0] depth_o,
  output logic                                    saturated_o
);

  // Wide enough for every integer part, and for the plane's side with a sign.
  localparam int unsigned ENTRY_BITS = gnomon_pkg::max_of(UV_BITS - UV_FRAC_BITS, PLANE_LOG2 + 1);
  localparam int unsigned CODE_BITS  = D_BITS - D_FRAC_BITS;
  localparam int unsigned DEPTH      = gnomon_pkg::DEPTH_FIELD_BITS;

  localparam logic signed [D_BITS-1:0] FAULT = mutations_pkg::ROUND_DEPTH ? D_BITS'(1) << (D_FRAC_BITS - 1) : '0;

  // Floor: an arithmetic shift drops the fraction. No value changes by the size casts, the integer parts fit.
  logic signed [ENTRY_BITS-1:0] u, v;
  logic signed [CODE_BITS-1:0]  code;
  assign u    = ENTRY_BITS'(u_i >>> UV_FRAC_BITS);
  assign v    = ENTRY_BITS'(v_i >>> UV_FRAC_BITS);
  assign code = CODE_BITS'((d_i + FAULT) >>> D_FRAC_BITS);

  // 0 <= u, v < 2^PLANE_LOG2: no bit set above, the sign among them.
  assign off_plane_o = u[ENTRY_BITS-1:PLANE_LOG2] != '0 || v[ENTRY_BITS-1:PLANE_LOG2] != '0;
  assign index_o     = {v[PLANE_LOG2-1:0], u[PLANE_LOG2-1:0]};

  // Saturation to 0..2^DEPTH_BITS - 2.
  localparam logic [DEPTH-1:0] DEEPEST = (DEPTH'(1) << DEPTH_BITS) - DEPTH'(2);
  logic below, above;
  assign below       = code[CODE_BITS-1];
  assign above       = !below && (code[CODE_BITS-1:DEPTH_BITS] != '0 || code[DEPTH_BITS-1:0] == '1);
  assign saturated_o = below || above;
  always_comb begin
    if (below)      depth_o = '0;
    else if (above) depth_o = DEEPEST;
    else            depth_o = DEPTH'(code[DEPTH_BITS-1:0]);
  end

endmodule
