// SPDX-License-Identifier: Apache-2.0
// The whole mode against the page in rationals, over random scenes, configurations and registers.
#include <gtest/gtest.h>

#include <gnomon/golden/topology/unit.hpp>

#include "reference.hpp"
#include "scenes.hpp"

namespace gnomon::test {
namespace {

using golden::topology::TopologyResult;
using golden::topology::TopologyUnit;

struct Tally {
  std::uint64_t compared = 0, shadow = 0, hit = 0, fallback = 0, off_plane = 0, uncertain = 0, visited = 0;
  void add(const TopologyResult& r) {
    ++compared;
    shadow += r.shadow ? 1U : 0U;
    hit += r.hit ? 1U : 0U;
    fallback += r.fallback ? 1U : 0U;
    off_plane += r.off_plane ? 1U : 0U;
    uncertain += r.uncertain ? 1U : 0U;
    visited += r.visited;
  }
};

/// Puts random quads, resolves random voxels, compares every answer and every list.
void compare(const TopologyConfig& config, std::uint64_t seed, int reach, Tally& tally) {
  stimulus::Random random(seed);
  const auto registers = seed % 3 == 0 ? from_above(config) : random_registers(random, config);
  TopologyUnit unit(config);
  unit.set_registers(registers);
  TopologyReference reference(config, registers);
  for (int i = 0; i < 60; ++i) {
    const Quad quad = random_quad(random, config, reach);
    unit.put(quad);
    reference.put(quad);
  }
  for (std::int64_t v = 0; v < config.side(); ++v)
    for (std::int64_t u = 0; u < config.side(); ++u) {
      const auto index = static_cast<std::size_t>(v * config.side() + u);
      ASSERT_EQ(unit.lists().list(index), reference.list(u, v));
      ASSERT_EQ(unit.lists().head(index), reference.head(u, v));
    }
  for (int i = 0; i < 120; ++i) {
    const Item voxel = random_item(random, config);
    const bool two_sided = random.chance(50), sorted = random.chance(30);
    const auto clearance = static_cast<std::uint32_t>(random.chance(50) ? 0 : random.between(0, 3000));
    const TopologyResult result = unit.resolve(voxel, two_sided, clearance, sorted);
    ASSERT_EQ(result, reference.resolve(voxel, two_sided, clearance, sorted)) << "seed " << seed;
    tally.add(result);
  }
}

TEST(TopologyStream, AnswersAreThoseOfThePage) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    TopologyConfig config = small_config();
    config.sub_bits = 2 + static_cast<int>(seed % 7);
    compare(config, seed, 8, tally);
  }
  EXPECT_EQ(tally.compared, 40U * 120U);
  EXPECT_GT(tally.hit, 300U);
  EXPECT_GT(tally.uncertain, tally.hit + 300U);
  EXPECT_GT(tally.off_plane, 50U);
  EXPECT_GT(tally.visited, 3000U);
}

TEST(TopologyStream, AlsoWhereNothingFits) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    TopologyConfig config = small_config();
    config.nodes_log2 = seed % 3 == 0 ? 8 : 12;
    config.quads_log2 = seed % 3 == 1 ? 5 : 10;
    config.span_log2 = seed % 3 == 2 ? 2 : 4;
    compare(config, 100 + seed, 16, tally);
  }
  EXPECT_EQ(tally.compared, 24U * 120U);
  EXPECT_GT(tally.fallback, 200U);
  EXPECT_GT(tally.hit, 60U);
}

TEST(TopologyStream, AlsoWithTheLargestAndSmallestParameters) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    TopologyConfig config = small_config();
    if (seed % 2 == 0) {
      config.voxel_frac_bits = 6;
      config.normal_bits = 11;
      config.matrix_frac_bits = 28;
      config.depth_bits = 24;
      config.sub_bits = 8;
      config.span_log2 = 6;
    } else {
      config.voxel_frac_bits = 0;
      config.normal_bits = 4;
      config.matrix_frac_bits = 12;
      config.depth_bits = 8;
      config.sub_bits = 2;
      config.span_log2 = 2;
    }
    compare(config, 200 + seed, seed % 2 == 0 ? 128 : 2, tally);
  }
  EXPECT_EQ(tally.compared, 10U * 120U);
}

}  // namespace
}  // namespace gnomon::test
