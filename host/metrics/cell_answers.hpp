// SPDX-License-Identifier: Apache-2.0
// Which exact answers occur in which cell of the grid.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/metrics/shadow_truth.hpp"

namespace gnomon::metrics {

/// For every voxel of an object that receives, 1 if in its cell and the 26 around it all samples and
/// representatives have the same lit or shadow answer, and no point of the shadow's border lies there. Voxels
/// of other objects get 0 and have no say. Sorts 8 bytes a sample.
std::vector<std::uint8_t> unambiguous_voxels(const voxel::VoxelSet& voxels,
                                             std::span<const Exact> voxel_answers,
                                             std::span<const std::uint8_t> receives,
                                             std::span<const SurfaceSample> samples,
                                             std::span<const Vec3> border);

}  // namespace gnomon::metrics
