// SPDX-License-Identifier: Apache-2.0
// Topology mode under lights at a position, against the page in rationals: random scenes, builds and
// registers.
#include <gtest/gtest.h>

#include <gnomon/golden/golden_engine.hpp>
#include <gnomon/golden/stream.hpp>

#include "reference.hpp"
#include "scenes.hpp"
#include "tests/support/perspective_registers.hpp"

namespace gnomon::test {
namespace {

using golden::HardwareConfig;
using golden::Register;
using golden::topology::TopologyResult;
using golden::topology::TopologyUnit;
using stimulus::AllRegisters;

HardwareConfig hardware(const TopologyConfig& config) {
  HardwareConfig result;
  result.voxel_bits = config.voxel_bits;
  result.voxel_frac_bits = config.voxel_frac_bits;
  result.normal_bits = config.normal_bits;
  result.matrix_frac_bits = config.matrix_frac_bits;
  result.depth_bits = config.depth_bits;
  result.plane_log2 = config.plane_log2;
  result.en_vpu_topology = result.en_perspective = true;
  result.sub_bits = config.sub_bits;
  result.span_log2 = config.span_log2;
  result.nodes_log2 = config.nodes_log2;
  result.quads_log2 = config.quads_log2;
  return result;
}

struct Tally {
  std::uint64_t compared = 0, hit = 0, behind = 0, outside_cone = 0, facing_away = 0, uncertain = 0,
                fallback = 0;
  void add(const TopologyResult& r) {
    ++compared;
    hit += r.hit ? 1U : 0U;
    behind += r.behind ? 1U : 0U;
    outside_cone += r.outside_cone ? 1U : 0U;
    facing_away += r.facing_away ? 1U : 0U;
    uncertain += r.uncertain ? 1U : 0U;
    fallback += r.fallback ? 1U : 0U;
  }
};

/// Puts random quads, resolves random voxels, compares every answer and every list.
void compare(const TopologyConfig& config, std::uint64_t seed, int extreme_percent, Tally& tally) {
  stimulus::Random random(seed);
  const AllRegisters registers =
      stimulus::extreme_perspective_registers(hardware(config), extreme_percent, random);
  TopologyUnit unit(config);
  unit.set_registers(stimulus::projection_registers(registers, hardware(config)));
  TopologyReference reference(config, exact::PerspectiveUnit(hardware(config), registers));
  const int reach = 1 << (config.position_bits() - 3);
  for (int i = 0; i < 60; ++i) {
    const Quad quad = random_quad(random, config, reach);
    unit.put(quad);
    reference.put(quad);
  }
  for (std::int64_t v = 0; v < config.side(); ++v)
    for (std::int64_t u = 0; u < config.side(); ++u) {
      const auto index = static_cast<std::size_t>(v * config.side() + u);
      ASSERT_EQ(unit.lists().list(index), reference.list(u, v)) << "seed " << seed;
      ASSERT_EQ(unit.lists().head(index), reference.head(u, v)) << "seed " << seed;
    }
  for (int i = 0; i < 60; ++i) {
    const Item voxel = random_item(random, config);
    const bool two_sided = random.chance(50), sorted = random.chance(30);
    const auto clearance = static_cast<std::uint32_t>(
        random.chance(40) ? 0 : random.between(0, (std::int64_t{1} << random.between(1, 24)) - 1));
    const TopologyResult result = unit.resolve(voxel, two_sided, clearance, sorted);
    ASSERT_EQ(result, reference.resolve(voxel, two_sided, clearance, sorted)) << "seed " << seed;
    tally.add(result);
  }
}

TEST(TopologyPerspective, AnswersAreThoseOfThePage) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    TopologyConfig config = small_config();
    config.sub_bits = 2 + static_cast<int>(seed % 7);
    config.span_log2 = 3 + static_cast<int>(seed % 2);
    compare(config, 1000 + seed, 0, tally);
  }
  EXPECT_EQ(tally.compared, 60U * 60U);
  for (const std::uint64_t count : {tally.hit, tally.behind, tally.outside_cone, tally.facing_away})
    EXPECT_GT(count, 100U);
  EXPECT_GT(tally.uncertain, tally.hit + 50U);
  EXPECT_GT(tally.fallback, 20U);
}

