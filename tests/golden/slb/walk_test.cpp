// SPDX-License-Identifier: Apache-2.0
// The walk of an edge: every pixel and every crossing, against exact rationals.
#include <gtest/gtest.h>

#include "tests/golden/slb/reference.hpp"
#include "tests/golden/slb/shapes.hpp"

namespace gnomon::golden::slb::testing {
namespace {

SlbConfig small(int frac, int slope) {
  SlbConfig config;
  config.frac_bits = frac;
  config.slope_bits = slope;
  config.plane_log2 = 5;
  config.subpixel_bits = std::max(frac + 3, slope - frac + 4);
  return config;
}

TEST(Walk, RandomEdgesAreExactForEveryFraction) {
  std::int64_t compared = 0;
  Random random(1);
  for (int frac = 3; frac <= 8; ++frac) {
    const SlbConfig config = small(frac, frac);
    const std::int64_t limit = config.side() * config.subpixels();
    for (int i = 0; i < 60; ++i) {
      const Vertex a{random.integer(-limit, 2 * limit), random.integer(-limit, 2 * limit)};
      const Vertex b{random.integer(-limit, 2 * limit), random.integer(-limit, 2 * limit)};
      if (a == b) continue;
      const std::int64_t done = check_walk(a, b, config);
      ASSERT_GT(done, 0) << "F=" << frac << " edge " << a.x << "," << a.y << " to " << b.x << "," << b.y;
      compared += done;
    }
  }
  EXPECT_GT(compared, 20'000);
}

TEST(Walk, ShortEdgesNearPixelCornersAreExact) {
  // Every edge between points of a quarter-pixel lattice over three pixels: all corners, borders and
  // diagonals.
  const SlbConfig config = small(4, 4);
  const std::int64_t quarter = config.subpixels() / 4;
  std::int64_t compared = 0;
  for (std::int64_t start = 0; start < 25; ++start)
    for (std::int64_t x = -6; x <= 10; ++x)
      for (std::int64_t y = -6; y <= 10; ++y) {
        const Vertex a{start % 5 * quarter, start / 5 * quarter}, b{x * quarter, y * quarter};
        if (a == b) continue;
        const std::int64_t done = check_walk(a, b, config);
        ASSERT_GT(done, 0) << a.x << "," << a.y << " to " << b.x << "," << b.y;
        compared += done;
      }
  EXPECT_GT(compared, 50'000);
}

TEST(Walk, NoDriftAtPixel65536) {
  SlbConfig config;
  config.plane_log2 = 16;
  const std::int64_t one = config.subpixels();
  const std::int64_t far = 65'536 * one;
  const Vertex from{-17, 5};
  for (const Vertex& to : {Vertex{far + 301, far - 77}, Vertex{far / 3 + 1, far + 999}, Vertex{far + 1, 6},
                           Vertex{-far, far / 7}}) {
    EdgeWalker walker(from, to, config);
    std::int64_t crossings = 0;
    while (!walker.done()) {
      walker.cross();
      ++crossings;
    }
    const EdgeSetup& edge = walker.setup();
    const std::int64_t cell = edge.y_major ? walker.row() : walker.column();
    const Position& low = edge.forward ? walker.behind() : walker.ahead();
    EXPECT_GT(crossings, 65'000);
    EXPECT_EQ(value_of(low, edge, config), reference_crossing(from, to, cell, config));
  }
}

TEST(Walk, TheCheckerNoticesOneUnit) {
  const SlbConfig config = small(4, 4);
  const Vertex a{3, 5}, b{700, 413};
  EXPECT_GT(check_walk(a, b, config), 0);
  EXPECT_EQ(check_walk(a, b, config, 1), -1);
}

TEST(Walk, DepthIsAnUpperBoundWithinThreeCodes) {
  SlbConfig config = small(4, 4);
  Random random(3);
  const std::int64_t limit = config.side() * config.subpixels();
  int compared = 0;
  for (int i = 0; i < 200; ++i) {
    const auto depth = [&] { return static_cast<std::uint32_t>(random.integer(0, 1'000'000)); };
    const Vertex a{random.integer(0, limit), random.integer(0, limit), depth()};
    const Vertex b{random.integer(0, limit), random.integer(0, limit), depth()};
    if (a.x == b.x && a.y == b.y) continue;
    EdgeWalker walker(a, b, config);
    const EdgeSetup& edge = walker.setup();
    if (edge.den <= config.subpixels()) continue;
    const std::int64_t major0 = edge.y_major ? a.y : a.x;
    for (;; walker.cross()) {
      const std::int64_t cell = edge.y_major ? walker.row() : walker.column();
      Rational largest = 0;
      for (const std::int64_t border : {cell, cell + 1}) {
        Rational t = Rational((border << config.subpixel_bits) - major0) / edge.den;
        if (!edge.forward) t = -t;
        t = std::clamp(t, Rational(0), Rational(1));
        largest = std::max<Rational>(largest, a.depth + t * (std::int64_t{b.depth} - std::int64_t{a.depth}));
      }
      ASSERT_GE(Rational(walker.depth()), largest);
      ASSERT_LT(Rational(walker.depth()), largest + 3);
      ++compared;
      if (walker.done()) break;
    }
  }
  EXPECT_GT(compared, 3000);
}

}  // namespace
}  // namespace gnomon::golden::slb::testing
