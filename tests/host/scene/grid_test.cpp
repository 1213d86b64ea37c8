// SPDX-License-Identifier: Apache-2.0
// The grid that holds a scene.
#include <gtest/gtest.h>

#include <cmath>

#include "host/scene/limit_bounds.hpp"
#include "host/scene/scene.hpp"
#include "host/voxel/voxelizer.hpp"
#include "tests/host/scene/files.hpp"

namespace gnomon::scene {
namespace {

Scene load(std::string_view text, const SceneOptions& options = {}) {
  const test::TempDir directory;
  return load_scene(directory.write("model.obj", text), options).value();
}

SceneOptions bare() {
  SceneOptions options;
  options.ground = false;
  return options;
}

/// Distance of `x` from the nearest voxel centre, in voxels.
double off_centre(double x) {
  return std::abs(x - std::floor(x) - 0.5);
}

TEST(Grid, HoldsEverythingWithAMargin) {
  for (const bool ground : {false, true}) {
    for (const std::uint32_t res : {16U, 64U, 255U, 1024U}) {
      SceneOptions options;
      options.ground = ground;
      const Scene scene = load(test::cube_text(), options);
      const voxel::Grid grid = fit_grid(scene, res, voxel::Adjacency::N18).value();
      EXPECT_EQ(grid.res, res);
      EXPECT_EQ(grid.adjacency, voxel::Adjacency::N18);
      for (const Object& object : scene.objects) {
        const Vec3 low = object.bounds.min * to_grid(grid), high = object.bounds.max * to_grid(grid);
        for (int axis = 0; axis < 3; ++axis) {
          EXPECT_GE(low[axis], 1 - 1e-9);
          EXPECT_LE(high[axis], res - 1 + 1e-9);
        }
      }
    }
  }
}

TEST(Grid, BeginsAtVoxelCentres) {
  const Scene scene = load(test::cube_text());
  const voxel::Grid grid = fit_grid(scene, 200, voxel::Adjacency::N26).value();
  Box3 all;
  for (const Object& object : scene.objects) all.extendBy(object.bounds);
  const Vec3 low = all.min * to_grid(grid);
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(off_centre(low[axis]), 0, 1e-9);
}

TEST(Grid, IsUsedUpByTheLongestSideOfTheSurfaces) {
  const Scene scene = load(test::cube_text());
  const voxel::Grid grid = fit_grid(scene, 128, voxel::Adjacency::N26).value();
  const Box3 ground = scene.objects.back().bounds;
  EXPECT_NEAR(std::max(ground.size().x, ground.size().z) / grid.voxel_size, 125, 1e-9);

  // A smooth cube's control points do not count: they end up outside.
  const Scene cube = load(test::cube_text(), bare());
  const voxel::Grid close = fit_grid(cube, 128, voxel::Adjacency::N26).value();
  EXPECT_NEAR(cube.objects[0].bounds.size().y / close.voxel_size, 125, 1e-9);
  EXPECT_GT(hull_bounds(cube.objects[0].mesh, to_grid(cube.objects[0], close)).max.y, 129);
}

TEST(Grid, VoxelCentresAreWhereTheContractSays) {
  const voxel::Grid grid{64, Vec3(1, 2, 3), 0.25, voxel::Adjacency::N26};
  const Vec3 centre = grid.origin + (Vec3(5, 6, 7) + Vec3(0.5)) * grid.voxel_size;
  EXPECT_EQ(centre * to_grid(grid), Vec3(5.5, 6.5, 7.5));
}

TEST(Grid, IsAcceptedByTheVoxelizerAtEveryScaleAndOffset) {
  for (const double scale : {1e-30, 1.0, 1e30}) {
    for (const double offset : {0.0, 1e7}) {
      Scene scene = load(test::cube_text(), bare());
      for (Vec3& p : scene.objects[0].mesh.positions) p = (p + Vec3(offset)) * scale;
      scene.objects[0].bounds = limit_bounds(scene.objects[0].mesh, Mat4()).value();
      const voxel::Grid grid = fit_grid(scene, 32, voxel::Adjacency::N26).value();
      std::vector<surface::LimitSurface> surfaces;
      surfaces.push_back(
          surface::LimitSurface::build(scene.objects[0].mesh, to_grid(scene.objects[0], grid)).value());
      const auto voxels = voxel::voxelize(surfaces, grid);
      ASSERT_TRUE(voxels.has_value()) << scale << " " << offset << " " << voxels.error().message;
      EXPECT_GT(voxels->voxels.size(), 1000U);
    }
  }
}

TEST(Grid, RefusesASceneWithoutExtent) {
  Scene scene = load(test::cube_text(), bare());
  scene.objects[0].bounds = Box3(Vec3(1, 1, 1), Vec3(1, 1, 1));
  EXPECT_FALSE(fit_grid(scene, 32, voxel::Adjacency::N26).has_value());
}

}  // namespace
}  // namespace gnomon::scene
