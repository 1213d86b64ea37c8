// SPDX-License-Identifier: Apache-2.0
// The answers as a NumPy array.
#pragma once

#include <gnomon/golden/codec.hpp>
#include <span>
#include <string>

#include "host/voxel/voxel_set.hpp"

namespace gnomon::pipeline {

/// voxels.npy: NumPy's format 1.0, little-endian int32, shape (N, 4), C order; a row is x, y, z, state (1
/// lit, 2 in shadow), in ascending order of x, y, z. `states` runs as `voxels.voxels`.
std::string voxels_npy(const voxel::VoxelSet& voxels, std::span<const golden::VoxelState> states);

}  // namespace gnomon::pipeline
