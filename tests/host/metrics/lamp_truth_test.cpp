// SPDX-License-Identifier: Apache-2.0
// Truth, borders and displacement under spot and point lights, on scenes that can be worked out by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "host/metrics/light_scale.hpp"
#include "host/metrics/shadow_error.hpp"
#include "host/metrics/shadow_map.hpp"
#include "tests/host/metrics/fixtures.hpp"

namespace gnomon::metrics {
namespace {

/// A square sheet over a larger one, and a lamp above that throws the upper one's shadow twice as large: from
/// 4.3 to 20.3.
struct LampOverSheet {
  static constexpr double kLow = 4.3, kHigh = 20.3;
  Vec3 lamp{12.3, 12.3, 36.5};
  std::vector<surface::LimitSurface> surfaces = fixtures::surfaces(
      {fixtures::rectangle(8.3, 8.3, 16.3, 16.3, 20.5), fixtures::sheet(2, 2, 30, 30, 4.5, 4, 4)});
  voxel::VoxelSet voxels = fixtures::voxels(surfaces, 32);

  ShadowTruth truth(const Light& light, double spacing = 0.5) const {
    TruthOptions options;
    options.spacing = spacing;
    return shadow_truth(ExactReference(surfaces, {true, true}, light), surfaces, voxels, options);
  }
  static bool under(double x, double y, double grow = 0) {
    return x > kLow - grow && x < kHigh + grow && y > kLow - grow && y < kHigh + grow;
  }
};

TEST(LampTruth, KnowsEveryVoxelUnderALamp) {
  const LampOverSheet scene;
  for (const Light& light : {Light{PointLight{scene.lamp}}, Light{SpotLight{scene.lamp, {0, 0, -1}, 60}}}) {
    const ShadowTruth truth = scene.truth(light);
    std::size_t dark = 0, clear = 0;
    for (std::size_t i = 0; i < truth.voxels.size(); ++i) {
      const voxel::Voxel& v = scene.voxels.voxels[i];
      const Vec3 p = representative(v);
      const bool shadow = v.object == 1 && LampOverSheet::under(p.x, p.y);
      EXPECT_EQ(truth.voxels[i], shadow ? Exact::Cast : Exact::Lit);
      dark += shadow ? 1U : 0U;
      const auto far_from = [](int cell) { return std::abs(cell - 4) > 1 && std::abs(cell - 20) > 1; };
      if (v.object == 1 && far_from(v.x) && far_from(v.y)) {
        EXPECT_EQ(truth.unambiguous[i], 1);
        ++clear;
      }
    }
    EXPECT_GT(dark, 200U);
    EXPECT_GT(clear, 400U);
  }
}

TEST(LampTruth, AreasAndBordersAreThoseAtDistanceOne) {
  const LampOverSheet scene;
  const ShadowTruth truth = scene.truth(PointLight{scene.lamp}, 0.1);
  // The ground lies 32 below the lamp, the sheet 16.
  EXPECT_NEAR(truth.border[1].cast, 4.0 * 16 / 32, 0.01);
  EXPECT_EQ(truth.border[1].attached, 0);
  EXPECT_EQ(truth.border[0].total(), 0);
  double area = 0;
  for (const SurfaceSample& s : truth.samples) area += double{s.light_area};
  EXPECT_NEAR(area, 28.0 * 28 / (32 * 32) + 8.0 * 8 / (16 * 16), 1e-3);
}

TEST(LampTruth, ASpotHasABorderWhereItsConeEnds) {
  const auto ground = fixtures::surfaces({fixtures::sheet(2, 2, 30, 30, 4.5, 4, 4)});
  const auto voxels = fixtures::voxels(ground, 32);
  TruthOptions options;
  options.spacing = 0.1;
  for (const double half : {10.0, 20.0}) {
    const SpotLight spot{{16, 16, 24.5}, {0, 0, -1}, half};
    const ShadowTruth truth = shadow_truth(ExactReference(ground, {true}, spot), ground, voxels, options);
    const double radius = std::tan(half * std::numbers::pi / 180);
    EXPECT_NEAR(truth.border[0].cast, 2 * std::numbers::pi * radius, 0.002 * 2 * std::numbers::pi);
    double lit = 0;
    for (const SurfaceSample& s : truth.samples) {
      EXPECT_TRUE(s.exact == Exact::Lit || s.exact == Exact::Outside);
      if (s.exact == Exact::Lit) lit += double{s.light_area};
    }
    EXPECT_NEAR(lit, std::numbers::pi * radius * radius, 0.01 * radius);
  }
}

TEST(LampTruth, AGrownShadowIsOffByHowMuchItGrew) {
  const LampOverSheet scene;
  const ShadowTruth truth = scene.truth(PointLight{scene.lamp}, 0.1);
  const auto measured = [&](double grow, double pitch) {
    SampleAnswers answers;
    const auto answer = [&](const SurfaceSample& s) -> std::uint8_t {
      return s.object == 1 && LampOverSheet::under(double{s.x}, double{s.y}, grow) ? 1 : 0;
    };
    for (const SurfaceSample& s : truth.samples) answers.samples.push_back(answer(s));
    for (const SurfaceSample& s : truth.border_samples) answers.border.push_back(answer(s));
    return displacement(truth, answers, {1u, pitch}).ground.entries();
  };
  // An entry that measures 1/32 at distance 1 is one voxel wide on the ground.
  EXPECT_NEAR(measured(0.5, 1.0 / 32), 0.5 + 0.25 / 16, 0.02);
  EXPECT_NEAR(measured(0.5, 1.0 / 64), 1.0 + 0.5 / 16, 0.04);
  EXPECT_NEAR(measured(-0.25, 1.0 / 32), 0.25 - 0.0625 / 16, 0.02);
  EXPECT_LT(measured(0, 1.0 / 32), 0.005);
}

TEST(LampTruth, WhatDoesNotReceiveCountsInNoFigure) {
  const LampOverSheet scene;
  const ReferenceObjects objects{{true, true}, {}, {true, false}};
  const ExactReference reference(scene.surfaces, objects, DirectionalLight{{0, 0, -1}});
  const ShadowTruth truth = shadow_truth(reference, scene.surfaces, scene.voxels);
  for (const SurfaceSample& s : truth.samples) EXPECT_EQ(s.object, 0);
  EXPECT_EQ(truth.border[1].total(), 0);
  std::vector<golden::VoxelState> states(truth.voxels.size(), golden::VoxelState::Shadow);
  std::size_t sheet = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    EXPECT_EQ(truth.voxels[i], Exact::Lit);
    EXPECT_LE(truth.unambiguous[i], scene.voxels.voxels[i].object == 0 ? 1 : 0);
    sheet += scene.voxels.voxels[i].object == 0 ? 1U : 0U;
  }
  const ShadowErrors errors = shadow_errors(truth, scene.voxels, states, {1u, 1.0});
  EXPECT_EQ(errors.all_voxels.ground.compared, 0U);
  EXPECT_EQ(errors.samples.ground.compared, 0U);
  EXPECT_EQ(errors.unambiguous_voxels.ground.compared, 0U);
  EXPECT_EQ(errors.displacement.ground.area_cast, 0);
  EXPECT_EQ(errors.all_voxels.models.compared, sheet);
  EXPECT_EQ(errors.all_voxels.models.false_shadow, sheet);
}

TEST(LightScale, ALampSeesTwentyFourSquaresAroundIt) {
  const auto surfaces = fixtures::surfaces({fixtures::box({4, 6, 8}, {28, 26, 30}, true)});
  const auto voxels = fixtures::voxels(surfaces, 32);
  for (const Vec3& lamp : {Vec3(16, 16, 19), Vec3(9, 20, 24)}) {
    const ShadowTruth truth =
        shadow_truth(ExactReference(surfaces, {true}, PointLight{lamp}), surfaces, voxels);
    double area = 0;
    for (const SurfaceSample& s : truth.samples) area += double{s.light_area};
    EXPECT_NEAR(area, 24, 0.15);
  }
}

TEST(LightScale, LengthsAreThoseOfTheProjection) {
  const LightScale spot(SpotLight{{1, 2, 3}, {0, 0, -1}, 70});
  // The plane at distance 1 sees (x, y, -z) - light as (x, y) / depth.
  const Vec3 a(4, 3, -5), b(4.002, 2.999, -5.003);
  const auto seen = [](const Vec3& p) { return Vec2((p.x - 1) / (3 - p.z), (p.y - 2) / (3 - p.z)); };
  EXPECT_NEAR(spot.length(a, b), (seen(b) - seen(a)).length(), 1e-9);
  EXPECT_NEAR(LightScale(PointLight{{1, 2, 3}}).length(a, b), (seen(b) - seen(a)).length(), 1e-9);
  EXPECT_NEAR(LightScale(DirectionalLight{{0, 0, -2}}).length(a, b), std::hypot(0.002, 0.001), 1e-12);
  // At the light itself, and behind a spot, it stays finite.
  for (const Vec3& p : {Vec3(1, 2, 3), Vec3(1, 2, 9)}) {
    EXPECT_TRUE(std::isfinite(spot.length(p, p + Vec3(0.1, 0, 0))));
    EXPECT_LE(spot.area({0, 0, 1e9}, 1, p),
              std::numbers::pi * std::pow(std::tan(70 * std::numbers::pi / 180), 2));
  }
}

TEST(LightScale, AShadowMapIsForDirectionalLights) {
  const LampOverSheet scene;
  const ExactReference reference(scene.surfaces, {true, true}, PointLight{scene.lamp});
  EXPECT_THROW(ShadowMap(reference, LightPlane{}), std::invalid_argument);
}

}  // namespace
}  // namespace gnomon::metrics
