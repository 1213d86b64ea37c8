// SPDX-License-Identifier: Apache-2.0
// Which voxel answers for a point.
#include "host/metrics/voxel_index.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/host/metrics/fixtures.hpp"

namespace gnomon::metrics {
namespace {

voxel::Voxel at(std::uint16_t x, std::uint16_t y, std::uint16_t z, float px = 0.5f) {
  return {x, y, z, 0, 0, 0, 0, {px, 0.5f, 0.5f}, {0, 0, 1}};
}

TEST(VoxelIndex, FindsEverySetVoxelAndNoOther) {
  const auto surfaces = fixtures::surfaces({fixtures::box({4, 4, 4}, {28, 28, 28}, false)});
  const voxel::VoxelSet set = fixtures::voxels(surfaces, 32);
  const VoxelIndex index(set);
  std::set<std::array<int, 3>> cells;
  for (std::uint32_t i = 0; i < set.voxels.size(); ++i) {
    const voxel::Voxel& v = set.voxels[i];
    EXPECT_EQ(index.find(v.x, v.y, v.z), i);
    cells.insert({v.x, v.y, v.z});
  }
  EXPECT_GT(cells.size(), 500u);
  std::size_t empty = 0;
  for (int z = -1; z <= 32; ++z)
    for (int y = -1; y <= 32; ++y)
      for (int x = -1; x <= 32; ++x)
        if (!cells.contains({x, y, z})) {
          EXPECT_EQ(index.find(x, y, z), kNoVoxel);
          ++empty;
        }
  EXPECT_EQ(empty, std::size_t{34} * 34 * 34 - cells.size());
}

TEST(VoxelIndex, AsksTheNearestNeighbourWhereTheOwnCellIsEmpty) {
  voxel::VoxelSet set;
  set.grid.res = 16;
  set.voxels = {at(3, 5, 5, 0.9f), at(5, 5, 5, 0.2f), at(8, 5, 5)};
  const VoxelIndex index(set);
  EXPECT_EQ(index.answering({5.99, 5.5, 5.5}), 1u);
  EXPECT_EQ(index.answering({4.4, 5.5, 5.5}), 0u);
  EXPECT_EQ(index.answering({4.7, 5.5, 5.5}), 1u);
  EXPECT_EQ(index.answering({7.5, 6.5, 5.5}), 2u);
  EXPECT_EQ(index.answering({12.5, 5.5, 5.5}), kNoVoxel);
}

TEST(VoxelIndex, AWalkGivesTheAnswersOfSinglePoints) {
  const auto surfaces = fixtures::surfaces({fixtures::torus({16, 16, 16}, 9, 4, 16, 8)});
  const voxel::VoxelSet set = fixtures::voxels(surfaces, 32);
  const VoxelIndex index(set);
  VoxelIndex::Walk walk(index);
  std::size_t compared = 0, neighbours = 0;
  for (int i = 0; i < 20000; ++i) {  // back and forth through and past the tube
    const double t = 0.001 * i;
    const Vec3 p(16 + 12 * std::cos(t), 16 + 9 * std::sin(1.7 * t), 16 + 5 * std::sin(23 * t));
    const std::uint32_t answer = index.answering(p);
    EXPECT_EQ(walk.answering(p), answer);
    if (answer == kNoVoxel) continue;
    ++compared;
    const voxel::Voxel& v = set.voxels[answer];
    neighbours += v.x != std::floor(p.x) || v.y != std::floor(p.y) || v.z != std::floor(p.z) ? 1U : 0U;
  }
  EXPECT_GT(compared, 3000u);
  EXPECT_GT(neighbours, 500u);
}

}  // namespace
}  // namespace gnomon::metrics
