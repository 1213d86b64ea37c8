// SPDX-License-Identifier: Apache-2.0
// Traces the exact shadow's border over the sample grids.
#pragma once

#include <span>
#include <vector>

#include "host/metrics/sample_grid.hpp"
#include "host/metrics/shadow_truth.hpp"

namespace gnomon::metrics {

/// Border length by object. `centers` holds the answers at the cells' centres: where all around a node agree,
/// it is not asked again. Inside faces the border is a polyline through crossings found by bisection on the
/// grid's lines; where it runs along a crease the two faces' answers are compared along their common border,
/// in steps of about `spacing` voxels.
std::vector<BorderLength> shadow_border(const ExactReference& reference,
                                        std::span<const surface::LimitSurface> surfaces,
                                        const SampleGrids& grids, std::span<const Exact> centers,
                                        double spacing);

}  // namespace gnomon::metrics
