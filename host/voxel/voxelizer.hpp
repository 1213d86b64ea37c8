// SPDX-License-Identifier: Apache-2.0
// Voxelization of limit surfaces by recursive midpoint subdivision of parameter space. Theory:
// docs/voxelization.md.
#pragma once

#include <functional>
#include <span>

#include "host/base/result.hpp"
#include "host/surface/limit_surface.hpp"
#include "host/voxel/voxel_set.hpp"

namespace gnomon::voxel {

struct VoxelizerOptions {
  bool subpatches = false;                    ///< return the leaves
  unsigned threads = 0;                       ///< 0: all cores
  std::function<void(double done)> progress;  ///< called with 0..1 from one thread at a time; may be empty
};

/// `surfaces[i]` is object i, already in grid coordinates (one unit is one voxel, voxel (0,0,0) spans
/// [0,1]^3). A limit point outside the grid [0, res)^3 is an error. The result is the same for every thread
/// count and every order of faces.
Result<VoxelSet> voxelize(std::span<const surface::LimitSurface> surfaces, const Grid& grid,
                          const VoxelizerOptions& options = {});

/// The same voxels in another order, with the least time and memory. `options.subpatches` is
/// ignored.
Result<CoordinateSet> voxelize_coordinates(std::span<const surface::LimitSurface> surfaces, const Grid& grid,
                                           const VoxelizerOptions& options = {});

}  // namespace gnomon::voxel
