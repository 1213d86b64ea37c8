// SPDX-License-Identifier: Apache-2.0
// Directed and random loops.
#include "tests/rtl/slb/outline/loops.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gnomon::rtl_test::slb {

namespace {

/// Vertices from pixels and sub-pixels, kept inside the coordinate range.
class Maker {
 public:
  explicit Maker(const SlbConfig& config)
      : config_(config), pixel_(config.subpixels()), limit_(std::int64_t{2} * config.side() * pixel_) {}

  std::int64_t pixel() const { return pixel_; }
  std::int64_t limit() const { return limit_; }
  std::int64_t inside(std::int64_t value) const { return std::clamp(value, -limit_, limit_ - 1); }
  std::uint32_t depth(std::int64_t value) const {
    return static_cast<std::uint32_t>(std::clamp<std::int64_t>(value, 0, config_.no_depth()));
  }
  /// Pixels and quarters of a pixel; depths rise by a third of the range.
  Loop quarters(std::initializer_list<std::pair<int, int>> points) const {
    Loop loop;
    for (const auto& [x, y] : points) {
      const auto step = static_cast<std::int64_t>(loop.size()) * (config_.no_depth() / 3);
      loop.push_back({inside(x * pixel_ / 4), inside(y * pixel_ / 4), depth(step % config_.no_depth())});
    }
    return loop;
  }

 private:
  SlbConfig config_;
  std::int64_t pixel_, limit_;
};

Loop moved(Loop loop, std::int64_t dx, std::int64_t dy, const Maker& make) {
  for (Vertex& vertex : loop) {
    vertex.x = make.inside(vertex.x + dx);
    vertex.y = make.inside(vertex.y + dy);
  }
  return loop;
}

/// The loop turned by quarter turns about the origin.
Loop turned(Loop loop, int quarters) {
  for (Vertex& vertex : loop) {
    for (int i = 0; i < quarters; ++i) vertex = {-vertex.y, vertex.x, vertex.depth};
  }
  return loop;
}

Loop backwards(Loop loop) {
  std::reverse(loop.begin(), loop.end());
  return loop;
}

/// Loops around the origin, in quarters of a pixel.
std::vector<Loop> basic_loops(const Maker& make) {
  return {
      {},
      make.quarters({{1, 1}}),
      make.quarters({{1, 1}, {1, 1}}),
      make.quarters({{1, 1}, {9, 5}}),
      make.quarters({{1, 1}, {9, 5}, {1, 1}}),                          // closes by a repeat: there and back
      make.quarters({{1, 1}, {9, 5}, {1, 1}, {9, 5}}),                  // opposite duplicate edges
      make.quarters({{1, 1}, {1, 1}, {9, 5}, {9, 5}, {3, 9}, {1, 1}}),  // repeats, the last one at the close
      make.quarters({{1, 1}, {3, 1}, {2, 3}}),                          // tiny
      make.quarters({{0, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 0}}),          // tiny, on the pixel's border
      make.quarters({{1, 1}, {2, 3}, {3, 1}}),                          // tiny, clockwise
      make.quarters({{0, 0}, {4, 0}, {4, 4}, {0, 4}}),                  // one pixel, all vertices on corners
      make.quarters({{0, 0}, {12, 0}, {12, 12}, {0, 12}}),              // on the grid
      make.quarters(
          {{0, 0}, {4, 0}, {8, 0}, {8, 4}, {8, 8}, {4, 8}, {0, 8}, {0, 4}}),  // through every corner
      make.quarters({{-8, -8}, {8, 8}, {8, 9}, {-8, -7}}),  // diagonal, through and beside corners
      make.quarters({{0, 0}, {16, 16}, {0, 16}}),
      make.quarters({{0, 0}, {8, 16}, {-8, 16}}),                       // slope 2 through corners
      make.quarters({{0, 0}, {16, 8}, {16, 9}, {0, 1}}),                // slope 1/2 through corners
      make.quarters({{2, 2}, {2, 14}, {14, 14}, {14, 2}}),              // walls in mid-pixel
      make.quarters({{1, 1}, {21, 3}, {1, 1}, {3, 21}}),                // a spike
      make.quarters({{1, 1}, {9, 1}, {5, 1}, {13, 1}, {13, 9}}),        // a spike along an edge
      make.quarters({{0, 0}, {16, 0}, {0, 16}, {16, 16}}),              // crosses itself
      make.quarters({{2, 2}, {6, 2}, {2, 3}, {3, 6}}),                  // several vertices in the first pixel
      make.quarters({{6, 2}, {2, 2}, {3, 3}, {2, 6}, {7, 7}, {5, 5}}),  // and in others
      make.quarters({{1, 1}, {2, 1}, {3, 2}, {9, 2}, {3, 3}, {2, 3}, {1, 2}}),
  };
}

Vertex random_vertex(Random& random, const Maker& make, Vertex from, std::int64_t reach) {
  Vertex vertex{make.inside(from.x + random.integer(-reach, reach)),
                make.inside(from.y + random.integer(-reach, reach)), 0};
  const auto snap = [&](std::int64_t value) { return value & ~(make.pixel() - 1); };
  switch (random.integer(0, 9)) {
    case 0:
      vertex.x = snap(vertex.x);
      break;
    case 1:
      vertex.y = snap(vertex.y);
      break;
    case 2:
      vertex = {snap(vertex.x), snap(vertex.y), 0};
      break;
    case 3:
      vertex.x = from.x;
      break;
    case 4:
      vertex.y = from.y;
      break;
    case 5:
      vertex.y = make.inside(from.y + (vertex.x - from.x));
      break;  // diagonal
    case 6:
      vertex.y = make.inside(from.y - (vertex.x - from.x));
      break;
    default:
      break;
  }
  return vertex;
}

std::uint32_t random_depth(Random& random, const Maker& make, std::uint32_t before) {
  switch (random.integer(0, 3)) {
    case 0:
      return before;
    case 1:
      return make.depth(std::int64_t{before} + random.integer(-3, 3));
    case 2:
      return make.depth(random.integer(0, 1) ? 0 : INT64_MAX);
    default:
      return make.depth(static_cast<std::int64_t>(random.bits() & 0xffffff));
  }
}

Loop random_walk(Random& random, const Maker& make, const SlbConfig& config) {
  const std::int64_t side = config.side() * make.pixel();
  const std::int64_t reaches[] = {1,
                                  make.pixel() / 4,
                                  make.pixel(),
                                  2 * make.pixel(),
                                  5 * make.pixel(),
                                  std::min<std::int64_t>(side, 64 * make.pixel())};
  const std::int64_t reach = std::max<std::int64_t>(1, reaches[random.integer(0, 5)]);
  Loop loop;
  Vertex at{random.integer(0, side), random.integer(0, side), random_depth(random, make, 0)};
  if (random.integer(0, 3) == 0) at = {random.integer(-make.limit(), make.limit() - 1), at.y, at.depth};
  const std::int64_t length = random.integer(0, 12);
  for (std::int64_t i = 0; i < length; ++i) {
    Vertex next = random_vertex(random, make, at, reach);
    const std::int64_t what = random.integer(0, 15);
    if (what == 0) next = at;                                        // a repeat
    if (what == 1 && loop.size() > 1) next = loop.end()[-2];         // a spike
    if (what == 2 && i > 0 && i + 1 == length) next = loop.front();  // closes by a repeat
    next.depth = random_depth(random, make, at.depth);
    loop.push_back(next);
    at = next;
  }
  return loop;
}

Loop random_star(Random& random, const SlbConfig& config) {
  const double radius = std::min(8.0, config.side() / 2.0);
  const double middle = config.side() / 2.0;
  Loop loop = quantise(star(random, static_cast<int>(random.integer(3, 40)), radius / 8, radius,
                            {middle + random.between(-1, 1), middle + random.between(-1, 1)}),
                       config, static_cast<std::uint32_t>(random.integer(0, config.no_depth())));
  if (random.integer(0, 1)) std::reverse(loop.begin(), loop.end());
  return loop;
}

Loop random_range(Random& random, const Maker& make) {
  Loop loop;
  const std::int64_t reach = std::min(make.limit(), 600 * make.pixel());
  for (std::int64_t i = random.integer(3, 4); i > 0; --i) {
    loop.push_back({random.integer(-reach, reach - 1), random.integer(-reach, reach - 1),
                    random_depth(random, make, 0)});
  }
  return loop;
}

}  // namespace

