// SPDX-License-Identifier: Apache-2.0
// The hardware with the perspective projection gives the words and counts that golden gives: both modes and
// projections mixed, ports and memories held back, the states kept in a frame buffer as well.
#include <gtest/gtest.h>

#include <map>

#include "tests/sim/cosim.hpp"
#include "tests/support/frame_stream.hpp"

namespace gnomon::sim::test {
namespace {

/// Both modes and the frame buffer behind them, small memories.
const golden::HardwareConfig kPerspective{.voxel_bits = 5,
                                          .voxel_frac_bits = 2,
                                          .depth_bits = 18,
                                          .plane_log2 = 5,
                                          .en_perspective = true,
                                          .en_vpu_topology = true,
                                          .nodes_log2 = 10,
                                          .quads_log2 = 8,
                                          .en_frame_buffer = true};

std::vector<stimulus::DirectedStream> streams(std::uint64_t seed) {
  std::vector<stimulus::DirectedStream> all = stimulus::directed_streams(kPerspective);
  for (std::uint64_t i = 0; i < 4; ++i) all.push_back(random_case(kPerspective, 10 * seed + i, 250));
  all.push_back({"frame buffer", stimulus::frame_stream(kPerspective, seed, 120)});
  return all;
}

/// Words compared; what the perspective projection met is added to `met`.
std::uint64_t expect_equal(Cosim& cosim, std::uint64_t seed, std::map<std::string, std::uint64_t>& met) {
  std::uint64_t words = 0;
  for (const stimulus::DirectedStream& stream : streams(seed)) {
    const CompareReport report = cosim.run(stream.words);
    EXPECT_TRUE(report.passed()) << stream.name << "\n" << to_text(report);
    words += report.words_compared;
    for (const auto& [name, count] : report.rtl_counters.events) met[name] += count;
  }
  return words;
}

TEST(PerspectiveCosim, PortsHeldBackInEveryWay) {
  RtlOptions options = Cosim::checked();
  options.quick_build = true;
  std::map<std::string, std::uint64_t> met;
  std::uint64_t words = 0;
  for (int kind = 0; kind < kStallProfiles; ++kind) {
    options.stalls = stall_profile(kind, 31 + static_cast<std::uint64_t>(kind));
    Cosim cosim(kPerspective, options);
    words += expect_equal(cosim, 1 + static_cast<std::uint64_t>(kind), met);
  }
  EXPECT_GT(words, 40'000u);
  for (const char* name :
       {"PROJECT_BEHIND", "RESOLVED_BEHIND", "RESOLVED_OUTSIDE_CONE", "QUADS_BEHIND", "QUADS_STRADDLING",
        "TOPOLOGY_BEHIND", "TOPOLOGY_OUTSIDE_CONE", "TOPOLOGY_HIT", "RESOLVED_UNCERTAIN", "FRAME_KEPT"}) {
    EXPECT_GT(met[name], 10u) << name;
  }
}

TEST(PerspectiveCosim, LatencyAndStallsOfTheMemoriesChangeNoWord) {
  RtlOptions options = Cosim::checked();
  options.quick_build = true;
  options.memory_latency = 7;
  options.memory_stall_seed = 99;
  options.stalls = stall_profile(3, 5);
  Cosim cosim(kPerspective, options);
  std::map<std::string, std::uint64_t> met;
  EXPECT_GT(expect_equal(cosim, 20, met), 7'000u);
}

TEST(PerspectiveCosim, ResetInTheMiddleOfAnything) {
  RtlOptions options = Cosim::checked();
  options.quick_build = true;
  options.stalls = stall_profile(4, 9);
  Cosim cosim(kPerspective, options);
  const std::vector<Word> before = random_case(kPerspective, 50, 100).words;
  const std::vector<Word> after = random_case(kPerspective, 51, 60).words;
  for (std::size_t cut = 3; cut < before.size(); cut += 1 + before.size() / 15) {
    cosim.rtl().reset();
    cosim.rtl().submit(std::span(before).first(cut));  // returns with the pipelines full
    const CompareReport report = cosim.run(after);     // resets
    EXPECT_TRUE(report.passed()) << "reset after " << cut << " words\n" << to_text(report);
    EXPECT_GT(report.words_compared, 100u);
  }
}

}  // namespace
}  // namespace gnomon::sim::test
