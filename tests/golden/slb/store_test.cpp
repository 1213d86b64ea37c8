// SPDX-License-Identifier: Apache-2.0
// Capacity, eviction, depth, cover samples and generations.
#include <gtest/gtest.h>

#include "tests/golden/slb/compare.hpp"
#include "tests/golden/slb/displacement.hpp"
#include "tests/golden/slb/oracle.hpp"

namespace gnomon::golden::slb::testing {
namespace {

SlbConfig plane(int frags) {
  SlbConfig config;
  config.frac_bits = config.slope_bits = 4;
  config.plane_log2 = 3;
  config.frags = frags;
  config.subpixel_bits = config.query_bits = 9;
  return config;
}

Loop quad(double x0, double y0, double x1, double y1, const SlbConfig& config, std::uint32_t depth = 0) {
  return quantise({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, config, depth);
}

void flat(SlbModel& model, std::uint8_t id, std::uint32_t depth, const std::vector<Loop>& loops) {
  model.begin_object(id, true, depth);
  for (const Loop& loop : loops) model.loop(loop);
  model.fill();
  model.end_object();
}

bool shadow(SlbModel& model, double x, double y, std::uint32_t depth, std::uint32_t bias = 0) {
  const double one = static_cast<double>(std::int64_t{1} << model.config().query_bits);
  return model.query({static_cast<std::int64_t>(x * one), static_cast<std::int64_t>(y * one), depth}, bias)
      .shadow;
}

/// Vertical strips through row 3, each with two lines in pixel (3, 3).
std::vector<Loop> strips(int count, const SlbConfig& config) {
  std::vector<Loop> loops;
  loops.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) loops.push_back(quad(3.06 + 0.1 * i, 1, 3.11 + 0.1 * i, 6, config));
  return loops;
}

class Capacity : public ::testing::TestWithParam<int> {};

TEST_P(Capacity, AnObjectUsesAllFragmentsThenOverflows) {
  const int frags = GetParam();
  const SlbConfig config = plane(frags);
  SlbModel fits(config), over(config);
  flat(fits, 1, 0, strips(frags, config));
  EXPECT_EQ(fits.counters().chains_dropped, 0u);
  EXPECT_EQ(fits.entry(3, 3).count, frags);
  EXPECT_EQ(fits.entry(3, 3).chains(0, frags), 2 * frags);
  EXPECT_EQ(compare(fits, {strips(frags, config)}, 100, 1).wrong_far, 0u);
  EXPECT_FALSE(fits.sticky().line_overflow);

  flat(over, 1, 0, strips(frags + 2, config));
  EXPECT_GT(over.counters().chains_dropped, 0u);
  EXPECT_TRUE(over.sticky().line_overflow);
  EXPECT_TRUE(over.entry(3, 3).overflow);
  EXPECT_EQ(over.entry(3, 3).count, frags);
  // Nothing outside the overflowing pixels suffers, and the strips that fitted still answer.
  const Comparison c = compare(over, {strips(frags + 2, config)}, 100, 1);
  EXPECT_EQ(c.wrong_away, 0u);
  EXPECT_EQ(c.wrong_far, 0u);
  EXPECT_TRUE(shadow(over, 3.085, 3.5, 1));
}

TEST_P(Capacity, TheFarthestObjectIsEvicted) {
  const int frags = GetParam();
  const SlbConfig config = plane(frags);
  SlbModel model(config);
  // One object a fragment, each a half plane left of x = 3.3 or 3.8, the farthest one first.
  for (int i = 0; i < frags; ++i)
    flat(model, static_cast<std::uint8_t>(i), static_cast<std::uint32_t>(100 - 10 * i),
         {quad(1.2, 1.2, i == 0 ? 3.8 : 3.3, 6, config)});
  EXPECT_EQ(model.counters().groups_evicted, 0u);
  flat(model, 50, 5, {quad(1.2, 1.2, 3.1, 6, config)});
  EXPECT_GT(model.counters().groups_evicted, 0u);
  EXPECT_TRUE(model.sticky().object_overflow);
  const Entry entry = model.entry(3, 3);
  EXPECT_TRUE(entry.overflow);
  EXPECT_EQ(entry.count, frags);
  EXPECT_EQ(entry.fragments[static_cast<std::size_t>(frags) - 1].object, 50);
  for (int i = 0; i < frags; ++i) EXPECT_NE(entry.fragments[static_cast<std::size_t>(i)].object, 0);
  // Object 0 covered the centre: its answer stays for the whole pixel.
  EXPECT_EQ(entry.full_depth, 100u);
  EXPECT_TRUE(shadow(model, 3.9, 3.5, 101));
  EXPECT_FALSE(shadow(model, 3.9, 3.5, 100));
}

TEST_P(Capacity, AFartherNewcomerLeavesItsAnswerAtTheCentre) {
  const int frags = GetParam();
  const SlbConfig config = plane(frags);
  for (const double edge : {3.8, 3.3}) {
    SlbModel model(config);
    for (int i = 0; i < frags; ++i)
      flat(model, static_cast<std::uint8_t>(i), 7, {quad(1.2, 1.2, 3.1, 6, config)});
    flat(model, 99, 50, {quad(1.2, 1.2, edge, 6, config)});
    EXPECT_GT(model.counters().chains_dropped, 0u);
    EXPECT_EQ(model.counters().groups_evicted, 0u);
    EXPECT_EQ(model.entry(3, 3).full_depth, edge > 3.5 ? 50u : config.no_depth());
    EXPECT_EQ(shadow(model, 3.95, 3.5, 60), edge > 3.5);
    EXPECT_TRUE(shadow(model, 2.5, 3.5, 60));
  }
}

TEST_P(Capacity, EqualDepthsKeepTheEarlier) {
  const int frags = GetParam();
  const SlbConfig config = plane(frags);
  SlbModel model(config);
  for (int i = 0; i <= frags; ++i)
    flat(model, static_cast<std::uint8_t>(i), 7, {quad(1.2, 1.2, 3.1, 6, config)});
  EXPECT_EQ(model.counters().groups_evicted, 0u);
  for (int i = 0; i < frags; ++i)
    EXPECT_EQ(model.entry(3, 3).fragments[static_cast<std::size_t>(i)].object, i);
}

INSTANTIATE_TEST_SUITE_P(Fragments, Capacity, ::testing::Values(1, 2, 3, 4));

TEST(Store, ACornerThatDoesNotFitIsReduced) {
  const SlbConfig config = plane(1);
  SlbModel model(config);
  // A line through pixel (3, 3) and a corner in it: three lines, two slots.
  flat(model, 1, 0, {quad(1, -2, 3.2, 10, config), quad(3.4, -2, 6, 3.6, config)});
  EXPECT_EQ(model.counters().chains_reduced, 1u);
  EXPECT_EQ(model.counters().chains_dropped, 0u);
  EXPECT_TRUE(model.entry(3, 3).overflow);
  EXPECT_EQ(model.entry(3, 3).fragments[0].op, FragmentOp::Two);
  EXPECT_TRUE(shadow(model, 3.1, 3.8, 1));
  EXPECT_TRUE(shadow(model, 3.9, 3.1, 1));
  EXPECT_FALSE(shadow(model, 3.9, 3.9, 1));
}

TEST(Depth, AFlatCasterNeverShadowsItselfAtBiasZero) {
  const SlbConfig config = plane(2);
  Random random(6);
  for (const std::uint32_t depth : {0u, 1u, 77u, config.no_depth() - 1}) {
    SlbModel model(config);
    flat(model, 1, depth, {quantise(star(random, 9, 1, 3.6, {4, 4}), config)});
    int deeper = 0;
    for (int i = 0; i < 20'000; ++i) {
      const std::int64_t span = std::int64_t{8} << config.query_bits;
      const QueryPoint point{random.integer(0, span - 1), random.integer(0, span - 1), depth};
      ASSERT_FALSE(model.query(point, 0).shadow);
      deeper += model.query({point.x, point.y, depth + 1}, 0).shadow ? 1 : 0;
      ASSERT_FALSE(model.query({point.x, point.y, depth + 1}, 1).shadow);
    }
    EXPECT_GT(deeper, 1000);
  }
}

TEST(Depth, NoneNeverShadows) {
  const SlbConfig config = plane(2);
  SlbModel model(config);
  EXPECT_FALSE(shadow(model, 3, 3, config.no_depth()));
  flat(model, 1, config.no_depth(), {quad(1, 1, 6, 6, config)});
  EXPECT_FALSE(shadow(model, 3, 3, config.no_depth()));
}

TEST(Depth, AGroupIsAsFarAsItsFarthestChain) {
  const SlbConfig config = plane(2);
  SlbModel model(config);
  model.begin_object(1, false, 0);
  model.loop(quad(1, 1, 3.3, 6, config, 10));
  model.loop(quad(3.6, 1, 6, 6, config, 90));
  model.fill();
  model.end_object();
  EXPECT_FALSE(shadow(model, 3.1, 3.5, 90));
  EXPECT_TRUE(shadow(model, 3.1, 3.5, 91));
}

TEST(Cover, SamplesCountWhereTheObjectCovers) {
  const SlbConfig config = plane(2);
  SlbModel model(config);
  model.begin_object(1, false, 0);
  model.loop(quad(1.5, 1.5, 5.5, 5.5, config, 40));
  EXPECT_THROW(model.cover({3, 3, 50, 0}, 0), std::logic_error);
  model.fill();
  EXPECT_EQ(model.entry(3, 3).full_depth, config.no_depth()) << "coverage alone has no depth";
  model.cover({3, 3, 50, 3}, 0);   // covered: counts
  model.cover({3, 3, 60, 0}, 0);   // farther: no change
  model.cover({1, 4, 99, 0}, 5);   // on the rim: no sheet fills this pixel
  model.cover({7, 3, 50, 0}, 0);   // outside
  model.cover({-1, 3, 50, 0}, 0);  // off the plane
  model.end_object();
  EXPECT_EQ(model.entry(3, 3).full_depth, 50u);
  EXPECT_EQ(model.entry(1, 4).full_depth, config.no_depth());
  EXPECT_EQ(model.entry(7, 3).full_depth, config.no_depth());
  EXPECT_EQ(model.counters().covers, 5u);
  EXPECT_EQ(model.counters().covers_used, 2u);
  // Another object, elsewhere: the first one's coverage does not count for it.
  model.begin_object(2, false, 0);
  model.loop(quad(6, 6.2, 7.5, 7.6, config, 40));
  model.fill();
  model.cover({3, 3, 1, 0}, 0);
  model.end_object();
  EXPECT_EQ(model.entry(3, 3).full_depth, 50u);
}

/// One sheet covers the pixels, another ends in those of column 3, at depth 40.
class OverlappingSheets : public ::testing::Test {
 protected:
  OverlappingSheets() : config_(plane(2)), model_(config_) {
    model_.begin_object(1, false, 0);
    model_.loop(quad(1, 1, 6, 6, config_, 90));
    model_.loop(quad(3.2, 1, 5.5, 6, config_, 40));
    model_.fill();
  }
  std::uint32_t full_depth_after(const CoverSample& sample, std::uint32_t margin) {
    model_.cover(sample, margin);
    return model_.entry(static_cast<int>(sample.column), static_cast<int>(sample.row)).full_depth;
  }
  SlbConfig config_;
  SlbModel model_;
};

TEST_F(OverlappingSheets, KeepTheirLinesAndCover) {
  model_.cover({3, 3, 95, 2}, 0);
  model_.cover({3, 3, 42, 3}, 0);  // the near sheet ends here
  model_.end_object();
  const Entry entry = model_.entry(3, 3);
  EXPECT_EQ(entry.count, 1);
  EXPECT_EQ(entry.fragments[0].threshold_m1, 0);
  EXPECT_EQ(entry.full_depth, 95u);
  EXPECT_TRUE(shadow(model_, 3.6, 3.5, 41)) << "the near sheet by its line";
  EXPECT_FALSE(shadow(model_, 3.1, 3.5, 95));
  EXPECT_TRUE(shadow(model_, 3.1, 3.5, 96)) << "the far sheet by its full depth";
}

TEST_F(OverlappingSheets, OnlyTheSheetThatEndsHereDoesNotCount) {
  EXPECT_EQ(full_depth_after({3, 3, 95, 2}, 0), 95u);
  EXPECT_EQ(full_depth_after({3, 3, 42, 2}, 0), 95u) << "39..42 holds the contour's 40";
  EXPECT_EQ(full_depth_after({3, 3, 40, 0}, 0), 95u);
  EXPECT_EQ(full_depth_after({3, 3, 39, 5}, 1), 95u) << "and so does 8..39 with a margin of 1";
  EXPECT_EQ(full_depth_after({3, 3, 43, 1}, 2), 95u) << "and 42..43 with one of 2";
  EXPECT_EQ(full_depth_after({3, 3, 43, 1}, 1), 43u) << "but not with one of 1";
  EXPECT_EQ(full_depth_after({3, 3, 39, 5}, 0), 39u) << "nearer than the contour: it hides it";
  EXPECT_EQ(full_depth_after({3, 3, 3, 31}, 0), 3u) << "the front stops at 0";
  EXPECT_EQ(full_depth_after({4, 3, 40, 3}, 9), 40u) << "no contour, no doubt";
}

TEST_F(OverlappingSheets, WithoutAnotherSheetTheOneThatEndsHereCounts) {
  EXPECT_EQ(full_depth_after({3, 4, 42, 3}, 0), 42u);
}

TEST(Clear, GenerationsNeverShowOldEntries) {
  const SlbConfig config = plane(1);
  SlbModel model(config);
  Random random(2);
  for (int round = 0; round < 600; ++round) {
    // Old entries everywhere but the last round's: after 255 rounds a tag comes again.
    if (round % 85 == 0) flat(model, 1, 3, {quad(0.5, 0.5, 7.5, 7.5, config)});
    const int column = static_cast<int>(random.integer(0, 7)), row = static_cast<int>(random.integer(0, 7));
    if (round % 85 != 0) {
      for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) {
          ASSERT_EQ(model.entry(x, y).count, 0) << "round " << round;
          ASSERT_EQ(model.entry(x, y).full_depth, config.no_depth()) << "round " << round;
        }
    } else {
      ASSERT_GT(model.entry(0, 3).count, 0);
      ASSERT_EQ(model.entry(3, 3).full_depth, 3u);
    }
    ASSERT_FALSE(model.entry(column, row).open);
    model.clear();
  }
}

TEST(Clear, ResetForgetsEverything) {
  const SlbConfig config = plane(2);
  SlbModel model(config), fresh(config);
  flat(model, 1, 3, {quad(0.5, 0.5, 7.5, 7.5, config)});
  model.begin_object(2, true, 3);
  for (const Vertex& v : quad(2.5, 0.5, 7.5, 7.5, config)) model.vertex(v);
  model.reset();
  EXPECT_EQ(model.counters(), fresh.counters());
  flat(model, 7, 1, {quad(1.5, 1.5, 3.5, 4.5, config)});
  flat(fresh, 7, 1, {quad(1.5, 1.5, 3.5, 4.5, config)});
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) EXPECT_EQ(model.entry(x, y), fresh.entry(x, y));
  EXPECT_EQ(model.counters(), fresh.counters());
}

}  // namespace
}  // namespace gnomon::golden::slb::testing
