// SPDX-License-Identifier: Apache-2.0
// Pictures under several lights and under lights of every kind.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "host/render/camera_rays.hpp"
#include "host/render/picture.hpp"
#include "tests/host/metrics/fixtures.hpp"

namespace gnomon::render {
namespace {

using golden::VoxelState;
using metrics::MaskValue;

/// A flat ground at z = 6.5, seen from above.
class Ground : public testing::Test {
 protected:
  Ground()
      : surfaces_(fixtures::surfaces({fixtures::sheet(3, 3, 61, 61, 6.5, 4, 4)})),
        voxels_(fixtures::voxels(surfaces_, 64)),
        scene_(surfaces_, voxels_),
        lit_(voxels_.voxels.size(), VoxelState::Lit),
        dark_(voxels_.voxels.size(), VoxelState::Shadow) {
    options_.width = kWidth;
    options_.height = kHeight;
    options_.supersample = 2;
    samples_ = kColumns * kRows;
  }

  Picture draw(const std::vector<StateShadows>& lights) const {
    return scene_.render(camera_, lights, std::vector{kDull}, options_);
  }
  /// Where sample i of a mask sees the ground.
  Vec3 seen(std::size_t i) const {
    const CameraRays rays(camera_, static_cast<double>(kWidth) / kHeight);
    const std::size_t column = i % kColumns, row = i / kColumns;
    const Vec3 way = rays.direction((static_cast<double>(column) + 0.5) / kColumns,
                                    (static_cast<double>(row) + 0.5) / kRows);
    return rays.eye() + way * ((6.5 - rays.eye().z) / way.z);
  }
  int red(const Picture& picture, std::size_t pixel) const { return picture.image.rgb[3 * pixel]; }

