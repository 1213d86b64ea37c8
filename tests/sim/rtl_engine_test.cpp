// SPDX-License-Identifier: Apache-2.0
// The engine around a model: pieces of streams, stalls, seeds, limits and everything that ends a run early.
#include "sim/rtl_engine.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <gnomon/golden/command.hpp>

#include "sim/interrupt.hpp"
#include "tests/sim/tiny_model.hpp"

namespace gnomon::sim::test {
namespace {

using testing::HasSubstr;

std::vector<Word> expected_fences(std::uint32_t first, std::uint32_t count) {
  std::vector<Word> words;
  for (std::uint32_t i = 0; i < count; ++i)
    words.push_back(golden::encode(golden::FenceResult{0, first + i}));
  return words;
}

Word nop(std::uint16_t items) {
  return golden::encode(golden::Header{0, 0, items, 0});
}

Word read_all() {
  const std::uint32_t range = golden::encode(golden::PlaneRange{0, 256});
  return golden::encode(golden::Header{static_cast<std::uint8_t>(golden::Op::ReadPlane), 0, 0, range});
}

TEST(RtlEngine, GivesResultsInOrderWithTheirCycles) {
  const auto engine = tiny_engine();
  engine->submit(fences(10, 100));
  std::vector<Word> words;
  std::vector<std::uint64_t> cycles;
  engine->drain_timed([&](auto more_words, auto more_cycles) {
    words.insert(words.end(), more_words.begin(), more_words.end());
    cycles.insert(cycles.end(), more_cycles.begin(), more_cycles.end());
  });
  EXPECT_EQ(words, expected_fences(10, 100));
  ASSERT_EQ(cycles.size(), 100u);
  for (std::size_t i = 0; i < cycles.size(); ++i)
    EXPECT_EQ(cycles[i], i + 1);  // one a cycle, each the cycle after its command
  EXPECT_EQ(engine->counters().events.at("COMMANDS"), 100u);
}

TEST(RtlEngine, PollGivesEachResultOnce) {
  const auto engine = tiny_engine();
  std::vector<Word> words;
  const auto take = [&](auto more, auto) { words.insert(words.end(), more.begin(), more.end()); };
  engine->submit(fences(0, 10));
  engine->poll(take);
  EXPECT_LE(words.size(), 10u);
  EXPECT_GT(words.size(), 0u);
  engine->poll(take);
  engine->submit(fences(10, 10));
  engine->drain_timed(take);
  EXPECT_EQ(words, expected_fences(0, 20));
}

TEST(RtlEngine, ClockStandsStillBetweenSubmits) {
  const std::vector<Word> words = fences(0, 50);
  const auto whole = tiny_engine();
  const auto pieces = tiny_engine();
  const std::vector<Word> expected = run(*whole, words);
  for (const Word& word : words) pieces->submit(std::span(&word, 1));
  EXPECT_EQ(run(*pieces, {}), expected);
  EXPECT_EQ(pieces->cycle(), whole->cycle());
}

TEST(RtlEngine, DrainInTheMiddleOfACommandReturns) {
  const auto engine = tiny_engine();
  EXPECT_EQ(run(*engine, std::vector<Word>{fences(1, 1)[0], nop(3), 0}), expected_fences(1, 1));
  EXPECT_EQ(run(*engine, std::vector<Word>{0, 0, fences(2, 1)[0]}), expected_fences(2, 1));
  EXPECT_EQ(engine->counters().events.at("COMMANDS"), 3u);
}

TEST(RtlEngine, StallsDelayAndChangeNothing) {
  const std::vector<Word> words = fences(0, 500);
  const auto plain = tiny_engine();
  run(*plain, words);
  std::vector<std::uint64_t> cycles;
  for (const StallProfile& stalls : {StallProfile{.command = {64, 0}}, StallProfile{.result = {64, 0}},
                                     StallProfile{.command = {128, 3}, .result = {128, 4}, .seed = 5}}) {
    RtlOptions options;
    options.stalls = stalls;
    const auto engine = tiny_engine(options);
    EXPECT_EQ(run(*engine, words), expected_fences(0, 500));
    EXPECT_GT(engine->cycle(), plain->cycle() * 3 / 2);
    cycles.push_back(engine->cycle());
    engine->reset();
    run(*engine, words);
    EXPECT_EQ(engine->cycle(), cycles.back()) << "the same seed must repeat the same stalls";
  }
  EXPECT_NE(cycles[0], cycles[2]);
}

TEST(RtlEngine, PowerUpContentIsRandomAndRepeatable) {
  const std::vector<Word> words{read_all()};
  std::vector<std::vector<Word>> contents;
  for (const std::uint32_t seed : {0u, 1u, 2u, 1u}) {
    RtlOptions options;
    options.seed = seed;
    contents.push_back(run(*tiny_engine(options), words));
  }
  EXPECT_NE(contents[0], contents[1]);
  EXPECT_NE(contents[1], contents[2]);
  EXPECT_EQ(contents[1], contents[3]);
}

TEST(RtlEngine, TwoEnginesInOneThreadDoNotMix) {
  const auto first = tiny_engine();
  const auto second = tiny_engine();
  first->submit(fences(0, 5));
  second->submit(fences(50, 5));
  EXPECT_EQ(run(*first, {}), expected_fences(0, 5));
  EXPECT_EQ(run(*second, {}), expected_fences(50, 5));
}

TEST(RtlEngine, EnginesMayEndInAnyOrder) {
  RtlOptions options;  // a labelled assertion makes a scope, which the runtime keeps in the model's context
  options.assertions = true;
  options.defines = {"TINY_ASSERTS"};
  auto first = tiny_engine(options), second = tiny_engine(options), third = tiny_engine(options);
  third.reset();
  EXPECT_EQ(run(*first, fences(0, 3)), expected_fences(0, 3));
  first.reset();
  EXPECT_EQ(run(*second, fences(0, 3)), expected_fences(0, 3));
}

TEST(RtlEngine, ReadPlaneLeavesNoTrace) {
  RtlOptions options;
  const auto watched = tiny_engine(options), plain = tiny_engine(options);
  run(*watched, fences(0, 3));
  run(*plain, fences(0, 3));
  EXPECT_EQ(watched->read_plane().size(), 512u * 512u);
  EXPECT_EQ(watched->read_plane(), watched->read_plane());
  EXPECT_EQ(watched->cycle(), plain->cycle());
  EXPECT_EQ(watched->counters().events, plain->counters().events);
  EXPECT_EQ(run(*watched, fences(3, 3)), run(*plain, fences(3, 3)));
}

TEST(RtlEngine, ResetForgetsWhatWasInFlight) {
  RtlOptions options;
  options.stalls.result = {.open_per_256 = 16, .block_log2 = 4};
  const auto engine = tiny_engine(options);
  engine->submit(std::vector<Word>{fences(1, 1)[0], nop(100), 1, 2, 3});
  engine->reset();
  EXPECT_EQ(engine->cycle(), 0u);
  EXPECT_EQ(engine->counters().events.at("COMMANDS"), 0u);
  EXPECT_EQ(run(*engine, fences(7, 2)), expected_fences(7, 2));
}

TEST(RtlEngine, WatchdogNamesTheStateOfAHang) {
  RtlOptions options;
  options.defines = {"TINY_HANGS"};
  options.hang_cycles = 5000;
  const auto engine = tiny_engine(options);
  try {
    run(*engine, fences(0, 10));
    FAIL() << "the hang went unnoticed";
  } catch (const HangError& error) {
    EXPECT_THAT(error.what(), HasSubstr("no word moved for 5000 cycles"));
    EXPECT_THAT(error.what(), HasSubstr("3 words taken, 7 waiting"));
    EXPECT_THAT(error.what(), HasSubstr("idle=1"));
  }
}

TEST(RtlEngine, WatchdogWaitsForPortsThatAreRarelyOpen) {
  RtlOptions options;
  options.stalls = {.command = {8, 8}, .result = {8, 8}, .seed = 3};
  const auto engine = tiny_engine(options);
  EXPECT_EQ(run(*engine, fences(0, 20)), expected_fences(0, 20));
}

TEST(RtlEngine, FailedAssertionStopsWithItsTextInsteadOfAborting) {
  RtlOptions options;
  options.defines = {"TINY_ASSERTS"};
  options.assertions = true;
  const auto engine = tiny_engine(options);
  EXPECT_EQ(run(*engine, fences(0, 4)), expected_fences(0, 4));
  try {
    run(*engine, fences(4, 4));
    FAIL() << "the assertion went unnoticed";
  } catch (const RtlFault& error) {
    EXPECT_THAT(error.what(), HasSubstr("tiny_never_five"));
  }
}

TEST(RtlEngine, AssertionsAreOffUnlessAskedFor) {
  RtlOptions options;
  options.defines = {"TINY_ASSERTS"};
  EXPECT_EQ(run(*tiny_engine(options), fences(0, 20)), expected_fences(0, 20));
}

TEST(RtlEngine, CycleLimitStops) {
  RtlOptions options;
  options.max_cycles = 100;
  const auto engine = tiny_engine(options);
  EXPECT_THROW(run(*engine, fences(0, 1000)), CycleLimit);
  EXPECT_EQ(engine->cycle(), 100u);
}

TEST(RtlEngine, ProgressIsReportedAndRises) {
  std::vector<Progress> reports;
  RtlOptions options;
  options.slice = 100;
  options.progress = [&](const Progress& progress) { reports.push_back(progress); };
  run(*tiny_engine(options), fences(0, 1000));
  ASSERT_GT(reports.size(), 5u);
  for (std::size_t i = 1; i < reports.size(); ++i) EXPECT_GE(reports[i].words, reports[i - 1].words);
  EXPECT_EQ(reports.back().words, 1000u);
  EXPECT_EQ(reports.back().results, 1000u);
}

TEST(RtlEngine, InterruptStopsTheRun) {
  const InterruptFlag interrupt;
  RtlOptions options;
  options.slice = 100;
  options.abort = &interrupt.flag();
  options.progress = [](const Progress& progress) {
    if (progress.cycles == 300) std::raise(SIGINT);
  };
  const auto engine = tiny_engine(options);
  EXPECT_THROW(run(*engine, fences(0, 1000)), Aborted);
  EXPECT_EQ(engine->cycle(), 400u);
}

TEST(RtlEngine, RefusesIllegalConfigurationsBeforeBuilding) {
  ModelCache cache(tiny_tools());
  EXPECT_THROW(make_rtl_engine({.plane_log2 = 13}, {}, cache), std::invalid_argument);
  EXPECT_EQ(cache.built(), 0);
}

TEST(RtlEngine, CoverageNeedsAModelThatCounts) {
  const TemporaryFolder folder;
  EXPECT_THROW(tiny_engine()->write_coverage(folder.path() / "coverage.dat"), std::logic_error);
  RtlOptions options;
  options.coverage = true;
  const auto engine = tiny_engine(options);
  run(*engine, fences(0, 3));
  engine->write_coverage(folder.path() / "coverage.dat");
  EXPECT_GT(std::filesystem::file_size(folder.path() / "coverage.dat"), 100u);
}

}  // namespace
}  // namespace gnomon::sim::test
