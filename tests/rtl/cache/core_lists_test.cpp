// SPDX-License-Identifier: Apache-2.0
// gnomon_core with plane, list heads, nodes and quad records in memory against the golden engine: offset and
// topology mode, lights of both kinds.
#include <gtest/gtest.h>

#include <array>
#include <gnomon/golden/codec.hpp>
#include <vector>

#include "Vcache_core_lists.h"
#include "core_cache_bench.hpp"
#include "sim/counter_names.hpp"
#include "tests/rtl/perspective/projection_streams.hpp"

namespace gnomon::rtl_test {
namespace {

TEST(CoreLists, AnswersAsGoldenInBothModes) {
  const std::array<LineTiming, 3> tempers{
      LineTiming{.latency = 1},
      LineTiming{.latency = 20, .spread = 30},
      LineTiming{.latency = 100, .spread = 50, .cycles_per_line = 8, .open_per_256 = 100},
  };
  const auto indices = event_indices();
  std::size_t compared = 0;
  std::array<std::uint64_t, sim::kCacheMemoryNames.size()> fills{}, misses{};
  std::uint32_t seed = 0;
  for (const ProjectionCase& one : projection_cases(8)) {
    ++seed;
    CoreCacheBench<Vcache_core_lists> bench(tempers[seed % tempers.size()], seed);
    if (seed % 3 == 0) bench.run_then_reset(one.words, std::uint64_t{97} * seed);
    const std::vector<Word> results = bench.run(one.words);
    ASSERT_EQ(bench.memory().broken(), "") << one.name;
    ASSERT_EQ(results.size(), one.results.size()) << one.name;
    for (std::size_t i = 0; i < results.size(); ++i, ++compared) {
      ASSERT_EQ(results[i], one.results[i])
          << one.name << " result " << i << "\n  rtl    " << golden::describe_result(results[i])
          << "\n  golden " << golden::describe_result(one.results[i]);
    }
    for (std::size_t i = 0; i < indices.size(); ++i)
      EXPECT_EQ(bench.counter(indices[i].first), one.events[i]) << one.name << " " << indices[i].second;
    for (unsigned memory = 0; memory < fills.size(); ++memory) {
      fills[memory] += bench.counter(sim::cache_counter_index(memory, sim::CacheEvent::Fills));
      misses[memory] += bench.counter(sim::cache_counter_index(memory, sim::CacheEvent::Misses));
    }
  }
  EXPECT_GT(compared, 15'000u);
  // Plane and quad records fit into their caches.
  for (const unsigned memory : {3u, 4u}) EXPECT_GT(fills[memory], 20u) << sim::kCacheMemoryNames[memory];
  EXPECT_GT(misses[5], 20u);
}

}  // namespace
}  // namespace gnomon::rtl_test
