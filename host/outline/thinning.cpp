// SPDX-License-Identifier: Apache-2.0
// Greedy: each edge reaches as far as its limits allow, then edges are moved to the middle of what they stand
// for.
#include "host/outline/thinning.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

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

/// The loop, turned so that it begins with its rightmost vertex.
Loop from_rightmost(const Loop& loop) {
  const auto found = std::max_element(loop.begin(), loop.end(), [](const Vertex& a, const Vertex& b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
  });
  Loop out(found, loop.end());
  out.insert(out.end(), loop.begin(), found);
  return out;
}

/// Without vertices in the place of the one before.
Loop without_repeats(Loop loop) {
  loop.erase(std::unique(loop.begin(), loop.end(),
                         [](const Vertex& a, const Vertex& b) { return distance(a, b) <= kNoWidth; }),
             loop.end());
  while (loop.size() > 1 && distance(loop.front(), loop.back()) <= kNoWidth) loop.pop_back();
  return loop;
}

/// A dense loop and the vertices of it that may be kept; places count on around the loop.
class Thinner {
 public:
  Thinner(const Loop& dense, std::vector<std::size_t> candidates, const ThinningLimits& limits)
      : dense_(dense), candidates_(std::move(candidates)), limits_(limits) {}

  /// Places of the vertices kept, rising.
  std::vector<std::size_t> run() const {
    std::vector<std::size_t> out;
    for (std::size_t at = 0; at < candidates_.size(); at = reach(at)) out.push_back(candidates_[at]);
    return out;
  }

 private:
  const Vertex& vertex(std::size_t place) const { return dense_[place % dense_.size()]; }
  std::size_t place(std::size_t candidate) const {
    const std::size_t n = candidates_.size();
    return candidate < n ? candidates_[candidate] : candidates_[candidate - n] + dense_.size();
  }

  /// The end of the longest edge from candidate `from` on.
  std::size_t reach(std::size_t from) const {
    std::size_t to = from + 1;
    while (to < candidates_.size() && may_join(place(from), place(to + 1))) ++to;
    return to;
  }

  bool may_join(std::size_t from, std::size_t to) const {
    if (distance(vertex(from), vertex(to)) > limits_.max_edge) return false;
    bool follows = true;
    bool stays = !limits_.fit_pixels && distance(vertex(from), vertex(to)) <= limits_.min_edge;
    for (std::size_t i = from + 1; i < to && (follows || stays); ++i) {
      const Departure d = departure(vertex(from), vertex(to), vertex(i));
      follows = follows && d.plane <= limits_.sag && d.depth <= limits_.depth;
      stays = stays && distance(vertex(from), vertex(i)) <= limits_.min_edge;
    }
    return follows || stays;
  }

  const Loop& dense_;
  std::vector<std::size_t> candidates_;
  const ThinningLimits& limits_;
};

bool same_pixel(const Vertex& a, const Vertex& b) {
  return std::floor(a.x) == std::floor(b.x) && std::floor(a.y) == std::floor(b.y);
}

/// Of the vertices first..last, the one farthest from the line between those before and after them; where
/// none is off it, the one in the middle.
std::size_t most_prominent(const Loop& loop, std::size_t first, std::size_t last) {
  const Vertex& before = loop[(first + loop.size() - 1) % loop.size()];
  const Vertex& after = loop[(last + 1) % loop.size()];
  std::size_t best = first + (last - first) / 2;
  double farthest = departure(before, after, loop[best]).plane + kNoWidth;
  for (std::size_t i = first; i <= last; ++i) {
    const double off = departure(before, after, loop[i]).plane;
    if (off > farthest) {
      farthest = off;
      best = i;
    }
  }
  return best;
}

/// One vertex for each stay in a pixel. The loop must begin where a pixel is entered.
std::vector<std::size_t> one_per_stay(const Loop& loop) {
  std::vector<std::size_t> out;
  for (std::size_t first = 0, next = 0; first < loop.size(); first = next) {
    while (next < loop.size() && same_pixel(loop[first], loop[next])) ++next;
    out.push_back(most_prominent(loop, first, next - 1));
  }
  return out;
}

