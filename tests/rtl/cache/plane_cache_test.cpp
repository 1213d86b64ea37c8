// SPDX-License-Identifier: Apache-2.0
// The plane behind its cache against an array: with memories of all tempers, with traffic that hits, misses,
// and sweeps, over clears and resets. Then how much of a memory's latency it hides; then seeded faults, which
// must be noticed.
#include <gtest/gtest.h>

#include <memory>
#include <string_view>

#include "Vplane_cache.h"
#include "Vplane_cache_faulty.h"
#include "Vplane_cache_large.h"
#include "plane_cache_bench.hpp"
#include "tests/support/seeded_faults.hpp"

namespace gnomon::rtl_test {
namespace {

constexpr std::uint32_t kEntries = 1u << 12;       // 64 x 64: 256 lines, behind a cache of 16
constexpr std::uint32_t kLargeEntries = 1u << 16;  // 256 x 256: 4,096 lines, behind one of 64

using Indices = std::function<std::uint32_t(std::mt19937&)>;

/// Few entries of few lines that share their sets: updates of the same words, lines that come and go.
std::uint32_t crowded(std::mt19937& random) {
  const auto bits = static_cast<std::uint32_t>(random());
  const std::uint32_t u = ((bits >> 4) & 1u) * 32 + (bits & 1u);
  const std::uint32_t v = ((bits >> 5) & 3u) * 16 + ((bits >> 1) & 1u);
  return v * 64 + u;
}
std::uint32_t anywhere(std::mt19937& random) {
  return static_cast<std::uint32_t>(random()) % kEntries;
}
/// Steps of one entry, as a surface makes them: nearly all hits.
Indices walk(std::uint32_t side) {
  auto place = std::make_shared<std::array<std::uint32_t, 2>>();
  return [place, side](std::mt19937& random) {
    const auto bits = static_cast<std::uint32_t>(random());
    if ((bits & 1023u) == 0) {
      (*place)[0] = static_cast<std::uint32_t>(random()) % side;
      (*place)[1] = static_cast<std::uint32_t>(random()) % side;
    }
    (*place)[(bits >> 10) & 1u] += ((bits >> 11) & 3u) == 0 ? side - 1 : 1;
    return ((*place)[1] % side) * side + (*place)[0] % side;
  };
}

const std::vector<LineTiming> kTempers{
    {.latency = 1},
    {.latency = 20, .spread = 30},
    {.latency = 5, .spread = 200, .open_per_256 = 60},
    {.latency = 100, .spread = 10, .cycles_per_line = 8, .open_per_256 = 200},
};

/// Passes as the units make them, mixed traffic besides, clears between; for all tempers of memory.
template <class Bench>
void run_all_traffic(Bench& bench, std::uint64_t cycles) {
  for (const Indices& index : {Indices(crowded), Indices(anywhere), walk(64)}) {
    for (int pass = 0; pass < 3; ++pass) {
      bench.run({.update = 256, .index = index}, cycles);
      bench.run({.read0 = 256, .read1 = 256, .index = index}, cycles);
      bench.run({.update = 60, .read0 = 100, .read1 = 80, .take = 150, .index = index}, cycles);
      bench.run({.read0 = 200, .read1 = 20, .take = 90, .index = index}, cycles / 2);
      if (pass == 1) bench.clear();
    }
    bench.run({.read0 = 256, .read1 = 256, .index = index}, cycles);
    bench.clear();
  }
}

TEST(PlaneCache, AnswersAsAnArrayWithMemoriesOfAllTempers) {
  std::uint64_t compared = 0;
  std::array<std::uint64_t, 6> events{};
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    for (const LineTiming& temper : kTempers) {
      PlaneCacheBench<Vplane_cache> bench(kEntries, temper, seed);
      run_all_traffic(bench, 1500);
      const PlaneOutcome& outcome = bench.outcome();
      ASSERT_FALSE(outcome.hung) << "seed " << seed << " latency " << temper.latency;
      ASSERT_EQ(outcome.wrong, 0u) << "seed " << seed << " latency " << temper.latency;
      ASSERT_EQ(bench.memory().broken(), "") << "seed " << seed << " latency " << temper.latency;
      EXPECT_EQ(outcome.events[3], bench.memory().traffic().reads);
      EXPECT_EQ(outcome.events[4], bench.memory().traffic().writes);
      compared += outcome.compared;
      for (std::size_t i = 0; i < events.size(); ++i) events[i] += outcome.events[i];
    }
  }
  EXPECT_GT(compared, 100'000u);
  for (const std::uint64_t count : events) EXPECT_GT(count, 5'000u);  // each kind of event was under test
}

TEST(PlaneCache, ReadsNothingThatItHasNotWritten) {
  PlaneCacheBench<Vplane_cache> bench(kEntries, {.latency = 20}, 5);
  for (int clears = 0; clears < 300; ++clears) {  // more than a round of generations
    bench.run({.update = 256, .index = anywhere}, 30);
    bench.clear();
  }
  const std::uint64_t reads = bench.memory().traffic().reads;
  bench.run({.read0 = 256, .read1 = 256, .index = anywhere}, 2000);
  EXPECT_EQ(bench.memory().traffic().reads, reads) << "after a clear no line is worth reading";
  EXPECT_EQ(bench.memory().broken(), "");
  EXPECT_EQ(bench.outcome().wrong, 0u);
  EXPECT_GT(bench.outcome().compared, 1000u);
}

TEST(PlaneCache, ResetInUseEmptiesIt) {
  PlaneCacheBench<Vplane_cache> bench(kEntries, {.latency = 50, .spread = 20}, 6);
  for (int round = 0; round < 20; ++round) {
    bench.run({.update = 256, .index = anywhere}, 200);
    bench.run({.update = 128, .read0 = 128, .read1 = 128, .index = anywhere}, 300);
    bench.reset();
  }
  bench.run({.read0 = 256, .read1 = 256, .index = anywhere}, 2000);
  EXPECT_FALSE(bench.outcome().hung);
  EXPECT_EQ(bench.outcome().wrong, 0u);
  EXPECT_EQ(bench.memory().broken(), "");
}

/// Patches of a surface, voxel by voxel and row by row: where they lie is random, their size is not.
Indices patches(std::uint32_t side) {
  auto place = std::make_shared<std::array<std::uint32_t, 3>>();  // corner, number of the voxel
  return [place, side](std::mt19937& random) {
    auto& [u, v, number] = *place;
    if (number++ % 576 == 0) {
      u = static_cast<std::uint32_t>(random()) % side;
      v = static_cast<std::uint32_t>(random()) % side;
    }
    return ((v + number / 24 % 24) % side) * side + (u + number % 24) % side;
  };
}

/// Cycles that `traffic` takes against the least it can: a request a cycle, and sixteen fills under way at
/// most, of a memory and a bus as fast as `timing` says.
double over_the_bound(const LineTiming& timing, PlaneTraffic traffic) {
  PlaneCacheBench<Vplane_cache_large> bench(kLargeEntries, timing, 9);
  traffic.index = patches(256);
  bench.run({.update = 256, .index = patches(256)}, 60'000);
  const PlaneOutcome before = bench.outcome();
  bench.run(traffic, 30'000);
  const PlaneOutcome& after = bench.outcome();
  EXPECT_FALSE(after.hung);
  EXPECT_EQ(after.wrong, 0u);
  EXPECT_EQ(bench.memory().broken(), "");
  const auto counted = [&](std::size_t event) {
    return static_cast<double>(after.events[event] - before.events[event]);
  };
  const double requests = counted(0) + counted(2);
  const double a_line = std::max((timing.latency + 6) / 16.0, static_cast<double>(timing.cycles_per_line));
  return static_cast<double>(after.cycles - before.cycles) /
         std::max({requests, counted(3) * a_line, counted(4) * a_line});
}

TEST(PlaneCache, IsAsFastAsSixteenLinesUnderWayAllow) {
  const PlaneTraffic project{.update = 256, .index = {}};
  const PlaneTraffic resolve{.read0 = 256, .read1 = 256, .index = {}};
  for (const std::uint32_t latency : {20u, 100u}) {
    const LineTiming timing{.latency = latency, .cycles_per_line = 8};
    EXPECT_LT(over_the_bound(timing, project), 1.15) << latency;
    EXPECT_LT(over_the_bound(timing, resolve), 1.15) << latency;
  }
}

TEST(PlaneCache, TakesAnUpdateACycleOfOneEntry) {
  PlaneCacheBench<Vplane_cache> bench(kEntries, {.latency = 200}, 1);
  bench.run({.update = 256, .index = [](std::mt19937&) { return 7u; }}, 3000);
  EXPECT_EQ(bench.outcome().wrong, 0u);
  EXPECT_GE(bench.outcome().events[0], 2990u);
}

TEST(PlaneCache, SeededFaultsAreNoticed) {
  int noticed = 0;
  for (const std::string_view fault : stimulus::kCacheFaults) {
    bool seen = false;
    for (const LineTiming& temper : kTempers) {
      PlaneCacheBench<Vplane_cache_faulty> bench(kEntries, temper, 1, std::string(fault));
      run_all_traffic(bench, 1500);
      const PlaneOutcome& outcome = bench.outcome();
      seen = seen || outcome.wrong > 0 || outcome.hung || !bench.memory().broken().empty();
    }
    EXPECT_TRUE(seen) << fault;
    noticed += seen ? 1 : 0;
  }
  EXPECT_EQ(noticed, static_cast<int>(stimulus::kCacheFaults.size()));
  PlaneCacheBench<Vplane_cache_faulty> bench(kEntries, kTempers[1], 1);
  run_all_traffic(bench, 1500);
  EXPECT_EQ(bench.outcome().wrong, 0u) << "without a fault";
  EXPECT_EQ(bench.memory().broken(), "") << "without a fault";
}

}  // namespace
}  // namespace gnomon::rtl_test
