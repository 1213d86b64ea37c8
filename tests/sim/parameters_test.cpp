// SPDX-License-Identifier: Apache-2.0
// Every pair of parameter values, against golden; and both sides refuse the same builds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/sim/cosim.hpp"
#include "tests/support/covering.hpp"

namespace gnomon::sim::test {
namespace {

/// Hardware and how much is spent on making its model fast.
struct Build {
  golden::HardwareConfig config;
  bool quick = false;
};

stimulus::DirectedStream joined(const std::vector<stimulus::DirectedStream>& streams) {
  stimulus::DirectedStream all{"all streams, one after the other", {}};
  for (const stimulus::DirectedStream& stream : streams)
    all.words.insert(all.words.end(), stream.words.begin(), stream.words.end());
  return all;
}

class Parameters : public testing::TestWithParam<Build> {};

TEST_P(Parameters, DirectedAndRandomStreams) {
  const golden::HardwareConfig& config = GetParam().config;
  RtlOptions options = Cosim::checked();
  options.stalls = stall_profile(3, 21);
  options.quick_build = GetParam().quick;
  Cosim cosim(config, options);
  // The plane is scrubbed after each reset; where it is large, one long stream stands for all.
  const bool large = config.plane_log2 > 9;
  std::vector<stimulus::DirectedStream> streams = stimulus::directed_streams(config);
  for (std::uint64_t seed = 1; seed <= (large ? 1 : 5); ++seed) {
    streams.push_back(random_case(config, seed, large ? 1000 : 200));
    if (config.en_vpu_topology) streams.push_back(topology_case(config, seed, 40));
  }
  if (large) streams = {joined(streams)};
  std::uint64_t words = 0;
  for (const stimulus::DirectedStream& stream : streams) {
    const CompareReport report = cosim.run(stream.words);
    EXPECT_TRUE(report.passed()) << stream.name << "\n" << to_text(report);
    words += report.words_compared;
  }
  EXPECT_GT(words, 3'000u);
}

/// Hardware with the silhouette-line buffer takes four times as long to compile: the default one, and as many
/// as there is time for, without topology mode. The projection unit without the buffer in the first of the
/// array, which have most pairs of its values. All of them, with all modes, in the soak.
std::vector<Build> builds() {
  constexpr std::size_t kWithBuffer = 7, kWithout = 16;
  std::vector<Build> chosen{{.config = {.en_slb = true}}};
  for (golden::HardwareConfig config : stimulus::slb_covering_array()) {
    if (chosen.size() == kWithBuffer) break;
    if (config == chosen.front().config) continue;
    config.en_vpu_topology = false;
    config.plane_log2 = 4;  // scrubbed after every reset
    config.slb_plane_log2 = std::min(config.slb_plane_log2, 8);
    chosen.push_back({config, true});
  }
  for (golden::HardwareConfig config : stimulus::covering_array()) {
    if (chosen.size() == kWithBuffer + kWithout) break;
    config.en_slb = false;
    // The mode makes a model cost twice as much to compile.
    config.en_vpu_topology = config.en_vpu_topology && config.plane_log2 == 9;
    const auto same = [&](const Build& build) { return build.config == config; };
    if (std::none_of(chosen.begin(), chosen.end(), same)) chosen.push_back({config, true});
  }
  return chosen;
}

INSTANTIATE_TEST_SUITE_P(CoveringArray, Parameters, testing::ValuesIn(builds()), [](const auto& test) {
  std::string name = describe(test.param.config);
  for (char& c : name) c = c == ' ' || c == '=' ? '_' : c;
  return name;
});

/// One step over each border of what is legal, and one step inside.
std::vector<golden::HardwareConfig> borders() {
  using Config = golden::HardwareConfig;
  struct Range {
    int Config::*member;
    int low, high;
  };
  const std::vector<Range> ranges{{&Config::voxel_bits, 4, 11},  {&Config::voxel_frac_bits, 0, 6},
                                  {&Config::normal_bits, 4, 12}, {&Config::matrix_frac_bits, 12, 28},
                                  {&Config::depth_bits, 8, 24},  {&Config::plane_log2, 4, 12}};
  std::vector<Config> configs;
  for (const Range& range : ranges) {
    for (const int value : {range.low - 1, range.low, range.high, range.high + 1}) {
      Config config{.voxel_bits = 6, .voxel_frac_bits = 2, .normal_bits = 6};
      config.*range.member = value;
      if (value >= 0) configs.push_back(config);  // parameters are unsigned in SystemVerilog
    }
  }
  const std::vector<Range> slb_ranges{{&Config::slb_plane_log2, 3, 12}, {&Config::frac_bits, 3, 8},
                                      {&Config::slope_bits, 3, 9},      {&Config::frags_per_pixel, 1, 4},
                                      {&Config::subpixel_bits, 11, 16}, {&Config::query_bits, 11, 16}};
  for (const Range& range : slb_ranges) {
    for (const int value : {range.low - 1, range.high + 1}) {
      Config config{
          .depth_bits = 8, .en_slb = true, .slb_plane_log2 = 3, .subpixel_bits = 12, .query_bits = 12};
      if (range.low == 11) config.frac_bits = 8;
      config.*range.member = value;
      configs.push_back(config);
    }
  }
  configs.push_back(
      {.depth_bits = 24, .en_slb = true, .slb_plane_log2 = 8, .subpixel_bits = 10, .query_bits = 10});
  configs.push_back(
      {.depth_bits = 24, .en_slb = true, .slb_plane_log2 = 8, .subpixel_bits = 11, .query_bits = 10});
  configs.push_back(
      {.depth_bits = 24, .en_slb = true, .slb_plane_log2 = 8, .subpixel_bits = 10, .query_bits = 11});
  for (const auto& [voxel_bits, layers_log2] :
       {std::pair{4, 0}, {4, 3}, {4, 4}, {10, 3}, {11, 0}, {11, 1}, {8, 3}}) {  // 3 V + L + 1 <= 34
    configs.push_back({.voxel_bits = voxel_bits,
                       .voxel_frac_bits = 0,
                       .en_frame_buffer = true,
                       .frame_layers_log2 = layers_log2});
  }
  configs.push_back({.en_slb = true, .frac_bits = 3, .slope_bits = 9, .subpixel_bits = 9});  // s < S - F + 4
  configs.push_back({.voxel_bits = 11, .voxel_frac_bits = 5, .normal_bits = 5});
  configs.push_back({.voxel_bits = 11, .voxel_frac_bits = 5, .normal_bits = 6});  // 66 bits of a voxel
  configs.push_back({.voxel_bits = 11, .voxel_frac_bits = 6, .normal_bits = 4});  // P = 17
  configs.push_back({.voxel_bits = 9, .voxel_frac_bits = 3, .normal_bits = 9, .matrix_frac_bits = 14});
  configs.push_back(
      {.voxel_bits = 9, .voxel_frac_bits = 3, .normal_bits = 9, .matrix_frac_bits = 13});  // f < P + 2
  return configs;
}

TEST(Parameters, GoldenAndElaborationRefuseTheSameBuilds) {
  const ModelCache cache;
  int refused = 0, accepted = 0;
  for (const golden::HardwareConfig& config : borders()) {
    const auto by_golden = config.check();
    const auto by_rtl = cache.refusal({.config = config});
    EXPECT_EQ(by_golden.has_value(), by_rtl.has_value())
        << describe(config) << "\ngolden: " << by_golden.value_or("accepts")
        << "\nrtl: " << by_rtl.value_or("accepts");
    if (by_rtl) {
      EXPECT_THAT(*by_rtl, testing::HasSubstr("parameter_check.sv"));
    }
    (by_rtl ? refused : accepted) += 1;
  }
  EXPECT_GE(refused, 30);
  EXPECT_GE(accepted, 20);
}

}  // namespace
}  // namespace gnomon::sim::test