  static inline const Material kDull = {{0.5f, 0.4f, 0.3f}, 0.0f, 10};
  const Light above_ = DirectionalLight{{0, 0, -1}};
  const Light slanted_ = DirectionalLight{Vec3(1, 0, -1).normalized()};
  const Light spot_ = SpotLight{{30, 28, 40}, Vec3(0.2, 0.1, -1).normalized(), 20};
  const Light point_ = PointLight{{30, 28, 20}};
  Camera camera_{{32, 20, 60}, {32, 30, 6.5}, {0, 1, 0}, 35};
  std::vector<surface::LimitSurface> surfaces_;
  voxel::VoxelSet voxels_;
  PictureScene scene_;
  std::vector<VoxelState> lit_, dark_;
  PictureOptions options_;
  static constexpr int kWidth = 96, kHeight = 72;
  static constexpr std::size_t kColumns = std::size_t{2} * kWidth,
                               kRows = std::size_t{2} * kHeight;  ///< of samples
  std::size_t samples_;
};

TEST_F(Ground, EveryLightHasAMaskOfItsOwn) {
  const Picture both = draw({{above_, dark_}, {slanted_, lit_}});
  ASSERT_EQ(both.lights, 2U);
  ASSERT_EQ(both.mask.size(), 2 * samples_);
  EXPECT_TRUE(std::ranges::equal(both.mask_of(0), draw({{above_, dark_}}).mask));
  EXPECT_TRUE(std::ranges::equal(both.mask_of(1), draw({{slanted_, lit_}}).mask));
  EXPECT_EQ(std::ranges::count(both.mask_of(0), MaskValue::Shadow), static_cast<std::ptrdiff_t>(samples_));
  EXPECT_EQ(std::ranges::count(both.mask_of(1), MaskValue::Lit), static_cast<std::ptrdiff_t>(samples_));
}

TEST_F(Ground, LightsAddUp) {
  const Picture none = draw({{above_, dark_}, {slanted_, dark_}});
  const Picture first = draw({{above_, lit_}, {slanted_, dark_}});
  const Picture second = draw({{above_, dark_}, {slanted_, lit_}});
  const Picture all = draw({{above_, lit_}, {slanted_, lit_}});
  const std::size_t middle = std::size_t{kHeight} / 2 * kWidth + kWidth / 2;
  EXPECT_LT(red(none, middle), red(second, middle));
  EXPECT_LT(red(second, middle), red(first, middle)) << "at half a right angle there is less of it";
  EXPECT_LT(red(first, middle), red(all, middle));
  EXPECT_EQ(none.image.rgb, draw({{above_, dark_}}).image.rgb) << "ambient light is there once";
}

TEST_F(Ground, ASpotsConeEndsAtTheSample) {
  const Picture picture = draw({{spot_, lit_}});
  std::size_t inside = 0, compared = 0;
  for (std::size_t i = 0; i < samples_; ++i) {
    const SpotLight& spot = std::get<SpotLight>(spot_);
    const Vec3 way = (seen(i) - spot.position).normalized();
    const double angle = std::acos(way.dot(spot.direction)) * 180 / std::numbers::pi;
    if (std::abs(angle - spot.half_angle) < 1e-3) continue;
    ASSERT_EQ(picture.mask[i], angle < spot.half_angle ? MaskValue::Lit : MaskValue::Shadow) << angle;
    inside += angle < spot.half_angle ? 1U : 0U;
    ++compared;
  }
  EXPECT_GT(compared, samples_ - 20);
  EXPECT_GT(inside, samples_ / 10);
  EXPECT_LT(inside, samples_ * 9 / 10);
}

TEST_F(Ground, VoxelsOutsideTheConeDoNotDarkenWhatIsInside) {
  std::vector<VoxelState> states = lit_;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const voxel::Voxel& v = voxels_.voxels[i];
    const Vec3 p(v.x + double{v.point[0]}, v.y + double{v.point[1]}, v.z + double{v.point[2]});
    if (!light_reaches(spot_, p)) states[i] = VoxelState::Shadow;
  }
  EXPECT_GT(std::ranges::count(states, VoxelState::Shadow), 500);
  EXPECT_EQ(draw({{spot_, states}}).image.rgb, draw({{spot_, lit_}}).image.rgb);
  // What is in shadow inside the cone is so up to its very edge.
  EXPECT_EQ(draw({{spot_, dark_}}).image.rgb, draw({{above_, dark_}}).image.rgb);
}

TEST_F(Ground, APointLightIsBrightestBelowIt) {
  const Picture picture = draw({{point_, lit_}});
  const Picture ambient = draw({{point_, dark_}});
  // Lambert's cosine, in linear light: check against the distance on the ground.
  std::size_t brightest = 0;
  for (std::size_t pixel = 0; pixel < std::size_t{kWidth} * kHeight; ++pixel) {
    EXPECT_GT(red(picture, pixel), red(ambient, pixel));
    if (red(picture, pixel) > red(picture, brightest)) brightest = pixel;
  }
  const std::size_t sample = (brightest / kWidth * 2) * kColumns + brightest % kWidth * 2;
  const Vec3 off = seen(sample) - std::get<PointLight>(point_).position;
  EXPECT_LT(std::hypot(off.x, off.y), 3);
}

TEST_F(Ground, ExactReferencesOfEveryKindGiveTheSameMasks) {
  // Nothing throws a shadow here: the reference knows the cone alone.
  const metrics::ExactReference exact_spot(surfaces_, {true}, spot_);
  const metrics::ExactReference exact_point = exact_spot.relit(point_);
  const std::vector<ExactShadows> lights = {{spot_, exact_spot}, {point_, exact_point}};
  const Picture exact = scene_.render_reference(camera_, lights, std::vector{kDull}, options_);
  const Picture given = draw({{spot_, lit_}, {point_, lit_}});
  EXPECT_EQ(exact.mask, given.mask);
  EXPECT_EQ(exact.image.rgb, given.image.rgb);
}

TEST_F(Ground, AMapOfErrorsSharesASampleAmongWrongLights) {
  const Picture right = draw({{above_, lit_}, {slanted_, lit_}});
  const Picture one = draw({{above_, dark_}, {slanted_, lit_}});
  const Picture both = draw({{above_, dark_}, {slanted_, dark_}});
  const Image wrong_once = error_map(one, right);
  EXPECT_EQ(wrong_once.rgb, error_map(both, right).rgb) << "red wherever some light is wrong";
  EXPECT_GT(wrong_once.rgb[0], wrong_once.rgb[2] + 150);
  // Falsely dark under one light, falsely lit under the other: half and half.
  const Image mixed = error_map(one, draw({{above_, lit_}, {slanted_, dark_}}));
  EXPECT_GT(mixed.rgb[0], mixed.rgb[1] + 50);
  EXPECT_GT(mixed.rgb[2], mixed.rgb[1] + 50);
  EXPECT_THROW(error_map(one, draw({{above_, lit_}})), std::invalid_argument);
}

}  // namespace
}  // namespace gnomon::render
