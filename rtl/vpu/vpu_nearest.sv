// SPDX-License-Identifier: Apache-2.0
// Modify function of the project pass: an entry keeps the nearest depth. Strictly smaller, so that ties keep the earlier
// voxel. Combinational, inside the plane's read-modify-write.

module vpu_nearest (
  input  gnomon_pkg::plane_entry_t                entry_i,
  input  logic [gnomon_pkg::DEPTH_FIELD_BITS-1:0] depth_i,
  output logic                                    write_o,
  output logic [gnomon_pkg::DEPTH_FIELD_BITS-1:0] depth_o
);

  assign write_o = !entry_i.present || depth_i < entry_i.depth ||
                   (mutations_pkg::TIES_REPLACE && depth_i == entry_i.depth);
  assign depth_o = depth_i;

endmodule
