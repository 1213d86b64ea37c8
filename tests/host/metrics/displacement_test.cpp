// SPDX-License-Identifier: Apache-2.0
// A shadow moved, or grown, by a known distance has that displacement.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "host/metrics/shadow_error.hpp"
#include "tests/host/metrics/fixtures.hpp"

namespace gnomon::metrics {
namespace {

constexpr double kSide = 12;

class DisplacementTest : public testing::Test {
 protected:
  DisplacementTest()
      : surfaces_(fixtures::surfaces({fixtures::rectangle(9.3, 9.3, 9.3 + kSide, 9.3 + kSide, 20.5),
                                      fixtures::sheet(2, 2, 30, 30, 4.5, 4, 4)})),
        voxels_(fixtures::voxels(surfaces_, 32)) {}

  ShadowTruth truth(const Vec3& travel, double spacing = 0.05) const {
    TruthOptions options;
    options.spacing = spacing;
    return shadow_truth(ExactReference(surfaces_, {true, true}, DirectionalLight{travel}), surfaces_, voxels_,
                        options);
  }

  /// The technique's answer on the ground; above it, nothing is in shadow.
  static double measured(const ShadowTruth& truth, double pitch,
                         const std::function<bool(double x, double y)>& dark) {
    SampleAnswers answers;
    const auto answer = [&](const SurfaceSample& s) -> std::uint8_t {
      return s.object == 1 && dark(double{s.x}, double{s.y}) ? 1 : 0;
    };
    for (const SurfaceSample& s : truth.samples) answers.samples.push_back(answer(s));
    for (const SurfaceSample& s : truth.border_samples) answers.border.push_back(answer(s));
    return displacement(truth, answers, {1u, pitch}).ground.entries();
  }

  static bool inside(double x, double y, double grow) {
    return x > 9.3 - grow && x < 9.3 + kSide + grow && y > 9.3 - grow && y < 9.3 + kSide + grow;
  }

  std::vector<surface::LimitSurface> surfaces_;
  voxel::VoxelSet voxels_;
};

TEST_F(DisplacementTest, AGrownSquareIsOffByHowMuchItGrew) {
  const ShadowTruth exact = truth({0, 0, -1});
  for (const double d : {0.25, 0.5, 1.0}) {
    const auto grown = [d](double x, double y) { return inside(x, y, d); };
    const double expected = d + d * d / kSide;  // with its four corners
    EXPECT_NEAR(measured(exact, 1, grown), expected, 0.02);
    EXPECT_NEAR(measured(exact, 2, grown), expected / 2, 0.01);
    const auto shrunk = [d](double x, double y) { return inside(x, y, -d); };
    EXPECT_NEAR(measured(exact, 1, shrunk), d - d * d / kSide, 0.02);
  }
}

TEST_F(DisplacementTest, AShiftCountsAcrossTheBorderNotAlongIt) {
  const ShadowTruth exact = truth({0, 0, -1});
  // Of the four sides two move by d and two slide along themselves.
  const double d = 0.6;
  EXPECT_NEAR(measured(exact, 1, [d](double x, double y) { return inside(x - d, y, 0); }), d / 2, 0.02);
}

TEST_F(DisplacementTest, ObliqueLightIsMeasuredInItsOwnPlane) {
  const ShadowTruth exact = truth({0.25, 0, -1});
  const double shift = 0.25 * (20.5 - 4.5);
  const double cosine = 1 / std::hypot(0.25, 1);
  const double d = 0.5;
  const auto moved = [&](double x, double y) { return inside(x - shift - d, y, 0); };
  const double area = 2 * d * kSide * cosine;
  const double border = 2 * kSide + 2 * kSide * cosine;
  EXPECT_NEAR(measured(exact, 1, moved), area / border, 0.02);
}

TEST_F(DisplacementTest, TheExactAnswerIsNotDisplaced) {
  const ShadowTruth exact = truth({0, 0, -1});
  EXPECT_LT(measured(exact, 1, [](double x, double y) { return inside(x, y, 0); }), 0.005);
}

TEST_F(DisplacementTest, SeesFarLessThanTheSamplesAreApart) {
  const ShadowTruth exact = truth({0, 0, -1}, 0.5);
  for (const double d : {0.01, 0.02, 0.05}) {
    EXPECT_NEAR(measured(exact, 1, [d](double x, double y) { return inside(x, y, d); }), d, 0.004);
    EXPECT_NEAR(measured(exact, 1, [d](double x, double y) { return inside(x, y, -d); }), d, 0.004);
  }
}

TEST_F(DisplacementTest, AreaIsCountedOnceWhetherMeasuredFinelyOrNot) {
  const ShadowTruth exact = truth({0, 0, -1}, 0.5);
  SampleAnswers wrong;
  for (const SurfaceSample& s : exact.samples) wrong.samples.push_back(in_shadow(s.exact) ? 0 : 1);
  for (const SurfaceSample& s : exact.border_samples) wrong.border.push_back(in_shadow(s.exact) ? 0 : 1);
  EXPECT_GT(exact.border_samples.size(), 64u * 80);
  EXPECT_NEAR(displacement(exact, wrong, {1u, 1.0}).ground.area_cast, 28.0 * 28.0, 0.01);
}

TEST_F(DisplacementTest, NeedsOneAnswerASample) {
  const ShadowTruth exact = truth({0, 0, -1});
  SampleAnswers few;
  few.samples.resize(3);
  EXPECT_THROW(displacement(exact, few, {}), std::invalid_argument);
  EXPECT_THROW(sample_mislabels(exact, few.samples, {}), std::invalid_argument);
  few.samples.resize(exact.samples.size());
  EXPECT_THROW(displacement(exact, few, {}), std::invalid_argument);
}

}  // namespace
}  // namespace gnomon::metrics
