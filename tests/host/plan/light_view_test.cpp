// SPDX-License-Identifier: Apache-2.0
// A light's views between them answer for every point they should, once.
#include "host/plan/light_view.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host/plan/representative.hpp"
#include "tests/host/plan/analytic_voxels.hpp"
#include "tests/support/random.hpp"

namespace gnomon::plan {
namespace {

const voxel::VoxelSet& scene() {
  static const auto set = test::ball_on_ground(64, {{32, 30, 36}, 15}, 4.5);
  return set;
}
const ObjectRoles& roles() {
  static const auto all = ObjectRoles::all({false, true});
  return all;
}

TEST(LightViews, ADirectionalLightIsOneViewOfEverything) {
  const auto views = light_views(DirectionalLight{Vec3(0.6, 0, -0.8)}, scene());
  ASSERT_EQ(views.size(), 1u);
  EXPECT_FALSE(views[0].perspective());
  EXPECT_EQ(views[0].axes.away, Vec3(0.6, 0, -0.8));
  const ViewVoxels seen = view_voxels(views[0], scene(), roles());
  EXPECT_EQ(seen.casters, all_voxels(scene()).casters);
  EXPECT_EQ(seen.receivers.size(), scene().voxels.size());
}

TEST(LightViews, ASpotAnswersInsideItsCone) {
  const SpotLight spot{{32, 32, 60}, Vec3(0, 0, -1), 30};
  const auto views = light_views(spot, scene());
  ASSERT_EQ(views.size(), 1u);
  stimulus::Random random(5);
  int inside = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto at = [&] { return static_cast<double>(random.between(0, 6400)) / 100; };
    const Vec3 p(at(), at(), at());
    EXPECT_EQ(views[0].answers(p), light_reaches(spot, p)) << p;
    inside += views[0].answers(p) ? 1 : 0;
  }
  EXPECT_GT(inside, 100);
  EXPECT_LT(inside, 1000);
}

TEST(LightViews, EveryVoxelIsOnOneSideOfAPointLight) {
  // The light lies over the ground, beside the ball: nothing is above it but part of the ball.
  const PointLight light{{6, 6, 20}};
  const auto views = light_views(light, scene());
  std::vector<int> answered(scene().voxels.size());
  for (const LightView& view : views) {
    const ViewVoxels seen = view_voxels(view, scene(), roles());
    EXPECT_FALSE(seen.receivers.empty()) << view.name();
    for (const std::uint32_t i : seen.receivers) {
      ++answered[i];
      const Vec3 from = representative(scene().voxels[i]) - light.position;
      EXPECT_NEAR(from.dot(view.axes.away), std::max({std::abs(from.x), std::abs(from.y), std::abs(from.z)}),
                  1e-12);
    }
  }
  EXPECT_EQ(answered, std::vector<int>(answered.size(), 1));
  EXPECT_LE(views.size(), 6u);
  EXPECT_GE(views.size(), 3u);
}

TEST(LightViews, TiesGoToTheLowerAxis) {
  EXPECT_EQ(half_axis_of({1, 1, 1}), 0);
  EXPECT_EQ(half_axis_of({-1, 1, 1}), 1);
  EXPECT_EQ(half_axis_of({0.5, -1, 1}), 3);
  EXPECT_EQ(half_axis_of({0.5, 0.5, -1}), 5);
  EXPECT_EQ(half_axis_of({0, 0, 0}), 0);
}

TEST(LightViews, FlagsLeaveObjectsOut) {
  ObjectRoles some = roles();
  some.casts = {true, false};
  some.receives = {false, true};
  const ViewVoxels seen = view_voxels(directional_view({0, 0, -1}), scene(), some);
  for (const std::uint32_t i : seen.casters) EXPECT_EQ(scene().voxels[i].object, 0);
  for (const std::uint32_t i : seen.receivers) EXPECT_EQ(scene().voxels[i].object, 1);
  EXPECT_EQ(seen.casters.size() + seen.receivers.size(), scene().voxels.size());
}

}  // namespace
}  // namespace gnomon::plan
