// SPDX-License-Identifier: Apache-2.0
// What stands behind the bus in the cycle model, part by part, against numbers worked out by hand from
// docs/cycle-model.md, docs/cache.md and docs/system-model.md.
#include <gtest/gtest.h>

#include <gnomon/golden/command.hpp>
#include <gnomon/golden/cycles.hpp>

#include "golden/cycles/dram.hpp"
#include "golden/cycles/line_cache.hpp"
#include "golden/cycles/plane_read.hpp"
#include "golden/cycles/ports.hpp"

namespace gnomon::golden::cycles {
namespace {

TEST(DramClock, OpensRowsAndSharesItsDataBus) {
  constexpr std::uint64_t kRow = 2048;
  DramClock dram({.latency = 10});
  // Bus 2, row 2, column 2, a word 1, latency 10.
  EXPECT_EQ(dram.access(0, 0, 8), 17u);
  EXPECT_EQ(dram.access(100, 64, 64), 100u + 2 + 2 + 8 + 10);            // its row is open
  EXPECT_EQ(dram.access(200, 8 * kRow, 8), 200u + 2 + 4 + 2 + 1 + 10);   // another row of the bank is
  EXPECT_EQ(dram.access(300, kRow, 512), 300u + 2 + 2 + 2 + 64 + 10);    // another bank
  EXPECT_EQ(dram.access(301, 8 * kRow, 8), 380u + 1);                    // waits for the data bus
  EXPECT_EQ(dram.access(400, 2 * kRow - 8, 16), 400u + 2 + 4 + 1 + 10);  // in two rows, the second one closed
}

/// 4 KiB over 256 lines: 32 sets; eight lines may be under way.
class Cache : public testing::Test {
 protected:
  void step(Cycle cycles = 1) {
    for (Cycle i = 0; i < cycles; ++i) cache_.end_cycle(now_++);
  }
  bool look_up(std::uint32_t line, bool writes = false) {
    const bool taken = cache_.look_up({.line = line, .writes = writes}, now_).first;
    step();
    return taken;
  }
  /// Cycles until it can be served, which it is.
  Cycle serve() {
    const Cycle before = now_;
    while (!cache_.ready(now_) && now_ < before + 50) step();
    if (cache_.ready(now_)) cache_.serve(now_);
    const Cycle waited = now_ - before;
    step();
    return waited;
  }
  CacheClock cache_{12, 8, 0, 3};
  Cycle now_ = 0;
};

TEST_F(Cache, ServesHitsAfterThreeCyclesAndEmptyLinesAfterFour) {
  EXPECT_TRUE(look_up(5));
  EXPECT_EQ(serve(), 3u) << "looked up in cycle 0, served in 4";
  EXPECT_TRUE(look_up(5));
  EXPECT_EQ(serve(), 2u);
  EXPECT_TRUE(cache_.fetches().empty());
}

TEST_F(Cache, WritesBackWhatWasWrittenAndFetchesItAgain) {
  EXPECT_TRUE(look_up(1, true));
  EXPECT_TRUE(look_up(1 + 32));
  EXPECT_TRUE(look_up(1 + 64, true)) << "in the place of 1, the less recently used";
  EXPECT_TRUE(look_up(1 + 32));
  for (int i = 0; i < 4; ++i) serve();
  ASSERT_EQ(cache_.backs().size(), 1u);
  EXPECT_EQ(cache_.backs().front().line, 1u);
  EXPECT_FALSE(look_up(1)) << "it is on its way out";
  const std::uint32_t victim = cache_.backs().front().number;
  cache_.back_taken();
  cache_.written(victim, now_);
  step();
  EXPECT_FALSE(look_up(1));
  EXPECT_TRUE(look_up(1));
  step(2);
  ASSERT_EQ(cache_.fetches().size(), 1u) << "memory has it now";
  EXPECT_EQ(cache_.fetches().front().line, 1u);
  EXPECT_FALSE(cache_.ready(now_ + 30));
  const std::uint32_t fill = cache_.fetches().front().number;
  cache_.fetch_taken();
  cache_.came(fill, now_);
  step();
  EXPECT_TRUE(cache_.ready(now_));
}

TEST_F(Cache, TwoReadsGoTogetherWhereBothHit) {
  look_up(2);
  look_up(3);
  serve();
  serve();
  const auto both = cache_.look_up({.line = 2, .beside_line = 3, .beside = true}, now_);
  EXPECT_TRUE(both.first);
  EXPECT_TRUE(both.beside);
  const auto one = cache_.look_up({.line = 2, .beside_line = 9, .beside = true}, now_);
  EXPECT_TRUE(one.first);
  EXPECT_FALSE(one.beside);
}

TEST_F(Cache, RemembersSixteenMisses) {
  for (std::uint32_t line = 0; line < 16; ++line) EXPECT_TRUE(look_up(line));
  EXPECT_FALSE(look_up(16));
  EXPECT_TRUE(look_up(3)) << "hits go on";
  serve();
  EXPECT_TRUE(look_up(16));
}

TEST_F(Cache, ForgetsAllWhenNothingIsOnItsWay) {
  look_up(7, true);
  EXPECT_FALSE(cache_.can_be_cleared(now_));
  serve();
  step(2);
  ASSERT_TRUE(cache_.can_be_cleared(now_));
  cache_.clear();
  look_up(7 + 32);
  look_up(7 + 64);
  look_up(7 + 96);
  for (int i = 0; i < 3; ++i) serve();
  EXPECT_TRUE(cache_.backs().empty()) << "what was written before the clear is gone";
}

TEST(PlaneLines, AreTilesInMortonOrder) {
  EXPECT_EQ(line_of_entry(3, 3), 0u);
  EXPECT_EQ(line_of_entry(4, 0), 1u);
  EXPECT_EQ(line_of_entry(0, 4), 2u);
  EXPECT_EQ(line_of_entry(12, 8), 0b1101u);
}

TEST(Ports, BringAWordACycleAfterTheFirstBurst) {
  Ports ports({.plane_log2 = 5}, {});
  ports.commands().expect(200);
  std::uint64_t words = 0;
  Cycle first = 0;
  for (; words < 200 && ports.now() < 1'000;) {
    const bool takes = ports.word();
    if (takes && words == 0) first = ports.now();
    words += takes ? 1 : 0;
    ports.cycle(takes, false, false);
  }
  // Granted in 0, its address in 1; bus 2, the job table's row closed and this one opened 4, column 2, 64
  // words, latency 20: its last beat is in 93, its first in 30, which is seen two cycles later.
  EXPECT_EQ(first, 32u);
  EXPECT_EQ(ports.now(), 32u + 200) << "bursts follow each other";
  EXPECT_TRUE(ports.commands().over());
}

TEST(Ports, HoldResultsBackWhenThirtyTwoWritesAreUnderWay) {
  Ports ports({.plane_log2 = 5}, {.latency = 2'000});
  std::uint64_t given = 0;
  while (ports.now() < 1'000) {
    const bool gives = ports.room();
    given += gives ? 1 : 0;
    ports.cycle(false, gives, false);
  }
  // 32 lines on their way, one gathered, and two words in the register and its spare.
  EXPECT_EQ(given, 33u * 8 + 2);
}

TEST(Ports, WaitForSoftwareWhenTheRingIsFull) {
  Ports ports({.plane_log2 = 5}, {});
  std::uint64_t given = 0;
  while (given < ResultDma::kRingWords + 100 && ports.now() < 100'000) {
    const bool gives = ports.room();
    given += gives ? 1 : 0;
    ports.cycle(false, gives, false);
  }
  EXPECT_GT(ports.now(), ResultDma::kRingWords + 100 + 620);
  EXPECT_LT(ports.now(), ResultDma::kRingWords + 100 + 700);
}

TEST(SystemTiming, SaysWhatIsWrong) {
  EXPECT_FALSE(SystemTiming{}.check());
  EXPECT_EQ(SystemTiming{.cache_log2 = 11}.check(), "CACHE_LOG2 = 11 is neither 0 nor in 12..16");
  EXPECT_EQ(SystemTiming{.line_ids_log2 = 6}.check(), "LINE_IDS_LOG2 = 6 is not in 3..5");
  EXPECT_EQ(SystemTiming{.axi_data_bits = 96}.check(), "AXI_DATA_BITS = 96 is none of 64, 128, 256, 512");
  EXPECT_EQ(SystemTiming{.banks = 0}.check(), "DRAM without banks, rows or data bus");
  const HardwareTiming timing{.system = SystemTiming{.cache_log2 = 11}};
  EXPECT_THROW(make_timed_golden_engine({}, timing), std::invalid_argument);
}

}  // namespace
}  // namespace gnomon::golden::cycles
