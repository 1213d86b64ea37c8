// SPDX-License-Identifier: Apache-2.0
// Topology mode from scene to states: against exact rays, against the method in double, and its stream.
#include <gtest/gtest.h>

#include <cmath>
#include <gnomon/golden/topology/beam_test.hpp>
#include <map>
#include <numeric>

#include "cages.hpp"
#include "host/metrics/shadow_error.hpp"
#include "host/metrics/shadow_truth.hpp"
#include "host/plan/topology_double.hpp"
#include "host/plan/topology_plan.hpp"
#include "host/voxel/voxelizer.hpp"
#include "tests/host/metrics/fixtures.hpp"
#include "tests/host/plan/topology_run.hpp"
#include "tests/support/random.hpp"

namespace gnomon::plan {
namespace {

using golden::VoxelState;
using golden::topology::TopologyResult;

constexpr std::uint32_t kRes = 64;
const std::vector<bool> kTwoSided{false, true};

/// A round body over a wavy sheet.
struct Scene {
  std::vector<surface::LimitSurface> surfaces;
  voxel::VoxelSet voxels;
  voxel::CastingQuads casting;
};

/// Voxels and quads of the surfaces.
void fill(Scene& scene) {
  voxel::Grid grid;
  grid.res = kRes;
  voxel::VoxelizerOptions options;
  options.subpatches = true;
  scene.voxels = voxel::voxelize(scene.surfaces, grid, options).value();
  scene.casting = voxel::casting_quads(scene.surfaces, scene.voxels);
}

Scene make_scene() {
  Scene scene;
  const Mat4 up = Mat4().setScale(14.0) * Mat4().setTranslation(Vec3(32, 32, 42));
  const Mat4 down = Mat4().setScale(Vec3(54, 54, 6)) * Mat4().setTranslation(Vec3(5, 5, 12));
  scene.surfaces.push_back(std::move(*surface::LimitSurface::build(test::torus(5, 4), up)));
  scene.surfaces.push_back(std::move(*surface::LimitSurface::build(test::sheet(4, 3), down)));
  fill(scene);
  return scene;
}
const Scene& scene() {
  static const Scene kScene = make_scene();
  return kScene;
}

/// A box over the same sheet.
const Scene& walls() {
  static const Scene kScene = [] {
    Scene scene;
    const Mat4 down = Mat4().setScale(Vec3(54, 54, 6)) * Mat4().setTranslation(Vec3(5, 5, 12));
    scene.surfaces.push_back(std::move(*surface::LimitSurface::build(
        fixtures::box({22.9, 22.9, 25.3}, {42.05, 42.05, 55.3}, true), Mat4())));
    scene.surfaces.push_back(std::move(*surface::LimitSurface::build(test::sheet(4, 3), down)));
    fill(scene);
    return scene;
  }();
  return kScene;
}

TopologyPlan plan_of(const Vec3& light, const TopologySettings& settings = {}) {
  return plan_topology(scene().voxels, scene().casting.quads, light, settings).value();
}
test::TopologyRun run(const TopologyPlan& plan) {
  return test::run_topology(plan, scene().voxels, kTwoSided);
}
std::vector<VoxelState> states(std::span<const TopologyResult> results) {
  std::vector<VoxelState> out;
  for (const auto& r : results) out.push_back(r.shadow ? VoxelState::Shadow : VoxelState::Lit);
  return out;
}

const std::vector<Vec3> kLights = {{0, 0, -1}, {0.4, 0.45, -1}, {1, -0.3, -0.5}};

TEST(Topology, AgreesWithExactRays) {
  std::uint64_t compared = 0, shadow = 0;
  for (const Vec3& light : kLights) {
    const metrics::ExactReference reference(scene().surfaces, kTwoSided, metrics::DirectionalLight{light});
    const auto truth = metrics::shadow_truth(reference, scene().surfaces, scene().voxels);
    const auto wrong = [&](std::span<const VoxelState> answers) {
      return metrics::shadow_errors(truth, scene().voxels, answers, {}).unambiguous_voxels.models;
    };
    for (const auto& [bits, limit] : std::map<int, double>{{0, 0.0015}, {2, 0.0004}, {4, 0.0001}}) {
      TopologySettings settings;
      settings.voxel_frac_bits = bits;
      const auto plan = plan_of(light, settings);
      const auto answers = run(plan);
      EXPECT_EQ(answers.results.size(), scene().voxels.voxels.size());
      EXPECT_LE(wrong(states(answers.results)).share(), limit) << bits << " fraction bits";
      EXPECT_LE(answers.events.at("QUADS_TESTED"), 6 * answers.events.at("TOPOLOGY_UNCERTAIN"));
      EXPECT_EQ(answers.events.at("TOPOLOGY_FALLBACK"), 0U);
      EXPECT_EQ(answers.sticky, 0U);
      shadow += answers.events.at("TOPOLOGY_HIT");
    }
    const auto quads = voxel::limit_quads(scene().surfaces, scene().voxels);
    const auto exact = topology_states_double(plan_of(light), scene().voxels, quads,
                                              all_voxels(scene().voxels).receivers, kTwoSided);
    EXPECT_LE(wrong(exact.states).share(), 0.00005);
    compared += wrong(exact.states).compared;
  }
  EXPECT_GT(compared, 10000U);
  EXPECT_GT(shadow, 2000U);
}

TEST(Topology, OrderOfListsDoesNotChangeAState) {
  TopologySettings settings;
  settings.sorted = false;
  for (const Vec3& light : kLights) {
    const auto sorted = run(plan_of(light)), unsorted = run(plan_of(light, settings));
    EXPECT_EQ(states(sorted.results), states(unsorted.results));
    EXPECT_EQ(sorted.events.at("TOPOLOGY_UNCERTAIN"), unsorted.events.at("TOPOLOGY_UNCERTAIN"));
    EXPECT_EQ(sorted.events.at("NODES_LINKED"), unsorted.events.at("NODES_LINKED"));
    EXPECT_LT(sorted.events.at("NODES_VISITED"), unsorted.events.at("NODES_VISITED"));
    EXPECT_LE(sorted.events.at("NODES_VISITED"), sorted.events.at("QUADS_TESTED") +
                                                     sorted.events.at("TOPOLOGY_UNCERTAIN") -
                                                     sorted.events.at("TOPOLOGY_HIT"));
  }
}

TEST(Topology, OrderOfQuadsChangesNothingButTheirNumbers) {
  TopologySettings by_tile;
  by_tile.order = ItemOrder::Tile;
  std::uint64_t hits = 0;
  for (const Vec3& light : kLights) {
    const TopologyPlan given = plan_of(light), moved = plan_of(light, by_tile);
    EXPECT_TRUE(std::ranges::is_permutation(given.quads, moved.quads));
    EXPECT_NE(given.quads, moved.quads);
    auto expected = run(given), found = run(moved);
    EXPECT_EQ(found.events, expected.events) << "as many nodes are visited, as many quads tested";
    ASSERT_EQ(found.results.size(), expected.results.size());
    for (std::size_t i = 0; i < found.results.size(); ++i) {
      TopologyResult &a = expected.results[i], &b = found.results[i];
      if (a.hit && b.hit) {
        EXPECT_EQ(given.quads[a.quad], moved.quads[b.quad]);
        b.quad = a.quad;
        ++hits;
      }
      EXPECT_EQ(a, b);
    }
  }
  EXPECT_GT(hits, 500U);
}

TEST(Topology, HitsNameAQuadThatIsInFront) {
  const Vec3& light = kLights[1];
  const auto plan = plan_of(light);
  const auto answers = run(plan);
  std::uint64_t checked = 0;
  for (std::size_t i = 0; i < answers.results.size(); ++i) {
    if (!answers.results[i].hit) continue;
    const auto& quad = plan.quads.at(answers.results[i].quad);
    const auto& voxel = scene().voxels.voxels[i];
    const Vec3 beam = light.normalized();
    for (const std::uint32_t c : quad) {
      const auto& corner = scene().voxels.voxels[c];
      const Vec3 apart(corner.x - voxel.x, corner.y - voxel.y, corner.z - voxel.z);
      EXPECT_LT(apart.dot(beam), 0);
      EXPECT_LT((apart - beam * apart.dot(beam)).length(), 5);
      ++checked;
    }
  }
  EXPECT_GT(checked, 1000U);
}

TEST(Topology, PoolsHoldTheScene) {
  const auto plan = plan_of(kLights[1]);
  const std::uint64_t nodes =
      std::accumulate(plan.list_length.begin(), plan.list_length.end(), std::uint64_t{0});
  EXPECT_EQ(run(plan).events.at("NODES_LINKED"), nodes);
  EXPECT_LE(nodes, std::uint64_t{1} << plan.vpu.config.nodes_log2);
  EXPECT_GT(2 * nodes, std::uint64_t{1} << plan.vpu.config.nodes_log2);
  EXPECT_EQ(plan.quads.size() + plan.edge_on, scene().casting.quads.size());
}

/// Walls along the light are many quads in few lists, and no beam meets one.
TEST(Topology, QuadsEdgeOnToTheLightAreLeftOutAndMissed) {
  const Scene& s = walls();
  TopologySettings settings;
  settings.sorted = false;
  settings.nodes_log2 = settings.quads_log2 = 17;
  const TopologyPlan plan = plan_topology(s.voxels, s.casting.quads, Vec3(0, 0, -1), settings).value();
  EXPECT_GT(plan.edge_on, s.casting.quads.size() / 3);
  TopologyPlan with_all = plan;
  with_all.quads = s.casting.quads;
  const auto without = test::run_topology(plan, s.voxels, {false, true});
  const auto with = test::run_topology(with_all, s.voxels, {false, true});
  EXPECT_EQ(without.events.at("QUADS_PUT") + plan.edge_on, with.events.at("QUADS_PUT"));
  EXPECT_EQ(states(without.results), states(with.results));
  EXPECT_GT(without.events.at("TOPOLOGY_HIT"), 100U);
  EXPECT_EQ(without.events.at("TOPOLOGY_HIT"), with.events.at("TOPOLOGY_HIT"));
  EXPECT_LT(2 * without.events.at("QUADS_TESTED"), with.events.at("QUADS_TESTED"));
}

/// A wall along the light, and below it a surface that comes out of a hollow by 0.15 voxels: it lies 0.1 to
/// 0.25 voxels behind the wall, which shades all of it. A start lifted farther than positions are rounded
/// would come out on the lit side.
TEST(Topology, AReliefOfATenthOfAVoxelIsShadedByTheWallAboveIt) {
  Scene scene;
  const Mat4 steep(0.01, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0.01, 0, 41.8, 0, 25, 1);
  scene.surfaces.push_back(std::move(
      *surface::LimitSurface::build(fixtures::box({22.9, 15.3, 25.3}, {42.05, 50.3, 55.3}, true), Mat4())));
  scene.surfaces.push_back(
      std::move(*surface::LimitSurface::build(fixtures::rectangle(0, 20, 15, 45, 0), steep)));
  fill(scene);
  const auto bright_ones = [&](const TopologySettings& settings) {
    const auto plan = plan_topology(scene.voxels, scene.casting.quads, Vec3(0, 0, -1), settings).value();
    const auto results = test::run_topology(plan, scene.voxels, kTwoSided).results;
    std::size_t bright = 0, all = 0;
    for (std::size_t i = 0; i < results.size(); ++i) {
      const voxel::Voxel& voxel = scene.voxels.voxels[i];
      if (voxel.object != 1 || voxel.z > 22 || voxel.y < 21 || voxel.y > 43) continue;
      ++all;
      bright += results[i].shadow ? 0U : 1U;
    }
    EXPECT_GE(all, 250U);
    return bright;
  };
  EXPECT_EQ(bright_ones({}), 0U);
  EXPECT_GE(bright_ones({.lift = 0.1}), 5U);
  EXPECT_GE(bright_ones({.lift = 0.2}), 50U);
}

TEST(Topology, ThePitchGrowsUntilThePoolIsLargeEnough) {
  const Vec3 light(0.3, 0.2, -1);
  const TopologyPlan usual = plan_of(light);
  TopologySettings small;
  small.most_nodes_log2 = usual.vpu.config.nodes_log2 - 1;
  const TopologyPlan coarser = plan_of(light, small);
  EXPECT_EQ(coarser.vpu.config.nodes_log2, small.most_nodes_log2);
  EXPECT_NEAR(std::remainder(std::log(coarser.settings.pitch), std::log(1.25)), 0, 1e-9);
  EXPECT_GT(coarser.settings.pitch, usual.settings.pitch);
  EXPECT_EQ(run(coarser).events.at("NODES_DROPPED"), 0u);

  small.nodes_log2 = 8;
  const TopologyPlan told = plan_of(light, small);
  EXPECT_EQ(told.settings.pitch, usual.settings.pitch) << "a pool that the user chose is kept";
  EXPECT_GT(run(told).events.at("NODES_DROPPED"), 0u);
}

TEST(Topology, ASmallPoolIsFlaggedAndLosesNoShadow) {
  TopologySettings settings;
  const auto whole = run(plan_of(kLights[1]));
  settings.nodes_log2 = 13;
  const auto small = run(plan_of(kLights[1], settings));
  EXPECT_EQ(small.sticky, golden::topology::kStickyListOverflow);
  EXPECT_GT(small.events.at("TOPOLOGY_FALLBACK"), 100U);
  std::uint64_t differ = 0;
  for (std::size_t i = 0; i < whole.results.size(); ++i) {
    EXPECT_GE(small.results[i].shadow, whole.results[i].shadow);
    if (small.results[i].shadow != whole.results[i].shadow) {
      EXPECT_TRUE(small.results[i].fallback);
      ++differ;
    }
  }
  EXPECT_GT(differ, 0U);
}

TEST(Topology, IllegalSettingsNameTheKey) {
  TopologySettings settings;
  settings.sub_bits = 1;
  const auto plan = plan_topology(scene().voxels, scene().casting.quads, kLights[0], settings);
  ASSERT_FALSE(plan.has_value());
  EXPECT_EQ(plan.error().message, "SUB_BITS=1 is out of range 2..8");
  EXPECT_FALSE(plan_topology(scene().voxels, {}, Vec3(0, 0, 0), {}).has_value());
}

TEST(Topology, MissingResultsAreNoticed) {
  const std::vector<golden::Word> one{golden::topology::encode(TopologyResult{})};
  EXPECT_EQ(topology_results(one, 1).value().size(), 1U);
  EXPECT_EQ(topology_results(one, 2).error().message, "the hardware returned 1 voxel states, expected 2");
  const std::vector<golden::Word> refused{golden::encode(golden::ErrorResult{.error = 4})};
  EXPECT_FALSE(topology_results(refused, 0).has_value());
}

/// Whole numbers, so that double precision is exact where it decides.
TEST(PublishedTest, AgreesWithTheHardwaresOnAnyTriangle) {
  stimulus::Random random(3);
  using golden::topology::Offset;
  std::uint64_t compared = 0, hits = 0, on_side = 0;
  for (int i = 0; i < 20000; ++i) {
    std::array<Offset, 3> t;
    for (Offset& o : t) o = {random.between(-6, 6), random.between(-6, 6)};
    if (i % 5 == 0) t[2] = {2 * t[1].x - t[0].x, 2 * t[1].y - t[0].y};
    if (i % 7 == 0) t[1] = {-t[0].x, -t[0].y};
    const auto corner = [&](const Offset& o) {
      return Vec3(static_cast<double>(o.x), static_cast<double>(o.y),
                  static_cast<double>(random.between(1, 9)));
    };
    const Vec3 v0 = corner(t[0]), v1 = corner(t[1]), v2 = corner(t[2]);
    const double distance = published_distance(Vec3(0, 0, 0), Vec3(0, 0, 1), v0, v1, v2);
    const bool hit = golden::topology::hits_triangle(t[0], t[1], t[2]);
    const auto cross = [](const Offset& a, const Offset& b) { return a.x * b.y - a.y * b.x; };
    const std::array<std::int64_t, 3> e{cross(t[0], t[1]), cross(t[1], t[2]), cross(t[2], t[0])};
    if (hit && (e[0] == 0 || e[1] == 0 || e[2] == 0)) {
      ++on_side;  // rounding may put the beam on either side
      continue;
    }
    EXPECT_EQ(distance > 0 && std::isfinite(distance), hit) << i;
    ++compared;
    hits += hit ? 1U : 0U;
  }
  EXPECT_GT(compared, 15000U);
  EXPECT_GT(hits, 1500U);
  EXPECT_GT(on_side, 500U);
}

}  // namespace
}  // namespace gnomon::plan
