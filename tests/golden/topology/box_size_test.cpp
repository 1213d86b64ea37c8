// SPDX-License-Identifier: Apache-2.0
// What the generators take a quad to cost is what golden counts.
#include "tests/support/box_size.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "tests/golden/topology/scenes.hpp"
#include "tests/support/perspective_registers.hpp"

namespace gnomon::golden_test {
namespace {

using golden::HardwareConfig;
using golden::topology::TopologyUnit;
using golden::topology::Word;

/// Compares quads under one light; returns how many of them meet the plane.
int compare_boxes(const HardwareConfig& config, const golden::topology::ProjectionRegisters& light,
                  stimulus::Random& random) {
  const auto topology = config.topology_config();
  TopologyUnit unit(topology);
  unit.set_registers(light);
  const auto nodes = [&] {
    return unit.lists().counters().nodes_linked + unit.lists().counters().nodes_dropped;
  };
  int on_plane = 0;
  for (int i = 0; i < 50; ++i) {
    const auto quad = test::random_quad(random, topology, 1 << random.between(0, 8));
    std::array<Word, 4> words{};
    std::transform(quad.begin(), quad.end(), words.begin(),
                   [&](const auto& corner) { return test::word_of(corner, topology); });
    const std::uint64_t before = nodes();
    unit.put(quad);
    const auto size = stimulus::box_size(words, light, topology);
    EXPECT_EQ(static_cast<std::uint64_t>(size), nodes() - before);
    on_plane += size > 0;
  }
  return on_plane;
}

TEST(BoxSize, IsTheNodesThatGoldenLinksOrDrops) {
  const HardwareConfig config{.plane_log2 = 6, .en_perspective = true, .en_vpu_topology = true};
  stimulus::Random random(5);
  int directional = 0, perspective = 0;
  for (int i = 0; i < 20; ++i) {
    const auto spot = stimulus::perspective_registers(config, random);
    const auto extreme = stimulus::extreme_perspective_registers(config, 20, random);
    for (const auto& registers : {spot, extreme})
      perspective += compare_boxes(config, stimulus::projection_registers(registers, config), random);
    auto light = stimulus::projection_registers(spot, config);
    const auto scene = stimulus::scene_registers(config, random);
    std::copy_n(scene.begin(), light.matrix.size(), light.matrix.begin());
    light.perspective.perspective = false;
    directional += compare_boxes(config, light, random);
  }
  EXPECT_GT(directional, 300);
  EXPECT_GT(perspective, 300);
}

}  // namespace
}  // namespace gnomon::golden_test
