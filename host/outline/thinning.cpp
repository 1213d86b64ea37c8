// SPDX-License-Identifier: Apache-2.0
// Greedy: each edge reaches as far as its limits allow.
#include "host/outline/thinning.hpp"

#include <algorithm>
#include <cmath>

namespace gnomon::outline {
namespace {

constexpr double kNoWidth = 1e-6;  // pixels

double distance(const Vertex& a, const Vertex& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

struct Departure {
  double plane, depth;
};

/// How far `p` is from the edge: in the plane, and in depth from the nearest point there.
Departure departure(const Vertex& a, const Vertex& b, const Vertex& p) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double square = dx * dx + dy * dy;
  const double along = square > 0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / square : 0;
  const double s = std::clamp(along, 0.0, 1.0);
  return {std::hypot(p.x - a.x - s * dx, p.y - a.y - s * dy),
          std::abs(p.depth - a.depth - s * (b.depth - a.depth))};
}

class Thinner {
 public:
  Thinner(const Loop& dense, const ThinningLimits& limits) : dense_(dense), limits_(limits) {}

  Loop run() {
    Loop out;
    start_ = rightmost();
    for (std::size_t at = 0; at < dense_.size();) {
      out.push_back(vertex(at));
      at = reach(at);
    }
    return out;
  }

 private:
  const Vertex& vertex(std::size_t i) const { return dense_[(start_ + i) % dense_.size()]; }

  std::size_t rightmost() const {
    const auto found = std::max_element(dense_.begin(), dense_.end(), [](const Vertex& a, const Vertex& b) {
      return a.x < b.x || (a.x == b.x && a.y < b.y);
    });
    return static_cast<std::size_t>(found - dense_.begin());
  }

  /// The end of the longest edge from vertex `from` on.
  std::size_t reach(std::size_t from) const {
    std::size_t to = from + 1;
    double farthest = distance(vertex(from), vertex(to));  // of those passed
    while (to < dense_.size()) {
      const double next = distance(vertex(from), vertex(to + 1));
      farthest = std::max(farthest, next);
      if (next > limits_.max_edge || !(farthest <= limits_.min_edge || follows(from, to + 1))) break;
      ++to;
    }
    return to;
  }

  bool follows(std::size_t from, std::size_t to) const {
    for (std::size_t i = from + 1; i < to; ++i) {
      const Departure d = departure(vertex(from), vertex(to), vertex(i));
      if (d.plane > limits_.sag || d.depth > limits_.depth) return false;
    }
    return true;
  }

  const Loop& dense_;
  ThinningLimits limits_;
  std::size_t start_ = 0;
};

}  // namespace

bool on_a_line(const Loop& loop) {
  if (loop.size() < 3) return true;
  const auto far = [&](const Vertex& from) {
    return *std::max_element(loop.begin(), loop.end(), [&](const Vertex& a, const Vertex& b) {
      return distance(from, a) < distance(from, b);
    });
  };
  const Vertex a = far(loop.front());
  const Vertex b = far(a);
  return std::all_of(loop.begin(), loop.end(),
                     [&](const Vertex& p) { return departure(a, b, p).plane <= kNoWidth; });
}

Loop thinned(const Loop& dense, const ThinningLimits& limits) {
  if (on_a_line(dense)) return {};
  Loop out = Thinner(dense, limits).run();
  return on_a_line(out) ? Loop() : out;
}

}  // namespace gnomon::outline
