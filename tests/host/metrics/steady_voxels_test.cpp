// SPDX-License-Identifier: Apache-2.0
// Which unambiguous voxels hang on a fraction of a voxel: low ledges under a low light, walls along the
// light.
#include "host/metrics/steady_voxels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "host/metrics/shadow_truth.hpp"
#include "tests/host/metrics/fixtures.hpp"

namespace gnomon::metrics {
namespace {

struct Lit {
  std::vector<surface::LimitSurface> surfaces;
  voxel::VoxelSet voxels;
  ShadowTruth truth;
  Lit(const std::vector<scene::ControlMesh>& meshes, const std::vector<bool>& two_sided, const Vec3& travel)
      : surfaces(fixtures::surfaces(meshes)),
        voxels(fixtures::voxels(surfaces, 32)),
        truth(shadow_truth(ExactReference(surfaces, two_sided, DirectionalLight{travel}), surfaces, voxels)) {
  }
};

/// A square from x = 2 to 10 at a height above a ground at 4.5; the light falls by `slope` along x.
Lit ledge(double height, double slope) {
  return Lit({fixtures::rectangle(2, 4, 10, 28, 4.5 + height), fixtures::sheet(2, 2, 30, 30, 4.5, 4, 4)},
             {true, true}, Vec3(1, 0, -slope));
}

TEST(SteadyVoxels, AShadowThinnerThanHalfAVoxelIsNot) {
  const Lit scene = ledge(0.3, 0.05);  // its shadow ends at x = 16, and 0.3 voxels above the ground
  std::size_t cast = 0, lit = 0;
  for (std::size_t i = 0; i < scene.voxels.voxels.size(); ++i) {
    const voxel::Voxel& v = scene.voxels.voxels[i];
    if (scene.truth.unambiguous[i] == 0 || v.object != 1) continue;
    if (v.y < 6 || v.y > 25) continue;
    const bool shadow = scene.truth.voxels[i] == Exact::Cast;
    EXPECT_EQ(scene.truth.steady[i], shadow ? 0 : 1) << v.x << " " << v.y;
    (shadow ? cast : lit) += 1;
  }
  EXPECT_GE(cast, 20u);
  EXPECT_GE(lit, 100u);
}

TEST(SteadyVoxels, AThickOneIsWhereHalfAVoxelAboveTheSurfaceIsDarkToo) {
  const Lit scene = ledge(1.5, 0.2);  // dark from x = 9.5 to 17.5, half a voxel higher from 7 to 15
  std::size_t steady = 0, thin = 0;
  for (std::size_t i = 0; i < scene.voxels.voxels.size(); ++i) {
    const voxel::Voxel& v = scene.voxels.voxels[i];
    if (scene.truth.unambiguous[i] == 0 || v.object != 1 || scene.truth.voxels[i] != Exact::Cast) continue;
    const Vec3 p = representative(v);
    EXPECT_EQ(scene.truth.steady[i], p.x < 15 ? 1 : 0) << p.x;
    (p.x < 15 ? steady : thin) += 1;
  }
  EXPECT_GE(steady, 40u);
  EXPECT_GE(thin, 10u);
}

TEST(SteadyVoxels, AWallAlongTheLightIsNot) {
  for (const double tilt : {0.0, 0.007, -0.007, 0.02, -0.02}) {
    const Lit scene({fixtures::box({8.3, 8.3, 4.3}, {20.3, 20.3, 20.3}, true)}, {false}, Vec3(tilt, 0, -1));
    std::size_t walls = 0, tops = 0;
    for (std::size_t i = 0; i < scene.voxels.voxels.size(); ++i) {
      const voxel::Voxel& v = scene.voxels.voxels[i];
      if (scene.truth.unambiguous[i] == 0) continue;
      const bool wall = std::abs(v.normal[0]) > 0.9F;
      const bool top = v.normal[2] > 0.9F;
      if (!wall && !top) continue;
      EXPECT_EQ(scene.truth.steady[i], top || std::abs(tilt) > 0.01 ? 1 : 0) << tilt;
      walls += wall ? 1 : 0;
      tops += top ? 1 : 0;
    }
    EXPECT_GE(walls, 200u);
    EXPECT_GE(tops, 80u);
  }
}

TEST(SteadyVoxels, RefusesFlagsOfAnotherScene) {
  const Lit scene = ledge(1.5, 0.2);
  const ExactReference reference(scene.surfaces, {true, true}, DirectionalLight{{0, 0, -1}});
  const std::vector<std::uint8_t> few(3, 1);
  EXPECT_THROW(steady_voxels(reference, scene.surfaces, scene.voxels, scene.truth.voxels, few),
               std::invalid_argument);
}

}  // namespace
}  // namespace gnomon::metrics
