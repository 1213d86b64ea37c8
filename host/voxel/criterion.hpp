// SPDX-License-Identifier: Apache-2.0
// When a subpatch is fine enough, and which way it is split if not. Theory: docs/voxelization.md.
#pragma once

#include <array>

#include "host/voxel/voxel_key.hpp"

namespace gnomon::voxel {

struct Split {
  bool u = false, v = false;
  bool none() const { return !u && !v; }
};

/// The voxels of a subpatch's corners, in the order (u0,v0), (u1,v0), (u1,v1), (u0,v1).
using Corners = std::array<VoxelKey, 4>;

/// Splits the directions whose sides are not between neighbours; where all sides are but both diagonals fail,
/// the direction that is wider in parameter space (`wider_u()`). N = 6 recurses like N = 26.
template <Adjacency kAdjacency, class WiderU>
inline Split criterion(const Corners& c, WiderU wider_u) {
  Split split{(gap<kAdjacency>(c[0], c[1]) | gap<kAdjacency>(c[3], c[2])) != 0,
              (gap<kAdjacency>(c[0], c[3]) | gap<kAdjacency>(c[1], c[2])) != 0};
  if (split.none() && gap<kAdjacency>(c[0], c[2]) != 0 && gap<kAdjacency>(c[1], c[3]) != 0) {
    (wider_u() ? split.u : split.v) = true;
  }
  return split;
}

}  // namespace gnomon::voxel
