// SPDX-License-Identifier: Apache-2.0
// Exact winding numbers against rationals and against the golden tests' integer oracle.
#include "host/slb/polygon_reference.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "tests/golden/slb/oracle.hpp"
#include "tests/host/slb/shapes.hpp"

namespace gnomon::slb {
namespace {

namespace oracle = golden::slb::testing;

TEST(ExactSide, IsExactWhereDoublesAreNot) {
  using Exact = boost::multiprecision::cpp_rational;
  std::mt19937_64 random(11);
  const auto unit = [&] { return std::ldexp(static_cast<double>(random() >> 11), -53); };
  int compared = 0, near = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec2 from(unit() * 64, unit() * 64), to(unit() * 64, unit() * 64);
    Vec2 point = from + (to - from) * unit();
    // A few units in the last place around the line.
    for (int step = static_cast<int>(random() % 5); step > 0; --step)
      point.x = std::nextafter(point.x, i % 2 == 0 ? 100.0 : -100.0);
    const Exact cross = (Exact(to.x) - Exact(from.x)) * (Exact(point.y) - Exact(from.y)) -
                        (Exact(to.y) - Exact(from.y)) * (Exact(point.x) - Exact(from.x));
    ASSERT_EQ(exact_side(from, to, point), cross > 0 ? 1 : cross < 0 ? -1 : 0);
    const double rounded = (to.x - from.x) * (point.y - from.y) - (to.y - from.y) * (point.x - from.x);
    near += (rounded > 0 ? 1 : rounded < 0 ? -1 : 0) == exact_side(from, to, point) ? 0 : 1;
    ++compared;
  }
  EXPECT_EQ(compared, 3000);
  EXPECT_GT(near, 10) << "plain doubles would have done: the test proves nothing";
  EXPECT_EQ(exact_side({0, 0}, {1, 1}, {0.5, 0.5}), 0);
}

TEST(PolygonReference, AgreesWithTheIntegerOracle) {
  const golden::slb::SlbConfig config = test::small_plane(7);
  std::mt19937_64 random(5);
  std::uint64_t compared = 0, covered = 0;
  for (const oracle::Shape& shape : oracle::shapes()) {
    const oracle::Scene scene = shape.make(config, 1);
    const oracle::Oracle expected(scene, config);
    const PolygonReference reference(test::from_golden(scene, config), config.side());
    for (int i = 0; i < 3000; ++i) {
      // Odd lattice points, as the oracle wants them.
      const auto place = [&] {
        return static_cast<std::int64_t>(random() % (64ULL << oracle::kPointBits)) | 1;
      };
      const std::int64_t x = place(), y = place();
      const Vec2 point(std::ldexp(static_cast<double>(x), -oracle::kPointBits),
                       std::ldexp(static_cast<double>(y), -oracle::kPointBits));
      for (std::size_t object = 0; object < scene.size(); ++object)
        ASSERT_EQ(reference.winding(object, point), expected.winding(object, x, y)) << shape.name;
      ASSERT_EQ(reference.covered(point), expected.covered(x, y)) << shape.name;
      covered += expected.covered(x, y) ? 1U : 0U;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 3000U * oracle::shapes().size());
  EXPECT_GT(covered, compared / 20);
}

TEST(PolygonReference, LooksAtDepth) {
  const Loop square{{1, 1}, {5, 1}, {5, 5}, {1, 5}};
  const PolygonReference reference({{0.75, {square}}, {0.25, {{{4, 4}, {9, 4}, {9, 9}}}}}, 16);
  EXPECT_FALSE(reference.in_shadow({2, 2}, 0.75)) << "at the caster's depth";
  EXPECT_TRUE(reference.in_shadow({2, 2}, 0.7500001));
  EXPECT_FALSE(reference.in_shadow({4.9, 4.1}, 0.25));
  EXPECT_TRUE(reference.in_shadow({4.9, 4.1}, 0.5));
  EXPECT_FALSE(reference.in_shadow({12, 12}, 1));
}

TEST(PolygonReference, AnswersOffThePlane) {
  const PolygonReference reference({{0, {{{-20, -20}, {-10, -20}, {-10, 40}, {-20, 40}}}}}, 16);
  EXPECT_EQ(reference.winding(0, {-15, -15}), 1);
  EXPECT_EQ(reference.winding(0, {-15, 8}), 1);
  EXPECT_EQ(reference.winding(0, {-5, 30}), 0);
}

}  // namespace
}  // namespace gnomon::slb
