// SPDX-License-Identifier: Apache-2.0
// Where a voxel's representative lies in the grid.
#pragma once

#include "host/base/vec.hpp"
#include "host/voxel/voxel_set.hpp"

namespace gnomon::plan {

/// In voxels; never on the far wall of its voxel.
inline Vec3 representative(const voxel::Voxel& voxel) {
  return {voxel.x + double{voxel.point[0]}, voxel.y + double{voxel.point[1]},
          voxel.z + double{voxel.point[2]}};
}

}  // namespace gnomon::plan
