// SPDX-License-Identifier: Apache-2.0
// Packing, rounding, adjacency and bricks, against the obvious.
#include "host/voxel/voxel_key.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "host/voxel/brick_set.hpp"

namespace gnomon::voxel {
namespace {

bool holds(const std::function<void()>& property) {
  return rc::check(property);
}

TEST(VoxelKey, AdjacencyIsTheDistanceOfCoordinates) {
  EXPECT_TRUE(holds([] {
    const auto near = rc::gen::inRange(0, 5);
    const int base = *rc::gen::element(0, 1, 500, 65530);
    const auto point = [&] { return std::array{base + *near, base + *near, base + *near}; };
    const auto a = point();
    auto b = point();
    if (*rc::gen::inRange(0, 4) == 0)
      b[static_cast<std::size_t>(*rc::gen::inRange(0, 3))] = *rc::gen::inRange(0, 65536);
    int most = 0;
    int sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      most = std::max(most, std::abs(a[k] - b[k]));
      sum += std::abs(a[k] - b[k]);
    }
    const auto key = [](const std::array<int, 3>& p) {
      return pack(static_cast<std::uint32_t>(p[0]), static_cast<std::uint32_t>(p[1]),
                  static_cast<std::uint32_t>(p[2]));
    };
    RC_ASSERT((gap<Adjacency::N26>(key(a), key(b)) == 0) == (most <= 1));
    RC_ASSERT((gap<Adjacency::N18>(key(a), key(b)) == 0) == (most <= 1 && sum <= 2));
  }));
}

TEST(VoxelKey, SnapsToTheNearestFraction) {
  EXPECT_EQ(snap(3.0, 8), 3U << 16);
  EXPECT_EQ(snap(std::nextafter(3.0, 0), 8), 3U << 16);  // one last bit below a wall is on it
  EXPECT_EQ(snap(3.0 - 0x1p-16, 8), (3U << 16) - 1);
  EXPECT_EQ(snap(-1e-9, 8), 0U);
  EXPECT_EQ(snap(8.0 - 0x1p-16, 8), (8U << 16) - 1);
  EXPECT_EQ(snap(65534.999, 65535), static_cast<std::uint32_t>(std::lround(65534.999 * 65536)));
}

TEST(VoxelKey, WhatIsOutsideTheGridIsNeverMistakenForInside) {
  for (const std::uint32_t res : {1U, 8U, 255U, 65535U}) {
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double x : {-0x1p-16, -1.0, -1e6, -1e300, -infinity, res + 0.0, res - 0x1p-20, res + 1.0,
                           1e300, infinity, std::numeric_limits<double>::quiet_NaN()}) {
      EXPECT_GE(snap(x, res) >> kFractionBits, res) << x;
    }
    EXPECT_EQ(snap(res - 0x1p-16, res) >> kFractionBits, res - 1);
  }
}

TEST(VoxelKey, GuardSeesOneCoordinateOutside) {
  EXPECT_TRUE(holds([] {
    const auto res = *rc::gen::inRange<std::uint32_t>(1, 65536);
    const auto inside = rc::gen::inRange<std::uint32_t>(0, res);
    GridGuard guard(res);
    for (int n = 0; n < 20; ++n) guard.add(pack(*inside, *inside, *inside));
    guard.add(pack(res - 1, res - 1, res - 1));
    RC_ASSERT(!guard.crossed());
    std::array<std::uint32_t, 3> p{*inside, *inside, *inside};
    p[*rc::gen::inRange<std::size_t>(0, 3)] = *rc::gen::inRange<std::uint32_t>(res, 65536);
    guard.add(pack(p[0], p[1], p[2]));
    guard.add(pack(*inside, *inside, *inside));
    RC_ASSERT(guard.crossed());
  }));
}

TEST(BrickSet, IsASet) {
  EXPECT_TRUE(holds([] {
    const auto keys =
        *rc::gen::container<std::vector<std::uint32_t>>(rc::gen::inRange<std::uint32_t>(0, 4000));
    BrickSet set(true);
    BrickSet other;
    BrickSet third;
    std::set<VoxelKey> expected;
    std::vector<VoxelKey> order;
    for (const std::uint32_t k : keys) {
      const VoxelKey key = pack(k % 17, k / 17 % 16 * 4000, k / 272);
      RC_ASSERT(set.insert(key) == expected.insert(key).second);
      third.insert(key);
      if (set.size() > order.size()) order.push_back(key);
      other.insert(k % 2 == 0 ? key : key + 1);
    }
    for (std::uint32_t i = 0; i < order.size(); ++i) RC_ASSERT(set.index(order[i]) == i);
    std::set<VoxelKey> visited;
    set.for_each([&](VoxelKey k) { RC_ASSERT(visited.insert(k).second); });
    RC_ASSERT(visited == expected);
    RC_ASSERT(!set.contains(pack(60000, 1, 2)));
    other.for_each([&](VoxelKey k) { expected.insert(k); });
    BrickSet merged;
    merged.merge(std::move(third));
    merged.merge(std::move(other));
    RC_ASSERT(merged.size() == expected.size());
    for (const VoxelKey k : expected) RC_ASSERT(merged.contains(k));
  }));
}

}  // namespace
}  // namespace gnomon::voxel
