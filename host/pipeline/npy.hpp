// SPDX-License-Identifier: Apache-2.0
// Arrays for NumPy.
#pragma once

#include <gnomon/golden/codec.hpp>
#include <span>
#include <string>
#include <vector>

#include "host/voxel/voxel_set.hpp"

namespace gnomon::pipeline {

/// What NumPy's format 1.0 has before the numbers of a little-endian int32 array of shape (rows, columns), C
/// order.
std::string npy_header(std::size_t rows, std::size_t columns);

/// voxels.npy: NumPy's format 1.0, int32, shape (N, 3 + lights); a row is x, y, z and a state for each light
/// (1 lit, 2 in shadow), in ascending order of x, y, z. Each of `states` runs as `voxels.voxels`.
std::string voxels_npy(const voxel::VoxelSet& voxels,
                       std::span<const std::vector<golden::VoxelState>> states);

}  // namespace gnomon::pipeline
