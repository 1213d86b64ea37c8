// SPDX-License-Identifier: Apache-2.0
// Traces the exact shadow's border over the sample grids.
#pragma once

#include <span>
#include <vector>

#include "host/metrics/sample_grid.hpp"
#include "host/metrics/shadow_truth.hpp"

namespace gnomon::metrics {

struct ShadowBorder {
  std::vector<BorderLength> length;  ///< by object that receives the shadow
  std::vector<Vec3> points;          ///< on the border, about two a grid cell that it crosses
  std::vector<CellRef> cells;        ///< that it crosses, in order
};

/// The border over all objects. `samples` holds the answers of the cells' samples: where all around a node
/// agree, it is not asked again. Inside faces the border is a polyline through crossings found by bisection
/// on the grid's lines; where it runs along a crease the two faces' answers are compared along their common
/// border, in steps of about `spacing` voxels.
ShadowBorder shadow_border(const ExactReference& reference, std::span<const surface::LimitSurface> surfaces,
                           const SampleGrids& grids, std::span<const Exact> samples, double spacing);

}  // namespace gnomon::metrics
