// SPDX-License-Identifier: Apache-2.0
// The silhouette-line buffer's commands inside the one stream (docs/command-stream.md), one rule a test.
#include <gtest/gtest.h>

#include <algorithm>
#include <gnomon/golden/command.hpp>
#include <gnomon/golden/golden_engine.hpp>
#include <gnomon/golden/slb/unit.hpp>
#include <gnomon/golden/stream.hpp>
#include <string>

#include "tests/golden/run_stream.hpp"
#include "tests/golden/slb/stimulus.hpp"
#include "tests/support/slb_directed.hpp"

namespace gnomon::golden_test {
namespace {

using golden::ErrorCode;
using golden::HardwareConfig;
using golden::Header;
using golden::Word;
using golden::slb::SlbOp;

constexpr std::uint8_t op(SlbOp value) {
  return static_cast<std::uint8_t>(value);
}

HardwareConfig small() {
  HardwareConfig config;
  config.plane_log2 = 5;
  config.en_slb = true;
  config.slb_plane_log2 = 4;
  return config;
}

/// A header without items, and three vertices where it is a LOOP.
std::vector<Word> slb(SlbOp which, std::uint8_t flags = 0) {
  if (which != SlbOp::Loop) return command({op(which), flags, 0, 0x07000005});
  const golden::slb::SlbConfig config = small().slb_config();
  const std::int64_t pixel = config.subpixels();
  const std::vector<golden::slb::Vertex> triangle{
      {pixel, pixel, 9}, {6 * pixel, 2 * pixel, 9}, {3 * pixel, 7 * pixel, 9}};
  std::vector<Word> items;
  items.reserve(triangle.size());
  for (const auto& vertex : triangle) items.push_back(encode(vertex, config));
  return command({op(which), flags, 3, 0}, items);
}

std::vector<int> errors(std::span<const Word> results) {
  std::vector<int> found;
  golden::ResultReader reader(results);
  while (const auto result = reader.next()) {
    if (golden::result_code(result->word) == golden::ResultCode::Error) {
      found.push_back(golden::decode_error_result(result->word).error);
    }
  }
  return found;
}

/// How a state is reached, what the page allows there, and how an object goes on from there to its end.
struct State {
  const char* name;
  std::vector<Word> reach;
  std::string allowed;  ///< by initial: sClear, Begin, Loop, Fill, Cover, End, Query, Read
  std::vector<Word> finish;
};
std::vector<State> states() {
  const std::vector<Word> begin = slb(SlbOp::BeginObject), loop = slb(SlbOp::Loop),
                          more = slb(SlbOp::Loop, 1), fill = slb(SlbOp::Fill), end = slb(SlbOp::EndObject);
  return {{"Idle", {}, "sBQR", begin + fill + end},
          {"Object without LOOP", begin, "LFE", end},
          {"Object", begin + loop, "LF", loop + fill + end},
          {"Loop", begin + more, "L", more + loop + fill + end},
          {"Filled", begin + fill, "CE", end},
          {"Filled with lines", begin + loop + fill, "CE", end}};
}

TEST(SlbEngine, EveryStateAllowsWhatItsRowSays) {
  const std::string initials = "sBLFCEQR";
  for (const State& state : states()) {
    for (std::uint8_t i = 0; i < 8; ++i) {
      const bool allowed = state.allowed.find(initials[i]) != std::string::npos;
      const std::vector<Word> tried = slb(static_cast<SlbOp>(0x20 + i));
      const Outcome outcome = run(small(), state.reach + tried);
      EXPECT_EQ(errors(outcome.results), allowed ? std::vector<int>{} : std::vector<int>{6})
          << state.name << ", " << golden::describe_header(tried.front());
      if (allowed) continue;
      // It has changed nothing: the object goes on as if it had not been.
      const Outcome rest = run(small(), state.reach + tried + state.finish);
      EXPECT_EQ(errors(rest.results), std::vector<int>{6}) << state.name;
      EXPECT_EQ(rest.results.front(),
                encode(golden::ErrorResult{
                    6, static_cast<std::uint32_t>(run(small(), state.reach).events.at("COMMANDS"))}));
      auto without = run(small(), state.reach + state.finish).events;
      ++without["COMMANDS"];
      ++without["ERRORS"];
      EXPECT_EQ(rest.events, without) << state.name;
    }
  }
}

TEST(SlbEngine, OfSeveralErrorsTheFirstInOrderIsReported) {
  HardwareConfig none = small();
  none.en_slb = false;
  const std::uint32_t beyond = golden::slb::encode(golden::slb::EntryRange{255, 2});
  struct Case {
    Header header;
    ErrorCode expected;
    HardwareConfig config;
  };
  const HardwareConfig slb = small();
  const Case cases[] = {
      {{0x1F, 1, 1, 0}, ErrorCode::UnknownOp, slb},
      {{0x28, 1, 1, 0}, ErrorCode::UnknownOp, slb},
      {{op(SlbOp::Fill), 1, 2, 0}, ErrorCode::ReservedFlag, slb},
      {{op(SlbOp::Loop), 2, 2, 0}, ErrorCode::ReservedFlag, slb},
      {{op(SlbOp::BeginObject), 0x80, 0, 0}, ErrorCode::ReservedFlag, slb},
      {{op(SlbOp::Query), 1, 2, 0}, ErrorCode::ReservedFlag, none},
      {{op(SlbOp::Query), 0, 2, 0}, ErrorCode::FeatureAbsent, none},
      {{op(SlbOp::Fill), 0, 2, 0}, ErrorCode::FeatureAbsent, none},
      {{op(SlbOp::ReadEntries), 0, 0, beyond}, ErrorCode::FeatureAbsent, none},
      {{op(SlbOp::Fill), 0, 2, 0}, ErrorCode::BadArgument, slb},
      {{op(SlbOp::Clear), 0, 1, 0}, ErrorCode::BadArgument, slb},
      {{op(SlbOp::BeginObject), 1, 1, 0}, ErrorCode::BadArgument, slb},
      {{op(SlbOp::EndObject), 0, 1, 0}, ErrorCode::BadArgument, slb},
      {{op(SlbOp::ReadEntries), 0, 1, 0}, ErrorCode::BadArgument, slb},
      {{op(SlbOp::ReadEntries), 0, 0, beyond}, ErrorCode::BadArgument, slb},
      {{op(SlbOp::Loop), 0, 2, 0}, ErrorCode::BadSequence, slb},
      {{op(SlbOp::Cover), 0, 2, 0}, ErrorCode::BadSequence, slb},
  };
  for (const Case& c : cases) {
    // Items of a command in error must be skipped: these would be errors themselves.
    const std::vector<Word> items(c.header.count, encode(Header{0x7F, 0, 0, 0}));
    const Outcome outcome = run(c.config, command(c.header, items) + command({0x03, 0, 0, 4}));
    ASSERT_EQ(outcome.results.size(), 2u);
    EXPECT_EQ(outcome.results[0], encode(golden::ErrorResult{static_cast<std::uint8_t>(c.expected), 0}))
        << golden::describe_header(encode(c.header));
  }
}

TEST(SlbEngine, OnlyHardwareWithTheUnitReportsItsEvents) {
  HardwareConfig none = small();
  none.en_slb = false;
  for (const auto& [name, count] : run(none, {}).events) EXPECT_NE(name.rfind("SLB_", 0), 0u) << name;
  const auto events = run(small(), {}).events;
  EXPECT_EQ(std::count_if(events.begin(), events.end(),
                          [](const auto& event) { return event.first.rfind("SLB_", 0) == 0; }),
            23);
}

/// Words of the buffer's results, raw words included, or of all others.
std::vector<Word> of_slb(std::span<const Word> results, bool wanted) {
  std::vector<Word> words;
  golden::ResultReader reader(results);
  while (const auto result = reader.next()) {
    const auto code = static_cast<std::uint8_t>(golden::result_code(result->word));
    if ((code == 0x26 || code == 0x27) != wanted) continue;
    words.push_back(result->word);
    words.insert(words.end(), result->raw.begin(), result->raw.end());
  }
  return words;
}

TEST(SlbEngine, TheUnitsDoNotDisturbEachOther) {
  const HardwareConfig config = small();
  std::size_t compared = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const auto vpu = stimulus::random_stream({.plane_log2 = 5}, {.seed = seed, .commands = 150});
    const auto commands =
        golden::slb::testing::random_commands(seed, config.slb_config(), {.error_share = 0});
    const std::vector<Word> alone = golden::slb::testing::to_words(commands);
    std::vector<Word> mixed, vpu_alone;
    golden::CommandReader reader(vpu);
    for (const auto& each : commands) {
      mixed = std::move(mixed) + golden::slb::testing::to_words({each});
      const auto other = reader.next();
      // Error words hold the command's index, and the buffer's own commands would end up in its sequence.
      if (!other || golden::CommandSequence(config).next(other->header) || other->header.op >= 0x20) continue;
      const auto words = command(other->header, {other->items.begin(), other->items.end()});
      mixed = std::move(mixed) + words;
      vpu_alone = std::move(vpu_alone) + words;
    }
    const auto results = run(config, mixed).results;
    const auto slb_results = run(config, alone).results;
    EXPECT_EQ(compare(slb_results, of_slb(results, true)).first, "") << "seed " << seed;
    // Sticky flags are both units'.
    const auto without_flags = [](std::vector<Word> words) {
      for (Word& word : words) {
        if (golden::result_code(word) == golden::ResultCode::Fence) word &= 0xFF0000FFFFFFFFFF;
      }
      return words;
    };
    const auto rest =
        compare(without_flags(run(config, vpu_alone).results), without_flags(of_slb(results, false)));
    EXPECT_EQ(rest.first, "") << "seed " << seed;
    compared += slb_results.size() + rest.compared;
  }
  EXPECT_GT(compared, 3000u);
}

TEST(SlbEngine, GivesTheUnitsAnswersHoweverTheStreamIsCut) {
  const HardwareConfig config = small();
  std::size_t compared = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    golden::slb::SlbUnit unit(config.slb_config());
    const auto commands = golden::slb::testing::random_commands(seed, config.slb_config());
    std::vector<Word> expected;
    for (std::uint32_t i = 0; i < commands.size(); ++i) {
      const auto& c = commands[i];
      const auto outcome = unit.execute(c.op, c.flags, c.arg, c.items);
      if (outcome.error != golden::slb::SlbError::None) {
        expected.push_back(encode(golden::ErrorResult{static_cast<std::uint8_t>(outcome.error), i}));
      }
      expected.insert(expected.end(), outcome.results.begin(), outcome.results.end());
    }
    for (const std::size_t piece : {0U, 1U, 2U, 3U, 7U, 100U}) {
      const Outcome outcome = run(config, golden::slb::testing::to_words(commands), piece);
      const Comparison comparison = compare(expected, outcome.results);
      EXPECT_EQ(comparison.differ, 0u) << comparison.first << " in pieces of " << piece;
      compared += comparison.compared;
      for (const auto& [name, count] : golden::slb::named(unit.model().counters())) {
        EXPECT_EQ(outcome.events.at(name), count) << name;
      }
    }
  }
  EXPECT_GT(compared, 10000u);
}

