// SPDX-License-Identifier: Apache-2.0
// The plain shadow map is off by what theory says, and a flat receiver never shadows itself.
#include "host/metrics/shadow_map.hpp"

#include <gtest/gtest.h>

#include "tests/host/metrics/fixtures.hpp"

namespace gnomon::metrics {
namespace {

class ShadowMapTest : public testing::Test {
 protected:
  ShadowMapTest()
      : surfaces_(fixtures::surfaces({fixtures::prism(23, Vec3(16.2, 15.7, 20), 7.3, 3, true),
                                      fixtures::sheet(2, 2, 30, 30, 4.5, 4, 4)})),
        voxels_(fixtures::voxels(surfaces_, 32)),
        reference_(surfaces_, {false, true}, DirectionalLight{{0, 0, -1}}),
        truth_(shadow_truth(reference_, surfaces_, voxels_)) {}

  /// Pixels of `pitch` voxels that run with no side along the shapes.
  static LightPlane plane(double pitch) {
    const double c = 0.8;
    const double s = 0.6;
    return {{Vec3(c, s, 0), Vec3(s, -c, 0), Vec3(0, 0, -1)}, 20, 50, pitch, 128};
  }
  double displaced(const LightPlane& plane) const {
    const SampleAnswers answers = ShadowMap(reference_, plane).answers(truth_);
    return displacement(truth_, answers, {1u, plane.pitch}).ground.entries();
  }

  std::vector<surface::LimitSurface> surfaces_;
  voxel::VoxelSet voxels_;
  ExactReference reference_;
  ShadowTruth truth_;
};

TEST_F(ShadowMapTest, IsOffByAQuarterOfAPixel) {
  EXPECT_NEAR(displaced(plane(1.0)), 0.244, 0.02);
  EXPECT_NEAR(displaced(plane(1.0).finer(2)), 0.244, 0.02);
  EXPECT_NEAR(displaced(plane(1.0).finer(8)), 0.244, 0.03);
}

TEST_F(ShadowMapTest, AFinerOneOfTheSameAreaHasTheSamePixelsDivided) {
  const LightPlane coarse = plane(1.0);
  const LightPlane fine = coarse.finer(8);
  EXPECT_EQ(fine.side, 8 * coarse.side);
  const Vec3 p(11.3, 17.9, 3);
  EXPECT_NEAR(fine.pixel(p).x, 8 * coarse.pixel(p).x, 1e-9);
  EXPECT_NEAR(fine.pixel(p).y, 8 * coarse.pixel(p).y, 1e-9);
}

TEST_F(ShadowMapTest, NothingOffThePlaneIsInShadowAndEverythingThatFacesAwayIs) {
  LightPlane small = plane(1.0);
  small.side = 1;
  small.x1 = small.y1 = -1000;
  const ShadowMap map(reference_, small);
  EXPECT_FALSE(map.in_shadow(Vec3(16, 16, 4.5), 1));
  EXPECT_TRUE(map.in_shadow(Vec3(16, 16, 4.5), -0.1));
  EXPECT_TRUE(ShadowMap(reference_, plane(1.0)).in_shadow(Vec3(16, 16, 4.5), 1));
}

TEST_F(ShadowMapTest, AFlatReceiverNeverShadowsItself) {
  const auto ground = fixtures::surfaces({fixtures::sheet(2, 2, 30, 30, 4.5, 4, 4)});
  const Vec3 travel = Vec3(1, 0.3, -0.3).normalized();
  const ExactReference alone(ground, {true}, DirectionalLight{travel});
  const Vec3 right = travel.cross(Vec3(0, 0, 1)).normalized();
  const ShadowMap map(alone, {{right, right.cross(travel), travel}, 64, 64, 1.3, 128});
  for (int i = 0; i < 1000; ++i)
    ASSERT_FALSE(map.in_shadow(Vec3(3 + 0.026 * i, 3 + 0.017 * i, 4.5), -travel.z)) << i;
}

}  // namespace
}  // namespace gnomon::metrics
