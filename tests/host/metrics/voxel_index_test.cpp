// SPDX-License-Identifier: Apache-2.0
// Which voxel answers for a point.
#include "host/metrics/voxel_index.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace gnomon::metrics
