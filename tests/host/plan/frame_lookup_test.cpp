// SPDX-License-Identifier: Apache-2.0
// With the frame buffer and without: the same states, whatever mode, light and voxels are asked for.
#include "host/plan/frame_lookup.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <gnomon/golden/golden_engine.hpp>
#include <map>
#include <numeric>
#include <set>

#include "cages.hpp"
#include "host/plan/topology_plan.hpp"
#include "host/voxel/voxelizer.hpp"

namespace gnomon::plan {
namespace {

using golden::StreamWriter;
using golden::VoxelState;
using golden::Word;
using testing::HasSubstr;

constexpr std::uint32_t kRes = 48;
const std::vector<bool> kTwoSided{false, true};
const Vec3 kLights[] = {{0.3, 0.2, -1}, {-0.7, 0.4, -0.6}, {0, 0, -1}};

/// A round body over a wavy sheet.
struct Scene {
  voxel::VoxelSet voxels;
  voxel::CastingQuads casting;
  std::vector<std::uint32_t> all;
};

const Scene& scene() {
  static const Scene kScene = [] {
    Scene scene;
    std::vector<surface::LimitSurface> surfaces;
    const Mat4 up = Mat4().setScale(9.0) * Mat4().setTranslation(Vec3(24, 24, 32));
    const Mat4 down = Mat4().setScale(Vec3(40, 40, 5)) * Mat4().setTranslation(Vec3(4, 4, 9));
    surfaces.push_back(std::move(*surface::LimitSurface::build(test::torus(5, 4), up)));
    surfaces.push_back(std::move(*surface::LimitSurface::build(test::sheet(4, 3), down)));
    voxel::Grid grid;
    grid.res = kRes;
    voxel::VoxelizerOptions options;
    options.subpatches = true;
    scene.voxels = voxel::voxelize(surfaces, grid, options).value();
    scene.casting = voxel::casting_quads(surfaces, scene.voxels);
    scene.all.resize(scene.voxels.voxels.size());
    std::iota(scene.all.begin(), scene.all.end(), 0U);
    return scene;
  }();
  return kScene;
}

struct Outcome {
  std::vector<Word> results;
  std::map<std::string, std::uint64_t> events;
};

class Machine {
 public:
  explicit Machine(const golden::HardwareConfig& config) : engine_(golden::make_golden_engine(config)) {}
  Outcome run(std::span<const Word> words) {
    engine_->submit(words);
    Outcome run;
    engine_->drain(
        [&](std::span<const Word> some) { run.results.insert(run.results.end(), some.begin(), some.end()); });
    run.events = engine_->counters().events;
    return run;
  }

