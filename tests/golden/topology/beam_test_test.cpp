// SPDX-License-Identifier: Apache-2.0
// The two-triangle test against the published form and against areas with depth, in exact rationals.
#include <gtest/gtest.h>

#include <algorithm>
#include <gnomon/golden/topology/beam_test.hpp>
#include <vector>

#include "reference.hpp"
#include "tests/support/random.hpp"

namespace gnomon::test {
namespace {

using golden::topology::hits_quad;
using golden::topology::hits_triangle;
using golden::topology::Offset;

constexpr int kStartDepth = 1000;
const Point kStart = {0, 0, kStartDepth};

Point corner(const Offset& at, std::int64_t depth) {
  return {Rational(at.x), Rational(at.y), Rational(depth)};
}

/// Corners of a kind of triangle: anywhere, near the beam, in line, repeated, or with the beam on a side.
std::array<Offset, 3> triangle(stimulus::Random& random, int kind, std::int64_t size) {
  const auto any = [&] { return Offset{random.between(-size, size), random.between(-size, size)}; };
  std::array<Offset, 3> t = {any(), any(), any()};
  const std::int64_t k = random.between(-2, 2);
  switch (kind) {
    case 1:  // in line with each other
      t[2] = {t[0].x + k * (t[1].x - t[0].x), t[0].y + k * (t[1].y - t[0].y)};
      break;
    case 2:  // in line with each other and the beam
      t[1] = {k * t[0].x, k * t[0].y};
      t[2] = {-t[0].x, -t[0].y};
      break;
    case 3:  // two corners are one
      t[static_cast<std::size_t>(random.between(1, 2))] = t[0];
      break;
    case 4:  // the beam on a side
      t[1] = {-t[0].x, -t[0].y};
      break;
    case 5:  // the beam at a corner
      t[static_cast<std::size_t>(random.between(0, 2))] = {0, 0};
      break;
    default:
      break;
  }
  return t;
}

TEST(BeamTest, AgreesWithThePublishedFormOnTrianglesInFront) {
  stimulus::Random random(1);
  int compared = 0, hits = 0;
  for (int i = 0; i < 6000; ++i) {
    const auto t = triangle(random, i % 6, i % 2 == 0 ? 4 : 4095);
    const auto depth = [&] { return random.between(kStartDepth - 300, kStartDepth - 1); };
    const Point a = corner(t[0], depth()), b = corner(t[1], depth()), c = corner(t[2], depth());
    const bool hit = hits_triangle(t[0], t[1], t[2]);
    EXPECT_EQ(hit, paper_hit(kStart, a, b, c)) << i;
    EXPECT_EQ(hit, light_space_hit(kStart, a, b, c)) << i;
    ++compared;
    hits += hit ? 1 : 0;
  }
  EXPECT_EQ(compared, 6000);
  EXPECT_GT(hits, 1000);
}

TEST(BeamTest, PublishedAndLightSpaceFormAgreeAtAnyDepth) {
  stimulus::Random random(2);
  int compared = 0, behind = 0;
  for (int i = 0; i < 6000; ++i) {
    const auto t = triangle(random, i % 6, 6);
    const auto depth = [&] { return random.between(kStartDepth - 4, kStartDepth + 4); };
    const Point a = corner(t[0], depth()), b = corner(t[1], depth()), c = corner(t[2], depth());
    const bool hit = light_space_hit(kStart, a, b, c);
    EXPECT_EQ(hit, paper_hit(kStart, a, b, c)) << i;
    ++compared;
    behind += hits_triangle(t[0], t[1], t[2]) && !hit ? 1 : 0;
  }
  EXPECT_EQ(compared, 6000);
  EXPECT_GT(behind, 500) << "depth has decided too";
}

TEST(BeamTest, OrientationAndOrderDoNotMatter) {
  stimulus::Random random(3);
  for (int i = 0; i < 3000; ++i) {
    auto t = triangle(random, i % 6, 5);
    const bool hit = hits_triangle(t[0], t[1], t[2]);
    for (const auto& [a, b, c] : std::vector<std::array<std::size_t, 3>>{{1, 2, 0}, {2, 1, 0}, {0, 2, 1}})
      EXPECT_EQ(hits_triangle(t[a], t[b], t[c]), hit);
  }
}

TEST(BeamTest, TrianglesWithoutAreaAreNeverHit) {
  stimulus::Random random(4);
  for (int i = 0; i < 3000; ++i) {
    const auto t = triangle(random, 1 + i % 3, 8);
    EXPECT_FALSE(hits_triangle(t[0], t[1], t[2]));
  }
}

TEST(BeamTest, AQuadIsItsTwoTriangles) {
  stimulus::Random random(5);
  int hits = 0;
  for (int i = 0; i < 6000; ++i) {
    const auto t = triangle(random, i % 6, 5);
    const Offset fourth = i % 4 == 0 ? t[2] : Offset{random.between(-5, 5), random.between(-5, 5)};
    const bool hit = hits_quad({t[0], t[1], t[2], fourth});
    EXPECT_EQ(hit, hits_triangle(t[0], t[1], t[2]) || hits_triangle(t[0], t[2], fourth));
    hits += hit ? 1 : 0;
  }
  EXPECT_GT(hits, 1000);
}

TEST(BeamTest, SidesAndCornersBelongToTheTriangle) {
  EXPECT_TRUE(hits_triangle({0, 0}, {4, 0}, {0, 4}));
  EXPECT_TRUE(hits_triangle({-2, 0}, {2, 0}, {0, 4}));
  EXPECT_TRUE(hits_triangle({-1, -1}, {3, -1}, {-1, 3}));
  EXPECT_FALSE(hits_triangle({1, 0}, {4, 0}, {1, 4}));
}

}  // namespace
}  // namespace gnomon::test
