// SPDX-License-Identifier: Apache-2.0
// What may be left out of a loop, and what may not.
#include "host/outline/thinning.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "winding.hpp"

namespace gnomon::outline {
namespace {

constexpr ThinningLimits kByLength{0.002, 10, 0.3, 4, false};
constexpr ThinningLimits kByPixels{0.002, 10, 0.3, 4, true};

Loop circle(double radius, int n) {
  Loop loop;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * std::numbers::pi * i / n;
    loop.push_back({30.3 + radius * std::cos(a), 30.7 + radius * std::sin(a), 0});
  }
  return loop;
}

/// A rectangle with many vertices on its sides.
Loop rectangle(double width, double height, int n) {
  const double x[] = {5.2, 5.2 + width, 5.2 + width, 5.2, 5.2};
  const double y[] = {7.1, 7.1, 7.1 + height, 7.1 + height, 7.1};
  Loop loop;
  for (std::size_t side = 0; side < 4; ++side)
    for (int i = 0; i < n; ++i) {
      const double s = double(i) / n;
      loop.push_back({x[side] + s * (x[side + 1] - x[side]), y[side] + s * (y[side + 1] - y[side]), 0});
    }
  return loop;
}

TEST(Thinning, KeepsCornersAndNothingElseOfARectangle) {
  const Loop out = thinned(rectangle(3, 2, 20), kByLength);
  EXPECT_EQ(out.size(), 4U);
  EXPECT_DOUBLE_EQ(test::signed_area(out), 6);
}

TEST(Thinning, FitsCornersToPixelsWithoutMovingThem) {
  const Loop out = thinned(rectangle(13, 12, 200), kByPixels);
  EXPECT_NEAR(test::signed_area(out), 156, 1e-6);
  EXPECT_LE(out.size(), 17U);
}

TEST(Thinning, BalancedEdgesKeepTheArea) {
  for (const double radius : {0.9, 3.0, 11.0, 25.0}) {
    const Loop dense = circle(radius, 4000);
    const double exact = test::signed_area(dense);
    const double inside = exact - test::signed_area(thinned(dense, kByLength));
    const double balanced = exact - test::signed_area(thinned(dense, kByPixels));
    EXPECT_GT(inside, 0);
    // The area between curve and edges, by the curve's length, against what edges across a pixel would lose.
    EXPECT_LT(std::abs(balanced) / test::length(dense), 0.2 / (12 * radius)) << radius;
  }
}

TEST(Thinning, KeepsDepthCloseToTheLoops) {
  Loop loop = rectangle(3, 2, 20);
  loop[10].depth = 11;
  EXPECT_EQ(thinned(loop, kByLength).size(), 5U);
  loop[10].depth = 9;
  EXPECT_EQ(thinned(loop, kByLength).size(), 4U);
}

TEST(Thinning, KeepsEdgesShorterThanTheLongestAllowed) {
  const Loop out = thinned(rectangle(30, 20, 100), kByLength);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const Vertex& b = out[(i + 1) % out.size()];
    EXPECT_LE(std::hypot(out[i].x - b.x, out[i].y - b.y), 4.0 + 1e-9);
  }
  EXPECT_GE(out.size(), 26U);
}

TEST(Thinning, LoopsInsideOnePixelStay) {
  Loop small = circle(0.2, 100);
  EXPECT_GE(thinned(small, kByPixels).size(), 3U);
  EXPECT_GT(test::signed_area(thinned(small, kByPixels)), 0);
}

TEST(Thinning, DropsWhatLiesOnALine) {
  const Loop there_and_back{{0, 0, 0}, {1, 2, 3}, {2, 4, 0}, {1.5, 3, 1}};
  EXPECT_TRUE(on_a_line(there_and_back));
  EXPECT_TRUE(thinned(there_and_back, kByPixels).empty());
  EXPECT_TRUE(thinned({{1, 1, 0}, {1, 1, 0}, {1, 1, 0}}, kByLength).empty());
  EXPECT_FALSE(on_a_line({{0, 0, 0}, {1, 0, 0}, {0, 1e-3, 0}}));
}

}  // namespace
}  // namespace gnomon::outline