 private:
  std::unique_ptr<golden::Engine> engine_;
};

std::vector<VoxelState> answers(const FrameLookup& lookup, std::span<const Word> results) {
  const FrameLookup* one[] = {&lookup};
  return frame_states(results, one).value().front();
}

/// Lights 0.. of topology mode: states without the frame buffer.
std::vector<std::vector<VoxelState>> plain_topology() {
  std::vector<std::vector<VoxelState>> states;
  for (const Vec3& light : kLights) {
    const TopologyPlan plan = plan_topology(scene().voxels, scene().casting.quads, light, {}).value();
    Machine machine(plan.vpu.config);
    const Outcome run = machine.run(topology_stream(plan, scene().voxels, kTwoSided));
    auto& of_light = states.emplace_back();
    const auto results = topology_results(run.results, scene().all.size()).value();
    for (const auto& result : results)
      of_light.push_back(result.shadow ? VoxelState::Shadow : VoxelState::Lit);
  }
  return states;
}

/// One plane for every light, as a run has it.
TopologySettings one_hardware() {
  TopologySettings settings;
  settings.plane_log2 = 7;
  settings.nodes_log2 = 17;
  settings.quads_log2 = 15;
  return settings;
}

struct Kept {
  golden::HardwareConfig config;
  Machine machine;
  Outcome run;
};

/// All lights of topology mode into layers of their own, states kept and no result words but the last fence.
Kept kept_topology() {
  const auto plan = [](const Vec3& light) {
    return plan_topology(scene().voxels, scene().casting.quads, light, one_hardware()).value();
  };
  const golden::HardwareConfig config =
      with_frame_buffer(plan(kLights[0]).vpu.config, std::size(kLights)).value();
  StreamWriter writer(config);
  writer.clear_frame();
  for (std::uint32_t light = 0; light < std::size(kLights); ++light) {
    writer.keep(golden::Keeping{.layer = light});
    write_topology(writer, config, plan(kLights[light]), scene().voxels, scene().all, kTwoSided);
  }
  writer.fence(0, false);
  Kept kept{config, Machine(config), {}};
  kept.run = kept.machine.run(writer.take());
  return kept;
}

TEST(FrameLookup, TopologyStatesOfSeveralLightsAreThoseWithoutIt) {
  const auto expected = plain_topology();
  Kept kept = kept_topology();
  EXPECT_EQ(kept.config.frame_layers_log2, 2);
  EXPECT_EQ(kept.run.results.size(), 1u) << "the fence alone";
  const FrameLookup lookup(scene().voxels, scene().all, kept.config);
  std::size_t compared = 0, shadows = 0;
  for (std::uint32_t light = 0; light < std::size(kLights); ++light) {
    StreamWriter writer(kept.config);
    lookup.write(writer, light);
    const std::vector<VoxelState> states = answers(lookup, kept.machine.run(writer.take()).results);
    EXPECT_EQ(states, expected[light]) << "light " << light;
    compared += states.size();
    for (const VoxelState state : states) shadows += state == VoxelState::Shadow ? 1U : 0U;
  }
  EXPECT_EQ(compared, 3 * scene().all.size());
  EXPECT_GT(shadows, compared / 10);
  EXPECT_LT(shadows, compared / 2);
}

TEST(FrameLookup, OffsetStatesAreThoseWithoutIt) {
  const VpuPlan plan = plan_vpu(scene().voxels, kLights[0], {}).value();
  const std::vector<golden::VoxelItem> items = voxel_items(scene().voxels, plan.config);
  Machine plain(plan.config);
  const Outcome without = plain.run(vpu_stream(plan, scene().voxels, kTwoSided));
  const auto results = voxel_results(without.results, items.size()).value();
  std::vector<VoxelState> expected;
  expected.reserve(results.size());
  for (const auto& result : results) expected.push_back(result.state);

  const golden::HardwareConfig config = with_frame_buffer(plan.config, 1).value();
  const FrameLookup lookup(scene().voxels, scene().all, config);
  StreamWriter writer(config);
  writer.clear_frame();
  writer.keep(golden::Keeping{});
  write_vpu(writer, config, plan, scene().voxels, all_voxels(scene().voxels), kTwoSided);
  lookup.write(writer, 0);
  Machine machine(config);
  const Outcome run = machine.run(writer.take());
  EXPECT_EQ(answers(lookup, run.results), expected);
  EXPECT_EQ(run.results.size(), lookup.words());
  EXPECT_EQ(run.events.at("FRAME_KEPT"), items.size());
  EXPECT_EQ(run.events.at("FRAME_OVERWRITTEN"), 0u) << "voxels are unique";
}

TEST(FrameLookup, ACamerasFrameCostsLookupsAlone) {
  Kept kept = kept_topology();
  const auto expected = plain_topology();
  for (std::uint32_t frame = 1; frame <= 3; ++frame) {
    std::vector<std::uint32_t> visible;
    for (const std::uint32_t v : scene().all)
      if (scene().voxels.voxels[v].x * frame % 7 < 3) visible.push_back(v);
    const FrameLookup lookup(scene().voxels, visible, kept.config);
    StreamWriter writer(kept.config);
    lookup.write(writer, 1);
    const Outcome run = kept.machine.run(writer.take());
    const std::vector<VoxelState> states = answers(lookup, run.results);
    ASSERT_EQ(states.size(), visible.size());
    for (std::size_t i = 0; i < visible.size(); ++i) ASSERT_EQ(states[i], expected[1][visible[i]]);
    for (const auto& [name, count] : run.events) {
      if (name == "COMMANDS" || name == "FRAME_BRICKS") continue;
      EXPECT_EQ(count, kept.run.events.at(name)) << name << " in frame " << frame;
    }
  }
}

TEST(FrameLookup, AsksForEachBrickOnce) {
  const golden::HardwareConfig config = with_frame_buffer({.voxel_bits = 6}, 1).value();
  const FrameLookup lookup(scene().voxels, scene().all, config);
  std::set<std::array<int, 3>> bricks;
  for (const voxel::Voxel& v : scene().voxels.voxels) bricks.insert({v.x / 4, v.y / 4, v.z / 4});
  EXPECT_EQ(lookup.bricks(), bricks.size());
  EXPECT_EQ(lookup.words(), 3 * bricks.size());
  EXPECT_EQ(lookup.voxels(), scene().all.size());
  const FrameLookup none(scene().voxels, {}, config);
  StreamWriter writer(config);
  none.write(writer, 0);
  EXPECT_TRUE(writer.words().empty());
}

TEST(FrameLookup, WhatIsTooLargeIsRefused) {
  EXPECT_EQ(with_frame_buffer({.voxel_bits = 8}, 0)->frame_layers_log2, 0);
  EXPECT_EQ(with_frame_buffer({.voxel_bits = 8}, 5)->frame_layers_log2, 3);
  golden::HardwareConfig large;
  large.voxel_bits = 11;
  large.voxel_frac_bits = 2;
  EXPECT_TRUE(with_frame_buffer(large, 1).has_value());
  EXPECT_EQ(
      with_frame_buffer(large, 2).error().message,
      "frame_buffer=on would take 4 GiB of states for 2 lights at 2048^3 voxels; it holds at most 2 GiB "
      "and 8 lights: set frame_buffer=off, or a smaller res");
  EXPECT_THAT(with_frame_buffer({.voxel_bits = 4}, 9).error().message, HasSubstr("for 9 lights at 16^3"));
}

TEST(FrameLookup, MissingAndRefusedAnswersAreErrors) {
  const golden::HardwareConfig config = with_frame_buffer({.voxel_bits = 6}, 1).value();
  const FrameLookup lookup(scene().voxels, std::vector<std::uint32_t>{0}, config);
  const FrameLookup* one[] = {&lookup};
  const Word states = 0x3118'0000'0000'0000;
  EXPECT_EQ(frame_states(std::vector<Word>{states, states}, one).error().message,
            "the hardware returned 2 words of states, expected 3");
  EXPECT_EQ(frame_states(std::vector<Word>(4, states), one).error().message,
            "the hardware returned 4 words of states, expected 3");
  const Word error = golden::encode(golden::ErrorResult{2, 7});
  EXPECT_THAT(frame_states(std::vector<Word>{error}, one).error().message,
              HasSubstr("refused a command: ERROR FEATURE_ABSENT"));
  EXPECT_TRUE(
      frame_states(std::vector<Word>{golden::encode(golden::FenceResult{}), states, states, states}, one));
}

}  // namespace
}  // namespace gnomon::plan
