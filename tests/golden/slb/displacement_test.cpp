// SPDX-License-Identifier: Apache-2.0
// The figures that the unit is built for: displacement over that of a shadow map 2^F times finer.
#include "tests/golden/slb/displacement.hpp"

#include <gtest/gtest.h>

namespace gnomon::golden::slb::testing {
namespace {

struct Goal {
  const char* shape;
  int frac, slope, frags;
  double limit;
  int instances;
};

SlbConfig configuration(const Goal& goal) {
  SlbConfig config;
  config.frac_bits = goal.frac;
  config.slope_bits = goal.slope;
  config.frags = goal.frags;
  config.plane_log2 = 6;
  config.depth_bits = 16;
  config.subpixel_bits = 12;
  config.query_bits = 16;
  return config;
}

Displacement measured(const Goal& goal, const SlbConfig& config) {
  Displacement sum;
  for (int i = 1; i <= goal.instances; ++i)
    sum += measure(shape(goal.shape).make(config, static_cast<std::uint64_t>(i)), config, 200,
                   static_cast<std::uint64_t>(i));
  return sum;
}

class Displaced : public ::testing::TestWithParam<Goal> {};

TEST_P(Displaced, StaysBelowTheGoal) {
  const Displacement d = measured(GetParam(), configuration(GetParam()));
  EXPECT_GT(d.wrong_area_fine, 0.1) << "enough wrong area in the reference to divide by";
  EXPECT_GT(d.queries, 100'000u);
  EXPECT_LE(d.ratio(), GetParam().limit) << d.mean() << " px";
}

INSTANTIATE_TEST_SUITE_P(
    Goals, Displaced,
    ::testing::Values(Goal{"random 24-gon", 3, 3, 1, 0.76, 6}, Goal{"random 24-gon", 4, 4, 1, 0.73, 6},
                      Goal{"random 24-gon", 5, 5, 1, 0.70, 8}, Goal{"random 24-gon", 7, 7, 1, 0.75, 16},
                      Goal{"random 24-gon", 8, 8, 1, 0.80, 24}, Goal{"random 24-gon", 3, 4, 1, 0.62, 6},
                      Goal{"random 24-gon", 4, 5, 1, 0.60, 6}, Goal{"random 24-gon", 6, 7, 1, 0.62, 12},
                      Goal{"smooth, edges 1.4 px", 4, 4, 1, 0.74, 6},
                      Goal{"gear, pitch 5 px", 4, 4, 1, 0.74, 6}, Goal{"strip 1 px", 4, 4, 1, 0.86, 12},
                      Goal{"strip 1 px", 7, 7, 1, 1.6, 24}, Goal{"strip 0.5 px", 7, 7, 1, 3.2, 24},
                      Goal{"strip 0.5 px", 7, 7, 2, 2.6, 24}, Goal{"overlapping", 4, 4, 1, 0.82, 6},
                      Goal{"overlapping", 4, 4, 2, 0.72, 6}, Goal{"sharing an edge", 4, 4, 1, 1.05, 6},
                      Goal{"sharing an edge", 4, 4, 2, 0.74, 6}, Goal{"pixel corners", 4, 4, 1, 0.62, 6}),
    [](const auto& goal) {
      std::string name = std::string(goal.param.shape) + "_F" + std::to_string(goal.param.frac) + "_S" +
                         std::to_string(goal.param.slope) + "_K" + std::to_string(goal.param.frags);
      for (char& c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
      return name;
    });

TEST(Displacement, PublishedRoundingIsWorseAndTheGoalNoticesIt) {
  const Goal goal{"random 24-gon", 4, 4, 1, 0.73, 6};
  SlbConfig config = configuration(goal);
  config.rounding = Rounding::Published;
  const Displacement d = measured(goal, config);
  EXPECT_GT(d.ratio(), 0.9);
  EXPECT_LT(d.ratio(), 1.2);
}

TEST(Displacement, ShadowMapsAreAsTheoryHasThem) {
  const Goal goal{"smooth, edges 1.4 px", 4, 4, 1, 0, 6};
  const Displacement d = measured(goal, configuration(goal));
  EXPECT_NEAR(d.wrong_area_plain / d.length, 0.244, 0.01);
  EXPECT_NEAR(d.wrong_area_fine / d.length * 16, 0.244, 0.02);
}

}  // namespace
}  // namespace gnomon::golden::slb::testing
