// SPDX-License-Identifier: Apache-2.0
// Rows, banks and the data bus, cycle by cycle from docs/system-model.md.
#include "sim/system/dram_timing.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace gnomon::sim::system::test {
namespace {

constexpr DramConfig kConfig{
    .banks = 4, .row_bytes = 1024, .t_rcd = 3, .t_rp = 5, .t_cas = 2, .bytes_per_cycle = 8, .latency = 10};

TEST(DramTiming, AnEmptyBankAHitAndAConflict) {
  DramTiming dram(kConfig);
  EXPECT_EQ(dram.access(100, 0, 64, false), 100u + 3 + 2 + 8 + 10);
  EXPECT_EQ(dram.access(200, 64, 64, false), 200u + 2 + 8 + 10);
  EXPECT_EQ(dram.access(300, std::uint64_t{4} * 1024, 64, true), 300u + 5 + 3 + 2 + 8 + 10)
      << "the next row of the same bank";
  EXPECT_EQ(dram.access(400, 1024, 8, false), 400u + 3 + 2 + 1 + 10) << "another bank";
  EXPECT_EQ(dram.access(500, 4 * 1024 + 8, 1, false), 500u + 2 + 1 + 10) << "left open";
  EXPECT_EQ(dram.statistics(), (DramStatistics{4, 1, 64 * 3 + 8 + 1, 2, 2, 1, 26}));
}

TEST(DramTiming, OneDataBusForAllBanks) {
  DramTiming dram(kConfig);
  EXPECT_EQ(dram.access(0, 0, 64, false), 3u + 2 + 8 + 10);
  EXPECT_EQ(dram.access(0, 1024, 64, false), 3u + 2 + 8 + 8 + 10)
      << "opens its row meanwhile, waits for the bus";
  EXPECT_EQ(dram.access(0, 64, 64, false), 3u + 2 + 8 + 8 + 8 + 10);
}

TEST(DramTiming, AStreamOfHitsRunsAtTheBusRate) {
  DramTiming dram(kConfig);
  std::uint64_t last = dram.access(0, 0, 64, false);
  for (std::uint64_t i = 1; i < 16; ++i) {
    const std::uint64_t done = dram.access(0, i * 64, 64, false);
    EXPECT_EQ(done - last, 8u);
    last = done;
  }
}

TEST(DramTiming, CutsAtTheEndOfARow) {
  DramTiming dram(kConfig);
  // 32 bytes of bank 0, then 32 of bank 1, which has opened its row meanwhile.
  EXPECT_EQ(dram.access(0, 1024 - 32, 64, false), 3u + 2 + 4 + 4 + 10);
  EXPECT_EQ(dram.statistics().rows_opened, 2u);
  EXPECT_EQ(dram.statistics().reads, 1u);
}

TEST(DramTiming, RefusesToBeNothing) {
  for (const DramConfig& config :
       {DramConfig{.banks = 0}, DramConfig{.row_bytes = 0}, DramConfig{.bytes_per_cycle = 0}})
    EXPECT_THROW(DramTiming{config}, std::invalid_argument);
}

}  // namespace
}  // namespace gnomon::sim::system::test
