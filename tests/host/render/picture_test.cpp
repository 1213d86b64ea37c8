// SPDX-License-Identifier: Apache-2.0
// Whole pictures: the corner rule, no holes, agreement with the reference.
#include "host/render/picture.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>

#include "host/render/shading.hpp"
#include "tests/host/metrics/fixtures.hpp"

namespace gnomon::render {
namespace {

using golden::VoxelState;
using metrics::MaskValue;

const Material kDull = {{0.5f, 0.4f, 0.3f}, 0.0f, 10};
const Light kOverhead = DirectionalLight{{0, 0, -1}};

PictureOptions small(int width, int height, int supersample = 1) {
  PictureOptions options;
  options.width = width;
  options.height = height;
  options.supersample = supersample;
  return options;
}

std::size_t count(const Picture& picture, MaskValue value) {
  return static_cast<std::size_t>(std::count(picture.mask.begin(), picture.mask.end(), value));
}

template <class Shadows>
Picture render_one(const PictureScene& scene, const Camera& camera, const Shadows& light,
                   std::span<const Material> materials, const PictureOptions& options) {
  return scene.render(camera, std::span(&light, 1), materials, options);
}
Picture from_states(const PictureScene& scene, const Camera& camera, const std::vector<VoxelState>& states,
                    const PictureOptions& options) {
  return render_one(scene, camera, StateShadows{kOverhead, states}, std::vector{kDull}, options);
}

/// One subpatch, made by hand, that fills the view.
struct OneSubpatch {
  std::vector<surface::LimitSurface> surfaces = fixtures::surfaces({fixtures::rectangle(0, 0, 16, 16, 2)});
  voxel::VoxelSet voxels;
  Camera camera{{8, 8, 12}, {8, 8, 2}, {0, 1, 0}, 40};
  OneSubpatch() {
    voxels.grid.res = 16;
    voxels.voxels.resize(4);
    voxels.subpatches = {{0, 0, 0, 0, 1, 1, {0, 1, 2, 3}}};
  }
};

TEST(Picture, AllSixteenCornerCombinationsFollowTheRule) {
  const OneSubpatch scene;
  const PictureScene picture(scene.surfaces, scene.voxels);
  std::size_t compared = 0;
  for (unsigned bits = 0; bits < 16; ++bits) {
    std::vector<VoxelState> states;
    int dark = 0;
    for (unsigned k = 0; k < 4; ++k) {
      states.push_back((bits >> k & 1) != 0 ? VoxelState::Shadow : VoxelState::Lit);
      dark += (bits >> k & 1) != 0 ? 1 : 0;
    }
    const Picture p = from_states(picture, scene.camera, states, small(8, 8));
    const LightTerm above{{0, 0, 1}, light_share(dark)};
    const Color expected = shade({{0, 0, 1}, {0, 0, 1}, {0, 1, 0}}, kDull, std::span(&above, 1));
    for (std::size_t pixel = 0; pixel < 64; ++pixel)
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(p.image.rgb[3 * pixel + k], to_srgb(double{expected[k]})) << bits;
        ++compared;
      }
    // The mask asks the nearest corner: row 0 is the bottom, where v = 0.
    EXPECT_EQ(p.mask[0], (bits & 1) != 0 ? MaskValue::Shadow : MaskValue::Lit);
    EXPECT_EQ(p.mask[7], (bits & 2) != 0 ? MaskValue::Shadow : MaskValue::Lit);
    EXPECT_EQ(p.mask[63], (bits & 4) != 0 ? MaskValue::Shadow : MaskValue::Lit);
    EXPECT_EQ(p.mask[56], (bits & 8) != 0 ? MaskValue::Shadow : MaskValue::Lit);
  }
  EXPECT_EQ(compared, 16u * 64 * 3);
}

class ClosedSurfaces : public testing::TestWithParam<int> {
 protected:
  static scene::ControlMesh mesh(int which) {
    switch (which) {
      case 0:
        return fixtures::box({6, 6, 6}, {58, 58, 58}, true);
      case 1:
        return fixtures::box({6, 6, 6}, {58, 58, 58}, false);
      case 2:
        return fixtures::prism(5, {32, 32, 32}, 26, 40, true);
      default:
        return fixtures::prism(3, {32, 32, 32}, 28, 50, false);
    }
  }
};

TEST_P(ClosedSurfaces, NoBackgroundShowsThroughFromInsideOrOutside) {
  const auto surfaces = fixtures::surfaces({mesh(GetParam())});
  const voxel::VoxelSet voxels = fixtures::voxels(surfaces, 64);
  const PictureScene scene(surfaces, voxels);
  const std::vector<VoxelState> states(voxels.voxels.size(), VoxelState::Lit);
  // From inside every ray must end on the surface; two wide views see nearly all of it.
  for (const double z : {-1.0, 1.0}) {
    const Camera inside{{32.1, 31.7, 32.3}, {32.1, 31.7, 32.3 + z}, {0, 1, 0}, 160};
    const Picture p = from_states(scene, inside, states, small(1000, 1000));
    EXPECT_EQ(p.mask.size(), 1000000u);
    EXPECT_EQ(count(p, MaskValue::Background), 0u);
  }
  const Camera outside{{150, 120, 90}, {32, 32, 32}, {0, 0, 1}, 3};
  const Picture p = from_states(scene, outside, states, small(600, 600));
  EXPECT_EQ(count(p, MaskValue::Background), 0u);
}

INSTANTIATE_TEST_SUITE_P(Shapes, ClosedSurfaces, testing::Range(0, 4));

TEST(Picture, AMissingSubpatchIsSeenAsAHole) {
  const auto surfaces = fixtures::surfaces({fixtures::box({6, 6, 6}, {58, 58, 58}, false)});
  voxel::VoxelSet voxels = fixtures::voxels(surfaces, 64);
  voxels.subpatches.erase(voxels.subpatches.begin() +
                          static_cast<std::ptrdiff_t>(voxels.subpatches.size() / 2));
  const PictureScene scene(surfaces, voxels);
  const std::vector<VoxelState> states(voxels.voxels.size(), VoxelState::Lit);
  std::size_t holes = 0;
  for (const double z : {-1.0, 1.0}) {
    const Camera inside{{32.1, 31.7, 32.3}, {32.1, 31.7, 32.3 + z}, {0, 1, 0}, 160};
    holes += count(from_states(scene, inside, states, small(1000, 1000)), MaskValue::Background);
  }
  EXPECT_GT(holes, 0u);
}

/// A box on the ground under a slanted light, with states from the exact reference.
class BoxOnGround : public testing::Test {
 protected:
  BoxOnGround()
      : surfaces_(fixtures::surfaces(
            {fixtures::box({20, 20, 6.5}, {34, 34, 20}, true), fixtures::sheet(3, 3, 61, 61, 6.5, 4, 4)})),
        voxels_(fixtures::voxels(surfaces_, 64)),
        reference_(surfaces_, {false, true}, metrics::DirectionalLight{Vec3(1, 0.4, -1).normalized()}),
        scene_(surfaces_, voxels_) {
    for (const voxel::Voxel& v : voxels_.voxels) {
      const bool dark =
          reference_.occluded(surfaces_[v.object].position(v.face, double{v.u}, double{v.v}),
                              surfaces_[v.object].normal(v.face, double{v.u}, double{v.v}), v.object);
      states_.push_back(dark ? VoxelState::Shadow : VoxelState::Lit);
    }
  }

