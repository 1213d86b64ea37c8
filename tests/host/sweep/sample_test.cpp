// SPDX-License-Identifier: Apache-2.0
// Samples: how often every value comes, and that a seed decides all.
#include "host/sweep/sample.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <set>

namespace gnomon::sweep {
namespace {

const std::vector<std::size_t> kValues{3, 7, 2};

std::vector<std::size_t> counts(const std::vector<Combination>& sample, std::size_t axis) {
  std::vector<std::size_t> counts(kValues[axis]);
  for (const Combination& combination : sample) ++counts.at(combination.at(axis));
  return counts;
}

TEST(Grid, HasEveryCombinationOnceTheLastAxisFastest) {
  const std::vector<Combination> all = grid(kValues);
  ASSERT_EQ(all.size(), 42U);
  EXPECT_EQ(all[0], (Combination{0, 0, 0}));
  EXPECT_EQ(all[1], (Combination{0, 0, 1}));
  EXPECT_EQ(all[2], (Combination{0, 1, 0}));
  EXPECT_TRUE(std::ranges::is_sorted(all));
  EXPECT_EQ(std::set<Combination>(all.begin(), all.end()).size(), 42U);
}

TEST(Grid, SizeSaturates) {
  const std::vector<std::size_t> many(8, 1000000);
  EXPECT_EQ(grid_size(many), std::numeric_limits<std::size_t>::max());
}

TEST(LatinHypercube, TakesEveryValueEquallyOften) {
  for (const std::size_t points : {1U, 5U, 42U, 100U}) {
    const std::vector<Combination> sample = latin_hypercube(kValues, points, 9);
    ASSERT_EQ(sample.size(), points);
    for (std::size_t axis = 0; axis < kValues.size(); ++axis) {
      const std::vector<std::size_t> times = counts(sample, axis);
      const auto [least, most] = std::ranges::minmax(times);
      EXPECT_LE(most - least, 1U) << points << " points, axis " << axis;
    }
  }
}

TEST(LatinHypercube, AxesAreIndependent) {
  const std::vector<std::size_t> two{10, 10};
  const std::vector<Combination> sample = latin_hypercube(two, 10, 3);
  const auto equal = std::ranges::count_if(sample, [](const Combination& c) { return c[0] == c[1]; });
  EXPECT_LT(equal, 10);
  EXPECT_FALSE(std::ranges::is_sorted(sample));
}

TEST(Random, IsEvenWithinChance) {
  const std::vector<Combination> sample = random_sample(kValues, 70000, 1);
  for (const std::size_t times : counts(sample, 1)) EXPECT_NEAR(static_cast<double>(times), 10000, 500);
}

TEST(Samples, DependOnTheSeedAlone) {
  EXPECT_EQ(random_sample(kValues, 50, 4), random_sample(kValues, 50, 4));
  EXPECT_NE(random_sample(kValues, 50, 4), random_sample(kValues, 50, 5));
  EXPECT_EQ(latin_hypercube(kValues, 50, 4), latin_hypercube(kValues, 50, 4));
  EXPECT_NE(latin_hypercube(kValues, 50, 4), latin_hypercube(kValues, 50, 5));
}

}  // namespace
}  // namespace gnomon::sweep
