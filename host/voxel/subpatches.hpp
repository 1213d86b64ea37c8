// SPDX-License-Identifier: Apache-2.0
// The subpatches of a voxel set as quads between voxels, without cracks where subpatches of different size
// meet. Theory: docs/vpu-topology.md, "Casters".
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "host/base/vec.hpp"
#include "host/surface/limit_surface.hpp"
#include "host/voxel/voxel_set.hpp"

namespace gnomon::voxel {

/// Two triangles, c0 c1 c2 and c0 c2 c3. Corners are indices into VoxelSet::voxels; c3 = c2 leaves one
/// triangle.
using VoxelQuad = std::array<std::uint32_t, 4>;

struct QuadStatistics {
  std::uint64_t subpatches = 0;
  std::uint64_t stitched = 0;    ///< subpatches with voxels of finer neighbours on their sides
  std::uint64_t degenerate = 0;  ///< subpatches or quads dropped: no three distinct voxels
  std::uint64_t repeated = 0;    ///< quads dropped: the triangles of another one
};

struct CastingQuads {
  std::vector<VoxelQuad> quads;  ///< in the order of the subpatches
  QuadStatistics statistics;
};

/// Quads that together cover the surfaces. A side that finer neighbours have put points on goes through the
/// voxels of all of them, so that neighbours share their sides. `surfaces` must be the ones that `set` was
/// made from, and `set.subpatches` must be filled. Time and memory grow with the number of subpatches.
CastingQuads casting_quads(std::span<const surface::LimitSurface> surfaces, const VoxelSet& set);

/// The same quads between the limit points themselves, none dropped: what voxels as corners are measured
/// against. The quads of a closed surface close to the bit.
struct LimitQuad {
  std::array<Vec3, 4> points;  ///< grid coordinates
  VoxelQuad voxels;            ///< that the points fell into
};
std::vector<LimitQuad> limit_quads(std::span<const surface::LimitSurface> surfaces, const VoxelSet& set);

}  // namespace gnomon::voxel