TEST(TopologyPerspective, AlsoAtTheEndsOfRegistersAndParameters) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    TopologyConfig config = small_config();
    if (seed % 2 == 0) {
      config.voxel_frac_bits = 6;
      config.normal_bits = 11;
      config.matrix_frac_bits = 28;
      config.depth_bits = 24;
      config.sub_bits = 8;
    } else {
      config.voxel_frac_bits = 0;
      config.normal_bits = 4;
      config.matrix_frac_bits = 12;
      config.depth_bits = 8;
      config.sub_bits = 2;
    }
    compare(config, 2000 + seed, seed % 4 < 2 ? 5 : 40, tally);
  }
  EXPECT_EQ(tally.compared, 40U * 60U);
}

/// What is put, counted and flagged through the one stream.
TEST(TopologyPerspective, QuadsBehindAreDroppedCountedAndFlagged) {
  const TopologyConfig small = small_config();
  const HardwareConfig config = hardware(small);
  stimulus::Random random(4);
  AllRegisters registers = stimulus::perspective_registers(config, random);
  const auto at = [&](Register reg) -> std::int64_t& { return registers[static_cast<std::size_t>(reg)]; };
  at(Register::Projection) = golden::kProjectionPerspective;
  at(Register::MatrixWx) = at(Register::MatrixWy) = 0;
  at(Register::MatrixWz) = std::int64_t{1} << config.matrix_frac_bits;  // behind at z < 20
  at(Register::MatrixW1) = std::int64_t{-20} * (std::int64_t{1} << config.matrix_frac_bits);
  at(Register::WNear) = 0;
  golden::StreamWriter writer(config);
  writer.set_registers(Register::MatrixUx, registers);
  const auto quad = [](std::uint32_t low, std::uint32_t high) {
    std::array<golden::VoxelItem, 4> corners{};
    for (std::size_t i = 0; i < 4; ++i) corners[i].position = {8, 8, i < 2 ? low : high};
    return corners;
  };
  const auto lit = golden::VoxelItem{{8, 8, 30}, {0, 0, -5}}, behind = golden::VoxelItem{{8, 8, 20}, {}};
  writer.put_quads(std::vector{quad(3, 20), quad(20, 21), quad(25, 30)});
  writer.resolve_topology(std::vector{lit, behind}, false, 0, false);
  writer.fence(1, true);
  const auto engine = golden::make_golden_engine(config);
  std::vector<Word> results;
  engine->submit(writer.words());
  engine->drain([&](std::span<const Word> w) { results.insert(results.end(), w.begin(), w.end()); });
  ASSERT_EQ(results.size(), 3u);
  EXPECT_EQ(results[1], Word{0x1483FFFFFF000000});
  EXPECT_EQ(golden::describe_result(results[1]),
            "TOPOLOGY_STATE state=2 facing_away=0 off_plane=0 uncertain=0 hit=0 fallback=0 behind=1 "
            "quad=16777215 visited=0 tested=0");
  EXPECT_NE(golden::decode_fence_result(results[2]).sticky & golden::kStickyBehindLight, 0u);
  const auto events = engine->counters().events;
  EXPECT_EQ(events.at("QUADS_PUT"), 3u);
  EXPECT_EQ(events.at("QUADS_BEHIND"), 1u);
  EXPECT_EQ(events.at("QUADS_STRADDLING"), 1u);
  EXPECT_EQ(events.at("TOPOLOGY_BEHIND"), 1u);
  EXPECT_EQ(events.at("TOPOLOGY_OUTSIDE_CONE"), 0u);
}

}  // namespace
}  // namespace gnomon::test
