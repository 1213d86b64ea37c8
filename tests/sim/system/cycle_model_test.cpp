// SPDX-License-Identifier: Apache-2.0
// Cycles predicted for hardware behind a bus, DRAM and a cache against those of gnomon_top within the system
// (docs/cycle-model.md, "Behind the bus").
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <gnomon/golden/cycles.hpp>
#include <gnomon/golden/stream.hpp>
#include <ostream>
#include <string>

#include "host/pipeline/cycle_timing.hpp"
#include "sim/counter_names.hpp"
#include "sim/system/system_engine.hpp"
#include "tests/support/scene_registers.hpp"
#include "tests/support/stimulus.hpp"
#include "tests/support/voxel_patterns.hpp"

namespace gnomon::sim::system::test {
namespace {

using golden::CycleTable;
using golden::Pass;
using stimulus::Pattern;
using Words = std::vector<Word>;

/// What the processor's own accesses to memory, which the model leaves out, may move in a cell.
constexpr std::uint64_t kGrace = 8;

struct Build {
  const char* name;
  golden::HardwareConfig config;
  int cache_log2, axi_data_bits;
};

void PrintTo(const Build& build, std::ostream* out) {
  *out << build.name;
}

/// Planes on the chip; in a cache that holds all of them; in one that holds a sixteenth, and so do those of
/// the other units.
const Build kBuilds[] = {{"on_chip", {.plane_log2 = 5}, 0, 64},
                         {"wide_bus", {.plane_log2 = 5}, 12, 128},
                         {"cached",
                          {.plane_log2 = 7,
                           .en_vpu_topology = true,
                           .nodes_log2 = 14,
                           .quads_log2 = 12,
                           .en_slb = true,
                           .slb_plane_log2 = 6},
                          12,
                          64}};

SystemOptions options_of(const Build& build, std::uint32_t latency) {
  SystemOptions options;
  options.rtl.quick_build = true;
  options.rtl.assertions = true;
  options.cache_log2 = build.cache_log2;
  options.axi_data_bits = build.axi_data_bits;
  options.system.dram.latency = latency;
  return options;
}

CycleTable measure(const Build& build, std::uint32_t latency, const Words& words) {
  const auto engine = make_system_engine(build.config, options_of(build, latency));
  engine->submit(words);
  engine->drain([](std::span<const Word>) {});
  const golden::Counters counters = engine->counters();
  CycleTable table;
  for (std::size_t p = 0; p < golden::kPasses; ++p)
    for (std::size_t c = 0; c < golden::kCauses; ++c)
      table.at(static_cast<Pass>(p), static_cast<golden::Cause>(c)) =
          counters.cycles.at(cycle_counter_name(p, c));
  return table;
}

CycleTable predict(const Build& build, std::uint32_t latency, const Words& words) {
  return golden::predict_cycles(build.config, pipeline::cycle_timing(options_of(build, latency)), words);
}

/// Cells that are off by more than `grace` cycles: "PROJECT.HAZARD: 500 measured, 600 predicted".
std::vector<std::string> far_off(const CycleTable& measured, const CycleTable& predicted,
                                 std::uint64_t grace) {
  std::vector<std::string> cells;
  for (std::size_t p = 1; p < golden::kPasses; ++p)
    for (std::size_t c = 0; c < golden::kCauses; ++c) {
      const std::uint64_t is = measured.at(static_cast<Pass>(p), static_cast<golden::Cause>(c));
      const std::uint64_t told = predicted.at(static_cast<Pass>(p), static_cast<golden::Cause>(c));
      if (std::max(is, told) - std::min(is, told) <= grace) continue;
      cells.push_back(cycle_counter_name(p, c) + ": " + std::to_string(is) + " measured, " +
                      std::to_string(told) + " predicted");
    }
  return cells;
}

/// Projected and resolved, as a scene is; a surface and points anywhere.
Words scene(const golden::HardwareConfig& config, std::uint64_t seed) {
  stimulus::Random random(seed);
  const auto registers = stimulus::scene_registers(config, random);
  golden::StreamWriter writer(config);
  writer.set_registers(golden::Register::MatrixUx, registers);
  for (const Pattern pattern : {Pattern::Sheet, Pattern::Uniform, Pattern::Columns}) {
    const auto voxels = stimulus::voxel_pattern(pattern, 2'000, registers, config, random);
    writer.clear_plane();
    writer.project(voxels);
    writer.resolve(voxels, false);
  }
  writer.fence(0, true);
  return writer.take();
}

class SystemCycles : public testing::TestWithParam<Build> {};

TEST_P(SystemCycles, AreThoseOfScenes) {
  for (const std::uint32_t latency : {20u, 100u, 200u}) {
    const Words words = scene(GetParam().config, latency);
    const CycleTable measured = measure(GetParam(), latency, words);
    EXPECT_THAT(far_off(measured, predict(GetParam(), latency, words), kGrace), testing::IsEmpty())
        << latency;
    EXPECT_GT(measured.of(Pass::Resolve), 6'000u);
    EXPECT_GT(measured.of(Pass::Project), 6'000u);
  }
}

/// Short commands of every kind: each may be off by its start.
TEST_P(SystemCycles, AreThoseOfRandomStreams) {
  for (const std::uint32_t latency : {20u, 200u}) {
    const Words words = stimulus::random_stream(GetParam().config, {.seed = latency, .commands = 150});
    const CycleTable measured = measure(GetParam(), latency, words);
    EXPECT_THAT(far_off(measured, predict(GetParam(), latency, words), 2 * kGrace), testing::IsEmpty())
        << latency;
  }
}

/// Objects drawn, filled, covered and asked about, quads put and walked, each many times its caches' size.
TEST(SystemCycleModel, KnowsEveryUnitBehindItsCaches) {
  const Build& build = kBuilds[2];
  for (const std::uint32_t latency : {50u, 200u}) {
    const Words words = stimulus::random_stream(
        build.config, {.seed = latency, .commands = 600, .max_items = 200, .illegal_percent = 0});
    const CycleTable measured = measure(build, latency, words);
    EXPECT_THAT(far_off(measured, predict(build, latency, words), kGrace), testing::IsEmpty()) << latency;
    for (const Pass pass : {Pass::Project, Pass::Resolve, Pass::Read, Pass::Draw, Pass::Fill, Pass::Query})
      EXPECT_GT(measured.of(pass), 4'000u) << static_cast<int>(pass);
    EXPECT_GT(measured.of(Pass::Cover), 1'000u);
  }
}

INSTANTIATE_TEST_SUITE_P(Builds, SystemCycles, testing::ValuesIn(kBuilds),
                         [](const auto& build) { return std::string(build.param.name); });

/// A model of another memory, or of another cache, is noticed.
TEST(SystemCycleModel, IsChecked) {
  const Build& build = kBuilds[2];
  const Words words = scene(build.config, 5);
  const CycleTable measured = measure(build, 200, words);
  EXPECT_THAT(far_off(measured, predict(build, 200, words), kGrace), testing::IsEmpty());
  Build larger = build;
  larger.cache_log2 = 13;
  for (const auto& wrong :
       {predict(build, 100, words), predict(build, 220, words), predict(larger, 200, words)})
    EXPECT_THAT(far_off(measured, wrong, kGrace), testing::Contains(testing::HasSubstr("RESOLVE")));
}

}  // namespace
}  // namespace gnomon::sim::system::test
