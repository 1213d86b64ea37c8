// SPDX-License-Identifier: Apache-2.0
// Which exact answers occur in which cell of the grid.
#pragma once

#include <cstdint>
#include <vector>

#include "host/metrics/shadow_truth.hpp"

namespace gnomon::metrics {

/// For every voxel, 1 if all samples and all representatives in its cell and the 26 around it have the same
/// lit or shadow answer. Sorts 8 bytes a sample.
std::vector<std::uint8_t> unambiguous_voxels(const voxel::VoxelSet& voxels,
                                             const std::vector<Exact>& voxel_answers,
                                             const std::vector<SurfaceSample>& samples);

}  // namespace gnomon::metrics
