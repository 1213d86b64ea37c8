// SPDX-License-Identifier: Apache-2.0
// Single situations in perspective with answers worked out by hand: behind, too near, outside the cone, on
// its edge, facing, off the plane, saturated; errors, flags and counters.
#include <gtest/gtest.h>

#include <gnomon/golden/stream.hpp>

#include "tests/golden/run_stream.hpp"
#include "tests/support/perspective_registers.hpp"

namespace gnomon::golden_test {
namespace {

using golden::ErrorCode;
using golden::HardwareConfig;
using golden::Op;
using golden::Register;
using golden::StreamWriter;
using golden::VoxelItem;
using golden::VoxelResult;
using golden::VoxelState;
using golden::Word;

const HardwareConfig kHardware{.en_perspective = true};  // P = 10, f = 22, D = 20, p = 9
constexpr std::int64_t kLight = 99;                      // ulps

/// A light at (512, 512, 99) that looks along +z; w = (z - 99) / 1024, 256 entries per unit of slope, and
/// depth code 2^19 (1 - 512 / (8 (z - 99))).
StreamWriter looking_up(std::int64_t projection = golden::kProjectionPerspective) {
  StreamWriter writer(kHardware);
  const std::int64_t one = std::int64_t{1} << kHardware.matrix_frac_bits;
  const std::int64_t unit = one << kHardware.position_bits();
  writer.set_register(Register::Projection, projection);
  writer.set_register(Register::MatrixWz, unit / 1024);
  writer.set_register(Register::MatrixW1, -kLight * unit / 1024);
  writer.set_register(Register::MatrixUx, one / 4);  // 256 entries / 1024
  writer.set_register(Register::MatrixU1, -512 * one / 4);
  writer.set_register(Register::MatrixVy, one / 4);
  writer.set_register(Register::MatrixV1, -512 * one / 4);
  writer.set_register(Register::CentreU, 256);
  writer.set_register(Register::CentreV, 256);
  writer.set_register(Register::KeyLimit, std::int64_t{1} << 23);
  writer.set_register(Register::KeyScale, std::int64_t{1} << 19);
  writer.set_register(Register::LightX, 8 * 512 + 4);
  writer.set_register(Register::LightY, 8 * 512 + 4);
  writer.set_register(Register::LightZ, 8 * kLight + 4);
  return writer;
}

std::vector<VoxelResult> resolve(StreamWriter& writer, const std::vector<VoxelItem>& items,
                                 bool two_sided = false) {
  writer.resolve(items, two_sided);
  std::vector<VoxelResult> results;
  for (const Word word : run(kHardware, writer.words()).results)
    results.push_back(golden::decode_voxel_result(word));
  return results;
}

VoxelItem at(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  return {{x, y, z}, {0, 0, -255}};
}

TEST(PerspectiveSemantics, BehindIsShadowAndIsNotProjected) {
  StreamWriter writer = looking_up();
  const auto results =
      resolve(writer, {at(512, 512, 0), at(512, 512, 98), at(512, 512, 99), at(512, 512, 100)});
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(results[i], (VoxelResult{.state = VoxelState::Shadow, .behind = true}));
  EXPECT_EQ(results[3], VoxelResult{}) << "one ulp in front";
  EXPECT_EQ(golden::encode(results[0]), Word{0x1183FFFFFF000000});

  StreamWriter project = looking_up();
  project.project(std::vector{at(512, 512, 0), at(512, 512, 99), at(512, 512, 100), at(512, 512, 200)});
  project.fence(7, true);
  project.fence(8, false);
  const Outcome outcome = run(kHardware, project.words());
  EXPECT_EQ(outcome.events.at("VOXELS_PROJECTED"), 4u);
  EXPECT_EQ(outcome.events.at("PROJECT_BEHIND"), 2u);
  EXPECT_EQ(outcome.events.at("PROJECT_OFF_PLANE"), 0u);
  EXPECT_EQ(outcome.events.at("PROJECT_SATURATED"), 1u) << "nearer than KEY_LIMIT allows";
  EXPECT_EQ(golden::decode_fence_result(outcome.results[0]).sticky,
            golden::kStickyBehindLight | golden::kStickyDepthSaturated);
  EXPECT_EQ(golden::decode_fence_result(outcome.results[1]).sticky, 0u);
}

TEST(PerspectiveSemantics, WNearMovesTheBorder) {
  StreamWriter writer = looking_up();
  writer.set_register(Register::WNear, 10);  // 2^-10 each: here so many position ulps
  const auto results = resolve(writer, {at(512, 512, 108), at(512, 512, 109)});
  EXPECT_TRUE(results[0].behind);
  EXPECT_FALSE(results[1].behind);
}

TEST(PerspectiveSemantics, PlacesAndDepthsAreThoseOfADivision) {
  // 100 ulps to the side at w = 1/4: 256 * 100 / 256 entries; at w = 1/2: half of that.
  StreamWriter writer = looking_up();
  writer.project(std::vector{at(612, 512, kLight + 256), at(612, 412, kLight + 512)});
  const Outcome outcome = run(kHardware, writer.words());
  const auto entry = [&](std::size_t u, std::size_t v) { return outcome.plane[v * 512 + u]; };
  // The reciprocal is a little small, so that what should be a whole entry falls just below it.
  EXPECT_EQ(entry(256 + 99, 256), (1u << 19) - (1u << 17) + 0u);
  EXPECT_EQ(entry(256 + 49, 256 - 50), (1u << 19) - (1u << 16) + 0u);
}

TEST(PerspectiveSemantics, TheConeHasAHardEdge) {
  for (const std::int64_t more : {-1, 0}) {
    StreamWriter writer = looking_up(golden::kProjectionPerspective | golden::kProjectionCone);
    // Radius 50 entries less what the floors take: x_u of 100 ulps at w = 1/2 is 49 + 255/256.
    const std::int64_t edge = (std::int64_t{50} << 8) - 1;
    writer.set_register(Register::ConeSquared, edge * edge + more);
    const auto results = resolve(writer, {at(612, 512, kLight + 512), at(613, 512, kLight + 512),
                                          at(611, 512, kLight + 512), at(612, 512, kLight - 1)});
    EXPECT_EQ(results[0].outside_cone, more < 0) << "on the edge is inside";
    EXPECT_EQ(results[1], (VoxelResult{.state = VoxelState::Shadow, .outside_cone = true}));
    EXPECT_EQ(golden::encode(results[1]), Word{0x1181FFFFFF000000});
    EXPECT_EQ(results[2], VoxelResult{});
    EXPECT_TRUE(results[3].behind && !results[3].outside_cone);
  }
  StreamWriter writer = looking_up();
  EXPECT_EQ(resolve(writer, {at(612, 512, kLight + 512)})[0], VoxelResult{}) << "no cone, no edge";
}

/// Two voxels with one normal, on either side of the light: one looks at it, one away.
TEST(PerspectiveSemantics, FacingIsByTheLightsPosition) {
  StreamWriter writer = looking_up();
  const VoxelItem left{{400, 512, 600}, {200, 0, 0}}, right{{600, 512, 600}, {200, 0, 0}};
  const auto results = resolve(writer, {left, right});
  EXPECT_EQ(results[0], VoxelResult{});
  EXPECT_EQ(results[1], (VoxelResult{.state = VoxelState::Shadow, .facing_away = true}));
  StreamWriter both = looking_up();
  const VoxelItem across{{512, 512, 600}, {0, 200, 0}};  // the beam is in the surface
  const auto two_sided = resolve(both, {left, right, across}, true);
  EXPECT_EQ(two_sided[0], VoxelResult{});
  EXPECT_EQ(two_sided[1], VoxelResult{});
  EXPECT_TRUE(two_sided[2].facing_away);
}

TEST(PerspectiveSemantics, AnythingNearerOnTheBeamShades) {
  StreamWriter writer = looking_up();
  writer.project(std::vector{at(562, 512, kLight + 256)});
  // Twice as far and twice as far to the side: the same beam, into the middle of the same entry's neighbours.
  const auto results =
      resolve(writer, {at(612, 512, kLight + 512), at(614, 512, kLight + 512), at(537, 512, kLight + 128)});
  EXPECT_TRUE(results[0].uncertain);
  EXPECT_EQ(results[0].state, VoxelState::Shadow);
  EXPECT_TRUE(results[0].beyond_max) << "DELTA_MAX is 0";
  EXPECT_EQ(results[1].state, VoxelState::Lit) << "the next entry";
  EXPECT_EQ(results[2].state, VoxelState::Lit) << "nearer than the caster";
}

/// DELTA_MAX is a share of KEY_SCALE / w.
TEST(PerspectiveSemantics, TheClampGrowsTowardsTheLight) {
  for (const std::uint32_t distance : {128u, 512u}) {
    StreamWriter writer = looking_up();
    writer.set_register(Register::MarginSquared, 0xFFFFFF);
    writer.set_register(Register::DeltaMax, 1 << 14);  // 1/64 of h
    const std::uint32_t z = kLight + distance;
    writer.project(std::vector{at(512, 512, z)});
    std::vector<VoxelItem> items;
    for (std::uint32_t behind = 1; behind < distance / 8; ++behind) items.push_back(at(512, 512, z + behind));
    const auto results = resolve(writer, items);
    // A voxel b ulps behind has the delta h b / distance: up to distance / 64 the margin decides.
    for (std::size_t i = 0; i < results.size(); ++i) {
      const std::size_t behind = i + 1;
      if (behind == distance / 64) continue;  // on the limit, up to rounding
      EXPECT_EQ(results[i].beyond_max, behind > distance / 64) << distance << " " << results[i].delta;
    }
    EXPECT_EQ(results.size(), distance / 8 - 1);
  }
}

TEST(PerspectiveSemantics, OffPlaneIsLitUnlessUnreached) {
  StreamWriter writer = looking_up();
  const VoxelResult off{.off_plane = true};
  EXPECT_EQ(resolve(writer, {at(1000, 512, kLight + 20)})[0], off);
  StreamWriter cone = looking_up(3);
  EXPECT_EQ(resolve(cone, {at(1000, 512, kLight + 20)})[0],
            (VoxelResult{.state = VoxelState::Shadow, .off_plane = true, .outside_cone = true}));
}

TEST(PerspectiveSemantics, CountersAndErrors) {
  StreamWriter writer = looking_up(3);
  writer.resolve(std::vector{at(512, 512, 0), at(600, 512, 300), at(512, 512, 300)}, false);
  const Outcome outcome = run(kHardware, writer.words());
  EXPECT_EQ(outcome.events.at("RESOLVED_BEHIND"), 1u);
  EXPECT_EQ(outcome.events.at("RESOLVED_OUTSIDE_CONE"), 1u);
  EXPECT_EQ(outcome.events.at("RESOLVED_SHADOW"), 2u);
  EXPECT_EQ(outcome.events.at("RESOLVED_FACING_AWAY"), 0u);
  EXPECT_FALSE(run({}, {}).events.contains("PROJECT_BEHIND"));
  // All 32 registers, and the last alone, are there; on hardware without perspective nothing is written.
  const auto all = command({static_cast<std::uint8_t>(Op::SetRegisters), 0, 32, 0}, std::vector<Word>(32, 1));
  EXPECT_TRUE(run(kHardware, all).results.empty());
  const Outcome refused = run({}, all);
  ASSERT_EQ(refused.results.size(), 1u);
  EXPECT_EQ(golden::decode_error_result(refused.results[0]).error,
            static_cast<std::uint8_t>(ErrorCode::FeatureAbsent));
  StreamWriter plain{HardwareConfig{}};
  EXPECT_THROW(plain.set_register(Register::Projection, 1), std::out_of_range);
}

}  // namespace
}  // namespace gnomon::golden_test
