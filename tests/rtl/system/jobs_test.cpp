// SPDX-License-Identifier: Apache-2.0
// Jobs through the rings of gnomon_top, behind memories of all kinds: results, counts, completions and
// counters are golden's.
#include "jobs.hpp"

#include <gtest/gtest.h>

#include <gnomon/golden/codec.hpp>

#include "Vsystem_cached.h"
#include "Vsystem_narrow.h"
#include "Vsystem_wide.h"
#include "sim/counter_names.hpp"

namespace gnomon::rtl_test {
namespace {

struct Situation {
  const char* name;
  MemoryTiming timing;
  Rings rings;
};

std::vector<Situation> situations() {
  return {{"quick", {1, 1, 256, false}, {}},
          {"latency 100", {100, 100, 256, false}, {}},
          {"random and reordered", {1, 80, 256, true}, {}},
          {"held back", {1, 20, 90, true}, {}},
          {"small result ring", {1, 30, 200, true}, {.command_log2 = 4, .result_log2 = 6}}};
}

template <class Model>
class SystemJobs : public testing::Test {};
using Builds = testing::Types<Vsystem_narrow, Vsystem_wide, Vsystem_cached>;
template <class Model>
constexpr golden::HardwareConfig kConfigOf = std::is_same_v<Model, Vsystem_cached> ? kCached : kSmall;
TYPED_TEST_SUITE(SystemJobs, Builds);

TYPED_TEST(SystemJobs, AnswersAsGolden) {
  std::size_t compared = 0;
  std::uint32_t seed = 1;
  for (const Situation& situation : situations()) {
    SCOPED_TRACE(situation.name);
    TopBench<TypeParam> bench(seed);
    bench.memory().set_timing(situation.timing);
    bench.start(situation.rings, 0x10000, seed * 1000);  // the ring begins anywhere
    Reference reference(kConfigOf<TypeParam>);
    for (std::uint16_t job = 0; job < 12; ++job, ++seed) {
      const std::vector<Word> words = random_job(kConfigOf<TypeParam>, seed, 20),
                              expected = reference.run(words);
      std::vector<Word> results;
      const std::uint32_t place = bench.submit(words, job, 1 + seed % 3, seed * 37 % 512);
      ASSERT_TRUE(bench.wait(results)) << "job " << job << " does not end";
      ASSERT_FALSE(bench.asserted());
      ASSERT_FALSE(bench.stopped()) << bench.read(hw::kErrorStatusOffset);
      bench.take_results(results);
      ASSERT_EQ(results, expected) << "job " << job;
      compared += results.size();
      const Completion completion = bench.completion(place);
      EXPECT_EQ(completion.state, 0x8003);
      EXPECT_EQ(completion.job, job);
      EXPECT_EQ(completion.errors, error_words(expected));
      EXPECT_EQ(completion.flags, bench.read(hw::kJobFlagsOffset));
      EXPECT_EQ(completion.flags & 1u, completion.errors != 0 ? 1u : 0u);
      EXPECT_EQ(completion.results, bench.read(hw::kResultHeadOffset));
      EXPECT_EQ(bench.read(hw::kJobsDoneOffset), job + 1u);
      EXPECT_EQ(bench.read(hw::kCommandTailOffset), bench.head());
      EXPECT_EQ(bench.read(hw::kStatusOffset), hw::kStatusIdleMask);
    }
    // Counters: the events are golden's, the cycles of one snapshot sum to the cycles since reset.
    const auto golden = reference.counters();
    bench.write(hw::kSnapshotOffset, 1);
    for (unsigned i = 0; i < sim::kEventNames.size(); ++i)
      EXPECT_EQ(bench.counter(i), golden.events.at(std::string(sim::kEventNames[i]))) << sim::kEventNames[i];
    std::uint64_t total = 0;
    constexpr std::size_t kCells = sim::kPassNames.size() * sim::kCauseNames.size();
    for (unsigned cell = 0; cell < kCells; ++cell) total += bench.counter(sim::kFirstCycleCounter + cell);
    const std::uint64_t now = bench.cycles();
    EXPECT_LT(total, now);
    bench.write(hw::kSnapshotOffset, 1);
    std::uint64_t later = 0;
    for (unsigned cell = 0; cell < kCells; ++cell) later += bench.counter(sim::kFirstCycleCounter + cell);
    EXPECT_GE(later - total, kCells * 2 * 3);  // as the reads above took
    EXPECT_LE(later, bench.cycles());
  }
  EXPECT_GT(compared, 5'000u);
}

TYPED_TEST(SystemJobs, StreamPortsAnswerAsGolden) {
  TopBench<TypeParam> bench(7);
  Reference reference(kConfigOf<TypeParam>);
  auto& model = bench.model();
  bench.run(5);
  EXPECT_EQ(model.s_axis_tready_o, 0);
  bench.write(hw::kPlaneBaseLowOffset, static_cast<std::uint32_t>(Rings{}.base));
  bench.write(hw::kControlOffset, hw::kControlEnableMask | hw::kControlSourceMask);
  std::mt19937 random(7);
  std::size_t compared = 0;
  for (std::uint64_t seed = 100; seed < 110; ++seed) {
    const std::vector<Word> words = random_job(kConfigOf<TypeParam>, seed, 20),
                            expected = reference.run(words);
    std::vector<Word> results;
    std::size_t given = 0;
    for (unsigned quiet = 0; quiet < 3000; ++quiet) {
      if (!model.s_axis_tvalid_i && given < words.size()) {
        model.s_axis_tvalid_i = random() % 4 != 0;
        model.s_axis_tdata_i = words[given];
      }
      model.m_axis_tready_i = random() % 4 != 0;
      model.clk_i = 0;
      model.eval();
      const bool taken = model.s_axis_tvalid_i && model.s_axis_tready_o;
      if (model.m_axis_tvalid_o && model.m_axis_tready_i) {
        results.push_back(model.m_axis_tdata_o);
        quiet = 0;
      }
      bench.clock();
      if (!taken) continue;
      ++given;
      model.s_axis_tvalid_i = 0;
      quiet = 0;
    }
    ASSERT_EQ(given, words.size());
    ASSERT_EQ(results, expected) << seed;
    compared += results.size();
  }
  EXPECT_GT(compared, 1'000u);
  EXPECT_FALSE(bench.asserted());
  EXPECT_EQ(bench.memory().beats() != 0, (std::is_same_v<TypeParam, Vsystem_cached>));
}

/// With 100 and with 200 cycles of latency words arrive and results leave at nearly one a cycle.
TEST(SystemThroughput, HidesALatencyOfTwoHundredCycles) {
  const golden::HardwareConfig config = kSmall;
  std::vector<Word> words;
  for (int command = 0; command < 8; ++command) {
    words.push_back(
        golden::encode(golden::Header{static_cast<std::uint8_t>(golden::Op::ResolveVoxels), 0, 500, 0}));
    for (std::uint32_t i = 0; i < 500; ++i)
      words.push_back(golden::encode(golden::VoxelItem{{i % 16, i / 16, 5}, {0, 0, -100}}, config));
  }
  const auto cycles = [&](unsigned latency) {
    TopBench<Vsystem_narrow> bench(3);
    bench.memory().set_timing({latency, latency, 256, false});
    bench.start({.command_log2 = 4, .result_log2 = 13}, 0x10000);
    bench.run(2000);  // the clear after reset
    const std::uint64_t before = bench.cycles();
    std::vector<Word> results;
    bench.submit(words, 1, 1);
    EXPECT_TRUE(bench.wait(results));
    EXPECT_EQ(results.size(), 4000u);
    return bench.cycles() - before;
  };
  const std::uint64_t near = cycles(1), far = cycles(100), farther = cycles(200);
  RecordProperty("cycles_latency_1", static_cast<int>(near));
  RecordProperty("cycles_latency_100", static_cast<int>(far));
  RecordProperty("cycles_latency_200", static_cast<int>(farther));
  EXPECT_LT(near, 4400u);
  // Once each: descriptor, first words, last results, completion.
  EXPECT_LT(far, near + 5ULL * 100);
  EXPECT_LT(farther, near + 5ULL * 200);
}

}  // namespace
}  // namespace gnomon::rtl_test
