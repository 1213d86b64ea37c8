// SPDX-License-Identifier: Apache-2.0
// Adaptive tessellation of a limit surface to a stated sag.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "host/metrics/parametric_mesh.hpp"
#include "host/surface/limit_surface.hpp"

namespace gnomon::metrics {

struct TessellationOptions {
  double sag = 1.0 / 512;    ///< voxels: largest measured distance between a triangle and the limit surface
  double longest_side = 16;  ///< voxels: no cell is longer, however flat
  std::size_t max_cells = 4'000'000;  ///< over all objects; where exceeded, the sag is relaxed (and reported)
};

struct Tessellation {
  std::vector<std::vector<ParamRect>> rects;  ///< by object
  double sag = 0;                             ///< voxels, the one that was kept
  std::size_t cells = 0;
};

/// Splits every face's parameter space at midpoints until each cell is flat to `sag`. Objects whose entry in
/// `wanted` is false get no rectangles; missing entries are wanted. Multithreaded, deterministic.
Tessellation tessellate(std::span<const surface::LimitSurface> surfaces, const TessellationOptions& options,
                        const std::vector<bool>& wanted = {});

}  // namespace gnomon::metrics
