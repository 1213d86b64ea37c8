// SPDX-License-Identifier: Apache-2.0
// Cameras and materials.
#include "host/render/view.hpp"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "host/render/camera_rays.hpp"

namespace gnomon::render {
namespace {

TEST(CameraRays, RightIsRightUpIsUpAndTheEdgesMeetTheFieldOfView) {
  const CameraRays rays({{0, -5, 0}, {0, 0, 0}, {0, 0, 1}, 90}, 2.0);
  EXPECT_NEAR((rays.direction(0.5, 0.5) - Vec3(0, 1, 0)).length(), 0, 1e-12);
  EXPECT_NEAR((rays.direction(0.5, 1) - Vec3(0, 1, 1).normalized()).length(), 0, 1e-12);
  EXPECT_NEAR((rays.direction(1, 0.5) - Vec3(2, 1, 0).normalized()).length(), 0, 1e-12);
}

TEST(CameraRays, RefusesViewsWithoutADirection) {
  EXPECT_THROW(CameraRays({{1, 1, 1}, {1, 1, 1}, {0, 0, 1}, 30}, 1), std::invalid_argument);
  EXPECT_THROW(CameraRays({{0, 0, 5}, {0, 0, 0}, {0, 0, 1}, 30}, 1), std::invalid_argument);
  EXPECT_THROW(CameraRays({{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 0}, 1), std::invalid_argument);
  EXPECT_THROW(CameraRays({{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 180}, 1), std::invalid_argument);
}

TEST(DefaultMaterials, GroundIsGreyAndNeighboursDiffer) {
  const auto materials = default_materials(6, 2);
  ASSERT_EQ(materials.size(), 6u);
  EXPECT_NEAR(double{materials[2].diffuse[0]}, double{materials[2].diffuse[2]}, 0.05);
  EXPECT_EQ(materials[2].specular, 0.0f);
  std::set<std::array<float, 3>> colors;
  for (const Material& m : materials) colors.insert(m.diffuse);
  EXPECT_EQ(colors.size(), 6u);
  EXPECT_EQ(default_materials(20, 20).size(), 20u);
}

}  // namespace
}  // namespace gnomon::render
