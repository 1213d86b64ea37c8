// SPDX-License-Identifier: Apache-2.0
// Linking and walking: boxes, order, early exit, clearance, and what happens when nothing more fits.
#include <gtest/gtest.h>

#include <stdexcept>

#include "scenes.hpp"

namespace gnomon::test {
namespace {

using golden::topology::Beam;
using golden::topology::Corner;
using golden::topology::kNoQuad;
using golden::topology::QuadLists;
using golden::topology::Walk;

constexpr int kSub = 4;  // sub_bits of small_config()

std::size_t entry(int u, int v) {
  return static_cast<std::size_t>(v) * 16 + static_cast<std::size_t>(u);
}
Corner corner(double u, double v, std::uint32_t depth) {
  return {.u = static_cast<std::int64_t>(u * (1 << kSub)),
          .v = static_cast<std::int64_t>(v * (1 << kSub)),
          .depth = depth};
}
std::array<Corner, 4> flat_square(double u, double v, double size, std::uint32_t depth) {
  return {corner(u, v, depth), corner(u + size, v, depth), corner(u + size, v + size, depth),
          corner(u, v + size, depth)};
}
Beam beam(double u, double v, std::uint32_t depth) {
  const Corner c = corner(u, v, depth);
  return {.u = c.u, .v = c.v, .depth = depth, .on_plane = true};
}

TEST(QuadLists, AQuadIsInEveryEntryOfItsBox) {
  QuadLists lists(small_config());
  lists.put(flat_square(2.5, 3.5, 1.5, 100));
  int linked = 0;
  for (int v = 0; v < 16; ++v)
    for (int u = 0; u < 16; ++u) {
      const bool inside = u >= 2 && u <= 4 && v >= 3 && v <= 5;
      EXPECT_EQ(lists.list(entry(u, v)).size(), inside ? 1U : 0U) << u << ' ' << v;
      EXPECT_EQ(lists.head(entry(u, v)).present, inside);
      linked += inside ? 1 : 0;
    }
  EXPECT_EQ(linked, 9);
  EXPECT_EQ(lists.counters().nodes_linked, 9U);
}

TEST(QuadLists, TheLastOneComesFirst) {
  QuadLists lists(small_config());
  for (int i = 0; i < 5; ++i) lists.put(flat_square(2, 2, 0.5, 100));
  EXPECT_EQ(lists.list(entry(2, 2)), (std::vector<std::uint32_t>{4, 3, 2, 1, 0}));
}

TEST(QuadLists, TheFirstHitEndsTheWalk) {
  QuadLists lists(small_config());
  for (int i = 0; i < 5; ++i) lists.put(flat_square(2, 2, 0.5, 100));
  lists.put(flat_square(2.75, 2.75, 0.25, 100));  // the same entry, beside the beam
  const Walk walk = lists.walk(beam(2.25, 2.25, 200), 0, false);
  EXPECT_TRUE(walk.uncertain && walk.hit);
  EXPECT_EQ(walk.quad, 4U);
  EXPECT_EQ(walk.visited, 2U);
  EXPECT_EQ(walk.tested, 2U);
}

TEST(QuadLists, OnlyQuadsNearerByTheClearanceCount) {
  QuadLists lists(small_config());
  lists.put(flat_square(2, 2, 0.5, 100));
  EXPECT_TRUE(lists.walk(beam(2.25, 2.25, 121), 20, false).hit);
  const Walk walk = lists.walk(beam(2.25, 2.25, 120), 20, false);
  EXPECT_FALSE(walk.uncertain || walk.hit);
  EXPECT_EQ(walk.visited, 0U) << "the head alone says that nothing is nearer";
}

TEST(QuadLists, TheFarthestCornerDecides) {
  QuadLists lists(small_config());
  auto quad = flat_square(2, 2, 0.5, 100);
  quad[2].depth = 300;
  lists.put(quad);
  EXPECT_FALSE(lists.walk(beam(2.25, 2.25, 300), 0, false).uncertain);
  EXPECT_TRUE(lists.walk(beam(2.25, 2.25, 301), 0, false).hit);
  EXPECT_EQ(lists.head(entry(2, 2)).near, 300U);
}

TEST(QuadLists, SortedWalksStopAtTheFirstThatIsNotNearer) {
  QuadLists lists(small_config());
  for (const std::uint32_t depth : {500U, 400U, 100U}) lists.put(flat_square(2, 2, 0.25, depth));
  const Beam beside = beam(2.75, 2.75, 300);
  const Walk all = lists.walk(beside, 0, false);
  const Walk sorted = lists.walk(beside, 0, true);
  EXPECT_EQ(all.visited, 3U);
  EXPECT_EQ(sorted.visited, 2U);
  EXPECT_EQ(all.tested, 1U);
  EXPECT_EQ(sorted.tested, 1U);
  EXPECT_FALSE(all.hit || sorted.hit);
}

TEST(QuadLists, WhenThePoolIsFullVoxelsFallBackOnTheNearestDepth) {
  TopologyConfig config = small_config();
  config.nodes_log2 = 4;
  QuadLists lists(config);
  lists.put(flat_square(0.5, 0.5, 2, 100));  // 9 entries
  lists.put(flat_square(4.5, 4.5, 2, 100));  // 9 entries: 7 fit, row by row
  EXPECT_EQ(lists.counters().nodes_linked, 16U);
  EXPECT_EQ(lists.counters().nodes_dropped, 2U);
  EXPECT_TRUE(lists.sticky().list_overflow);
  EXPECT_TRUE(lists.head(entry(4, 6)).linked);
  EXPECT_EQ(lists.head(entry(5, 6)),
            (golden::topology::ListHead{.present = true, .linked = false, .dropped = true, .near = 100}));

  const Walk inside = lists.walk(beam(5.75, 6.25, 200), 0, false);
  EXPECT_TRUE(inside.uncertain && inside.fallback);
  EXPECT_FALSE(inside.hit);
  EXPECT_EQ(inside.quad, kNoQuad);
  EXPECT_FALSE(lists.walk(beam(5.75, 6.25, 100), 0, false).fallback) << "nothing is nearer";
  EXPECT_TRUE(lists.walk(beam(5.75, 5.75, 200), 0, false).hit) << "other entries have lost nothing";

  lists.clear();
  EXPECT_FALSE(lists.head(entry(5, 6)).present);
  lists.put(flat_square(4.5, 4.5, 2, 100));
  EXPECT_TRUE(lists.walk(beam(5.75, 6.25, 200), 0, false).hit);
  EXPECT_TRUE(lists.sticky().list_overflow) << "sticky until it is cleared";
}

TEST(QuadLists, AQuadBeyondTheRecordsOrTooLargeIsLostInAllItsEntries) {
  TopologyConfig config = small_config();
  config.quads_log2 = 4;
  config.span_log2 = 2;
  QuadLists lists(config);
  lists.put(flat_square(8, 8, 3.9, 100));
  EXPECT_EQ(lists.counters().quads_too_large, 0U);
  lists.put(flat_square(8, 8, 4, 100));
  EXPECT_EQ(lists.counters().quads_too_large, 1U);
  EXPECT_EQ(lists.counters().nodes_dropped, 25U);
  for (int i = 2; i < 16; ++i) lists.put(flat_square(2, 2, 0.5, 100));
  EXPECT_EQ(lists.counters().nodes_dropped, 25U);
  lists.put(flat_square(2, 2, 1.5, 90));
  EXPECT_EQ(lists.counters().nodes_dropped, 29U);
  EXPECT_EQ(lists.list(entry(2, 2)).size(), 14U);
  EXPECT_TRUE(lists.walk(beam(3.25, 3.25, 100), 0, false).fallback);
}

TEST(QuadLists, BoxesAreClippedToThePlane) {
  QuadLists lists(small_config());
  lists.put(flat_square(3, 3, 1, 7));
  EXPECT_FALSE(lists.sticky().quad_off_plane);
  lists.put(flat_square(-1, 15, 2, 7));
  EXPECT_EQ(lists.counters().nodes_linked, 4U + 2U);
  EXPECT_TRUE(lists.sticky().quad_off_plane);
  lists.put(flat_square(-3, 5, 2.5, 7));
  EXPECT_EQ(lists.counters().nodes_linked, 6U);
  EXPECT_EQ(lists.counters().quads_off_plane, 1U);
  EXPECT_EQ(lists.list(entry(0, 15)), (std::vector<std::uint32_t>{1}));
  lists.put(flat_square(3, 3, 0.5, 7));
  EXPECT_EQ(lists.list(entry(3, 3)), (std::vector<std::uint32_t>{3, 0})) << "all quads are numbered";
}

TEST(QuadLists, IllegalConfigurationsAreRefused) {
  TopologyConfig config = small_config();
  config.sub_bits = 9;
  EXPECT_EQ(config.check(), "SUB_BITS=9 is out of range 2..8");
  EXPECT_THROW(QuadLists{config}, std::invalid_argument);
  config = small_config();
  config.normal_bits = 12;
  config.voxel_bits = 11;
  EXPECT_TRUE(config.check().has_value());
}

}  // namespace
}  // namespace gnomon::test
