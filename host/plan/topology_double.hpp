// SPDX-License-Identifier: Apache-2.0
// Topology mode in double precision, on exact corners and with the published ray-triangle test: the method
// without its quantisation (docs/vpu-topology.md).
#pragma once

#include <gnomon/golden/codec.hpp>
#include <span>
#include <vector>

#include "host/plan/topology_plan.hpp"

namespace gnomon::plan {

/// Distance along `direction` (unit length) at which a ray meets a triangle, by five dot products; negative
/// behind the start, infinite where it misses or runs along the plane.
double published_distance(const Vec3& start, const Vec3& direction, const Vec3& v0, const Vec3& v1,
                          const Vec3& v2);

/// What the exact method says, and what it took.
struct TopologyDouble {
  std::vector<golden::VoxelState> states;
  std::uint64_t uncertain = 0;
  std::uint64_t tested = 0;  ///< quads
};

/// States of `receivers`, in their order, with the plan's plane and clearance; beams start at the
/// representatives, `lift` voxels along N.
TopologyDouble topology_states_double(const TopologyPlan& plan, const voxel::VoxelSet& voxels,
                                      std::span<const voxel::LimitQuad> quads,
                                      std::span<const std::uint32_t> receivers,
                                      const std::vector<bool>& two_sided, double lift = 0);

}  // namespace gnomon::plan
