// SPDX-License-Identifier: Apache-2.0
// gnomon_core against the golden engine: builds with a fast plane, with a slow and stalling one, and without
// the resolve pass; then its throughput and its account of cycles. Co-simulation at length is in tests/sim.
#include <gtest/gtest.h>

#include <gnomon/golden/codec.hpp>
#include <gnomon/golden/golden_engine.hpp>
#include <string>
#include <vector>

#include "Vtop_default.h"
#include "Vtop_no_offset.h"
#include "Vtop_slow_plane.h"
#include "sim/counter_names.hpp"
#include "stream_bench.hpp"
#include "tests/support/stimulus.hpp"

namespace gnomon::rtl_test {
namespace {

using golden::HardwareConfig;
using golden::Header;
using golden::Op;

template <class Model>
HardwareConfig config_of() {
  HardwareConfig config;
  config.en_vpu_offset = !std::is_same_v<Model, Vtop_no_offset>;
  return config;
}

std::uint64_t cycle_total(auto& bench) {
  std::uint64_t total = 0;
  constexpr std::size_t kCells = sim::kPassNames.size() * sim::kCauseNames.size();
  for (unsigned cell = 0; cell < kCells; ++cell) total += bench.counter(sim::kFirstCycleCounter + cell);
  return total;
}

template <class Model>
class Top : public testing::Test {
 protected:
  /// Runs both and counts the words compared; the first difference is shown in words.
  void compare(const std::string& name, std::span<const Word> words, Stalls stalls, std::uint32_t seed,
               std::uint64_t reset_after = 0) {
    const auto golden = golden::make_golden_engine(config_of<Model>());
    std::vector<Word> expected;
    golden->submit(words);
    golden->drain(
        [&](std::span<const Word> some) { expected.insert(expected.end(), some.begin(), some.end()); });

    StreamBench<Model> bench(seed);
    if (reset_after > 0) bench.run_then_reset(words, stalls, reset_after);
    const std::vector<Word> results = bench.run(words, stalls);
    ASSERT_EQ(results.size(), expected.size()) << name << " seed " << seed;
    for (std::size_t i = 0; i < expected.size(); ++i, ++compared_) {
      ASSERT_EQ(results[i], expected[i])
          << name << " seed " << seed << " result " << i << "\n  rtl    "
          << golden::describe_result(results[i]) << "\n  golden " << golden::describe_result(expected[i]);
    }
    const auto counters = golden->counters();
    for (unsigned i = 0; i < sim::kEventNames.size(); ++i) {
      const std::string event(sim::kEventNames[i]);
      EXPECT_EQ(bench.counter(i), counters.events.at(event)) << name << " seed " << seed << " " << event;
    }
    EXPECT_EQ(cycle_total(bench), bench.cycles()) << name;
  }

