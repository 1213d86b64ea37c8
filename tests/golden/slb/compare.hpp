// SPDX-License-Identifier: Apache-2.0
// Answers of the model against the exact polygon, with what the page excuses set apart.
#pragma once

#include <cstdint>
#include <gnomon/golden/slb/model.hpp>

#include "tests/golden/slb/shapes.hpp"

namespace gnomon::golden::slb::testing {

struct Comparison {
  std::uint64_t compared = 0;
  std::uint64_t wrong = 0;       ///< of all
  std::uint64_t wrong_away = 0;  ///< in pixels that no edge touches: must be 0
  std::uint64_t wrong_far = 0;   ///< farther than 1 / (2^min(F,S) - 1) px from every edge, without an excuse
  std::uint64_t excused = 0;     ///< farther, but overflow, a chain with several vertices, or an acute corner
};

/// Asks `per_pixel` random points in every pixel of the plane.
Comparison compare(SlbModel& model, const Scene& scene, int per_pixel, std::uint64_t seed);

}  // namespace gnomon::golden::slb::testing
