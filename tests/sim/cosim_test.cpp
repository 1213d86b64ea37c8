// SPDX-License-Identifier: Apache-2.0
// The hardware gives the words that golden gives: directed and random streams, ports held back, resets,
// power-up content.
#include "tests/sim/cosim.hpp"

#include <gtest/gtest.h>

#include <gnomon/golden/golden_engine.hpp>
#include <set>

#include "tests/sim/tiny_model.hpp"

namespace gnomon::sim::test {
namespace {

/// Small enough that a reset is quick, large enough for every pattern.
golden::HardwareConfig small_plane() {
  golden::HardwareConfig config;
  config.plane_log2 = 6;
  return config;
}

TEST(Cosim, DirectedStreamsOnTheDefaultHardware) {
  Cosim cosim({});
  std::uint64_t words = 0;
  for (const stimulus::DirectedStream& stream : stimulus::directed_streams({})) {
    const CompareReport report = cosim.run(stream.words);
    EXPECT_TRUE(report.passed()) << stream.name << "\n" << to_text(report);
    words += report.words_compared;
  }
  EXPECT_GT(words, 10'000u);
}

class StalledCosim : public testing::TestWithParam<int> {};

TEST_P(StalledCosim, DirectedAndRandomStreams) {
  RtlOptions options = Cosim::checked();
  options.stalls = stall_profile(GetParam(), 77 + static_cast<std::uint64_t>(GetParam()));
  Cosim cosim(small_plane(), options);
  std::vector<stimulus::DirectedStream> streams = stimulus::directed_streams(small_plane());
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    streams.push_back(random_case(small_plane(), 1000 * static_cast<std::uint64_t>(GetParam()) + seed, 300));
  }
  std::uint64_t words = 0;
  for (const stimulus::DirectedStream& stream : streams) {
    const CompareReport report = cosim.run(stream.words);
    EXPECT_TRUE(report.passed()) << stream.name << "\n" << to_text(report);
    words += report.words_compared;
  }
  EXPECT_GT(words, 10'000u);
}

INSTANTIATE_TEST_SUITE_P(Ports, StalledCosim, testing::Range(0, kStallProfiles));

struct Memory {
  int latency, stall_seed;
};

class MemoryCosim : public testing::TestWithParam<Memory> {};

/// No unit may depend on when the plane answers.
TEST_P(MemoryCosim, LatencyAndStallsOfThePlaneChangeNoWord) {
  RtlOptions options = Cosim::checked();
  options.memory_latency = GetParam().latency;
  options.memory_stall_seed = GetParam().stall_seed;
  options.stalls = stall_profile(3, 5);
  Cosim cosim(small_plane(), options);
  std::vector<stimulus::DirectedStream> streams = stimulus::directed_streams(small_plane());
  for (std::uint64_t seed = 1; seed <= 10; ++seed) streams.push_back(random_case(small_plane(), seed, 300));
  for (const stimulus::DirectedStream& stream : streams) {
    const CompareReport report = cosim.run(stream.words);
    EXPECT_TRUE(report.passed()) << stream.name << "\n" << to_text(report);
  }
}

INSTANTIATE_TEST_SUITE_P(Plane, MemoryCosim,
                         testing::Values(Memory{1, 4711}, Memory{3, 0}, Memory{7, 99}, Memory{64, 0}),
                         [](const auto& test) {
                           return "latency_" + std::to_string(test.param.latency) + "_stalls_" +
                                  std::to_string(test.param.stall_seed);
                         });

TEST(Cosim, ResetInTheMiddleOfAnything) {
  RtlOptions options = Cosim::checked();
  options.stalls = stall_profile(4, 9);
  Cosim cosim(small_plane(), options);
  const std::vector<Word> before = random_case(small_plane(), 50, 100).words;
  const std::vector<Word> after = random_case(small_plane(), 51, 60).words;
  for (std::size_t cut = 3; cut < before.size(); cut += 1 + before.size() / 25) {
    cosim.rtl().reset();
    cosim.rtl().submit(std::span(before).first(cut));  // returns with the pipelines full
    const CompareReport report = cosim.run(after);     // resets
    EXPECT_TRUE(report.passed()) << "reset after " << cut << " words\n" << to_text(report);
    EXPECT_GT(report.words_compared, 100u);
  }
}

TEST(Cosim, NeitherWordsNorCyclesDependOnThePowerUpContent) {
  const std::vector<Word> stream = random_case(small_plane(), 60, 200).words;
  std::vector<std::uint64_t> cycles;
  for (const std::uint32_t seed : {1u, 2u, 3u, 0u, 0xFFFFFFFFu}) {
    RtlOptions options = Cosim::checked();
    options.seed = seed;
    Cosim cosim(small_plane(), options);
    const CompareReport report = cosim.run(stream);
    EXPECT_TRUE(report.passed()) << to_text(report);
    cycles.push_back(report.cycles);
  }
  EXPECT_EQ(cycles, std::vector<std::uint64_t>(cycles.size(), cycles.front()));
}

TEST(Cosim, PiecesOfAStreamGiveTheSameWordsAndCycles) {
  Cosim cosim(small_plane());
  const std::vector<Word> stream = random_case(small_plane(), 70, 200).words;
  const std::vector<Word> whole = run(cosim.rtl(), stream);
  const std::uint64_t cycles = cosim.rtl().cycle();
  cosim.rtl().reset();
  std::size_t piece = 1;
  for (std::size_t offset = 0; offset < stream.size(); piece = piece % 97 + 1) {
    const std::size_t count = std::min(piece, stream.size() - offset);
    cosim.rtl().submit(std::span(stream).subspan(offset, count));
    offset += count;
  }
  EXPECT_EQ(run(cosim.rtl(), {}), whole);
  EXPECT_EQ(cosim.rtl().cycle(), cycles);
}

TEST(Cosim, DrainInTheMiddleOfEveryKindOfCommand) {
  Cosim cosim(small_plane());
  const std::vector<Word> stream = random_case(small_plane(), 71, 60).words;
  for (std::size_t offset = 0; offset < stream.size(); offset += 5) {
    const auto piece = std::span(stream).subspan(offset, std::min<std::size_t>(5, stream.size() - offset));
    ASSERT_EQ(run(cosim.rtl(), piece), run(cosim.golden(), piece)) << "at word " << offset;
    ASSERT_EQ(cosim.rtl().counters().events, cosim.golden().counters().events) << "at word " << offset;
  }
  EXPECT_EQ(cosim.rtl().read_plane(), cosim.golden().read_plane());
}

TEST(Cosim, StickyFlagsAtTheCounterPort) {
  Cosim cosim(small_plane());
  std::set<std::uint64_t> seen;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    std::vector<Word> stream = random_case(small_plane(), seed, 12).words;
    EXPECT_TRUE(cosim.run(stream).passed());
    const std::uint64_t flags = cosim.rtl().sticky();
    const std::vector<Word> answer = run(cosim.rtl(), fences(1, 1));
    ASSERT_EQ(answer.size(), 1u);
    EXPECT_EQ(golden::decode_fence_result(answer[0]).sticky, flags);
    seen.insert(flags);
  }
  EXPECT_GE(seen.size(), 3u);
}

/// Verilator's rewriting of bit operations has had faults; a model without it must agree.
TEST(Cosim, PlainBitOperationsGiveTheSameWordsAndCycles) {
  const std::vector<Word> stream = random_case({}, 80, 400).words;
  Cosim optimised({});
  RtlOptions plain = Cosim::checked();
  plain.plain_bit_operations = true;
  Cosim unoptimised({}, plain);
  const CompareReport first = optimised.run(stream), second = unoptimised.run(stream);
  EXPECT_TRUE(first.passed()) << to_text(first);
  EXPECT_TRUE(second.passed()) << to_text(second);
  EXPECT_EQ(first.cycles, second.cycles);
  EXPECT_EQ(first.rtl_counters.cycles, second.rtl_counters.cycles);
}

}  // namespace
}  // namespace gnomon::sim::test
