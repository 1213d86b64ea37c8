// SPDX-License-Identifier: Apache-2.0
// Every comparison is counted, and a single wrong state shows.
#include "host/metrics/shadow_error.hpp"

#include <gtest/gtest.h>

#include "tests/host/metrics/fixtures.hpp"

namespace gnomon::metrics {
namespace {

class ShadowErrorTest : public testing::Test {
 protected:
  ShadowErrorTest()
      : surfaces_(fixtures::surfaces(
            {fixtures::rectangle(8.3, 8.3, 16.3, 16.3, 20.5), fixtures::sheet(2, 2, 30, 30, 4.5, 4, 4)})),
        voxels_(fixtures::voxels(surfaces_, 32)),
        truth_(shadow_truth(ExactReference(surfaces_, {true, true}, DirectionalLight{{0, 0, -1}}), surfaces_,
                            voxels_)) {
    for (const Exact answer : truth_.voxels)
      states_.push_back(in_shadow(answer) ? golden::VoxelState::Shadow : golden::VoxelState::Lit);
  }

  ShadowErrors errors() const { return shadow_errors(truth_, voxels_, states_, {1u, 1.0}); }
  std::size_t voxel_at(int x, int y, int z) const { return VoxelIndex(voxels_).find(x, y, z); }

  std::vector<surface::LimitSurface> surfaces_;
  voxel::VoxelSet voxels_;
  ShadowTruth truth_;
  std::vector<golden::VoxelState> states_;
};

TEST_F(ShadowErrorTest, ExactStatesAreRightEverywhere) {
  const ShadowErrors e = errors();
  EXPECT_EQ(e.all_voxels.ground.compared, 29u * 29u);
  EXPECT_EQ(e.all_voxels.total().compared, voxels_.voxels.size());
  EXPECT_EQ(e.all_voxels.total().wrong(), 0u);
  // Of 29 x 29 ground cells, the ring from 7 to 17 less its inside, 10 to 14, sees both answers.
  EXPECT_EQ(e.unambiguous_voxels.ground.compared, 29u * 29u - (11u * 11u - 5u * 5u));
  EXPECT_EQ(e.unambiguous_voxels.total().wrong(), 0u);
  // From 4.5 to 20.5 no answer hangs on half a voxel.
  EXPECT_EQ(e.steady_voxels.ground, e.unambiguous_voxels.ground);
  EXPECT_EQ(e.samples.total().compared, truth_.samples.size());
}

TEST_F(ShadowErrorTest, OneFlippedVoxelIsSeenAsWhatItIs) {
  states_[voxel_at(25, 25, 4)] = golden::VoxelState::Shadow;
  EXPECT_EQ(errors().all_voxels.ground, (Mislabels{841, 1, 0}));
  EXPECT_EQ(errors().unambiguous_voxels.ground.false_shadow, 1u);
  EXPECT_EQ(errors().steady_voxels.ground.false_shadow, 1u);
  states_[voxel_at(12, 12, 4)] = golden::VoxelState::Lit;
  EXPECT_EQ(errors().all_voxels.ground, (Mislabels{841, 1, 1}));
  EXPECT_DOUBLE_EQ(errors().all_voxels.ground.share(), 2.0 / 841);
  EXPECT_EQ(errors().all_voxels.models.wrong(), 0u);
  states_[voxel_at(12, 12, 20)] = golden::VoxelState::Shadow;
  EXPECT_EQ(errors().all_voxels.models.false_shadow, 1u);
  EXPECT_EQ(errors().all_voxels.total().wrong(), 3u);
}

TEST_F(ShadowErrorTest, AVoxelAtTheBorderCountsAmongAllButNotAmongTheUnambiguous) {
  const ShadowErrors before = errors();
  auto& state = states_[voxel_at(8, 12, 4)];
  state = state == golden::VoxelState::Lit ? golden::VoxelState::Shadow : golden::VoxelState::Lit;
  EXPECT_EQ(errors().all_voxels.ground.wrong(), 1u);
  EXPECT_EQ(errors().unambiguous_voxels.ground, before.unambiguous_voxels.ground);
}

TEST_F(ShadowErrorTest, AFlippedVoxelAddsItsOwnAreaToTheDisplacement) {
  const Displacement before = errors().displacement.ground;
  states_[voxel_at(25, 25, 4)] = golden::VoxelState::Shadow;
  const Displacement after = errors().displacement.ground;
  EXPECT_NEAR(after.area_cast - before.area_cast, 1.0, 1e-6);
  EXPECT_EQ(after.border_cast, before.border_cast);
}

TEST_F(ShadowErrorTest, WithoutAGroundEverythingIsAModel) {
  const ShadowErrors e = shadow_errors(truth_, voxels_, states_, {});
  EXPECT_EQ(e.all_voxels.ground.compared, 0u);
  EXPECT_EQ(e.all_voxels.models.compared, voxels_.voxels.size());
}

TEST_F(ShadowErrorTest, RefusesStatesThatAreNone) {
  states_.back() = golden::VoxelState::Empty;
  EXPECT_THROW(errors(), std::invalid_argument);
  states_.pop_back();
  EXPECT_THROW(errors(), std::invalid_argument);
}

}  // namespace
}  // namespace gnomon::metrics
