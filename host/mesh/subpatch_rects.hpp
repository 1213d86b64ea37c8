// SPDX-License-Identifier: Apache-2.0
// The subpatches of a voxel set, object by object, as the triangulation takes them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/metrics/parametric_mesh.hpp"
#include "host/voxel/voxel_set.hpp"

namespace gnomon::mesh {

/// One object's subpatches.
struct SubpatchRects {
  std::vector<metrics::ParamRect> rects;
  std::vector<std::uint32_t> subpatches;  ///< of each rectangle: its index in VoxelSet::subpatches
};

/// By object, in the order of VoxelSet::subpatches. Throws std::out_of_range where a subpatch belongs to none
/// of `objects`.
std::vector<SubpatchRects> subpatch_rects(const voxel::VoxelSet& voxels, std::size_t objects);

}  // namespace gnomon::mesh