/// A command that has begun shows its effect as far as its items have come.
TEST(SlbEngine, AnswersAndCountsInTheMiddleOfACommand) {
  const auto engine = golden::make_golden_engine(small());
  const auto loop = slb(SlbOp::Loop);
  engine->submit(slb(SlbOp::BeginObject) + std::vector<Word>(loop.begin(), loop.begin() + 3));
  EXPECT_EQ(engine->counters().events.at("SLB_VERTICES"), 2u);
  EXPECT_EQ(engine->counters().events.at("SLB_CROSSINGS"), 0u);
  engine->submit(std::span(loop).subspan(3));
  EXPECT_EQ(engine->counters().events.at("SLB_LOOPS"), 1u);
  EXPECT_GT(engine->counters().events.at("SLB_CROSSINGS"), 10u);
  engine->submit(slb(SlbOp::Fill) + slb(SlbOp::EndObject) + std::vector<Word>{0x2600000300000000, 0, 0});
  EXPECT_EQ(drain(*engine).size(), 2u);
  engine->submit(std::vector<Word>{0});
  EXPECT_EQ(drain(*engine).size(), 1u);
}

TEST(SlbEngine, ResetForgetsAnOpenLoopThePlaneAndTheFlags) {
  const HardwareConfig config = small();
  const auto engine = golden::make_golden_engine(config);
  const std::vector<Word> probe =
      command({op(SlbOp::ReadEntries), 0, 0, 0xFF000000}) + command({0x03, 0, 0, 1});
  engine->submit(probe);
  const std::vector<Word> fresh = drain(*engine);
  for (const auto& [name, words] : stimulus::slb_directed_streams(config)) {
    engine->submit(words + slb(SlbOp::BeginObject) + slb(SlbOp::Loop, 1));
    drain(*engine);
    engine->reset();
    engine->submit(probe);
    EXPECT_EQ(drain(*engine), fresh) << "after " << name;
    EXPECT_EQ(engine->counters().events.at("SLB_VERTICES"), 0u);
    engine->reset();
  }
}

TEST(SlbEngine, StickyFlagsOfTheUnitStandBesideTheOthers) {
  const HardwareConfig config = small();
  const auto flags = [&](const char* wanted) {
    std::uint32_t seen = 0;
    for (const auto& [name, words] : stimulus::slb_directed_streams(config)) {
      if (name != wanted) continue;
      const std::vector<Word> results = run(config, words).results;
      golden::ResultReader reader(results);
      while (const auto result = reader.next()) {
        if (golden::result_code(result->word) == golden::ResultCode::Fence)
          seen |= golden::decode_fence_result(result->word).sticky;
      }
      EXPECT_EQ(golden::decode_fence_result(results.back()).sticky, 0u) << "cleared by the fence before";
    }
    return seen;
  };
  EXPECT_EQ(flags("slb_overflow"), golden::slb::kStickyLineOverflow | golden::slb::kStickyObjectOverflow);
  EXPECT_EQ(flags("slb_winding") & golden::slb::kStickyWindingSaturated,
            golden::slb::kStickyWindingSaturated);
  EXPECT_EQ(flags("slb_sequence") & 0xFF, golden::kStickyErrorSeen);
}

}  // namespace
}  // namespace gnomon::golden_test
