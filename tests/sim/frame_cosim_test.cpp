// SPDX-License-Identifier: Apache-2.0
// The hardware with the frame buffer gives the words and counts that golden gives, and takes the cycles that
// docs/frame-buffer.md promises.
#include <gtest/gtest.h>

#include <algorithm>
#include <gnomon/golden/golden_engine.hpp>
#include <gnomon/golden/stream.hpp>

#include "tests/sim/altered_engine.hpp"
#include "tests/sim/cosim.hpp"
#include "tests/support/covering.hpp"
#include "tests/support/frame_stream.hpp"
#include "tests/support/seeded_faults.hpp"

namespace gnomon::sim::test {
namespace {

using golden::HardwareConfig;
using golden::StreamWriter;
using golden::VoxelItem;

/// Both modes, two layers, small memories: one model for most of these tests.
const HardwareConfig kFrame{.voxel_bits = 5,
                            .voxel_frac_bits = 3,
                            .depth_bits = 16,
                            .plane_log2 = 4,
                            .en_vpu_topology = true,
                            .nodes_log2 = 10,
                            .quads_log2 = 8,
                            .en_frame_buffer = true,
                            .frame_layers_log2 = 1};

RtlOptions quick() {
  RtlOptions options = Cosim::checked();
  options.quick_build = true;
  return options;
}

/// Streams of the frame buffer and, of everything, random and directed ones.
std::vector<stimulus::DirectedStream> streams_for(const HardwareConfig& config, std::uint64_t seed) {
  std::vector<stimulus::DirectedStream> streams = stimulus::directed_streams(config);
  streams.push_back(random_case(config, seed, 150));
  for (std::uint64_t i = 0; i < 3; ++i) {
    streams.push_back({"frame buffer, seed " + std::to_string(10 * seed + i),
                       stimulus::frame_stream(config, 10 * seed + i, 120)});
  }
  return streams;
}

std::uint64_t expect_equal(Cosim& cosim, const std::vector<stimulus::DirectedStream>& streams) {
  std::uint64_t words = 0, kept = 0;
  for (const stimulus::DirectedStream& stream : streams) {
    const CompareReport report = cosim.run(stream.words);
    EXPECT_TRUE(report.passed()) << stream.name << "\n" << to_text(report);
    words += report.words_compared;
    kept += report.rtl_counters.events.at("FRAME_KEPT");
  }
  EXPECT_GT(kept, 1'000u);
  return words;
}

class StalledFrame : public testing::TestWithParam<int> {};

TEST_P(StalledFrame, RandomStreams) {
  const auto kind = static_cast<std::uint64_t>(GetParam());
  RtlOptions options = quick();
  options.stalls = stall_profile(GetParam(), 41 + kind);
  Cosim cosim(kFrame, options);
  EXPECT_GT(expect_equal(cosim, streams_for(kFrame, 100 + kind)), 5'000u);
}

INSTANTIATE_TEST_SUITE_P(Ports, StalledFrame, testing::Range(0, kStallProfiles));

/// Three builds of the array here, with all modes; all in the soak; each with a memory of its own.
class FrameBuild : public testing::TestWithParam<std::size_t> {};

TEST_P(FrameBuild, DirectedAndRandomStreams) {
  const std::size_t number = GetParam();
  const HardwareConfig config = stimulus::frame_covering_array().at(number);
  RtlOptions options = quick();
  options.memory_latency = std::array{1, 7, 2, 64, 3}.at(number / 2);
  options.memory_stall_seed = number % 4 == 0 ? 0 : 4711;
  options.stalls = stall_profile(4, number);
  Cosim cosim(config, options);
  EXPECT_GT(expect_equal(cosim, streams_for(config, 200 + number)), 3'000u);
}

INSTANTIATE_TEST_SUITE_P(CoveringArray, FrameBuild, testing::Values(1u, 3u, 8u));

TEST(FrameCosim, ResetInTheMiddleOfAnything) {
  RtlOptions options = quick();
  options.stalls = stall_profile(4, 9);
  Cosim cosim(kFrame, options);
  const std::vector<Word> before = stimulus::frame_stream(kFrame, 50, 60);
  const std::vector<Word> after = stimulus::frame_stream(kFrame, 51, 40);
  for (std::size_t cut = 3; cut < before.size(); cut += 1 + before.size() / 10) {
    cosim.rtl().reset();
    cosim.rtl().submit(std::span(before).first(cut));  // returns with the pipelines full
    const CompareReport report = cosim.run(after);     // resets
    EXPECT_TRUE(report.passed()) << "reset after " << cut << " words\n" << to_text(report);
  }
}

/// `count` voxels along a row, `same_brick` of them next to each other at a time.
std::vector<VoxelItem> row(std::size_t count, std::size_t same_brick) {
  std::vector<VoxelItem> items(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto x = static_cast<std::uint32_t>(i / same_brick * 4 % 32 + i % 4);
    items[i].position = {x << kFrame.voxel_frac_bits, 5, 9};
    items[i].normal = {1, 2, 3};
  }
  return items;
}

constexpr std::size_t kItems = 2000;

/// Cycles of what `write` adds to a stream.
template <typename Write>
double cycles_of(const Write& write) {
  Cosim cosim(kFrame, quick());
  const auto cycles = [&](bool with) {
    StreamWriter writer(kFrame);
    writer.fence(1, false);
    if (with) write(writer);
    writer.fence(2, false);
    const CompareReport report = cosim.run(writer.take());
    EXPECT_TRUE(report.passed()) << to_text(report);
    return static_cast<double>(report.cycles);
  };
  return cycles(true) - cycles(false);
}

TEST(FrameCosim, AVoxelKeptACycleWhateverBricksTheyHit) {
  for (const std::size_t same_brick : {1u, 2u, 3u, 64u, 100'000u}) {
    const double cycles = cycles_of([&](StreamWriter& writer) {
      writer.keep(golden::Keeping{1, true});
      writer.resolve(row(kItems, same_brick), true);
    });
    EXPECT_LE(cycles, 1.05 * kItems) << same_brick << " voxels in a brick";
  }
}

/// Besides the last voxels' way through the memory.
TEST(FrameCosim, KeepingTakesNoMoreCyclesThanThePass) {
  constexpr double kDrain = 8;
  const auto offset = [](bool keep, bool quiet) {
    return cycles_of([&](StreamWriter& writer) {
      if (keep) writer.keep(golden::Keeping{0, quiet});
      writer.resolve(row(kItems, 7), true);
    });
  };
  const auto topology = [](bool keep) {
    return cycles_of([&](StreamWriter& writer) {
      if (keep) writer.keep(golden::Keeping{0, true});
      writer.resolve_topology(row(kItems, 7), true, 0, false);
    });
  };
  EXPECT_LE(offset(true, true), offset(false, false) + kDrain);
  EXPECT_LE(offset(true, false), offset(false, false) + kDrain);
  EXPECT_LE(topology(true), topology(false) + kDrain);
}

TEST(FrameCosim, ALookupACycleAndABrickThree) {
  const double states = cycles_of([](StreamWriter& writer) { writer.look_up(row(kItems, 3), 0, false); });
  EXPECT_LE(states, 1.02 * kItems);
  const double bricks = cycles_of([](StreamWriter& writer) { writer.look_up(row(kItems, 3), 0, true); });
  EXPECT_LE(bricks, 3.02 * kItems);
}

/// 32³ in two layers are 1,024 bricks, 64 lines of 16: a clear scrubs one of them.
TEST(FrameCosim, AClearTakesItsLinesAndTwoCycles) {
  EXPECT_EQ(cycles_of([](StreamWriter& writer) { writer.clear_frame(); }), 3.0);
}

TEST(FrameCosim, ADifferenceInAWordOfStatesIsLocated) {
  StreamWriter writer(kFrame);
  writer.look_up(row(30, 3), 0, false);
  AlteredEngine reference(golden::make_golden_engine(kFrame), flip_bit(1, 3));
  const auto rtl = make_rtl_engine(kFrame, quick());
  const CompareReport report = compare(reference, *rtl, writer.take());
  EXPECT_EQ(report.words_compared, 2u);
  EXPECT_EQ(report.words_differing, 1u);
}

class FrameMutation : public testing::TestWithParam<std::string_view> {};

/// Without assertions: it is the words and counters that must show the fault.
TEST_P(FrameMutation, IsNoticed) {
  RtlOptions options;
  options.quick_build = true;
  options.defines = {"GNOMON_MUTATE_" + std::string(GetParam())};
  options.stalls = stall_profile(3, 3);
  const HardwareConfig config{
      .voxel_bits = 4, .plane_log2 = 4, .en_frame_buffer = true, .frame_layers_log2 = 1};
  Cosim cosim(config, options);
  bool noticed = false;
  for (std::uint64_t seed = 1; seed <= 5 && !noticed; ++seed) {
    noticed = !cosim.run(stimulus::frame_stream(config, seed, 150), {.stop_at_first = true}).passed();
  }
  EXPECT_TRUE(noticed) << "no stream shows the fault";
}

INSTANTIATE_TEST_SUITE_P(Rtl, FrameMutation, testing::ValuesIn(stimulus::kFrameFaults),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace gnomon::sim::test
