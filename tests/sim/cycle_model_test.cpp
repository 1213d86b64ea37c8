// SPDX-License-Identifier: Apache-2.0
// The predicted cycles against the counters of the RTL: every pass and every cause, on random and directed
// streams (docs/cycle-model.md).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <gnomon/golden/cycles.hpp>
#include <map>
#include <ostream>
#include <set>
#include <string>

#include "tests/sim/cosim.hpp"
#include "tests/support/frame_stream.hpp"

namespace gnomon::sim::test {
namespace {

using golden::HardwareConfig;
using golden::HardwareTiming;

/// A build, what its memories and dividers are like, and how it is compiled.
struct Build {
  const char* name;
  HardwareConfig config;
  HardwareTiming timing;
  bool quick;
  std::set<std::string> passes;  ///< that its streams have
};

void PrintTo(const Build& build, std::ostream* out) {
  *out << build.name;
}

const std::set<std::string> kVoxelPasses{"CONTROL", "CLEAR", "PROJECT", "RESOLVE", "READ"};
const std::set<std::string> kAllPasses{"CONTROL", "CLEAR", "PROJECT", "RESOLVE", "READ",
                                       "DRAW",    "FILL",  "COVER",   "QUERY"};

/// Those of other tests, and one with all units, slow memories and a single divider.
const Build kBuilds[] = {
    {"offset", {.plane_log2 = 6}, {}, false, kVoxelPasses},
    {"slb", {.en_slb = true}, {}, false, kAllPasses},
    {"frame",
     {.voxel_bits = 5,
      .voxel_frac_bits = 3,
      .depth_bits = 16,
      .plane_log2 = 4,
      .en_vpu_topology = true,
      .nodes_log2 = 10,
      .quads_log2 = 8,
      .en_frame_buffer = true,
      .frame_layers_log2 = 1},
     {},
     true,
     kVoxelPasses},
    {"everything",
     {.voxel_bits = 5,
      .depth_bits = 12,
      .plane_log2 = 4,
      .en_perspective = true,
      .en_vpu_topology = true,
      .nodes_log2 = 8,
      .quads_log2 = 6,
      .en_frame_buffer = true,
      .en_slb = true,
      .slb_plane_log2 = 5,
      .frac_bits = 4,
      .slope_bits = 4,
      .frags_per_pixel = 1},
     {.memory_latency = 3, .slb_dividers = 1},
     true,
     kAllPasses},
};

std::unique_ptr<RtlEngine> engine_of(const Build& build) {
  RtlOptions options = Cosim::checked();
  options.memory_latency = build.timing.memory_latency;
  options.slb_dividers = build.timing.slb_dividers;
  options.quick_build = build.quick;
  return make_rtl_engine(build.config, options);
}

using Cycles = std::map<std::string, std::uint64_t>;

/// IDLE tells how long the bench waited with the next word; nobody predicts that.
bool predicted(const std::string& cell) {
  return !cell.starts_with("cycles.IDLE.");
}

Cycles measure(RtlEngine& rtl, std::span<const Word> words) {
  rtl.reset();
  rtl.submit(words);
  rtl.drain([](std::span<const Word>) {});
  return rtl.counters().cycles;
}

/// "cycles.PROJECT.BUSY: 5 measured, 6 predicted" for each cell that differs.
std::vector<std::string> differences(const Cycles& measured, const Cycles& predictions) {
  std::vector<std::string> lines;
  for (const auto& [cell, count] : measured) {
    const auto found = predictions.find(cell);
    if (!predicted(cell) || (found != predictions.end() && found->second == count)) continue;
    lines.push_back(cell + ": " + std::to_string(count) + " measured, " +
                    (found == predictions.end() ? "nothing" : std::to_string(found->second)) + " predicted");
  }
  return lines;
}

std::vector<stimulus::DirectedStream> streams_for(const HardwareConfig& config) {
  std::vector<stimulus::DirectedStream> streams = stimulus::directed_streams(config);
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    streams.push_back(random_case(config, seed, 120));
    if (config.en_frame_buffer)
      streams.push_back(
          {"frame buffer, seed " + std::to_string(seed), stimulus::frame_stream(config, seed, 120)});
  }
  return streams;
}

class CycleModel : public testing::TestWithParam<Build> {};

TEST_P(CycleModel, IsExact) {
  const Build& build = GetParam();
  const auto rtl = engine_of(build);
  std::size_t cells = 0;
  std::set<std::string> passes;
  for (const stimulus::DirectedStream& stream : streams_for(build.config)) {
    const Cycles measured = measure(*rtl, stream.words);
    const Cycles predictions = golden::predict_cycles(build.config, build.timing, stream.words).named();
    EXPECT_THAT(differences(measured, predictions), testing::IsEmpty()) << stream.name;
    for (const auto& [cell, count] : measured) {
      if (!predicted(cell) || count == 0) continue;
      ++cells;
      passes.insert(cell.substr(7, cell.rfind('.') - 7));
    }
  }
  EXPECT_EQ(passes, build.passes);
  EXPECT_GT(cells, 100u);
}

INSTANTIATE_TEST_SUITE_P(Builds, CycleModel, testing::ValuesIn(kBuilds),
                         [](const auto& build) { return std::string(build.param.name); });

/// A model that is off by one anywhere, or of other hardware, is noticed.
TEST(CycleModels, AreChecked) {
  const Build& build = kBuilds[0];
  const auto rtl = engine_of(build);
  const std::vector<Word> words = random_case(build.config, 1, 120).words;
  const Cycles measured = measure(*rtl, words);
  const golden::CycleTable table = golden::predict_cycles(build.config, build.timing, words);
  ASSERT_THAT(differences(measured, table.named()), testing::IsEmpty());
  std::size_t altered = 0;
  for (std::size_t pass = 1; pass < golden::kPasses; ++pass) {
    for (std::size_t cause = 0; cause < golden::kCauses; ++cause) {
      golden::CycleTable other = table;
      ++other.at(static_cast<golden::Pass>(pass), static_cast<golden::Cause>(cause));
      EXPECT_THAT(differences(measured, other.named()), testing::SizeIs(1));
      ++altered;
    }
  }
  EXPECT_EQ(altered, 54u);
  EXPECT_THAT(differences(measured, {}), testing::SizeIs(54));

  const HardwareTiming slower{.memory_latency = 2};
  const auto late = differences(measured, golden::predict_cycles(build.config, slower, words).named());
  for (const char* pass : {"PROJECT", "RESOLVE", "READ"})
    EXPECT_THAT(late, testing::Contains(testing::StartsWith(std::string("cycles.") + pass)));
}

}  // namespace
}  // namespace gnomon::sim::test
