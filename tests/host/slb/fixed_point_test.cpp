// SPDX-License-Identifier: Apache-2.0
// Every rounding between a file's numbers and the unit's.
#include "host/slb/fixed_point.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "tests/host/slb/shapes.hpp"

namespace gnomon::slb {
namespace {

using testing::HasSubstr;

TEST(FixedPoint, VerticesGoToTheNearestLatticePoint) {
  golden::slb::SlbConfig config = test::small_plane(4);
  config.subpixel_bits = 8;
  const double unit = 1.0 / 256;
  const auto fixed =
      to_fixed({{0.5, {{{1, 2}, {1 + 0.49 * unit, 3 - 0.5 * unit}, {-0.51 * unit, -64}}}}}, config);
  ASSERT_TRUE(fixed);
  const auto& loop = fixed->at(0).loops.at(0);
  EXPECT_EQ(loop[0], (golden::slb::Vertex{256, 512, fixed->at(0).depth}));
  EXPECT_EQ(loop[1].x, 256);
  EXPECT_EQ(loop[1].y, 768);  // halves go up
  EXPECT_EQ(loop[2].x, -1);
  EXPECT_EQ(loop[2].y, -64 * 256);
}

TEST(FixedPoint, RefusesVerticesOutsideTheGuardBand) {
  const golden::slb::SlbConfig config = test::small_plane(7);
  const auto refusal = [&](const Vec2& vertex) {
    const auto fixed = to_fixed({{0, {}}, {0, {{{0, 0}, {1, 0}, {0, 1}}, {{0, 0}, vertex, {1, 1}}}}}, config);
    return fixed ? std::string("not refused") : fixed.error().message;
  };
  EXPECT_EQ(
      refusal({128, 0}),
      "object 1, loop 1, vertex 1 (objects[1].loops[1][1]): x=128 lies outside the guard band, expected "
      "-64..128 (the plane is 64 pixels a side)");
  EXPECT_THAT(refusal({0, -64.5}), HasSubstr("vertex 1 (objects[1].loops[1][1]): y=-64.5 lies outside"));
  EXPECT_THAT(refusal({1e300, 0}), HasSubstr("x=1e+300"));
  EXPECT_EQ(refusal({127.999, -64}), "not refused");
}

TEST(FixedPoint, AReceiverAtACastersDepthIsNotBehindIt) {
  golden::slb::SlbConfig config;
  std::mt19937_64 random(3);
  std::uint64_t compared = 0;
  for (const int bits : {8, 16, 20, 24}) {
    config.depth_bits = bits;
    for (int i = 0; i < 2000; ++i) {
      const double depth = std::ldexp(static_cast<double>(random() >> 11), -53);
      EXPECT_LE(receiver_depth(depth, config), caster_depth(depth, config));
      // Two codes behind it is in shadow for sure.
      const double behind = depth + 2.0 / (config.no_depth() - 1);
      EXPECT_GT(receiver_depth(behind, config), caster_depth(depth, config));
      ++compared;
    }
    EXPECT_EQ(caster_depth(0, config), 0U);
    EXPECT_EQ(receiver_depth(-5, config), 0U);
    EXPECT_EQ(caster_depth(1, config), config.no_depth() - 1);
    EXPECT_EQ(receiver_depth(1, config), config.no_depth() - 1);
    EXPECT_EQ(receiver_depth(1.5, config), config.no_depth());
  }
  EXPECT_EQ(compared, 8000U);
}

TEST(FixedPoint, QueriesAreFlooredAndStayOffThePlane) {
  golden::slb::SlbConfig config = test::small_plane(4);
  config.query_bits = 8;
  const auto x_of = [&](double x) { return to_query({x, 0, 0}, config).x; };
  EXPECT_EQ(x_of(1), 256);
  EXPECT_EQ(x_of(std::nextafter(1.0, 0.0)), 255);
  EXPECT_EQ(x_of(-1e-12), -1);
  EXPECT_EQ(x_of(-1e18), -256);
  EXPECT_EQ(x_of(1e18), 64 * 256);
  EXPECT_EQ(x_of(std::nextafter(64.0, 0.0)), 64 * 256 - 1);
}

}  // namespace
}  // namespace gnomon::slb
