// SPDX-License-Identifier: Apache-2.0
// Orders of items are permutations, keep what has to stay in order, and bring neighbours together.
#include "host/plan/item_order.hpp"

#include <gmock/gmock.h>

#include <numeric>

#include "host/plan/quad_order.hpp"
#include "tests/host/plan/analytic_voxels.hpp"
#include "tests/support/random.hpp"

namespace gnomon::plan {
namespace {

using testing::ElementsAre;

std::vector<std::uint32_t> counted(std::size_t count) {
  std::vector<std::uint32_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0U);
  return numbers;
}

std::vector<std::uint32_t> ascending(std::vector<std::uint32_t> numbers) {
  std::ranges::sort(numbers);
  return numbers;
}

TEST(TileOrder, TilesAreNumberedInTurns) {
  EXPECT_EQ(tile_of({0, 0}), 0U);
  EXPECT_EQ(tile_of({3.99, 3.99}), 0U);
  EXPECT_EQ(tile_of({4, 0}), 1U);
  EXPECT_EQ(tile_of({0, 4}), 2U);
  EXPECT_EQ(tile_of({4, 4}), 3U);
  EXPECT_EQ(tile_of({4 * 1023, 4 * 1023}), 0xFFFFFU) << "the last tile of the largest plane";
  EXPECT_EQ(tile_of({-1e9, 5}), tile_of({0, 5})) << "off the plane: the tile next to it";
  EXPECT_EQ(tile_of({1e12, 0}), tile_of({4 * 16383, 0}));
}

TEST(TileOrder, ItemsOfATileKeepTheirOrder) {
  const std::vector<std::uint32_t> tiles{7, 2, 7, 0, 2, 2};
  const auto order = by_tile(tiles);
  EXPECT_THAT(order, ElementsAre(3, 1, 4, 5, 0, 2));
  EXPECT_THAT(put_back(order, order), ElementsAre(0, 1, 2, 3, 4, 5)) << "answers find back";
  EXPECT_THAT(put_back(tiles, {}), ElementsAre(7, 2, 7, 0, 2, 2)) << "nothing was moved";
}

TEST(TileOrder, AViewIsSentWholeAndObjectByObject) {
  const voxel::VoxelSet voxels = test::ball_on_ground(32, {{16, 16, 16}, 6}, 4);
  Projection parallel;
  parallel.u = Vec3(1, 0, 0);
  parallel.v = Vec3(0, 1, 0);
  ViewVoxels seen = all_voxels(voxels);
  std::erase_if(seen.receivers, [](std::uint32_t i) { return i % 3 == 0; });
  for (const Objects objects : {Objects::Apart, Objects::Together}) {
    const SentVoxels sent = sent_by_tile(parallel, voxels, seen, objects);
    EXPECT_EQ(ascending(sent.voxels.casters), seen.casters);
    EXPECT_NE(sent.voxels.casters, seen.casters);
    EXPECT_EQ(ascending(sent.places), counted(seen.receivers.size()));
    EXPECT_EQ(put_back(sent.voxels.receivers, sent.places), seen.receivers);
    std::size_t runs = 1, tiles = 1;
    for (std::size_t i = 1; i < sent.voxels.receivers.size(); ++i) {
      const auto& a = voxels.voxels[sent.voxels.receivers[i - 1]];
      const auto& b = voxels.voxels[sent.voxels.receivers[i]];
      runs += a.object != b.object ? 1U : 0U;
      tiles += a.x / 4 != b.x / 4 || a.y / 4 != b.y / 4 ? 1U : 0U;
    }
    EXPECT_EQ(runs == 2, objects == Objects::Apart) << "a command for each object";
    EXPECT_EQ(tiles == 64, objects == Objects::Together) << "each tile of the ground once";
  }
}

bool share_an_entry(const LinkedBox& a, const LinkedBox& b) {
  return a.u < b.u + b.columns && b.u < a.u + a.columns && a.v < b.v + b.rows && b.v < a.v + a.rows;
}

/// Boxes of up to 4 by 4 entries, some of them empty.
std::vector<LinkedBox> random_boxes(stimulus::Random& random, std::int64_t side, std::size_t count) {
  std::vector<LinkedBox> boxes(count);
  for (LinkedBox& box : boxes) {
    const auto at = [&](std::int64_t last) {
      return static_cast<std::uint32_t>(random.between(0, last - 1));
    };
    if (at(10) == 0) continue;
    box = {at(side - 4), at(side - 4), 1 + at(4), 1 + at(4)};
  }
  return boxes;
}

TEST(QuadOrder, QuadsWithAnEntryInCommonStayInOrder) {
  stimulus::Random random(5);
  std::uint64_t kept = 0, moved = 0;
  for (int turn = 0; turn < 20; ++turn) {
    const auto boxes = random_boxes(random, 32, 300);
    const auto order = depth_first(boxes, 32);
    ASSERT_EQ(ascending(order), counted(boxes.size()));
    for (std::size_t i = 0; i < order.size(); ++i)
      for (std::size_t j = i + 1; j < order.size(); ++j) {
        const bool common = share_an_entry(boxes[order[i]], boxes[order[j]]);
        if (order[i] < order[j]) continue;
        EXPECT_FALSE(common) << order[i] << " was overtaken by " << order[j];
        ++moved;
      }
    for (std::size_t i = 0; i < boxes.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) kept += share_an_entry(boxes[i], boxes[j]) ? 1U : 0U;
  }
  EXPECT_GT(kept, 10000U);
  EXPECT_GT(moved, 100000U) << "or there was nothing to see";
}

/// Tiles that change from one box to the next.
std::size_t changes(std::span<const LinkedBox> boxes, std::span<const std::uint32_t> order) {
  std::size_t count = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    const LinkedBox &a = boxes[order[i - 1]], &b = boxes[order[i]];
    count += a.u / 8 != b.u / 8 || a.v / 8 != b.v / 8 ? 1U : 0U;
  }
  return count;
}

TEST(QuadOrder, NeighboursOfASlopeComeTogether) {
  // Two by two entries each, on a slope along the diagonal: by depth, every row after row crosses the plane.
  std::vector<LinkedBox> boxes;
  for (std::uint32_t sum = 0; sum < 2 * 62; ++sum)
    for (std::uint32_t u = 0; u < 62; ++u)
      if (sum >= u && sum - u < 62) boxes.push_back({u, sum - u, 2, 2});
  const auto order = depth_first(boxes, 64);
  EXPECT_LT(3 * changes(boxes, order), 2 * changes(boxes, counted(boxes.size())));
}

}  // namespace
}  // namespace gnomon::plan
