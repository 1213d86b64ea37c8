// SPDX-License-Identifier: Apache-2.0
// gnomon_core with its planes in memory against the golden engine: the same words and the same event
// counters, whatever the memory is like, and every cycle accounted for.
#include <gtest/gtest.h>

#include <gnomon/golden/codec.hpp>
#include <gnomon/golden/golden_engine.hpp>
#include <string>
#include <vector>

#include "Vcache_core.h"
#include "Vcache_core_small.h"
#include "core_cache_bench.hpp"
#include "sim/counter_names.hpp"
#include "tests/rtl/slb/slb_streams.hpp"
#include "tests/support/stimulus.hpp"

namespace gnomon::rtl_test {
namespace {

using golden::HardwareConfig;

/// Parameters as in CMakeLists.txt.
template <class Model>
HardwareConfig config_of() {
  HardwareConfig config;
  config.en_slb = true;
  config.plane_log2 = 6;
  config.slb_plane_log2 = 6;
  if (std::is_same_v<Model, Vcache_core_small>) {
    config.plane_log2 = 4;
    config.slb_plane_log2 = 3;
    config.frac_bits = config.slope_bits = 4;
    config.frags_per_pixel = 1;
    config.subpixel_bits = config.query_bits = 7;
    config.depth_bits = 8;
  }
  return config;
}

const std::vector<LineTiming> kTempers{
    {.latency = 1},
    {.latency = 20, .spread = 30},
    {.latency = 100, .spread = 50, .cycles_per_line = 8, .open_per_256 = 100},
};

template <class Model>
class CoreCache : public testing::Test {
 protected:
  void compare(const std::string& name, std::span<const Word> words, std::uint32_t seed,
               std::uint64_t reset_after = 0) {
    const auto golden = golden::make_golden_engine(config_of<Model>());
    std::vector<Word> expected;
    golden->submit(words);
    golden->drain(
        [&](std::span<const Word> some) { expected.insert(expected.end(), some.begin(), some.end()); });

    CoreCacheBench<Model> bench(kTempers[seed % kTempers.size()], seed);
    if (reset_after > 0) bench.run_then_reset(words, reset_after);
    const std::vector<Word> results = bench.run(words);
    bench.rest(1'000);
    ASSERT_EQ(bench.memory().broken(), "") << name << " seed " << seed;
    ASSERT_EQ(results.size(), expected.size()) << name << " seed " << seed;
    for (std::size_t i = 0; i < expected.size(); ++i, ++compared_) {
      ASSERT_EQ(results[i], expected[i])
          << name << " seed " << seed << " result " << i << "\n  rtl    "
          << golden::describe_result(results[i]) << "\n  golden " << golden::describe_result(expected[i]);
    }
    const auto events = golden->counters().events;
    for (unsigned i = 0; i < sim::kEventNames.size(); ++i)
      EXPECT_EQ(bench.counter(i), events.at(std::string(sim::kEventNames[i]))) << sim::kEventNames[i];
    for (unsigned i = 0; i < sim::kSlbEventNames.size(); ++i) {
      EXPECT_EQ(bench.counter(sim::kFirstSlbCounter + i), events.at(std::string(sim::kSlbEventNames[i])))
          << sim::kSlbEventNames[i];
    }
    std::uint64_t cycles = 0;
    for (std::size_t pass = 0; pass < sim::kPassNames.size(); ++pass) {
      for (std::size_t cause = 0; cause < sim::kCauseNames.size(); ++cause)
        cycles += bench.counter(sim::cycle_counter_index(pass, cause));
    }
    EXPECT_EQ(cycles, bench.cycles()) << name;
    std::uint64_t fills = 0, write_backs = 0;
    for (unsigned memory = 0; memory < sim::kCacheMemoryNames.size(); ++memory) {
      fills += bench.counter(sim::cache_counter_index(memory, sim::CacheEvent::Fills));
      write_backs += bench.counter(sim::cache_counter_index(memory, sim::CacheEvent::WriteBacks));
      misses_ += bench.counter(sim::cache_counter_index(memory, sim::CacheEvent::Misses));
    }
    if (reset_after == 0) {
      EXPECT_EQ(fills, bench.memory().traffic().reads);
      EXPECT_EQ(write_backs, bench.memory().traffic().writes);
    }
    fills_ += fills;
    write_backs_ += write_backs;
  }

  std::size_t compared_ = 0;
  std::uint64_t misses_ = 0, fills_ = 0, write_backs_ = 0;
};
using Builds = testing::Types<Vcache_core, Vcache_core_small>;
TYPED_TEST_SUITE(CoreCache, Builds);

TYPED_TEST(CoreCache, AnswersAsGolden) {
  const HardwareConfig config = config_of<TypeParam>();
  for (std::uint32_t seed = 1; seed <= 6; ++seed) {
    this->compare("random", stimulus::random_stream(config, {.seed = seed, .commands = 150}), seed);
    this->compare("random objects", random_slb_stream(seed, config), seed);
    if (this->HasFatalFailure()) return;
  }
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    this->compare("crowded", crowded_slb_stream(seed, config), seed);
    this->compare("wide", wide_slb_stream(seed, config), seed);
    if (this->HasFatalFailure()) return;
  }
  for (const stimulus::DirectedStream& stream : stimulus::directed_streams(config)) {
    this->compare(stream.name, stream.words, 2);
    if (this->HasFatalFailure()) return;
  }
  EXPECT_GT(this->compared_, 10'000u);
  EXPECT_GT(this->misses_, 500u);
  if (config.plane_log2 == 6) {  // the other planes fit into their caches
    EXPECT_GT(this->fills_, 1000u);
    EXPECT_GT(this->write_backs_, 1000u);
  }
}

TYPED_TEST(CoreCache, StartsAnewAfterAReset) {
  const HardwareConfig config = config_of<TypeParam>();
  for (std::uint32_t seed = 1; seed <= 6; ++seed) {
    this->compare("random", stimulus::random_stream(config, {.seed = seed, .commands = 60}), seed,
                  700 + 333 * seed);
    this->compare("random objects", random_slb_stream(seed, config), seed, 900 + 444 * seed);
    if (this->HasFatalFailure()) return;
  }
  EXPECT_GT(this->compared_, 1000u);
}

}  // namespace
}  // namespace gnomon::rtl_test
