// SPDX-License-Identifier: Apache-2.0
// The criterion by plain recursion over whole faces, point by point: what the fast voxelizer must reproduce.
#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <tuple>

#include "host/surface/limit_surface.hpp"
#include "host/voxel/voxel_set.hpp"

namespace gnomon::test {

using Coordinates = std::tuple<int, int, int>;

struct ReferenceVoxels {
  std::set<Coordinates> voxels;
  std::uint64_t leaves = 0;
  std::uint64_t floor_hits = 0;
};

/// N = 26 and 18; for N = 6 the voxels of the recursion alone.
ReferenceVoxels reference_voxels(std::span<const surface::LimitSurface> surfaces, const voxel::Grid& grid);

}  // namespace gnomon::test
