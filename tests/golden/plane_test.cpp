// SPDX-License-Identifier: Apache-2.0
// What the plane keeps: the nearest depth, in any order, since the last clear.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <gnomon/golden/stream.hpp>

#include "tests/golden/cases.hpp"
#include "tests/golden/run_stream.hpp"

namespace gnomon::golden_test {
namespace {

using golden::HardwareConfig;
using golden::Register;
using golden::StreamWriter;
using golden::VoxelItem;

/// u = x, v = y, depth = z.
StreamWriter identity_writer(const HardwareConfig& config) {
  StreamWriter writer(config);
  const std::int64_t one = std::int64_t{1} << config.matrix_frac_bits;
  writer.set_register(Register::MatrixUx, one);
  writer.set_register(Register::MatrixVy, one);
  writer.set_register(Register::MatrixDz, std::int64_t{1} << (config.position_bits() + 4));
  return writer;
}

RC_GTEST_PROP(PlaneProperty, NearestDepthDoesNotDependOnOrder, (std::uint64_t seed)) {
  const Case c = any_case(seed, Content::Scene, 100);
  auto order = c.items;
  stimulus::Random random(seed + 1);
  for (std::size_t i = order.size(); i > 1; --i) {
    std::swap(order[i - 1],
              order[static_cast<std::size_t>(random.between(0, static_cast<std::int64_t>(i) - 1))]);
  }
  const auto plane = [&](const std::vector<VoxelItem>& items) {
    StreamWriter writer(c.config);
    writer.set_registers(Register::MatrixUx, c.registers);
    writer.project(items);
    return run(c.config, writer.words()).plane;
  };
  RC_ASSERT(plane(order) == plane(c.items));
}

/// An entry holds a depth and nothing else, so of two equal depths it cannot be seen which one stayed, but
/// for this: the later one does not count as a write.
TEST(Plane, ATieIsNotAWrite) {
  const HardwareConfig config;
  const VoxelItem near{{5, 6, 7}, {}}, far{{5, 6, 8}, {}};
  const auto writes = [&](std::vector<VoxelItem> items) {
    StreamWriter writer = identity_writer(config);
    writer.project(items);
    const Outcome outcome = run(config, writer.words());
    EXPECT_EQ(outcome.plane[6 * 512 + 5], 7u);
    return outcome.events.at("PLANE_WRITES");
  };
  EXPECT_EQ(writes({near, near, near}), 1u);
  EXPECT_EQ(writes({far, near, near}), 2u);
  EXPECT_EQ(writes({near, far, near}), 1u);
}

TEST(Plane, TheFarthestCodeIsStillNearerThanEmpty) {
  for (const int depth_bits : {8, 24}) {
    const HardwareConfig config{.depth_bits = depth_bits};
    StreamWriter writer = identity_writer(config);
    const std::int64_t code = std::int64_t{1} << (config.position_bits() + 4);
    writer.set_register(Register::MatrixD1, code << depth_bits);
    writer.project(std::vector<VoxelItem>{{{0, 0, 0}, {}}});
    const Outcome outcome = run(config, writer.words());
    EXPECT_EQ(outcome.plane[0], (1u << depth_bits) - 2);
    EXPECT_EQ(outcome.events.at("PROJECT_SATURATED"), 1u);
    EXPECT_EQ(outcome.events.at("PLANE_WRITES"), 1u);
    EXPECT_EQ(outcome.plane[1], golden::kEmpty);
  }
}

/// Longer than any epoch or generation counter.
TEST(Plane, ManyClearsForgetEverything) {
  const HardwareConfig config{.plane_log2 = 4};
  StreamWriter writer = identity_writer(config);
  for (std::uint32_t i = 0; i < 1100; ++i) {
    const VoxelItem item{{i % 16, i / 16 % 16, i % 7}, {}};
    writer.project(std::vector<VoxelItem>{item});
    writer.read_plane(i % 256, 1);
    writer.clear_plane();
    writer.read_plane(i % 256, 1);
  }
  const Outcome outcome = run(config, writer.words());
  ASSERT_EQ(outcome.results.size(), 2200u);
  for (std::uint32_t i = 0; i < 1100; ++i) {
    const auto before = golden::decode_plane_entry_result(outcome.results[std::size_t{2} * i]);
    const auto after = golden::decode_plane_entry_result(outcome.results[std::size_t{2} * i + 1]);
    ASSERT_TRUE(before.present);
    ASSERT_EQ(before.depth, i % 7);
    ASSERT_FALSE(after.present);
    ASSERT_EQ(after.depth, 0u);
  }
  EXPECT_EQ(std::ranges::count(outcome.plane, golden::kEmpty), 256);
}

}  // namespace
}  // namespace gnomon::golden_test
