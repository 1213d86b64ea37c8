// SPDX-License-Identifier: Apache-2.0
// What voxelization makes of a scene: unique voxels, their representatives and the subpatches between them.
#pragma once

#include <cstdint>
#include <vector>

#include "host/base/vec.hpp"

namespace gnomon::voxel {

/// When two voxels count as neighbours: they share a face (6), at least an edge (18), at least a corner (26).
enum class Adjacency : std::uint8_t { N6 = 6, N18 = 18, N26 = 26 };

/// Where the grid lies in the world: the centre of voxel i is origin + (i + 1/2) * voxel_size on each axis.
struct Grid {
  std::uint32_t res = 256;  ///< voxels a side
  Vec3 origin{0, 0, 0};
  double voxel_size = 1;
  Adjacency adjacency = Adjacency::N26;
};

/// One set voxel. Its representative is the limit point with the smallest (object, face, u, v) key that fell
/// into it, so it does not depend on the order in which threads or faces arrived.
struct Voxel {
  std::uint16_t x, y, z;
  std::uint16_t object;  ///< the representative's object
  std::uint32_t face;    ///< the representative's parametric face within that object
  float u, v;            ///< the representative's parameters (dyadic, exact in float up to 24 levels)
  float point[3];  ///< the representative relative to the voxel's low corner, a multiple of 2^-16, 0 <= t < 1
  float normal[3];  ///< unit normal of the limit surface at the representative
};

/// A final subpatch of the recursion: a rectangle of one face's parameter space whose corners are adjacent
/// voxels. Corners run (u0,v0), (u1,v0), (u1,v1), (u0,v1).
struct Subpatch {
  std::uint32_t object, face;
  float u0, v0, u1, v1;
  std::uint32_t corner[4];  ///< indices into VoxelSet::voxels
};

/// Counts that the report shows and the tests check.
struct VoxelStatistics {
  std::uint64_t evaluations = 0;   ///< limit-surface evaluations done
  std::uint64_t subpatches = 0;    ///< leaves of the recursion
  std::uint64_t floor_hits = 0;    ///< leaves that the recursion floor ended before the criterion did
  std::uint64_t zero_normals = 0;  ///< representatives whose normal had to be nudged
  double seconds = 0;              ///< wall time
};

struct VoxelSet {
  Grid grid;
  std::vector<Voxel>
      voxels;  ///< unique; sorted by (object, face, v, u) of the representative: coherent on the surface
  std::vector<Subpatch> subpatches;  ///< empty unless asked for
  VoxelStatistics statistics;
};

/// A set voxel's place alone.
struct VoxelCoordinate {
  std::uint16_t x, y, z;
};

/// The same set of voxels where nothing but their places is wanted: 6 bytes each.
struct CoordinateSet {
  Grid grid;
  std::vector<VoxelCoordinate>
      voxels;  ///< unique; ordered by brick of 8x8x8 voxels (z, y, x), then by z, y, x
  VoxelStatistics statistics;
};

}  // namespace gnomon::voxel
