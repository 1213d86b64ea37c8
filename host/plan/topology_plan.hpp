// SPDX-License-Identifier: Apache-2.0
// From voxels, the quads between them and a light to topology mode's configuration and command stream.
// Theory: docs/vpu-topology.md.
#pragma once

#include <gnomon/golden/topology/codec.hpp>
#include <span>
#include <vector>

#include "host/base/result.hpp"
#include "host/plan/item_order.hpp"
#include "host/plan/vpu_plan.hpp"
#include "host/voxel/subpatches.hpp"

namespace gnomon::plan {

/// What the user may choose about topology mode; the rest follows from the scene.
struct TopologySettings {
  double pitch = 1;       ///< voxels per plane entry
  double lift = -1;       ///< voxels that a beam starts above its voxel, along N; -1: as the bits ask for
  double clearance = -1;  ///< voxels that a caster must be nearer; -1: as the bits ask for
  bool sorted = true;     ///< send the nearest quads last, so that lists begin with them
  ItemOrder order = ItemOrder::Surface;  ///< of quads; every list is the same in both
  int plane_log2 = 0;                    ///< log2 of the plane's side; 0: the smallest that holds the scene
  int voxel_frac_bits = -1;              ///< -1: as many as the voxel word leaves, at most 4
  int normal_bits = 0;                   ///< 0: as many as the voxel word leaves, at most 9
  int matrix_frac_bits = 22;
  int depth_bits = 20;
  int sub_bits = 4;
  int span_log2 = 4;
  int nodes_log2 = 0;  ///< 0: the smallest pool that holds the scene
  int quads_log2 = 0;  ///< 0: as many records as the scene has quads
  /// Where a pool as the scene needs would be larger, the pitch grows until it is not.
  int most_nodes_log2 = 24;
};

/// Everything topology mode needs for one view of a light.
struct TopologyPlan {
  VpuPlan vpu;                             ///< hardware, projection, registers; OFFSET_FACTOR is the lift
  TopologySettings settings;               ///< as resolved
  std::uint32_t clearance = 0;             ///< depth codes
  std::vector<golden::VoxelItem> items;    ///< all voxels as the hardware sees them
  std::vector<voxel::VoxelQuad> quads;     ///< in the order of the stream: a quad's number is its index
  std::uint64_t edge_on = 0;               ///< quads left out: the light sees no area of them
  std::vector<std::uint32_t> list_length;  ///< of every plane entry, v * side + u
};

/// `quads` are what casts; the plane holds all of `seen`. Fails where the settings make no legal hardware.
Result<TopologyPlan> plan_topology(const voxel::VoxelSet& voxels, std::span<const voxel::VoxelQuad> quads,
                                   const LightView& view, const ViewVoxels& seen,
                                   const TopologySettings& settings);
/// For one directional light over all voxels: `light` is the way it travels, in grid coordinates, any length
/// but zero.
Result<TopologyPlan> plan_topology(const voxel::VoxelSet& voxels, std::span<const voxel::VoxelQuad> quads,
                                   const Vec3& light, const TopologySettings& settings);

/// Registers, clear, put all, resolve `receivers`. `hardware` is the writer's; it may have a larger plane and
/// larger pools than the plan. `two_sided[object]` marks open surfaces.
void write_topology(golden::StreamWriter& writer, const golden::HardwareConfig& hardware,
                    const TopologyPlan& plan, const voxel::VoxelSet& voxels,
                    std::span<const std::uint32_t> receivers, const std::vector<bool>& two_sided);
/// The same for all voxels, as a stream of its own, and a fence.
std::vector<golden::Word> topology_stream(const TopologyPlan& plan, const voxel::VoxelSet& voxels,
                                          const std::vector<bool>& two_sided);

/// The voxel results among `results`, in the order of the receivers. Fails if their number is not `expected`
/// or an error word is among them.
Result<std::vector<golden::topology::TopologyResult>> topology_results(std::span<const golden::Word> results,
                                                                       std::size_t expected);

}  // namespace gnomon::plan
