// SPDX-License-Identifier: Apache-2.0
// The beam of a voxel: its lifted point in sub-entries of the plane, and the depth code where it starts: floors, range
// check, saturation. One registered stage.

module topology_lift #(
  parameter int unsigned POSITION_BITS    = 10,
  parameter int unsigned NORMAL_BITS      = 9,
  parameter int unsigned MATRIX_FRAC_BITS = 22,
  parameter int unsigned DEPTH_BITS       = 20,
  parameter int unsigned PLANE_LOG2       = 9,
  parameter int unsigned SUB_BITS         = 4,
  // Derived; not to be overridden.
  parameter int unsigned UV_SUM = gnomon_pkg::uv_offset_bits(MATRIX_FRAC_BITS, POSITION_BITS, NORMAL_BITS),
  parameter int unsigned D_SUM  = gnomon_pkg::depth_offset_bits(DEPTH_BITS, POSITION_BITS, NORMAL_BITS),
  parameter int unsigned PLACE  = PLANE_LOG2 + SUB_BITS
) (
  input  logic                     clk_i,
  input  logic                     en_i,
  input  logic signed [UV_SUM-1:0] u_sum_i, v_sum_i,
  input  logic signed [D_SUM-1:0]  d_sum_i,
  output logic                     off_plane_o,
  output logic [PLACE-1:0]         u_o, v_o,     // meaningless off the plane
  output logic [DEPTH_BITS-1:0]    depth_o
);

  // To sub-entries: on a plane with 2^SUB_BITS times the entries a side.
  logic                                    off_plane, unused_saturated;  // only PUT_QUADS flags saturation
  logic [2*PLACE-1:0]                      place;
  logic [gnomon_pkg::DEPTH_FIELD_BITS-1:0] depth;
  vpu_locate #(
    .UV_BITS     (UV_SUM),
    .UV_FRAC_BITS(MATRIX_FRAC_BITS - SUB_BITS),
    .D_BITS      (D_SUM),
    .D_FRAC_BITS (gnomon_pkg::depth_frac_bits(POSITION_BITS) - POSITION_BITS),
    .DEPTH_BITS  (DEPTH_BITS),
    .PLANE_LOG2  (PLACE)
  ) u_locate (
    .u_i(u_sum_i), .v_i(v_sum_i), .d_i(d_sum_i), .off_plane_o(off_plane), .index_o(place), .depth_o(depth),
    .saturated_o(unused_saturated)
  );
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      off_plane_o <= off_plane;
      {v_o, u_o}  <= place;
      depth_o     <= depth[DEPTH_BITS-1:0];
    end
  end

  if (DEPTH_BITS < gnomon_pkg::DEPTH_FIELD_BITS) begin : gen_unused
    logic unused_depth;
    assign unused_depth = ^depth[gnomon_pkg::DEPTH_FIELD_BITS-1:DEPTH_BITS];  // zero
  end

endmodule
