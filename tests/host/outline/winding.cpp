// SPDX-License-Identifier: Apache-2.0
// Crossings of a ray to the left.
#include "winding.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gnomon::outline::test {

LoopSet::LoopSet(const std::vector<Loop>& loops) {
  double low = std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::lowest();
  for (const Loop& loop : loops)
    for (const Vertex& v : loop) {
      low = std::min(low, v.y);
      high = std::max(high, v.y);
    }
  if (low > high) return;
  first_row_ = static_cast<int>(std::floor(low));
  rows_.resize(static_cast<std::size_t>(std::floor(high)) - static_cast<std::size_t>(first_row_) + 1);
  for (const Loop& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Edge e{loop[i], loop[(i + 1) % loop.size()]};
      const int from = static_cast<int>(std::floor(std::min(e.a.y, e.b.y)));
      const int to = static_cast<int>(std::floor(std::max(e.a.y, e.b.y)));
      for (int r = from; r <= to; ++r) rows_[static_cast<std::size_t>(r - first_row_)].push_back(e);
    }
}

const std::vector<LoopSet::Edge>* LoopSet::row(double y) const {
  const int r = static_cast<int>(std::floor(y)) - first_row_;
  return r < 0 || r >= static_cast<int>(rows_.size()) ? nullptr : &rows_[static_cast<std::size_t>(r)];
}

int LoopSet::winding(double x, double y) const {
  const auto* edges = row(y);
  if (edges == nullptr) return 0;
  int turns = 0;
  for (const Edge& e : *edges) {
    if ((e.a.y < y) == (e.b.y < y)) continue;
    if (e.a.x + (y - e.a.y) / (e.b.y - e.a.y) * (e.b.x - e.a.x) < x) turns += e.a.y < y ? -1 : 1;
  }
  return turns;
}

double LoopSet::distance(double x, double y, double limit) const {
  double best = limit;
  for (const double other : {y - 1, y, y + 1}) {
    const auto* edges = row(other);
    if (edges == nullptr) continue;
    for (const auto& [a, b] : *edges) {
      const double dx = b.x - a.x;
      const double dy = b.y - a.y;
      const double square = dx * dx + dy * dy;
      const double s = square > 0 ? std::clamp(((x - a.x) * dx + (y - a.y) * dy) / square, 0.0, 1.0) : 0;
      best = std::min(best, std::hypot(x - a.x - s * dx, y - a.y - s * dy));
    }
  }
  return best;
}

double signed_area(const Loop& loop) {
  double twice = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vertex& a = loop[i];
    const Vertex& b = loop[(i + 1) % loop.size()];
    twice += a.x * b.y - b.x * a.y;
  }
  return twice / 2;
}

double length(const Loop& loop) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vertex& b = loop[(i + 1) % loop.size()];
    sum += std::hypot(b.x - loop[i].x, b.y - loop[i].y);
  }
  return sum;
}

}  // namespace gnomon::outline::test
