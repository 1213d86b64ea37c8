// SPDX-License-Identifier: Apache-2.0
// Which voxels triangles touch, against clipping in exact rationals; the gaps along borders.
#include "host/voxel/completion.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <set>
#include <vector>

namespace gnomon::voxel {
namespace {

constexpr int kRes = 5;

bool holds(const std::function<void()>& property) {
  return rc::check(property);
}

std::set<VoxelKey> touched(const Triangle& t) {
  std::set<VoxelKey> out;
  for_each_touched(t, kRes, [&](VoxelKey k) { out.insert(k); });
  return out;
}

using Rational = boost::multiprecision::cpp_rational;
using Polygon = std::vector<std::array<Rational, 3>>;

// The part of a polygon where sign * (coordinate - wall) >= 0.
Polygon clip(const Polygon& polygon, std::size_t axis, int sign, int wall) {
  Polygon out;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto& p = polygon[i];
    const auto& q = polygon[(i + 1) % polygon.size()];
    const Rational a = sign * (p[axis] - wall);
    const Rational b = sign * (q[axis] - wall);
    if (a >= 0) out.push_back(p);
    if ((a > 0 && b < 0) || (a < 0 && b > 0)) {
      const Rational t = a / (a - b);
      out.push_back({p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]), p[2] + t * (q[2] - p[2])});
    }
  }
  return out;
}

std::set<VoxelKey> touched_by_clipping(const Triangle& t) {
  std::set<VoxelKey> out;
  for (int v = 0; v < kRes * kRes * kRes; ++v) {
    const std::array<int, 3> cube{v % kRes, v / kRes % kRes, v / (kRes * kRes)};
    Polygon polygon;
    for (const GridPoint& p : t)
      polygon.push_back({Rational(p[0], 65536), Rational(p[1], 65536), Rational(p[2], 65536)});
    for (std::size_t k = 0; k < 3; ++k) {
      polygon = clip(polygon, k, 1, cube[k]);
      polygon = clip(polygon, k, -1, cube[k] + 1);
    }
    if (polygon.empty()) continue;
    out.insert(pack(static_cast<std::uint32_t>(cube[0]), static_cast<std::uint32_t>(cube[1]),
                    static_cast<std::uint32_t>(cube[2])));
  }
  return out;
}

// Corners on coarse places, where triangles touch walls, edges and corners, and next to them.
Triangle any_triangle(std::uint32_t extent) {
  const auto low = *rc::gen::inRange<std::uint32_t>(0, kRes - extent + 1);
  Triangle t{};
  for (auto& p : t) {
    for (auto& c : p) {
      c = (low * 65536) + *rc::gen::inRange<std::uint32_t>(0, 4 * extent) * 16384;
      if (*rc::gen::inRange(0, 3) == 0) c += *rc::gen::inRange<std::uint32_t>(0, 16384);
    }
  }
  return t;
}

TEST(Completion, TouchesTheVoxelsInWhichClippingLeavesAnything) {
  std::size_t triangles = 0;
  for (const std::uint32_t extent : {1U, 2U, 3U}) {
    EXPECT_TRUE(holds([&] {
      const Triangle t = any_triangle(extent);
      ++triangles;
      RC_ASSERT(touched(t) == touched_by_clipping(t));
    }));
  }
  EXPECT_GE(triangles, 300U);
}

// Large triangles take wider integers; moved and scaled ones must not take others.
TEST(Completion, LargeTrianglesAreTestedAsExactly) {
  EXPECT_TRUE(holds([] {
    Triangle t = any_triangle(kRes);
    std::set<VoxelKey> expected;
    for (const VoxelKey k : touched(t)) expected.insert(k);
    // The same triangle 64 times as large touches a cube of 64 voxels a side iff it touches a voxel in there.
    for (auto& p : t) {
      for (auto& c : p) c *= 64;
    }
    std::set<VoxelKey> found;
    for_each_touched(t, 64 * kRes,
                     [&](VoxelKey k) { found.insert(pack(key_x(k) / 64, key_y(k) / 64, key_z(k) / 64)); });
    RC_ASSERT(found == expected);
  }));
}

TEST(Completion, WallsEdgesAndCornersBelongToAllTheirVoxels) {
  constexpr std::uint32_t kOne = 1U << 16;
  const GridPoint corner{3 * kOne, 3 * kOne, 3 * kOne};
  EXPECT_EQ(touched({corner, corner, corner}).size(), 8U);
  const GridPoint inner{3 * kOne + 5, 3 * kOne + 5, 3 * kOne};
  EXPECT_EQ(touched({inner, inner, inner}).size(), 2U);
  const GridPoint inside{3 * kOne + 5, 3 * kOne + 5, 3 * kOne + 5};
  EXPECT_EQ(touched({inside, inside, inside}).size(), 1U);
  // One unit short of a diagonal plane through a corner.
  const Triangle diagonal{GridPoint{2 * kOne, 4 * kOne - 1, 3 * kOne + 9},
                          GridPoint{4 * kOne - 1, 2 * kOne, 3 * kOne + 9},
                          GridPoint{3 * kOne, 3 * kOne - 1, 3 * kOne + 8}};
  EXPECT_FALSE(touched(diagonal).contains(pack(3, 3, 3)));
}

TEST(Completion, GapsAreFoundBetweenSidesOfDifferentLength) {
  const auto p = [](std::uint32_t x) { return GridPoint{x, x * x, 0}; };
  BorderSide whole{{1, 0, 0, 0}, 0, 4, p(0), p(4), {}};
  std::vector<BorderSide> sides{whole,
                                {{1, 0, 0, 0}, 0, 2, p(0), p(2), {}},
                                {{1, 0, 0, 0}, 2, 3, p(2), p(3), {}},
                                {{1, 0, 0, 0}, 3, 4, p(3), p(4), {}},
                                {{2, 0, 0, 0}, 1, 2, p(1), p(2), {}}};
  std::vector<Triangle> gaps;
  for_each_gap(sides, [&](const BorderSide&, const Triangle& t) { gaps.push_back(t); });
  const std::vector<Triangle> expected{{p(0), p(2), p(3)}, {p(0), p(3), p(4)}};
  EXPECT_EQ(gaps, expected);
}

}  // namespace
}  // namespace gnomon::voxel
