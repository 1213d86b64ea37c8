// SPDX-License-Identifier: Apache-2.0
// Cycles of the passes on a scene: a node linked a cycle, a node visited or a voxel taken a cycle.
#include <gtest/gtest.h>

#include <iostream>

#include "tests/rtl/topology/bench.hpp"
#include "tests/rtl/topology/builds.hpp"
#include "tests/rtl/topology/surfaces.hpp"

namespace gnomon::rtl_test::topology {
namespace {

constexpr double kCodes = 1000;  // a voxel

/// What the passes cost, and what the page says they do.
struct Cost {
  double put = 0, resolve = 0;  ///< cycles from the first word to the drain
  double put_bound = 0;         ///< a quad: a corner a cycle, an entry a cycle
  double resolve_bound = 0;     ///< a voxel: a cycle, and one for every node but the first
  TopologyCounters counters;
};

Cost measure(const Surface& surface, const ProjectionRegisters& registers, std::uint8_t flags) {
  const TopologyConfig config = SceneBuild::config();
  TopologyBench<Vtopology_scene> bench(1);
  const std::vector<Command> commands = {set(registers), put(surface.quads, config),
                                         resolve(surface.voxels, config, flags, kCodes)};
  Cost cost;
  bench.run(std::span(commands).first(1));
  const std::uint64_t start = bench.cycles();
  bench.run(std::span(commands).subspan(1, 1));
  cost.put = static_cast<double>(bench.cycles() - start);
  const Outcome outcome = bench.run(std::span(commands).subspan(2, 1));
  cost.resolve = static_cast<double>(bench.cycles() - start) - cost.put;
  cost.counters = outcome.counters;
  for (const Word word : outcome.results)
    cost.resolve_bound += std::max(1u, golden::topology::decode_topology_result(word).visited);
  for (const Quad& quad : surface.quads) {
    const Outcome alone =
        expected(std::vector<Command>{set(registers), put(std::span(&quad, 1), config)}, config);
    cost.put_bound += static_cast<double>(std::max<std::uint64_t>(4, alone.counters.nodes_linked));
  }
  return cost;
}

/// The voxels whose lists are walked.
std::vector<Item> uncertain_voxels(const Surface& surface, const ProjectionRegisters& registers) {
  const TopologyConfig config = SceneBuild::config();
  const Outcome outcome = expected(std::vector<Command>{set(registers), put(surface.quads, config),
                                                        resolve(surface.voxels, config, 0, kCodes)},
                                   config);
  std::vector<Item> voxels;
  for (std::size_t i = 0; i < surface.voxels.size(); ++i) {
    if (golden::topology::decode_topology_result(outcome.results[i]).uncertain)
      voxels.push_back(surface.voxels[i]);
  }
  return voxels;
}

const std::vector<std::array<double, 3>> kLights = {{0, 0, -1}, {0.4, 0.3, -0.85}, {0.8, 0.5, -0.25}};

TEST(TopologyThroughput, ASceneCostsWhatThePageSays) {
  for (const auto& direction : kLights) {
    for (const std::uint8_t flags : {std::uint8_t{0}, golden::topology::kSorted}) {
      Surface surface = sphere_over_ground(SceneBuild::config());
      if (flags != 0) sort_far_first(surface.quads, direction);
      const Cost cost = measure(surface, light(SceneBuild::config(), direction, 1, kCodes), flags);
      const TopologyCounters& c = cost.counters;
      std::cout << c.quads_put << " quads, " << c.nodes_linked << " nodes: " << cost.put << " cycles of "
                << cost.put_bound << "; " << c.resolved << " voxels, " << c.nodes_visited
                << " nodes visited, " << c.quads_tested << " quads tested: " << cost.resolve << " cycles of "
                << cost.resolve_bound << "\n";
      EXPECT_LE(cost.put, 1.01 * cost.put_bound);
      EXPECT_LE(cost.resolve, cost.resolve_bound);
    }
  }
}

TEST(TopologyThroughput, ANodeIsLinkedACycleWhereQuadsAreNotSmall) {
  const TopologyConfig config = SceneBuild::config();
  Surface ground = sphere_over_ground(config);
  ground.quads.resize(3600);
  ground.voxels.resize(1);
  const Cost cost = measure(ground, light(config, {0.1, 0.1, -1}, 2, kCodes), 0);
  const double cycles = cost.put / static_cast<double>(cost.counters.nodes_linked);
  std::cout << cycles << " cycles a node\n";
  EXPECT_LE(cycles, 1.01);
}

TEST(TopologyThroughput, AQuadIsTestedACycle) {
  for (const auto& direction : kLights) {
    const ProjectionRegisters registers = light(SceneBuild::config(), direction, 1, kCodes);
    Surface surface = sphere_over_ground(SceneBuild::config());
    sort_far_first(surface.quads, direction);
    surface.voxels = uncertain_voxels(surface, registers);
    for (const std::uint8_t flags : {std::uint8_t{0}, golden::topology::kSorted}) {
      const Cost cost = measure(surface, registers, flags);
      const auto visited = static_cast<double>(cost.counters.nodes_visited);
      const auto tested = static_cast<double>(cost.counters.quads_tested);
      std::cout << cost.counters.uncertain << " walks, " << visited << " nodes: " << cost.resolve / visited
                << " cycles a node, " << cost.resolve / tested << " a quad tested\n";
      EXPECT_LE(cost.resolve, 1.06 * visited);
    }
  }
}

}  // namespace
}  // namespace gnomon::rtl_test::topology
