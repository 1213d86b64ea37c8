// SPDX-License-Identifier: Apache-2.0
// Both maps on shapes whose shadows are known: how far borders are off, what the bias is good for, what it
// costs.
#include "host/compare/depth_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace gnomon::compare {
namespace {

constexpr double kFloor = 20;   ///< depth of the receiver behind the disc
constexpr double kRadius = 23;  ///< of the disc, voxels
const Vec3 kCentre(40.3, 39.6, 8);

/// Light along +z over 80 x 80 voxels.
MapPlan plan_of(int side) {
  const LightAxes axes{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
  return {LightPlane{axes, 0, 0, 80.0 / side, side}, 0, 100, 20};
}

bool under_disc(const Vec3& p) {
  return std::hypot(p.x - kCentre.x, p.y - kCentre.y) < kRadius;
}

Sheets disc(const Vec3& start) {
  return under_disc(start) ? Sheets{kCentre.z - start.z, 1} : Sheets{};
}

/// Wrong area by the border's length and the texel's side, on a floor that faces the light.
double displacement(const DepthMap& map, int kernel) {
  constexpr int kSteps = 1600;  // of the 80 voxels
  constexpr double kStep = 80.0 / kSteps;
  int wrong = 0;
  for (int y = 0; y < kSteps; ++y) {
    for (int x = 0; x < kSteps; ++x) {
      const Vec3 p((x + 0.5) * kStep, (y + 0.5) * kStep, kFloor);
      wrong += map.in_shadow(p, 1, kernel) != under_disc(p) ? 1 : 0;
    }
  }
  return wrong * kStep * kStep / (2 * std::numbers::pi * kRadius) / map.plan().plane.pitch;
}

TEST(DepthMap, PlainIsOffByAQuarterOfATexelAndFilteredByLess) {
  const DepthMap map(plan_of(80), disc);
  EXPECT_NEAR(displacement(map, 1), 0.244, 0.01);
  EXPECT_LT(displacement(map, 2), 0.9 * displacement(map, 1));
  EXPECT_LT(displacement(map, 3), 0.6 * displacement(map, 1));
  EXPECT_LT(displacement(map, 5), displacement(map, 2));
}

TEST(DepthMap, FourTimesTheTexelsHalveTheDisplacement) {
  const DepthMap coarse(plan_of(60), disc), fine(plan_of(120), disc);
  const double coarse_voxels = displacement(coarse, 1) * 80 / 60,
               fine_voxels = displacement(fine, 1) * 80 / 120;
  EXPECT_NEAR(coarse_voxels / fine_voxels, 2, 0.15);
}

/// The floor itself, tilted by `tan` along x, seen by the light: it must not shadow itself.
int self_shadowed(double tan, int kernel, int depth_bits) {
  MapPlan plan = plan_of(50);
  plan.depth_bits = depth_bits;
  plan.codes_per_voxel = depth_bits == 20 ? 100 : 0.2;
  const auto depth = [tan](const Vec3& p) { return 30 + (p.x - 40) * tan; };
  const DepthMap map(plan, [&](const Vec3& start) { return Sheets{depth(start) - start.z, 1}; });
  int dark = 0;
  for (int i = 0; i < 40'000; ++i) {
    const int row = i / 200, column = i % 200;
    Vec3 p(10 + 0.3 * column + 1e-4 * i, 10 + 0.3 * row, 0);
    p.z = depth(p);
    dark += map.in_shadow(p, 1 / std::hypot(1, tan), kernel) ? 1 : 0;
  }
  return dark;
}

TEST(DepthMap, AFlatReceiverNeverShadowsItself) {
  for (const int kernel : {1, 2, 3, 5, 8}) {
    for (const double tan : {0.0, 0.3, 0.7}) {
      EXPECT_EQ(self_shadowed(tan, kernel, 20), 0) << kernel << ", " << tan;
      EXPECT_EQ(self_shadowed(tan, kernel, 6), 0) << kernel << ", " << tan;
    }
  }
}

TEST(DepthMap, ABiasTooSmallForItsSlopeIsNoticed) {
  const auto too_steep = [](double tan) {
    const DepthMap map(plan_of(50), [tan](const Vec3& start) {
      return Sheets{30 + (start.x - 40) * tan - start.z, 1};
    });
    int dark = 0;
    for (int i = 0; i < 1000; ++i) {
      const double x = 38 + 0.004 * i;
      dark += map.in_shadow(Vec3(x, 40, 30 + (x - 40) * tan), 1, 1) ? 1 : 0;  // said to face the light
    }
    return dark;
  };
  EXPECT_EQ(too_steep(0), 0);
  EXPECT_GT(too_steep(0.5), 100);
}

TEST(DepthMap, AnswersOffTheMapAndOnBacksWithoutALook) {
  const DepthMap map(plan_of(80), disc);
  EXPECT_TRUE(map.in_shadow(Vec3(40, 40, kFloor), 1, 1));
  EXPECT_FALSE(map.in_shadow(Vec3(400, 40, kFloor), 1, 3));
  EXPECT_FALSE(map.in_shadow(Vec3(-1e9, 40, kFloor), 1, 3));
  EXPECT_TRUE(map.in_shadow(Vec3(5, 5, kFloor), -0.2, 1));
  EXPECT_FALSE(map.in_shadow(Vec3(5, 5, kFloor), 0.2, 1));
  EXPECT_FALSE(map.in_shadow(Vec3(40, 40, 3), 1, 1)) << "in front of the disc";
}

TEST(DepthMap, HoldsCodesOfTheWidthThatWasAskedFor) {
  MapPlan plan = plan_of(80);
  plan.depth_bits = 8;
  plan.codes_per_voxel = 2;
  const DepthMap map(plan, disc);
  EXPECT_EQ(map.empty_code(), 255u);
  EXPECT_EQ(map.code(40, 40), 16u);
  EXPECT_EQ(map.code(0, 0), 255u);
  EXPECT_THROW(DepthMap(plan_of(0), disc), std::invalid_argument);
}

TEST(DepthMap, CountsItsCyclesAndBytes) {
  const DepthMap map(plan_of(80), [](const Vec3& start) {
    return under_disc(start) ? Sheets{5, 2} : Sheets{};
  });
  const double covered = std::numbers::pi * kRadius * kRadius;
  EXPECT_NEAR(static_cast<double>(map.drawn()), 2 * covered, 0.03 * covered);
  const MapCosts costs = map.costs(1000, 3);
  EXPECT_EQ(costs.clear_cycles, 400u);
  EXPECT_EQ(costs.draw_cycles, map.drawn());
  EXPECT_EQ(costs.query_cycles, 9000u);
  EXPECT_EQ(costs.bytes_read, (map.drawn() + 9000) * 3);
  EXPECT_EQ(costs.bytes_written, (map.drawn() + 6400) * 3);
}

TEST(MapPlan, FillsTheMemoryItIsGiven) {
  constexpr std::uint64_t kBits = std::uint64_t{256} * 256 * 24;
  EXPECT_EQ(side_within(kBits, 3), 256);
  EXPECT_EQ(side_within(kBits - 1, 3), 255);
  EXPECT_EQ(side_within(5, 3), 1);
  const MapPlan plan = with_side(plan_of(80), 200);
  EXPECT_EQ(plan.memory_bits(), 200u * 200u * 24u);
  const Vec3 p(17.3, 60.1, 2);
  EXPECT_NEAR(plan.plane.pixel(p).x, 2.5 * plan_of(80).plane.pixel(p).x, 1e-9);
  EXPECT_NEAR(plan.plane.pitch * plan.plane.side, 80, 1e-9);
}

}  // namespace
}  // namespace gnomon::compare