  std::size_t compared_ = 0;
};
using Tops = testing::Types<Vtop_default, Vtop_slow_plane, Vtop_no_offset>;
TYPED_TEST_SUITE(Top, Tops);

TYPED_TEST(Top, AnswersDirectedStreamsAsGolden) {
  for (const auto& stream : stimulus::directed_streams(config_of<TypeParam>())) {
    this->compare(stream.name, stream.words, {}, 1);
    this->compare(stream.name, stream.words, {.command_open = 100, .result_open = 120}, 2);
  }
  EXPECT_GT(this->compared_, 2'000u);
}

TYPED_TEST(Top, AnswersRandomStreamsAsGolden) {
  const Stalls stalls[] = {{}, {256, 100}, {100, 256}, {200, 30}};
  for (std::uint32_t seed = 1; seed <= 12; ++seed) {
    this->compare("random", stimulus::random_stream(config_of<TypeParam>(), {.seed = seed}), stalls[seed % 4],
                  seed);
  }
  EXPECT_GT(this->compared_, 1'000u);
}

TYPED_TEST(Top, RecoversFromResetInTheMiddle) {
  for (std::uint32_t seed = 1; seed <= 12; ++seed) {
    this->compare("reset", stimulus::random_stream(config_of<TypeParam>(), {.seed = seed}), {200, 200}, seed,
                  seed * 1777);  // some during the scrub, some during items, clears and blocked results
  }
  EXPECT_GT(this->compared_, 1'000u);
}

/// `count` voxels, all of the same entry, as one command.
std::vector<Word> voxels(Op op, std::uint16_t count) {
  const HardwareConfig config;
  std::vector<Word> words{encode(Header{static_cast<std::uint8_t>(op), 0, count, 0})};
  for (std::uint32_t i = 0; i < count; ++i) {
    words.push_back(encode(golden::VoxelItem{{1, 1, count - i}, {0, 0, -100}}, config));
  }
  return words;
}

/// The depth row's z coefficient one code an ulp: the voxels above become nearer one after the other.
std::vector<Word> depth_registers() {
  const HardwareConfig config;
  return {encode(Header{static_cast<std::uint8_t>(Op::SetRegisters), 0, 1, 10}),
          Word{1} << (config.position_bits() + 4)};
}

void append(std::vector<Word>& words, const std::vector<Word>& more) {
  words.insert(words.end(), more.begin(), more.end());
}

TEST(TopThroughput, OneVoxelACycleInBothPassesOnOneEntry) {
  constexpr std::uint16_t kVoxels = 1000;
  std::vector<Word> words = depth_registers();
  for (int i = 0; i < 2; ++i) append(words, voxels(Op::ProjectVoxels, kVoxels));
  for (int i = 0; i < 2; ++i) append(words, voxels(Op::ResolveVoxels, kVoxels));
  StreamBench<Vtop_default> bench(1);
  EXPECT_EQ(bench.run(words).size(), 2u * kVoxels);

  const auto cycles = [&](std::size_t pass, std::size_t cause) {
    return bench.counter(sim::cycle_counter_index(pass, cause));
  };
  for (const std::size_t pass :
       {3u, 4u}) {  // PROJECT, RESOLVE: items and two headers, nothing else held them
    EXPECT_EQ(cycles(pass, 0), 2u * kVoxels + 2);  // BUSY
    EXPECT_EQ(cycles(pass, 2), 0u);                // OUTPUT_BLOCKED
    EXPECT_EQ(cycles(pass, 3), 0u);                // MEMORY_WAIT
  }
  EXPECT_EQ(cycles(3, 4), 5u);           // HAZARD: the drain between the passes; its last voxel wrote nothing
  EXPECT_EQ(cycles(4, 1), 13u);          // INPUT_STARVED: the drain at the end
  EXPECT_EQ(bench.counter(5), kVoxels);  // PLANE_WRITES: each voxel of the first command was nearer
}

TEST(TopThroughput, ADrainAfterAWriteTakesACycleMore) {
  std::vector<Word> words = depth_registers();
  append(words, voxels(Op::ProjectVoxels, 10));
  append(words, voxels(Op::ResolveVoxels, 10));
  StreamBench<Vtop_default> bench(1);
  bench.run(words);
  EXPECT_EQ(bench.counter(sim::cycle_counter_index(3, 4)), 6u);  // PROJECT, HAZARD
}

TEST(TopThroughput, OneEntryACycleWhenReadBack) {
  StreamBench<Vtop_default> bench(1);
  const std::vector<Word> words{encode(Header{static_cast<std::uint8_t>(Op::ReadPlane), 0, 0, 255u << 24})};
  EXPECT_EQ(bench.run(words).size(), 256u);
  EXPECT_LE(bench.counter(sim::cycle_counter_index(5, 0)), 256u + 6u);  // READ, BUSY
}

TEST(TopThroughput, AClearCostsAScrubbedSlice) {
  StreamBench<Vtop_default> bench(1);
  bench.run({});
  const std::uint64_t after_reset = bench.counter(sim::cycle_counter_index(2, 0));
  EXPECT_EQ(after_reset, 512u * 512u / 16u);
  const std::vector<Word> words(10, encode(Header{static_cast<std::uint8_t>(Op::ClearPlane), 0, 0, 0}));
  bench.run(words);
  const std::uint64_t a_clear = 2 + (512 * 512 / 16 + 254) / 255;  // header, step of the generation, lines
  EXPECT_EQ(bench.counter(sim::cycle_counter_index(2, 0)) - after_reset, 10 * a_clear);
}

TEST(TopCounters, BlameTheRightCause) {
  std::vector<Word> words = depth_registers();
  append(words, voxels(Op::ResolveVoxels, 1000));
  const auto blamed = [&](Stalls stalls, std::size_t cause) {
    StreamBench<Vtop_default> bench(1);
    bench.run(words, stalls);
    return bench.counter(sim::cycle_counter_index(4, cause));
  };
  EXPECT_GT(blamed({.command_open = 64}, 1), 2000u);  // INPUT_STARVED: three quarters of the time
  EXPECT_GT(blamed({.result_open = 64}, 2), 2000u);   // OUTPUT_BLOCKED
  StreamBench<Vtop_slow_plane> slow(1);
  slow.run(words);
  EXPECT_GT(slow.counter(sim::cycle_counter_index(4, 3)), 500u);  // MEMORY_WAIT
}

}  // namespace
}  // namespace gnomon::rtl_test
