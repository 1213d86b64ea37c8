// SPDX-License-Identifier: Apache-2.0
// Exact answers for polygons: winding numbers in integers, distances in double.
#pragma once

#include <cstdint>
#include <vector>

#include "tests/golden/slb/shapes.hpp"

namespace gnomon::golden::slb::testing {

/// Points are given in 2^-kPointBits pixels; must not lie on an edge's end points' rows (odd values never
/// do).
inline constexpr int kPointBits = 18;

class Oracle {
 public:
  Oracle(const Scene& scene, const SlbConfig& config);

  /// Winding number of one object.
  int winding(std::size_t object, std::int64_t x, std::int64_t y) const;
  /// Some object has a winding number of at least 1.
  bool covered(std::int64_t x, std::int64_t y) const;
  /// Distance to the nearest edge, pixels.
  double distance(std::int64_t x, std::int64_t y) const;
  /// Some edge touches the closed pixel.
  bool near_outline(std::int64_t column, std::int64_t row) const;

 private:
  struct Edge {
    std::int64_t x0, y0, x1, y1;
  };
  std::vector<std::vector<Edge>> objects_;
  std::vector<std::vector<std::vector<Edge>>> rows_;  ///< [object][row + side]: edges that meet the row
  std::vector<bool> outline_;
  int side_;
};

}  // namespace gnomon::golden::slb::testing
