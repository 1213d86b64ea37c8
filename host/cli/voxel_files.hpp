// SPDX-License-Identifier: Apache-2.0
// Voxel sets as files for other programs: NumPy, OpenVDB, and the grid as JSON.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "host/base/result.hpp"
#include "host/voxel/voxel_set.hpp"

namespace gnomon::cli {

/// x y z of every voxel, in ascending order.
std::vector<std::array<std::int32_t, 3>> sorted_coordinates(const voxel::CoordinateSet& voxels);

/// {"res", "origin", "voxel_size", "adjacency"}: voxel centre = origin + (i + 1/2) * voxel_size.
nlohmann::ordered_json grid_json(const voxel::Grid& grid);

/// NumPy's format 1.0: little-endian int32, shape (rows, 3), C order.
Result<void> write_npy(const std::filesystem::path& path,
                       const std::vector<std::array<std::int32_t, 3>>& rows);

/// One fog volume named "density", 1 in every voxel and 0 elsewhere, whose transform puts index i at the
/// centre of voxel i in the world. Fails where OpenVDB cannot hold so small a voxel size.
Result<void> write_vdb(const std::filesystem::path& path,
                       const std::vector<std::array<std::int32_t, 3>>& rows, const voxel::Grid& grid);

}  // namespace gnomon::cli
