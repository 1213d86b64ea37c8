// SPDX-License-Identifier: Apache-2.0
// Parameters to hardware, without a scene.
#include "host/cli/area_hardware.hpp"

#include "host/cli/run_settings.hpp"
#include "host/plan/plan_registers.hpp"

namespace gnomon::cli {
namespace {

constexpr int kSlbPlaneLog2 = 8;  ///< unless the parameters say

/// Widths as the planner has them for this grid.
golden::HardwareConfig with_projection(golden::HardwareConfig hardware, const pipeline::RunSettings& run) {
  voxel::VoxelSet none;
  none.grid.res = run.res;
  const golden::HardwareConfig planned = plan::hardware_for(none, run.vpu);
  hardware.voxel_bits = planned.voxel_bits;
  hardware.voxel_frac_bits = planned.voxel_frac_bits;
  hardware.normal_bits = planned.normal_bits;
  hardware.matrix_frac_bits = planned.matrix_frac_bits;
  if (run.vpu.plane_log2 > 0) hardware.plane_log2 = run.vpu.plane_log2;
  return hardware;
}

}  // namespace

Result<golden::HardwareConfig> area_hardware(const config::Settings& settings, const std::string& technique) {
  const pipeline::RunSettings run = run_settings(settings);
  golden::HardwareConfig hardware;
  hardware.en_vpu_offset = false;
  if (technique.starts_with("slb"))
    hardware = run.slb.hardware(run.slb.plane_log2 > 0 ? run.slb.plane_log2 : kSlbPlaneLog2);
  hardware.depth_bits = run.vpu.depth_bits;
  hardware.en_vpu_offset = technique == "voxel-offset" || technique == "slb+voxel";
  hardware.en_vpu_topology = technique == "voxel-topology";
  if (hardware.en_vpu_topology) {
    hardware.sub_bits = run.topology.sub_bits;
    hardware.span_log2 = run.topology.span_log2;
    if (run.topology.nodes_log2 > 0) hardware.nodes_log2 = run.topology.nodes_log2;
    if (run.topology.quads_log2 > 0) hardware.quads_log2 = run.topology.quads_log2;
  }
  if (hardware.en_vpu_offset || hardware.en_vpu_topology) hardware = with_projection(hardware, run);
  if (const auto problem = hardware.check()) return fail(*problem);
  return hardware;
}

}  // namespace gnomon::cli
