// SPDX-License-Identifier: Apache-2.0
// Winding numbers by counting crossings of a ray to the left.
#include "tests/golden/slb/oracle.hpp"

#include <algorithm>
#include <cmath>

namespace gnomon::golden::slb::testing {

Oracle::Oracle(const Scene& scene, const SlbConfig& config) : side_(config.side()) {
  const int shift = kPointBits - config.subpixel_bits;
  const auto rows = static_cast<std::size_t>(side_);
  outline_.assign(rows * rows, false);
  for (const Object& object : scene) {
    std::vector<Edge> edges;
    std::vector<std::vector<Edge>> by_row(rows);
    for (const Loop& loop : object)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vertex &a = loop[i], &b = loop[(i + 1) % loop.size()];
        edges.push_back({a.x << shift, a.y << shift, b.x << shift, b.y << shift});
      }
    for (const Edge& e : edges) {
      const std::int64_t first = std::clamp<std::int64_t>(std::min(e.y0, e.y1) >> kPointBits, 0, side_ - 1);
      const std::int64_t last = std::clamp<std::int64_t>(std::max(e.y0, e.y1) >> kPointBits, 0, side_ - 1);
      for (std::int64_t row = first; row <= last; ++row) by_row[static_cast<std::size_t>(row)].push_back(e);
      const double one = std::ldexp(1.0, kPointBits);
      const double length =
          std::hypot(static_cast<double>(e.x1 - e.x0), static_cast<double>(e.y1 - e.y0)) / one;
      const int steps = static_cast<int>(length * 64) + 1;
      for (int i = 0; i <= steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        const double x = (static_cast<double>(e.x0) + t * static_cast<double>(e.x1 - e.x0)) / one;
        const double y = (static_cast<double>(e.y0) + t * static_cast<double>(e.y1 - e.y0)) / one;
        for (const double dx : {-0.02, 0.02})
          for (const double dy : {-0.02, 0.02}) {
            const double column = std::floor(x + dx), row = std::floor(y + dy);
            if (column < 0 || row < 0 || column >= side_ || row >= side_) continue;
            outline_[static_cast<std::size_t>(row) * rows + static_cast<std::size_t>(column)] = true;
          }
      }
    }
    objects_.push_back(edges);
    rows_.push_back(by_row);
  }
}

int Oracle::winding(std::size_t object, std::int64_t x, std::int64_t y) const {
  const std::int64_t row = y >> kPointBits;
  const bool on_rows = row >= 0 && row < side_;
  const std::vector<Edge>& edges = on_rows ? rows_[object][static_cast<std::size_t>(row)] : objects_[object];
  int sum = 0;
  for (const Edge& e : edges) {
    if ((e.y0 < y) == (e.y1 < y)) continue;
    // Differences stay below 2^30 on planes up to 2^10: 62 bits.
    const std::int64_t side = (e.x1 - e.x0) * (y - e.y0) - (x - e.x0) * (e.y1 - e.y0);
    const bool upwards = e.y1 > e.y0;
    // side > 0 going up: the point is left of the crossing.
    const bool crossing_left_of_point = upwards ? side < 0 : side > 0;
    if (crossing_left_of_point) sum += upwards ? -1 : 1;
  }
  return sum;
}

bool Oracle::covered(std::int64_t x, std::int64_t y) const {
  for (std::size_t i = 0; i < objects_.size(); ++i)
    if (winding(i, x, y) >= 1) return true;
  return false;
}

double Oracle::distance(std::int64_t x, std::int64_t y) const {
  double best = 1e300;
  for (const auto& edges : objects_)
    for (const Edge& e : edges) {
      const auto px = static_cast<double>(x - e.x0), py = static_cast<double>(y - e.y0);
      const auto dx = static_cast<double>(e.x1 - e.x0), dy = static_cast<double>(e.y1 - e.y0);
      const double length2 = dx * dx + dy * dy;
      const double t = length2 == 0 ? 0 : std::clamp((px * dx + py * dy) / length2, 0.0, 1.0);
      best = std::min(best, std::hypot(px - t * dx, py - t * dy));
    }
  return std::ldexp(best, -kPointBits);
}

bool Oracle::near_outline(std::int64_t column, std::int64_t row) const {
  return outline_[static_cast<std::size_t>(row) * static_cast<std::size_t>(side_) +
                  static_cast<std::size_t>(column)];
}

}  // namespace gnomon::golden::slb::testing