/// Turns the loop to begin where it enters a pixel; as it is where it never does.
Loop from_entry(Loop loop) {
  for (std::size_t i = 0; i < loop.size(); ++i)
    if (!same_pixel(loop[(i + loop.size() - 1) % loop.size()], loop[i])) {
      std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(i), loop.end());
      break;
    }
  return loop;
}

/// An edge and how far to its right, on average, the curve runs that it stands for.
struct Balance {
  Vec2 right;  ///< unit length
  double length, offset;
};

class Balancer {
 public:
  Balancer(const Loop& dense, std::span<const std::size_t> kept) : dense_(dense), kept_(kept) {}

  Loop run() const {
    std::vector<Balance> edges;
    edges.reserve(kept_.size());
    for (std::size_t i = 0; i < kept_.size(); ++i) edges.push_back(balance(kept_[i], end(i)));
    Loop out;
    out.reserve(kept_.size());
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      const Vec2 shift = common_shift(edges[(i + edges.size() - 1) % edges.size()], edges[i]);
      const Vertex& v = vertex(kept_[i]);
      out.push_back({v.x + shift.x, v.y + shift.y, v.depth});
    }
    return out;
  }

 private:
  const Vertex& vertex(std::size_t place) const { return dense_[place % dense_.size()]; }
  std::size_t end(std::size_t edge) const {
    return edge + 1 < kept_.size() ? kept_[edge + 1] : kept_[0] + dense_.size();
  }

  Balance balance(std::size_t from, std::size_t to) const {
    const Vertex& a = vertex(from);
    const Vertex& b = vertex(to);
    const double length = distance(a, b);
    if (!(length > 0)) return {{0, 0}, 0, 0};
    const Vec2 right((b.y - a.y) / length, (a.x - b.x) / length);
    double area = 0;  // twice, between the curve and the edge
    for (std::size_t i = from; i < to; ++i) {
      const Vertex& p = vertex(i);
      const Vertex& q = vertex(i + 1);
      area += (p.x - a.x) * (q.y - a.y) - (q.x - a.x) * (p.y - a.y);
    }
    return {right, length, area / (2 * length)};
  }

  /// Of the shifts that bring both edges to their offsets, weighted by length, about the smallest.
  static Vec2 common_shift(const Balance& a, const Balance& b) {
    constexpr double kSlack = 0.01;
    const double slack = kSlack * (a.length + b.length);
    const double xx = a.length * a.right.x * a.right.x + b.length * b.right.x * b.right.x + slack;
    const double xy = a.length * a.right.x * a.right.y + b.length * b.right.x * b.right.y;
    const double yy = a.length * a.right.y * a.right.y + b.length * b.right.y * b.right.y + slack;
    const Vec2 r = a.right * (a.length * a.offset) + b.right * (b.length * b.offset);
    const double det = xx * yy - xy * xy;
    if (!(det > 0)) return {0, 0};
    return {(yy * r.x - xy * r.y) / det, (xx * r.y - xy * r.x) / det};
  }

  const Loop& dense_;
  std::span<const std::size_t> kept_;
};

Loop by_curvature(const Loop& dense, ThinningLimits limits) {
  limits.fit_pixels = false;
  std::vector<std::size_t> all(dense.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const std::vector<std::size_t> kept = Thinner(dense, std::move(all), limits).run();
  Loop out;
  out.reserve(kept.size());
  for (const std::size_t place : kept) out.push_back(dense[place]);
  return out;
}

Loop by_pixels(const Loop& dense, const ThinningLimits& limits) {
  const Loop loop = from_entry(dense);
  const std::vector<std::size_t> kept = Thinner(loop, one_per_stay(loop), limits).run();
  if (kept.size() < 3) return by_curvature(dense, limits);
  return Balancer(loop, kept).run();
}

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
  const Loop loop = from_rightmost(without_repeats(dense));
  Loop out = limits.fit_pixels ? by_pixels(loop, limits) : by_curvature(loop, limits);
  return on_a_line(out) ? Loop() : out;
}

}  // namespace gnomon::outline
