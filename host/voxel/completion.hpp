// SPDX-License-Identifier: Apache-2.0
// N = 6: which voxels a triangle touches, in exact integer arithmetic.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "host/voxel/lattice.hpp"
#include "host/voxel/voxel_key.hpp"

namespace gnomon::voxel {

using Triangle = std::array<GridPoint, 3>;

/// Calls `visit` for every voxel of the grid whose closed cube meets the closed triangle. Exact.
void for_each_touched(const Triangle& triangle, std::uint32_t res,
                      const std::function<void(VoxelKey)>& visit);

/// The side of a leaf on the border of its block.
struct BorderSide {
  std::array<std::uint32_t, 4> line;  ///< equal for sides on the same curve
  std::uint32_t t0, t1;               ///< dyadic interval along the curve, t0 < t1
  GridPoint p0, p1;                   ///< at t0 and t1
  Voxel representative;               ///< one of the leaf's corners
};

/// The triangles between each side and the points that other leaves have put on the same curve. Sorts
/// `sides`.
void for_each_gap(std::vector<BorderSide>& sides,
                  const std::function<void(const BorderSide&, const Triangle&)>& visit);

/// `voxel` as the representative of another voxel: its point moved to the nearest place in there.
Voxel moved_into(VoxelKey key, Voxel voxel);

}  // namespace gnomon::voxel
