// SPDX-License-Identifier: Apache-2.0
// gnomon_core with topology mode against the golden engine: all commands of the projection unit mixed,
// errors, sticky flags and counters, waiting on all ports, a reset in the middle.
#include <gtest/gtest.h>

#include <gnomon/golden/codec.hpp>
#include <gnomon/golden/golden_engine.hpp>
#include <string>

#include "Vtop_default.h"
#include "Vtopology_top.h"
#include "sim/counter_names.hpp"
#include "tests/rtl/stream_bench.hpp"
#include "tests/rtl/topology/program_stream.hpp"

namespace gnomon::rtl_test {
namespace {

using golden::HardwareConfig;

HardwareConfig top_config() {
  return {.voxel_bits = 5,
          .voxel_frac_bits = 1,
          .depth_bits = 16,
          .plane_log2 = 5,
          .en_vpu_topology = true,
          .sub_bits = 3,
          .span_log2 = 3,
          .nodes_log2 = 9,
          .quads_log2 = 7};
}

struct Answer {
  std::vector<Word> words;
  golden::Counters counters;
};
Answer golden_answer(const HardwareConfig& config, std::span<const Word> words) {
  const auto engine = golden::make_golden_engine(config);
  Answer answer;
  engine->submit(words);
  engine->drain(
      [&](std::span<const Word> some) { answer.words.insert(answer.words.end(), some.begin(), some.end()); });
  answer.counters = engine->counters();
  return answer;
}

TEST(TopologyTop, AnswersRandomStreamsAsGolden) {
  constexpr std::array<Stalls, 3> kStalls = {Stalls{}, Stalls{60, 256}, Stalls{256, 70}};
  std::size_t compared = 0;
  std::uint64_t errors = 0, hits = 0, dropped = 0;
  for (std::uint64_t seed = 0; seed < 15; ++seed) {
    const std::vector<Word> words =
        topology::program_stream(top_config(), {.seed = seed, .doubtful_percent = 30});
    const Answer expected = golden_answer(top_config(), words);
    StreamBench<Vtopology_top> bench(static_cast<std::uint32_t>(seed));
    if (seed % 2 == 1) bench.run_then_reset(words, kStalls[seed % 3], 300 * seed);
    const std::vector<Word> results = bench.run(words, kStalls[seed % 3]);
    ASSERT_EQ(results.size(), expected.words.size()) << "seed " << seed;
    for (std::size_t i = 0; i < results.size(); ++i, ++compared) {
      ASSERT_EQ(results[i], expected.words[i])
          << "seed " << seed << " result " << i << "\n  rtl    " << golden::describe_result(results[i])
          << "\n  golden " << golden::describe_result(expected.words[i]);
    }
    const auto event = [&](std::string_view name) { return expected.counters.events.at(std::string(name)); };
    for (unsigned i = 0; i < sim::kEventNames.size(); ++i)
      EXPECT_EQ(bench.counter(i), event(sim::kEventNames[i])) << sim::kEventNames[i];
    for (unsigned i = 0; i < sim::kTopologyEventNames.size(); ++i)
      EXPECT_EQ(bench.counter(sim::kFirstTopologyCounter + i), event(sim::kTopologyEventNames[i]))
          << sim::kTopologyEventNames[i];
    std::uint64_t cycles = 0;
    for (std::size_t pass = 0; pass < sim::kPassNames.size(); ++pass)
      for (std::size_t cause = 0; cause < sim::kCauseNames.size(); ++cause)
        cycles += bench.counter(sim::cycle_counter_index(pass, cause));
    EXPECT_EQ(cycles, bench.cycles());
    errors += event("ERRORS");
    hits += event("TOPOLOGY_HIT");
    dropped += event("NODES_DROPPED");
  }
  EXPECT_GT(compared, 15u * 1024u);
  EXPECT_GT(errors, 30u);
  EXPECT_GT(hits, 20u);
  EXPECT_GT(dropped, 0u);
}

TEST(TopologyTop, HardwareWithoutTheModeAnswersError2) {
  std::vector<Word> words;
  for (std::uint8_t op = 0x12; op <= 0x15; ++op) {
    words.push_back(encode(golden::Header{.op = op, .count = 4}));
    words.insert(words.end(), 4, Word{0});
  }
  StreamBench<Vtop_default> bench(1);
  const std::vector<Word> results = bench.run(words);
  EXPECT_EQ(results, golden_answer({}, words).words);
  ASSERT_EQ(results.size(), 4u);
  EXPECT_EQ(results[0] >> 48, 0xFF02u);
}

}  // namespace
}  // namespace gnomon::rtl_test
