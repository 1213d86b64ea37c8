// SPDX-License-Identifier: Apache-2.0
// From voxels and a light to the VPU's configuration, registers and command stream. Theory: docs/vpu.md,
// docs/planning.md.
#pragma once

#include <gnomon/golden/codec.hpp>
#include <gnomon/golden/config.hpp>
#include <gnomon/golden/stream.hpp>
#include <span>
#include <vector>

#include "host/base/result.hpp"
#include "host/base/vec.hpp"
#include "host/plan/light_view.hpp"
#include "host/plan/projection.hpp"
#include "host/voxel/voxel_set.hpp"

namespace gnomon::plan {

/// What the user may choose about the VPU; the rest follows from the scene.
struct VpuSettings {
  double pitch = 1.4;       ///< voxels per plane entry; in perspective at the typical receiver
  double caster_pitch = 0;  ///< in perspective: the same at the nearest casters, at least; 0: pitch

  double offset_factor = 0.7;  ///< voxels that an uncertain voxel moves along its normal
  double margin = 1.5;         ///< slope-scaled margin, voxels per unit of tan(N, L)
  double margin_tan_max = 10;  ///< where the margin stops growing
  int plane_log2 = 0;          ///< log2 of the plane's side; 0: the smallest that holds the scene
  int voxel_frac_bits = -1;    ///< -1: as many as the voxel word leaves, at most 4
  int normal_bits = 0;         ///< 0: as many as the voxel word leaves, at most 9
  int matrix_frac_bits = 22;
  int depth_bits = 20;
};

/// Everything the VPU needs for one view of a light.
struct VpuPlan {
  golden::HardwareConfig config;
  Projection projection;
  VpuSettings settings;
  std::vector<std::int64_t> registers;  ///< all that `config` has, in register order
};

/// The plane holds all of `seen`, casters and receivers. Fails where the settings make no legal hardware (the
/// error names the key) or nothing is seen.
Result<VpuPlan> plan_vpu(const voxel::VoxelSet& voxels, const LightView& view, const ViewVoxels& seen,
                         const VpuSettings& settings);
/// For one directional light over all voxels: `light` is the way it travels, any length but zero.
Result<VpuPlan> plan_vpu(const voxel::VoxelSet& voxels, const Vec3& light, const VpuSettings& settings);

/// A voxel as the hardware sees it: position and normal quantised (position: floor; normal: nearest, halves
/// away from zero).
golden::VoxelItem voxel_item(const voxel::Voxel& voxel, const golden::HardwareConfig& config);
/// All of them, in the order of `voxels.voxels`.
std::vector<golden::VoxelItem> voxel_items(const voxel::VoxelSet& voxels,
                                           const golden::HardwareConfig& config);

/// The plan's registers; on hardware that has more, the others are set to 0.
void write_registers(golden::StreamWriter& writer, const golden::HardwareConfig& hardware,
                     const VpuPlan& plan);
/// Registers, clear, project `seen.casters`, resolve `seen.receivers`. `hardware` is the writer's; it may
/// have a larger plane than the plan. `two_sided[object]` marks open surfaces.
void write_vpu(golden::StreamWriter& writer, const golden::HardwareConfig& hardware, const VpuPlan& plan,
               const voxel::VoxelSet& voxels, const ViewVoxels& seen, const std::vector<bool>& two_sided);
/// The same for all voxels, as a stream of its own, and a fence.
std::vector<golden::Word> vpu_stream(const VpuPlan& plan, const voxel::VoxelSet& voxels,
                                     const std::vector<bool>& two_sided);

/// The voxel results among `results`, in the order of the receivers. Fails if their number is not `expected`
/// or an error word is among them.
Result<std::vector<golden::VoxelResult>> voxel_results(std::span<const golden::Word> results,
                                                       std::size_t expected);

/// The same method in double precision and with exact positions and normals, in the order of the receivers:
/// what quantisation is measured against.
std::vector<golden::VoxelState> offset_states_double(const VpuPlan& plan, const voxel::VoxelSet& voxels,
                                                     const ViewVoxels& seen,
                                                     const std::vector<bool>& two_sided);

}  // namespace gnomon::plan