std::vector<Loop> directed_loops(const SlbConfig& config) {
  const Maker make(config);
  const std::vector<Loop> basic = basic_loops(make);
  const std::int64_t side = config.side() * make.pixel();
  // Around the origin, in the plane, across its upper right corner, in the guard band.
  const std::pair<std::int64_t, std::int64_t> places[] = {
      {0, 0}, {side / 2, side / 2}, {side, side}, {-side, side / 2 + 1}};
  std::vector<Loop> loops;
  for (const auto& [x, y] : places) {
    for (int quarters = 0; quarters < 4; ++quarters) {
      for (const Loop& loop : basic) {
        loops.push_back(moved(turned(loop, quarters), x, y, make));
        loops.push_back(backwards(loops.back()));
      }
    }
  }
  return loops;
}

std::vector<Loop> random_loops(std::uint64_t seed, int count, const SlbConfig& config) {
  const Maker make(config);
  Random random(seed);
  std::vector<Loop> loops;
  for (int i = 0; i < count; ++i) {
    const std::int64_t what = random.integer(0, 19);
    if (what == 0) {
      loops.push_back(random_range(random, make));
    } else if (what < 6) {
      loops.push_back(random_star(random, config));
    } else {
      loops.push_back(random_walk(random, make, config));
    }
  }
  return loops;
}

std::vector<Loop> longest_edges(const SlbConfig& config) {
  const Maker make(config);
  const std::int64_t low = -make.limit(), high = make.limit() - 1;
  const std::uint32_t far = config.no_depth() - 1;
  return {
      {{low, low, 0}, {high, high, far}, {high - 1, high, 1}},       // the diagonal, and one ulp beside it
      {{low, high, far}, {high, low + 1, 0}, {high, low, far / 2}},  // falling
      {{low, 1, 0}, {high, 2, far}, {high, 3, 5}},                   // nearly level
      {{5, high, 3}, {4, low, far}, {6, low, 0}},                    // nearly upright
      {{low, low, 7}, {high, low / 3, far}, {low / 3, high, far / 3}},
  };
}

Loop smooth_loop(const SlbConfig& config, double radius, double edge) {
  const int count = static_cast<int>(2 * std::numbers::pi * radius / edge);
  const double middle = config.side() / 2.0, pixel = static_cast<double>(config.subpixels());
  Loop loop;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    const double depth = (0.5 + 0.4 * std::sin(3 * angle)) * config.no_depth();
    loop.push_back({std::llround((middle + radius * std::cos(angle)) * pixel),
                    std::llround((middle + radius * std::sin(angle)) * pixel),
                    static_cast<std::uint32_t>(depth)});
  }
  return loop;
}

}  // namespace gnomon::rtl_test::slb
