// SPDX-License-Identifier: Apache-2.0
// The contour of a smooth closed limit surface found by bisection on a fine grid of every face: slow, simple,
// and nothing of the outliner's.
#pragma once

#include <vector>

#include "host/outline/outline.hpp"

namespace gnomon::outline::test {

/// Short pieces of the contour, every one a loop of two vertices there and back, in no order. `n` cells along
/// each side of each face.
std::vector<Loop> exact_contour(const surface::LimitSurface& surface, const LightFrame& frame, int n);

}  // namespace gnomon::outline::test
