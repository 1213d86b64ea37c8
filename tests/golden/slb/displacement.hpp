// SPDX-License-Identifier: Apache-2.0
// Mean border displacement: wrongly answered area over outline length, of the buffer and of shadow maps.
#pragma once

#include <cstdint>
#include <gnomon/golden/slb/model.hpp>

#include "tests/golden/slb/shapes.hpp"

namespace gnomon::golden::slb::testing {

struct Displacement {
  double wrong_area = 0;        ///< square pixels, of the buffer
  double wrong_area_fine = 0;   ///< of a shadow map 2^FRAC_BITS times finer
  double wrong_area_plain = 0;  ///< of a shadow map of the plane's own resolution
  double length = 0;            ///< outline, pixels
  std::uint64_t queries = 0, wrong = 0, chains = 0, dropped = 0;

  double ratio() const { return wrong_area_fine > 0 ? wrong_area / wrong_area_fine : 0; }
  double mean() const { return wrong_area / length; }
  Displacement& operator+=(const Displacement& other);
};

/// Draws the scene into a model of its own and asks `per_pixel` random points in every pixel at the outline
/// (an eighth of that in the pixels next to them).
Displacement measure(const Scene& scene, const SlbConfig& config, int per_pixel, std::uint64_t seed);

/// All objects of a scene at depth 0.
void draw(SlbModel& model, const Scene& scene);

}  // namespace gnomon::golden::slb::testing
