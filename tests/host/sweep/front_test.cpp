// SPDX-License-Identifier: Apache-2.0
// Fronts against their definition.
#include "host/sweep/front.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>

namespace gnomon::sweep {
namespace {

using Points = std::vector<std::vector<double>>;

TEST(Front, KeepsWhatNothingBeats) {
  const Points points{{1, 5}, {2, 2}, {5, 1}, {3, 3}, {2, 6}};
  EXPECT_EQ(pareto_front(points), (std::vector<bool>{true, true, true, false, false}));
}

TEST(Front, EqualsStandOrFallTogether) {
  EXPECT_EQ(pareto_front(Points{{1, 1}, {1, 1}, {2, 2}, {2, 2}}),
            (std::vector<bool>{true, true, false, false}));
}

TEST(Front, LeavesOutWhatIsNoNumber) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(pareto_front(Points{{none, 0}, {1, 1}, {-INFINITY, 0}}), (std::vector<bool>{false, true, false}));
}

TEST(Front, OfNothingIsEmpty) {
  EXPECT_TRUE(pareto_front({}).empty());
}

TEST(Front, IsItsDefinition) {
  rc::check("a point is on the front exactly if no other dominates it", [] {
    const auto raw = *rc::gen::container<std::vector<std::array<int, 3>>>(
        rc::gen::container<std::array<int, 3>>(rc::gen::inRange(0, 4)));
    Points points;
    for (const auto& p : raw) points.push_back({double(p[0]), double(p[1]), double(p[2])});
    const std::vector<bool> front = pareto_front(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      bool beaten = false;
      for (const auto& other : points) {
        bool no_worse = true;
        for (std::size_t k = 0; k < 3; ++k) no_worse = no_worse && other[k] <= points[i][k];
        beaten = beaten || (no_worse && other != points[i]);
      }
      RC_ASSERT(front[i] == !beaten);
    }
  });
}

}  // namespace
}  // namespace gnomon::sweep
