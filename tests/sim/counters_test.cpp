// SPDX-License-Identifier: Apache-2.0
// Cycle counters: every cycle has one place, and one voxel a cycle is what the units are built for.
#include <gtest/gtest.h>

#include <gnomon/golden/stream.hpp>
#include <numeric>

#include "tests/sim/cosim.hpp"
#include "tests/sim/tiny_model.hpp"
#include "tests/support/scene_registers.hpp"
#include "tests/support/voxel_patterns.hpp"

namespace gnomon::sim::test {
namespace {

using stimulus::Pattern;

std::uint64_t sum(const std::map<std::string, std::uint64_t>& cycles, const std::string& prefix = "cycles.") {
  return std::accumulate(cycles.begin(), cycles.end(), std::uint64_t{0},
                         [&](std::uint64_t total, const auto& cell) {
                           return total + (cell.first.starts_with(prefix) ? cell.second : 0);
                         });
}

golden::HardwareConfig small_plane() {
  golden::HardwareConfig config;
  config.plane_log2 = 6;
  return config;
}

class CycleTable : public testing::TestWithParam<int> {};

TEST_P(CycleTable, SumsToTheCyclesSinceReset) {
  RtlOptions options = Cosim::checked();
  options.stalls = stall_profile(GetParam(), 8);
  Cosim cosim(small_plane(), options);
  const CompareReport report = cosim.run(random_case(small_plane(), 5, 300).words);
  EXPECT_TRUE(report.passed()) << to_text(report);
  EXPECT_EQ(report.rtl_counters.cycles.size(), 60u);
  EXPECT_EQ(sum(report.rtl_counters.cycles), report.cycles);
  EXPECT_GT(report.cycles, 1000u);
}

INSTANTIATE_TEST_SUITE_P(Ports, CycleTable, testing::Range(0, kStallProfiles));

TEST(CycleTables, ReadingDisturbsNothing) {
  Cosim cosim(small_plane());
  const std::vector<Word> stream = random_case(small_plane(), 6, 50).words;
  const std::vector<Word> plain = run(cosim.rtl(), stream);
  const golden::Counters expected = cosim.rtl().counters();
  cosim.rtl().reset();
  for (const Word& word : stream) {
    cosim.rtl().submit(std::span(&word, 1));
    cosim.rtl().counters();
  }
  EXPECT_EQ(run(cosim.rtl(), {}), plain);
  EXPECT_EQ(cosim.rtl().counters().events, expected.events);
  EXPECT_EQ(cosim.rtl().counters().cycles, expected.cycles);
}

TEST(CycleTables, StarvationAndBlockingAreToldApart) {
  RtlOptions hungry = Cosim::checked(), blocked = Cosim::checked();
  hungry.stalls.command = {64, 0};
  blocked.stalls.result = {64, 0};
  stimulus::Random random(1);
  const auto registers = stimulus::scene_registers(small_plane(), random);
  golden::StreamWriter writer(small_plane());
  writer.set_registers(golden::Register::MatrixUx, registers);
  writer.resolve(stimulus::voxel_pattern(Pattern::Uniform, 5000, registers, small_plane(), random), false);
  const std::vector<Word> stream = writer.take();

  Cosim starving(small_plane(), hungry), blocking(small_plane(), blocked);
  const auto starved = starving.run(stream).rtl_counters.cycles;
  const auto stopped = blocking.run(stream).rtl_counters.cycles;
  EXPECT_GT(starved.at("cycles.RESOLVE.INPUT_STARVED"), 10'000u);
  EXPECT_LT(starved.at("cycles.RESOLVE.OUTPUT_BLOCKED"), 100u);
  EXPECT_GT(stopped.at("cycles.RESOLVE.OUTPUT_BLOCKED"), 10'000u);
  EXPECT_LT(stopped.at("cycles.RESOLVE.INPUT_STARVED"), 100u);
}

class Throughput : public testing::TestWithParam<int> {};

TEST_P(Throughput, OneVoxelACycleInBothPasses) {
  constexpr std::size_t kVoxels = 20'000;
  Cosim cosim({}, RtlOptions{});
  stimulus::Random random(9);
  const auto registers = stimulus::scene_registers({}, random);
  golden::StreamWriter writer({});
  writer.set_registers(golden::Register::MatrixUx, registers);
  const auto voxels =
      stimulus::voxel_pattern(static_cast<Pattern>(GetParam()), kVoxels, registers, {}, random);
  writer.project(voxels);
  writer.resolve(voxels, false);
  const CompareReport report = cosim.run(writer.take());
  EXPECT_TRUE(report.passed()) << to_text(report);
  EXPECT_EQ(report.rtl_counters.events.at("VOXELS_PROJECTED"), kVoxels);
  EXPECT_EQ(report.rtl_counters.events.at("VOXELS_RESOLVED"), kVoxels);
  const std::uint64_t project = sum(report.rtl_counters.cycles, "cycles.PROJECT.");
  const std::uint64_t resolve = sum(report.rtl_counters.cycles, "cycles.RESOLVE.");
  EXPECT_GE(project, kVoxels);
  EXPECT_GE(resolve, kVoxels);
  EXPECT_LE(project, kVoxels * 105 / 100);
  EXPECT_LE(resolve, kVoxels * 105 / 100);
}

INSTANTIATE_TEST_SUITE_P(Patterns, Throughput, testing::Range(0, stimulus::kPatternCount));

/// The hardest case for a read-modify-write: every voxel in the same entry, each nearer than the one before.
TEST(Throughputs, SameEntryInEveryCycle) {
  constexpr std::uint32_t kVoxels = 1000;
  golden::StreamWriter writer({});
  const std::int64_t code = std::int64_t{1} << (golden::HardwareConfig{}.position_bits() + 4);
  writer.set_register(golden::Register::MatrixDz, -code);
  writer.set_register(golden::Register::MatrixD1, 2000 * code);
  std::vector<golden::VoxelItem> voxels(kVoxels);
  for (std::uint32_t i = 0; i < kVoxels; ++i) voxels[i].position = {5, 5, i};
  writer.project(voxels);
  writer.resolve(voxels, false);
  Cosim cosim({});
  const CompareReport report = cosim.run(writer.take());
  EXPECT_TRUE(report.passed()) << to_text(report);
  EXPECT_EQ(report.rtl_counters.events.at("PLANE_WRITES"), kVoxels);
  EXPECT_LE(sum(report.rtl_counters.cycles, "cycles.PROJECT."), kVoxels * 105 / 100);
  EXPECT_LE(sum(report.rtl_counters.cycles, "cycles.RESOLVE."), kVoxels * 105 / 100);
}

}  // namespace
}  // namespace gnomon::sim::test
