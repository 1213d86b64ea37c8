// SPDX-License-Identifier: Apache-2.0
// Cycles of the silhouette-line buffer: a crossing, a query, a sample, an entry and a span of a fill, a word
// of a dump; and what waits are blamed on.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <gnomon/golden/codec.hpp>
#include <gnomon/golden/slb/codec.hpp>
#include <numbers>
#include <string_view>
#include <vector>

#include "sim/counter_names.hpp"
#include "slb_builds.hpp"
#include "slb_streams.hpp"
#include "tests/rtl/stream_bench.hpp"

namespace gnomon::rtl_test {
namespace {

using golden::slb::SlbConfig;
using golden::slb::SlbOp;

constexpr std::size_t kClear = 2, kRead = 5, kDraw = 6, kFill = 7, kCover = 8, kQuery = 9;
constexpr std::size_t kInputStarved = 1, kOutputBlocked = 2, kMemoryWait = 3;

void append(std::vector<Word>& words, const std::vector<Word>& more) {
  words.insert(words.end(), more.begin(), more.end());
}

/// A closed curve around the middle of the plane; neighbouring corners are about `edge` pixels apart.
std::vector<Word> curve(const SlbConfig& config, double radius, double edge) {
  const auto corners = static_cast<int>(2 * std::numbers::pi * radius / edge);
  const double middle = config.side() / 2.0;
  const auto scale = static_cast<double>(config.subpixels());
  std::vector<Word> items;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    const double r = radius * (1 + 0.2 * std::sin(3 * angle));
    items.push_back(encode(golden::slb::Vertex{std::llround((middle + r * std::cos(angle)) * scale),
                                               std::llround((middle + r * std::sin(angle)) * scale),
                                               static_cast<std::uint32_t>(100 + i)},
                           config));
  }
  return items;
}

/// One object of `loops` equal loops.
std::vector<Word> object(const std::vector<Word>& loop, int loops) {
  std::vector<Word> words = slb_command(SlbOp::BeginObject, 0, 1u << 24 | 5, {});
  for (int i = 0; i < loops; ++i) append(words, slb_command(SlbOp::Loop, 0, 0, loop));
  append(words, slb_command(SlbOp::Fill, 0, 0, {}));
  return words;
}

std::uint64_t slb_event(auto& bench, std::string_view name) {
  const auto* at = std::find(sim::kSlbEventNames.begin(), sim::kSlbEventNames.end(), name);
  return bench.counter(sim::kFirstSlbCounter + static_cast<unsigned>(at - sim::kSlbEventNames.begin()));
}

std::uint64_t pass_cycles(auto& bench, std::size_t pass) {
  std::uint64_t cycles = 0;
  for (std::size_t cause = 0; cause < sim::kCauseNames.size(); ++cause) {
    cycles += bench.counter(sim::cycle_counter_index(pass, cause));
  }
  return cycles;
}

double per(std::uint64_t cycles, std::uint64_t events) {
  return static_cast<double>(cycles) / static_cast<double>(events);
}

TEST(SlbThroughput, ACrossingACycleOnSmoothOutlines) {
  const SlbConfig config = SlbBuild<Vslb_default>::config().slb_config();
  for (const double edge : {1.4, 1.0, 0.9, 5.0}) {
    StreamBench<Vslb_default> bench(1);
    bench.run(object(curve(config, 12, edge), 30));
    const std::uint64_t crossings = slb_event(bench, "SLB_CROSSINGS");
    EXPECT_GT(crossings, 2'500u);
    EXPECT_LE(per(pass_cycles(bench, kDraw), crossings), 1.10) << "edges of " << edge << " px";
    RecordProperty("crossing", std::to_string(per(pass_cycles(bench, kDraw), crossings)));
  }
}

/// Left to right and bottom to top, in pixels; their borders run through the middle of pixels.
struct Box {
  std::int64_t left, bottom, right, top;
};

/// Cycles of the fill of an object of boxes, on a plane of 64 pixels a side: a row is a span of four lines.
struct Fill {
  std::uint64_t cycles, pixels, groups, covered;
};
Fill fill_of(const std::vector<Box>& boxes, bool flat) {
  const SlbConfig config = SlbBuild<Vslb_faulty>::config().slb_config();
  const auto corner = [&](std::int64_t x, std::int64_t y) {
    const std::int64_t half = config.subpixels() / 2;
    return encode(golden::slb::Vertex{x * config.subpixels() + half, y * config.subpixels() + half, 5},
                  config);
  };
  std::vector<Word> words =
      slb_command(SlbOp::BeginObject, flat ? golden::slb::kBeginFlat : 0, 1u << 24 | 5, {});
  for (const Box& box : boxes)
    append(words, slb_command(SlbOp::Loop, 0, 0,
                              {corner(box.left, box.bottom), corner(box.right, box.bottom),
                               corner(box.right, box.top), corner(box.left, box.top)}));
  append(words, slb_command(SlbOp::Fill, 0, 0, {}));
  StreamBench<Vslb_faulty> bench(1);
  bench.run(words);
  return {pass_cycles(bench, kFill), slb_event(bench, "SLB_FILL_PIXELS"), slb_event(bench, "SLB_FILL_GROUPS"),
          slb_event(bench, "SLB_FILL_COVERED")};
}

constexpr std::uint64_t kFillStart = 9;  // a header, and the pipeline that fills once

TEST(SlbThroughput, AFillTakesACycleForAnEntryWithLines) {
  const Fill fill = fill_of({{4, 4, 59, 59}}, false);
  EXPECT_EQ(fill.pixels, 56u * 64);
  EXPECT_EQ(fill.groups, 4u * 55);
  EXPECT_EQ(fill.covered, 54u * 54);
  EXPECT_EQ(fill.cycles, fill.groups + kFillStart);  // the plain lines between them go along
}

TEST(SlbThroughput, AFillTakesACycleForASpanWithoutLines) {
  const Fill fill = fill_of({{4, 2, 5, 3}, {4, 60, 5, 61}}, false);
  EXPECT_EQ(fill.pixels, 60u * 64);
  EXPECT_EQ(fill.groups, 8u);
  EXPECT_EQ(fill.cycles, fill.groups + 56 + kFillStart);
}

TEST(SlbThroughput, AFillOfAFlatObjectTakesACycleForACoveredLine) {
  const Fill fill = fill_of({{4, 4, 59, 59}}, true);
  EXPECT_EQ(fill.covered, 54u * 54);
  EXPECT_EQ(fill.cycles, fill.groups + 2ULL * 54 + kFillStart);  // the two lines in the middle of a row
}

TEST(SlbThroughput, AFillOfAnObjectThatTouchesNoRowTakesNothing) {
  const Fill fill = fill_of({}, false);
  EXPECT_EQ(fill.pixels, 0u);
  EXPECT_EQ(fill.cycles, 2u);
}

TEST(SlbThroughput, AQueryAndASampleACycle) {
  const SlbConfig config = SlbBuild<Vslb_default>::config().slb_config();
  constexpr std::int64_t kItems = 2000;
  std::vector<Word> points, samples;
  for (std::int64_t i = 0; i < kItems; ++i) {
    points.push_back(encode(golden::slb::QueryPoint{i * 16, (i % 32) << 10, 5000}, config));
    samples.push_back(encode(golden::slb::CoverSample{i / 5 % 32, 16, 5000, 0}, config));
  }
  StreamBench<Vslb_default> bench(1);
  std::vector<Word> words = object(curve(config, 12, 1), 1);
  append(words, slb_command(SlbOp::Cover, 0, 5, samples));
  append(words, slb_command(SlbOp::EndObject, 0, 0, {}));
  for (int i = 0; i < 3; ++i) append(words, slb_command(SlbOp::Query, 0, 5, points));
  EXPECT_EQ(bench.run(words).size(), 3u * kItems);
  EXPECT_LE(per(pass_cycles(bench, kCover), kItems), 1.02);
  EXPECT_LE(per(pass_cycles(bench, kQuery), 3 * kItems), 1.02);
}

TEST(SlbThroughput, AWordOfADumpACycle) {
  StreamBench<Vslb_default> bench(1);
  EXPECT_EQ(bench.run(slb_command(SlbOp::ReadEntries, 0, 255u << 24, {})).size(), 256u * 5);
  EXPECT_LE(pass_cycles(bench, kRead), 256u * 5 + 8);
}

TEST(SlbThroughput, AClearCostsAScrubbedSlice) {
  StreamBench<Vslb_default> bench(1);
  bench.run({});
  const std::uint64_t after_reset = pass_cycles(bench, kClear);
  EXPECT_EQ(after_reset, 32u * 32 / 16 + 1);  // a line a cycle, longer than the other plane's
  std::vector<Word> words;
  for (int i = 0; i < 10; ++i) append(words, slb_command(SlbOp::Clear, 0, 0, {}));
  bench.run(words);
  EXPECT_EQ(pass_cycles(bench, kClear) - after_reset, 10u * 3);  // header, one line, end
}

TEST(SlbThroughput, BlamesTheRightCause) {
  const SlbConfig config = SlbBuild<Vslb_default>::config().slb_config();
  const std::vector<Word> points(1000, encode(golden::slb::QueryPoint{5000, 5000, 5000}, config));
  const std::vector<Word> words = slb_command(SlbOp::Query, 0, 0, points);
  const auto blamed = [&](Stalls stalls, std::size_t cause) {
    StreamBench<Vslb_default> bench(1);
    bench.run(words, stalls);
    return bench.counter(sim::cycle_counter_index(kQuery, cause));
  };
  EXPECT_GT(blamed({.command_open = 64}, kInputStarved), 2000u);
  EXPECT_GT(blamed({.result_open = 64}, kOutputBlocked), 2000u);
  const SlbConfig small = SlbBuild<Vslb_small>::config().slb_config();
  StreamBench<Vslb_small> slow(1);
  slow.run(object(curve(small, 3, 1), 30));
  EXPECT_GT(slow.counter(sim::cycle_counter_index(kDraw, kMemoryWait)), 200u);
}

}  // namespace
}  // namespace gnomon::rtl_test
