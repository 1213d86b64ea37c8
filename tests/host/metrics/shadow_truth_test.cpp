// SPDX-License-Identifier: Apache-2.0
// Truth per voxel, the unambiguous ones, and the length of the border, on scenes that can be worked out by
// hand.
#include "host/metrics/shadow_truth.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <cstring>

#include "tests/host/metrics/fixtures.hpp"

namespace gnomon::metrics {
namespace {

/// A square sheet over a larger one. Its edges lie inside cells, at 8.3 and 16.3.
struct SheetOverGround {
  std::vector<surface::LimitSurface> surfaces = fixtures::surfaces(
      {fixtures::rectangle(8.3, 8.3, 16.3, 16.3, 20.5), fixtures::sheet(2, 2, 30, 30, 4.5, 4, 4)});
  voxel::VoxelSet voxels = fixtures::voxels(surfaces, 32);
  ShadowTruth truth(const Vec3& travel, double spacing = 0.5) const {
    TruthOptions options;
    options.spacing = spacing;
    return shadow_truth(ExactReference(surfaces, {true, true}, DirectionalLight{travel}), surfaces, voxels,
                        options);
  }
};

TEST(ShadowTruth, KnowsEveryVoxelUnderAVerticalLight) {
  const SheetOverGround scene;
  const ShadowTruth truth = scene.truth({0, 0, -1});
  const auto& voxels = scene.voxels.voxels;
  ASSERT_EQ(truth.voxels.size(), voxels.size());
  ASSERT_EQ(truth.unambiguous.size(), voxels.size());
  std::size_t ground = 0;
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    const voxel::Voxel& v = voxels[i];
    const Vec3 p = representative(v);
    const bool under = v.object == 1 && p.x > 8.3 && p.x < 16.3 && p.y > 8.3 && p.y < 16.3;
    EXPECT_EQ(truth.voxels[i], under ? Exact::Cast : Exact::Lit);
    // The border runs through cells 8 and 16: the cells within one of them, along the square's sides, see
    // both answers.
    const bool at_x = (std::abs(v.x - 8) <= 1 || std::abs(v.x - 16) <= 1) && v.y >= 7 && v.y <= 17;
    const bool at_y = (std::abs(v.y - 8) <= 1 || std::abs(v.y - 16) <= 1) && v.x >= 7 && v.x <= 17;
    EXPECT_EQ(truth.unambiguous[i], v.object == 1 && (at_x || at_y) ? 0 : 1)
        << v.x << " " << v.y << " " << v.z;
    ground += v.object;
  }
  EXPECT_EQ(ground, 29u * 29u);
}

TEST(ShadowTruth, SamplesAddUpToTheProjectedArea) {
  const SheetOverGround scene;
  for (const Vec3& travel : {Vec3(0, 0, -1), Vec3(1, 0, -1), Vec3(0.4, -0.7, -0.3)}) {
    const ShadowTruth truth = scene.truth(travel);
    double area = 0;
    for (const SurfaceSample& s : truth.samples) {
      area += double{s.light_area};
      EXPECT_NE(s.voxel, kNoVoxel);
    }
    const double cosine = -travel.z / travel.length();
    EXPECT_NEAR(area, (28 * 28 + 8 * 8) * cosine, 0.01);
  }
}

TEST(ShadowTruth, MeasuresTheBorderInTheLightsPlane) {
  const SheetOverGround scene;
  const ShadowTruth upright = scene.truth({0, 0, -1}, 0.1);
  EXPECT_NEAR(upright.border[1].cast, 32, 0.2);  // marching squares cut each corner by less than a cell
  EXPECT_EQ(upright.border[1].attached, 0);
  EXPECT_EQ(upright.border[0].total(), 0);
  // A tilt along x shortens what runs along x, and the shadow stays on the ground.
  const ShadowTruth tilted = scene.truth({0.5, 0, -1}, 0.1);
  EXPECT_NEAR(tilted.border[1].cast, 16 + 16 / std::hypot(0.5, 1), 0.2);
}

TEST(ShadowTruth, FindsTheTerminatorOnCreasesAndOnSmoothSurfaces) {
  const auto sharp = fixtures::surfaces({fixtures::box({8, 6, 10}, {24, 26, 22}, true)});
  const auto box_voxels = fixtures::voxels(sharp, 32);
  const ShadowTruth box =
      shadow_truth(ExactReference(sharp, {false}, DirectionalLight{{0, 0, -1}}), sharp, box_voxels);
  EXPECT_NEAR(box.border[0].attached, 2 * (16 + 20), 1e-6);
  EXPECT_EQ(box.border[0].cast, 0);

  const auto round = fixtures::surfaces({fixtures::torus({32, 32, 32}, 18, 8, 32, 16)});
  const auto round_voxels = fixtures::voxels(round, 64);
  const ShadowTruth torus =
      shadow_truth(ExactReference(round, {false}, DirectionalLight{{0, 0, -1}}), round, round_voxels);
  const double pi = std::acos(-1);
  EXPECT_NEAR(torus.border[0].attached, 2 * pi * (26 + 10), 0.5);
  EXPECT_NEAR(torus.border[0].cast, 0, 0.1);
}

TEST(ShadowTruth, DoesNotDependOnTheNumberOfThreads) {
  const auto surfaces = fixtures::surfaces(
      {fixtures::box({8, 8, 8}, {24, 24, 24}, false), fixtures::sheet(2, 2, 30, 30, 4.5, 4, 4)});
  const auto voxels = fixtures::voxels(surfaces, 32);
  const auto run = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return shadow_truth(ExactReference(surfaces, {false, true}, DirectionalLight{{0.3, 0.2, -1}}), surfaces,
                        voxels);
  };
  const ShadowTruth one = run(1);
  const ShadowTruth more = run(4);
  EXPECT_EQ(one.voxels, more.voxels);
  EXPECT_EQ(one.unambiguous, more.unambiguous);
  EXPECT_EQ(one.rays, more.rays);
  ASSERT_EQ(one.samples.size(), more.samples.size());
  for (std::size_t i = 0; i < one.samples.size(); ++i) {
    EXPECT_EQ(one.samples[i].exact, more.samples[i].exact);
    EXPECT_EQ(one.samples[i].light_area, more.samples[i].light_area);
  }
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(one.border[i].cast, more.border[i].cast);
    EXPECT_EQ(one.border[i].attached, more.border[i].attached);
  }
}

TEST(ShadowTruth, ReportsProgressAndCanBeCancelled) {
  const SheetOverGround scene;
  const ExactReference reference(scene.surfaces, {true, true}, DirectionalLight{{0, 0, -1}});
  double last = 0;
  TruthOptions options;
  options.progress = [&](double done) {
    EXPECT_GT(done, last);
    last = done;
  };
  shadow_truth(reference, scene.surfaces, scene.voxels, options);
  EXPECT_EQ(last, 1.0);
  options.progress = nullptr;
  options.cancelled = [] { return true; };
  EXPECT_THROW(shadow_truth(reference, scene.surfaces, scene.voxels, options), Cancelled);
}

TEST(ShadowTruth, RefusesASpacingOfZero) {
  const SheetOverGround scene;
  EXPECT_THROW(scene.truth({0, 0, -1}, 0), std::invalid_argument);
}

}  // namespace
}  // namespace gnomon::metrics
