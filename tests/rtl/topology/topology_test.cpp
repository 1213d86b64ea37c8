// SPDX-License-Identifier: Apache-2.0
// Topology mode's unit against golden, word for word and counter for counter.
#include <gtest/gtest.h>

#include "tests/rtl/topology/bench.hpp"
#include "tests/rtl/topology/builds.hpp"
#include "tests/rtl/topology/surfaces.hpp"

namespace gnomon::rtl_test::topology {
namespace {

using golden::topology::decode_topology_result;
using test::at;
using test::from_above;
using test::square;

template <class Build>
class TopologyUnit : public testing::Test {};
using Builds = testing::Types<SceneBuild, SmallBuild, WideBuild>;
TYPED_TEST_SUITE(TopologyUnit, Builds);

/// Those whose pools a moment's quads fill.
template <class Build>
class TopologyPools : public testing::Test {};
using SmallPools = testing::Types<SmallBuild, WideBuild>;
TYPED_TEST_SUITE(TopologyPools, SmallPools);

TYPED_TEST(TopologyUnit, RandomProgramsGiveGoldensWordsAndCounters) {
  const TopologyConfig config = TypeParam::config();
  TopologyBench<typename TypeParam::Model> bench(1);
  TopologyCounters total;
  std::size_t compared = 0;
  for (std::uint64_t seed = 0; seed < 16; ++seed) {
    stimulus::Random random(seed);
    const Program program = random_program(random, config, 40);
    const Stalls stalls =
        seed % 2 == 0 ? Stalls{} : Stalls{.items = 150, .results = seed % 4 == 1 ? 40u : 200u};
    bench.reset();
    const Outcome want = expected(program, config);
    ASSERT_EQ(difference(bench.run(program, stalls), want), "") << "seed " << seed;
    compared += want.results.size();
    total.hit += want.counters.hit;
    total.nodes_dropped += want.counters.nodes_dropped;
    total.fallback += want.counters.fallback;
    total.quads_off_plane += want.counters.quads_off_plane;
    total.quads_too_large += want.counters.quads_too_large;
    total.quads_saturated += want.counters.quads_saturated;
  }
  EXPECT_GT(compared, 16u * 256u + 3000u);
  EXPECT_GT(total.hit, 20u);
  EXPECT_GT(total.nodes_dropped, 0u);
  EXPECT_GT(total.fallback, 0u);
  EXPECT_GT(total.quads_off_plane, 0u);
  EXPECT_GT(total.quads_saturated, 0u);
  EXPECT_TRUE(total.quads_too_large > 0 || config.span_log2 > config.plane_log2);
}

TYPED_TEST(TopologyUnit, AResetInTheMiddleLeavesNothingBehind) {
  const TopologyConfig config = TypeParam::config();
  TopologyBench<typename TypeParam::Model> bench(2);
  const std::uint64_t scrub = static_cast<std::uint64_t>(config.side() * config.side()) / 16;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    stimulus::Random random(100 + seed);
    const Program program = random_program(random, config, 12);
    bench.run_then_reset(program, {.results = 100}, scrub + 150 + 211 * seed);
    ASSERT_EQ(difference(bench.run(program), expected(program, config)), "") << "seed " << seed;
    bench.reset();
  }
}

/// Beams at every sub-entry around quads of all orders and degeneracies.
TYPED_TEST(TopologyUnit, SidesCornersAndDegenerateQuads) {
  const TopologyConfig config = TypeParam::config();
  ProjectionRegisters registers;  // a position ulp is a sub-entry, depths stay below the last code
  const std::int64_t sub = std::int64_t{1} << (config.matrix_frac_bits - config.sub_bits);
  registers.matrix = {sub,
                      0,
                      0,
                      0,
                      0,
                      sub,
                      0,
                      0,
                      0,
                      0,
                      -(std::int64_t{4} << (config.position_bits() + 4)),
                      std::int64_t{100} << (config.position_bits() + 4)};
  const auto place = [](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    return Item{.position = {x, y, z}, .normal = {0, 0, 3}};
  };
  const std::vector<Quad> quads = {
      {place(2, 2, 9), place(6, 2, 9), place(6, 6, 9), place(2, 6, 9)},  // square
      {place(2, 2, 9), place(2, 6, 9), place(6, 6, 9), place(6, 2, 9)},  // the other way round
      {place(2, 2, 9), place(6, 6, 9), place(6, 2, 9), place(2, 6, 9)},  // crossed
      {place(3, 3, 9), place(7, 4, 9), place(4, 7, 9), place(4, 7, 9)},  // triangle
      {place(3, 3, 9), place(3, 3, 9), place(7, 4, 9), place(4, 7, 9)},  // triangle, first half empty
      {place(2, 2, 9), place(4, 4, 9), place(6, 6, 9), place(3, 3, 9)},  // a line
      {place(5, 5, 9), place(5, 5, 9), place(5, 5, 9), place(5, 5, 9)},  // a point
      {place(1, 4, 9), place(4, 3, 9), place(8, 4, 9), place(4, 4, 9)},  // concave
  };
  std::vector<Item> voxels;
  for (std::uint32_t y = 0; y < 10; ++y)
    for (std::uint32_t x = 0; x < 10; ++x) voxels.push_back(place(x, y, 1));
  Program program{set(registers)};
  for (const Quad& quad : quads) {
    program.push_back(clear_lists());
    program.push_back(put(std::span(&quad, 1), config));
    program.push_back(resolve(voxels, config, 0, 0));
  }
  TopologyBench<typename TypeParam::Model> bench(3);
  const Outcome want = expected(program, config);
  ASSERT_EQ(want.results.size(), 800u);
  EXPECT_EQ(difference(bench.run(program), want), "");
  EXPECT_GT(want.counters.hit, 100u);
}

TYPED_TEST(TopologyPools, TheyRunOutAndVoxelsFallBack) {
  const TopologyConfig config = TypeParam::config();
  stimulus::Random random(7);
  std::vector<Quad> quads;
  quads.reserve(700);
  for (int i = 0; i < 700; ++i)
    quads.push_back(test::random_quad(random, config, 2 * ulps_per_entry(config)));
  std::vector<Item> voxels;
  voxels.reserve(600);
  for (int i = 0; i < 600; ++i) voxels.push_back(test::random_item(random, config));
  const Program program = {set(light(config, {0.3, 0.2, -1})),
                           put(quads, config),
                           resolve(voxels, config, 1, 0),
                           put(quads, config),
                           resolve(voxels, config, 3, 1),
                           clear_lists(),
                           put(quads, config),
                           resolve(voxels, config, 0, 0)};
  TopologyBench<typename TypeParam::Model> bench(4);
  const Outcome want = expected(program, config);
  EXPECT_EQ(difference(bench.run(program), want), "");
  EXPECT_GT(want.counters.nodes_dropped, 100u);
  EXPECT_GT(want.counters.fallback, 10u);
  EXPECT_TRUE(want.sticky.list_overflow);
}

TYPED_TEST(TopologyUnit, ListsOfOldGenerationsStayEmpty) {
  const TopologyConfig config = TypeParam::config();
  stimulus::Random random(8);
  Program program{set(light(config, {0, 0, -1}))};
  for (int round = 0; round < 520; ++round) {
    const Quad quad = test::random_quad(random, config, 2 * ulps_per_entry(config));
    if (round % 40 == 0) program.push_back(put(std::span(&quad, 1), config));
    if (round % 51 == 0) {
      const std::vector<Item> voxels(3, quad[0]);
      program.push_back(resolve(voxels, config, 1, 0));
    }
    program.push_back(clear_lists());
  }
  for (Command& command : read_all(config)) program.push_back(command);
  TopologyBench<typename TypeParam::Model> bench(5);
  const Outcome want = expected(program, config);
  EXPECT_EQ(difference(bench.run(program), want), "");
  for (std::size_t i = want.results.size() - 256; i < want.results.size(); ++i)
    EXPECT_EQ(want.results[i] & 0x80000000u, 0u);
}

Program scene_program(const TopologyConfig& config, std::uint8_t flags) {
  const std::array<double, 3> direction = {0.4, 0.3, -0.85};
  Surface surface = sphere_over_ground(config);
  if ((flags & golden::topology::kSorted) != 0) sort_far_first(surface.quads, direction);
  return {set(light(config, direction, 1, 1000)), put(surface.quads, config),
          resolve(surface.voxels, config, flags, 1000)};
}

TEST(TopologyScene, ASphereThrowsItsShadow) {
  const TopologyConfig config = SceneBuild::config();
  for (const std::uint8_t flags : {std::uint8_t{0}, golden::topology::kSorted}) {
    const Program program = scene_program(config, flags);
    TopologyBench<Vtopology_scene> bench(6);
    const Outcome want = expected(program, config);
    EXPECT_EQ(difference(bench.run(program), want), "");
    EXPECT_EQ(want.results.size(), 61u * 61 + 105 * 53);
    EXPECT_GT(want.counters.hit, 400u);
    EXPECT_EQ(want.counters.nodes_dropped, 0u);
  }
}

TEST(TopologyScene, LongListsSaturateTheirCounts) {
  const TopologyConfig config = SceneBuild::config();
  const Item voxel = at(config, 8.75, 8.75, 2);
  Quad corner = square(config, 8, 8, 0.25, 20);  // the voxel's entry, but not its beam
  const std::vector<Quad> quads(4200, corner);
  const std::vector<Item> voxels(2, voxel);
  const Program program = {set(from_above(config)), put(quads, config), resolve(voxels, config, 0, 0)};
  TopologyBench<Vtopology_scene> bench(7);
  const Outcome got = bench.run(program);
  EXPECT_EQ(difference(got, expected(program, config)), "");
  ASSERT_EQ(got.results.size(), 2u);
  const auto result = decode_topology_result(got.results[0]);
  EXPECT_EQ(result.visited, 4095u);
  EXPECT_EQ(result.tested, 4095u);
  EXPECT_EQ(got.counters.nodes_visited, 8400u);
  EXPECT_EQ(got.counters.quads_tested, 8400u);
}

TEST(TopologyMutation, HeadsWithoutForwardingAreNoticed) {
  const TopologyConfig config = SceneBuild::config();
  const Program program = scene_program(config, 0);
  TopologyBench<Vtopology_no_forwarding> bench(8);
  EXPECT_NE(difference(bench.run(program), expected(program, config)), "");
}

TEST(TopologyMutation, TheComparisonSeesWordsCountersAndFlags) {
  const TopologyConfig config = SmallBuild::config();
  stimulus::Random random(9);
  const Outcome want = expected(random_program(random, config, 10), config);
  EXPECT_EQ(difference(want, want), "");
  Outcome other = want;
  other.results.back() ^= 1;
  EXPECT_NE(difference(other, want), "");
  other = want;
  other.results.pop_back();
  EXPECT_NE(difference(other, want), "");
  other = want;
  ++other.counters.quads_tested;
  EXPECT_NE(difference(other, want), "");
  other = want;
  other.sticky.list_overflow = !other.sticky.list_overflow;
  EXPECT_NE(difference(other, want), "");
}

}  // namespace
}  // namespace gnomon::rtl_test::topology
