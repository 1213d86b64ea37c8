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

TEST(FullTurn, GoesAroundTheTargetInEqualStepsAndStartsWhereItIs) {
  const Camera start{{4, 1, 7}, {1, 1, 1}, {0, 0, 2}, 33};
  const std::vector<Camera> turn = full_turn(start, 8);
  ASSERT_EQ(turn.size(), 8U);
  EXPECT_EQ(turn[0].eye, start.eye);
  // A quarter turn to the left: from +x to +y.
  EXPECT_LT((turn[2].eye - Vec3(1, 4, 7)).length(), 1e-12);
  const double step = (turn[1].eye - turn[0].eye).length();
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_NEAR((turn[(i + 1) % 8].eye - turn[i].eye).length(), step, 1e-12);
    EXPECT_NEAR((turn[i].eye - start.target).length(), (start.eye - start.target).length(), 1e-12);
    EXPECT_EQ(turn[i].target, start.target);
    EXPECT_EQ(turn[i].up, start.up);
    EXPECT_EQ(turn[i].fov_degrees, 33);
  }
  EXPECT_TRUE(full_turn(start, 0).empty());
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
