// SPDX-License-Identifier: Apache-2.0
// Where a voxel's representative lies in the grid.
#pragma once

#include <algorithm>

#include "host/base/vec.hpp"
#include "host/voxel/voxel_set.hpp"

namespace gnomon::plan {

/// In voxels. Never on the far wall of the voxel, where rounding to single precision may have put it: it
/// would count for the neighbour.
inline Vec3 representative(const voxel::Voxel& voxel) {
  const auto inside = [](float t) { return std::min(double{t}, 1 - 0x1p-24); };
  return {voxel.x + inside(voxel.point[0]), voxel.y + inside(voxel.point[1]),
          voxel.z + inside(voxel.point[2])};
}

}  // namespace gnomon::plan
