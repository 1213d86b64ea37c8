// SPDX-License-Identifier: Apache-2.0
// gnomon_core with the perspective projection and both modes against golden: every word and counter, ports
// held back, a reset in the middle; cycles.
#include <gtest/gtest.h>

#include <gnomon/golden/codec.hpp>
#include <map>

#include "Vperspective_slow.h"
#include "Vperspective_top.h"
#include "sim/counter_names.hpp"
#include "tests/rtl/perspective/projection_streams.hpp"
#include "tests/rtl/stream_bench.hpp"
#include "tests/support/perspective_registers.hpp"
#include "tests/support/voxel_patterns.hpp"

namespace gnomon::rtl_test {
namespace {

using golden::Header;
using golden::Op;

template <class Model>
class PerspectiveTop : public testing::Test {};
using Builds = testing::Types<Vperspective_top, Vperspective_slow>;
TYPED_TEST_SUITE(PerspectiveTop, Builds);

TYPED_TEST(PerspectiveTop, AnswersAsGoldenInBothProjections) {
  constexpr std::array<Stalls, 4> kStalls = {Stalls{}, Stalls{60, 256}, Stalls{256, 70}, Stalls{150, 150}};
  std::size_t compared = 0;
  std::uint32_t seed = 0;
  std::map<std::string, std::uint64_t> total;
  for (const ProjectionCase& one : projection_cases(10)) {
    StreamBench<TypeParam> bench(++seed);
    if (seed % 3 == 0) bench.run_then_reset(one.words, kStalls[seed % 4], 97 * seed);
    const std::vector<Word> results = bench.run(one.words, kStalls[seed % 4]);
    ASSERT_EQ(results.size(), one.results.size()) << one.name;
    for (std::size_t i = 0; i < results.size(); ++i, ++compared) {
      ASSERT_EQ(results[i], one.results[i])
          << one.name << " result " << i << "\n  rtl    " << golden::describe_result(results[i])
          << "\n  golden " << golden::describe_result(one.results[i]);
    }
    const auto indices = event_indices();
    for (std::size_t i = 0; i < indices.size(); ++i) {
      EXPECT_EQ(bench.counter(indices[i].first), one.events[i]) << one.name << " " << indices[i].second;
      total[indices[i].second] += one.events[i];
    }
  }
  EXPECT_GT(compared, 20'000u);
  for (const auto name : sim::kPerspectiveEventNames) EXPECT_GT(total.at(std::string(name)), 50u) << name;
  EXPECT_GT(total.at("RESOLVED_UNCERTAIN"), 100u);
  EXPECT_GT(total.at("TOPOLOGY_HIT"), 20u);
}

/// As many voxels as fit into a command, all in front of the light.
std::vector<Word> items(Op op, std::span<const golden::VoxelItem> voxels) {
  std::vector<Word> words{encode(
      Header{.op = static_cast<std::uint8_t>(op), .count = static_cast<std::uint16_t>(voxels.size())})};
  for (const golden::VoxelItem& voxel : voxels) words.push_back(encode(voxel, perspective_build()));
  return words;
}

TEST(PerspectiveThroughput, AVoxelACycleAndEightStagesMore) {
  const golden::HardwareConfig config = perspective_build();
  stimulus::Random random(3);
  const stimulus::AllRegisters registers = stimulus::perspective_registers(config, random);
  std::vector<Word> words{
      encode(Header{.op = static_cast<std::uint8_t>(Op::SetRegisters), .count = golden::kAllRegisterCount})};
  for (const std::int64_t value : registers) words.push_back(static_cast<Word>(value));
  const auto voxels = stimulus::voxel_pattern(stimulus::Pattern::Sheet, 2000,
                                              stimulus::pattern_registers(registers, config), config, random);
  for (const Op op : {Op::ProjectVoxels, Op::ResolveVoxels}) {
    const std::vector<Word> command = items(op, voxels);
    words.insert(words.end(), command.begin(), command.end());
  }
  StreamBench<Vperspective_top> bench(1);
  EXPECT_EQ(bench.run(words).size(), voxels.size());
  const auto cycles = [&](std::size_t pass, std::size_t cause) {
    return bench.counter(sim::cycle_counter_index(pass, cause));
  };
  EXPECT_EQ(cycles(3, 0), voxels.size() + 1);  // PROJECT, BUSY: the items and the header
  EXPECT_EQ(cycles(4, 0), voxels.size() + 1);
  EXPECT_EQ(cycles(3, 3) + cycles(4, 3), 0u);  // MEMORY_WAIT
  EXPECT_EQ(cycles(4, 2), 0u);                 // OUTPUT_BLOCKED
  EXPECT_GE(cycles(3, 4), 5u + 8u);            // HAZARD: the drain between the passes
  EXPECT_LE(cycles(3, 4), 6u + 8u);
  EXPECT_EQ(cycles(4, 1), 13u + 8u);  // INPUT_STARVED: the drain at the end
}

}  // namespace
}  // namespace gnomon::rtl_test