  Picture from_states(const PictureOptions& options) const {
    return render_one(scene_, camera_, StateShadows{light_, states_}, materials_, options);
  }
  Picture exact(const PictureOptions& options) const {
    const ExactShadows exact{light_, reference_};
    return scene_.render_reference(camera_, std::span(&exact, 1), materials_, options);
  }

  Light light_ = DirectionalLight{Vec3(1, 0.4, -1).normalized()};
  Camera camera_{{60, -45, 70}, {34, 32, 8}, {0, 0, 1}, 36};
  std::vector<Material> materials_ = default_materials(2, 1);
  std::vector<surface::LimitSurface> surfaces_;
  voxel::VoxelSet voxels_;
  metrics::ExactReference reference_;
  PictureScene scene_;
  std::vector<VoxelState> states_;
};

TEST_F(BoxOnGround, StatesThatAreExactDifferFromTheReferenceOnlyAlongTheBorder) {
  const Picture given = from_states(small(320, 240));
  const Picture reference = exact(small(320, 240));
  const metrics::MaskError error = metrics::mask_error(given.mask, reference.mask);
  EXPECT_GT(error.receivers, 25000u);
  EXPECT_GT(error.both_shadow, 2500u);
  EXPECT_LT(error.false_shadow_share() + error.false_lit_share(), 0.03);
  EXPECT_GT(error.iou(), 0.85);
  EXPECT_LT(metrics::rmse(given.image.rgb, reference.image.rgb), 0.05);
}

TEST_F(BoxOnGround, WrongStatesAreSeen) {
  const Picture reference = exact(small(320, 240));
  const metrics::MaskError before = metrics::mask_error(from_states(small(320, 240)).mask, reference.mask);
  for (std::size_t i = 0; i < states_.size(); ++i)
    if (voxels_.voxels[i].object == 1 && voxels_.voxels[i].x > 50) states_[i] = VoxelState::Shadow;
  const metrics::MaskError after = metrics::mask_error(from_states(small(320, 240)).mask, reference.mask);
  EXPECT_GT(after.false_shadow, before.false_shadow + 1000);
  EXPECT_EQ(after.false_lit, before.false_lit);
}

TEST_F(BoxOnGround, ExactAnswersAtTheVisiblePointsGiveTheReference) {
  const PictureOptions options = small(160, 120, 2);
  const VisiblePoints visible = scene_.visible_points(camera_, reference_, options);
  ASSERT_EQ(visible.of_sample.size(), 320u * 240);
  const Picture reference = exact(options);
  std::vector<std::uint8_t> shadowed(visible.points.size(), 2);
  std::size_t seen = 0;
  for (std::size_t i = 0; i < visible.of_sample.size(); ++i) {
    ASSERT_EQ(visible.of_sample[i] == kNoPoint, reference.mask[i] == MaskValue::Background);
    if (visible.of_sample[i] == kNoPoint) continue;
    ASSERT_EQ(shadowed.at(visible.of_sample[i]), 2) << "a point of its own for each sample";
    shadowed[visible.of_sample[i]] = reference.mask[i] == MaskValue::Shadow ? 1 : 0;
    ++seen;
  }
  EXPECT_EQ(seen, visible.points.size());
  const auto answer = [&] {
    return render_one(scene_, camera_, PointShadows{light_, visible, shadowed}, materials_, options);
  };
  const Picture answered = answer();
  EXPECT_EQ(answered.image.rgb, reference.image.rgb);
  EXPECT_EQ(answered.mask, reference.mask);

  for (const Receiver& p : visible.points) ASSERT_GE(p.z, 6.49f);
  shadowed.pop_back();
  EXPECT_THROW(answer(), std::invalid_argument);
}

TEST_F(BoxOnGround, OnlyTheStatesOfVisibleVoxelsMatter) {
  const PictureOptions options = small(160, 120, 2);
  const std::vector<std::uint32_t> visible = scene_.visible_voxels(camera_, options);
  EXPECT_TRUE(std::ranges::is_sorted(visible));
  EXPECT_GT(visible.size(), 1000U);
  EXPECT_LT(visible.size(), states_.size() - 500) << "the box hides its far sides";
  std::vector<VoxelState> known(states_.size(), VoxelState::Empty);
  for (const std::uint32_t i : visible) known[i] = states_[i];
  const Picture expected = from_states(options);
  EXPECT_EQ(render_one(scene_, camera_, StateShadows{light_, known}, materials_, options).image.rgb,
            expected.image.rgb);
  // They do matter: turned over, the picture changes.
  for (const std::uint32_t i : visible)
    known[i] = known[i] == VoxelState::Lit ? VoxelState::Shadow : VoxelState::Lit;
  EXPECT_NE(render_one(scene_, camera_, StateShadows{light_, known}, materials_, options).mask,
            expected.mask);
}

TEST_F(BoxOnGround, ThePictureDoesNotDependOnTheNumberOfThreads) {
  const Picture more = from_states(small(160, 120, 2));
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
  const PictureScene again(surfaces_, voxels_);
  const Picture one =
      render_one(again, camera_, StateShadows{light_, states_}, materials_, small(160, 120, 2));
  EXPECT_EQ(one.image.rgb, more.image.rgb);
  EXPECT_EQ(one.mask, more.mask);
}

TEST_F(BoxOnGround, ReportsProgressAndCanBeCancelled) {
  PictureOptions options = small(64, 200);
  double last = 0;
  options.progress = [&](double done) {
    EXPECT_GT(done, last);
    last = done;
  };
  from_states(options);
  EXPECT_EQ(last, 1.0);
  options.progress = nullptr;
  options.cancelled = [] { return true; };
  EXPECT_THROW(from_states(options), metrics::Cancelled);
}

TEST_F(BoxOnGround, RefusesWhatDoesNotFit) {
  EXPECT_THROW(from_states(small(0, 10)), std::invalid_argument);
  EXPECT_THROW(from_states(small(10, 10, 17)), std::invalid_argument);
  EXPECT_THROW(scene_.render(camera_, std::span<const StateShadows>(), materials_, small(10, 10)),
               std::invalid_argument);
  states_.pop_back();
  EXPECT_THROW(from_states(small(10, 10)), std::invalid_argument);
  materials_.pop_back();
  EXPECT_THROW(exact(small(10, 10)), std::invalid_argument);
  voxels_.subpatches.clear();
  EXPECT_THROW(PictureScene(surfaces_, voxels_), std::invalid_argument);
}

}  // namespace
}  // namespace gnomon::render
