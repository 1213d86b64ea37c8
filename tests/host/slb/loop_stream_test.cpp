// SPDX-License-Identifier: Apache-2.0
// Streams of flat casters and their answers, through the engine.
#include "host/slb/loop_stream.hpp"

#include <gtest/gtest.h>

#include <gnomon/golden/golden_engine.hpp>
#include <gnomon/golden/slb/model.hpp>
#include <gnomon/golden/stream.hpp>
#include <random>

#include "host/slb/engine_run.hpp"
#include "host/slb/polygon_reference.hpp"
#include "tests/host/slb/shapes.hpp"

namespace gnomon::slb {
namespace {

Loop square(double low, double high) {
  return {{low, low}, {high, low}, {high, high}, {low, high}};
}

LoopResults answers(const LoopScene& scene, const std::vector<Receiver>& receivers,
                    const golden::HardwareConfig& config, bool entries = false) {
  const auto casters = to_fixed(scene, config.slb_config()).value();
  std::vector<golden::slb::QueryPoint> queries;
  queries.reserve(receivers.size());
  for (const Receiver& receiver : receivers) queries.push_back(to_query(receiver, config.slb_config()));
  const auto stream = loop_stream(casters, queries, config, entries);
  return decode_results(run_golden(config, stream, [](double) {}).results, queries.size(), config);
}

TEST(LoopStream, AnswersByPlaceAndDepth) {
  const golden::HardwareConfig config = test::hardware(test::small_plane(7));
  Loop hole = square(20, 30);
  std::reverse(hole.begin(), hole.end());
  const LoopScene scene{{0.25, {square(10, 40), hole}}, {0.75, {}}, {0.5, {square(22, 60)}}};
  const auto found = answers(scene,
                             {{15, 15, 1},
                              {15, 15, 0.25},
                              {15, 15, 0.24},
                              {21, 21, 1},
                              {25, 25, 1},
                              {25, 25, 0.5},
                              {35, 35, 0.4},
                              {50, 50, 0.5},
                              {50, 50, 0.51},
                              {-5, 15, 1},
                              {64, 15, 1},
                              {1e9, -1e9, 1}},
                             config);
  std::string text;
  for (const golden::slb::QueryAnswer& answer : found.answers) text += answer.shadow ? '1' : '0';
  EXPECT_EQ(text, "100010101000");
  EXPECT_TRUE(found.answers.back().off_plane);
  EXPECT_TRUE(found.entries.empty());
}

TEST(LoopStream, TakesMoreObjectsThanThereAreIds) {
  const golden::HardwareConfig config = test::hardware(test::small_plane(5));
  LoopScene scene;
  std::vector<Receiver> receivers;
  for (int i = 0; i < 300; ++i) {
    const int column = i % 20, row = i / 20;
    const double x = 3 * column + 0.3, y = 3 * row + 0.3;
    scene.push_back({0.5, {{{x, y}, {x + 1.9, y + 0.1}, {x + 0.9, y + 1.8}}}});
    receivers.push_back({x + 0.9, y + 0.7, 1});
  }
  const auto found = answers(scene, receivers, config);
  ASSERT_EQ(found.answers.size(), 300U);
  for (std::size_t i = 0; i < 300; ++i) EXPECT_TRUE(found.answers[i].shadow) << i;
}

TEST(LoopStream, TakesMoreQueriesThanACommand) {
  const golden::HardwareConfig config = test::hardware(test::small_plane(7));
  const LoopScene scene{{0.5, {{{3, 5}, {60, 20}, {31, 61}}}}};
  const PolygonReference reference(scene, 64);
  std::mt19937_64 random(2);
  std::vector<Receiver> receivers(150000);
  for (Receiver& r : receivers) {
    r = {std::ldexp(static_cast<double>(random() >> 11), -53) * 64,
         std::ldexp(static_cast<double>(random() >> 11), -53) * 64, 1};
  }
  const auto found = answers(scene, receivers, config);
  std::size_t wrong = 0, compared = 0;
  for (std::size_t i = 0; i < receivers.size(); ++i) {
    ++compared;
    wrong += found.answers[i].shadow == reference.in_shadow({receivers[i].x, receivers[i].y}, 1) ? 0U : 1U;
  }
  EXPECT_EQ(compared, 150000U);
  // 170 px of border, off by 0.6 of a 128 times finer map.
  EXPECT_LT(wrong, 30U);
}

TEST(LoopStream, ReadsTheWholePlane) {
  const golden::HardwareConfig config = test::hardware(test::small_plane(4));
  const auto found = answers({{0.5, {square(10.5, 20)}}}, {{1, 1, 1}}, config, true);
  ASSERT_EQ(found.entries.size(), 64U * 64U);
  EXPECT_EQ(found.entries[12 * 64 + 12].full_depth, caster_depth(0.5, config.slb_config()));
  EXPECT_EQ(found.entries[12 * 64 + 10].count, 1);
  EXPECT_EQ(found.entries[0].full_depth, config.slb_config().no_depth());
}

TEST(LoopStream, RefusesResultsOfOtherStreams) {
  const golden::HardwareConfig config = test::hardware(test::small_plane(4));
  EXPECT_THROW(decode_results({}, 1, config), std::logic_error);
  const golden::Word error = golden::encode(golden::ErrorResult{6, 3});
  EXPECT_THROW(decode_results(std::vector{error}, 0, config), std::logic_error);
}

}  // namespace
}  // namespace gnomon::slb
