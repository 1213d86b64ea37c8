// SPDX-License-Identifier: Apache-2.0
// The displacement of known displacements, and against the golden tests' own measurement.
#include "host/slb/border_samples.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host/slb/fixed_point.hpp"
#include "tests/golden/slb/displacement.hpp"
#include "tests/host/slb/shapes.hpp"

namespace gnomon::slb {
namespace {

namespace gold = golden::slb;

/// What the golden model answers to the samples after drawing `scene`.
Displacement measure(const LoopScene& drawn, const BorderSamples& samples, const gold::SlbConfig& config) {
  gold::SlbModel model(config);
  const auto casters = to_fixed(drawn, config).value();
  for (const FixedCaster& caster : casters) {
    model.begin_object(0, true, caster.depth);
    for (const auto& loop : caster.loops) model.loop(loop);
    model.fill();
    model.end_object();
  }
  std::vector<gold::QueryAnswer> answers;
  answers.reserve(samples.queries.size());
  for (const gold::QueryPoint& point : samples.queries) answers.push_back(model.query(point, 0));
  return displacement(samples, answers);
}

LoopScene rectangle(double left, double low, double right, double high) {
  return {{0.5, {{{left, low}, {right, low}, {right, high}, {left, high}}}}};
}

TEST(BorderSamples, AShiftOfTwoSidesCountsHalf) {
  const gold::SlbConfig config = test::small_plane(7);
  const LoopScene square = rectangle(10, 10, 42, 42);
  const PolygonReference reference(square, config.side());
  const BorderSamples samples = border_samples(reference, config, {400, 1});
  EXPECT_NEAR(samples.border, 128, 1e-9);
  const Displacement exact = measure(square, samples, config);
  EXPECT_EQ(exact.wrong, 0U) << "rectangles on the grid have no error";
  EXPECT_EQ(exact.plain_map, 0);
  EXPECT_EQ(exact.fine_map, 0);
  for (const double shift : {0.125, 0.5}) {
    const Displacement moved = measure(rectangle(10 + shift, 10, 42 + shift, 42), samples, config);
    EXPECT_NEAR(moved.buffer, shift / 2, 0.003);
    const Displacement grown =
        measure(rectangle(10 - shift, 10 - shift, 42 + shift, 42 + shift), samples, config);
    EXPECT_NEAR(grown.buffer, shift + shift * shift / 32, 0.005);
  }
}

TEST(BorderSamples, SeesHolesAwayFromTheBorder) {
  const gold::SlbConfig config = test::small_plane(4);
  const LoopScene square = rectangle(10, 10, 42, 42);
  const BorderSamples samples = border_samples(PolygonReference(square, config.side()), config, {16, 1});
  LoopScene holed = square;
  holed[0].loops.push_back({{20, 20}, {20, 24}, {24, 24}, {24, 20}});
  EXPECT_NEAR(measure(holed, samples, config).buffer, 16.0 / 128, 1e-6);
}

TEST(BorderSamples, HiddenOutlinesAreNoBorder) {
  const gold::SlbConfig config = test::small_plane(4);
  LoopScene scene = rectangle(10, 10, 42, 42);
  scene.push_back(rectangle(20, 20, 30, 30)[0]);  // inside the first
  scene.push_back(rectangle(-20, 50, 8, 58)[0]);  // half off the plane
  const BorderSamples samples = border_samples(PolygonReference(scene, config.side()), config, {1, 1});
  EXPECT_NEAR(samples.border, 4 * 32 + 2 * 8 + 8, 0.2);
}

TEST(BorderSamples, PlainMapsAreOffByAQuarterPixel) {
  const gold::SlbConfig config = test::small_plane(4);
  double plain = 0, fine = 0;
  for (std::uint64_t i = 1; i <= 6; ++i) {
    const auto scene = test::from_golden(gold::testing::shape("random 24-gon").make(config, i), config);
    const BorderSamples samples = border_samples(PolygonReference(scene, config.side()), config, {256, i});
    plain += samples.plain_wrong / samples.border / 6;
    fine += samples.fine_wrong / samples.border / 6;
  }
  EXPECT_NEAR(plain, 0.245, 0.012);
  EXPECT_NEAR(fine, 0.244 / 16, 0.001);
}

TEST(BorderSamples, AgreesWithTheGoldenTestsMeasurement) {
  for (const char* name : {"random 24-gon", "gear, pitch 5 px"}) {
    for (const int frac_bits : {4, 7}) {
      const gold::SlbConfig config = test::small_plane(frac_bits);
      const gold::testing::Scene scene = gold::testing::shape(name).make(config, 2);
      const gold::testing::Displacement expected = gold::testing::measure(scene, config, 900, 4);
      const LoopScene casters = test::from_golden(scene, config);
      const BorderSamples samples =
          border_samples(PolygonReference(casters, config.side()), config, {900, 9});
      const Displacement found = measure(casters, samples, config);
      EXPECT_NEAR(found.border, expected.length, 0.01 * expected.length);
      EXPECT_NEAR(found.ratio(), expected.ratio(), 0.1 * expected.ratio()) << name << " F=" << frac_bits;
      EXPECT_LT(found.ratio(), 0.75);
      EXPECT_GT(found.wrong, 20U);
    }
  }
}

TEST(BorderSamples, NeedsAnAnswerASample) {
  const gold::SlbConfig config = test::small_plane(4);
  const BorderSamples samples = border_samples(PolygonReference(rectangle(1, 1, 3, 3), 64), config, {1, 1});
  EXPECT_THROW(displacement(samples, {}), std::invalid_argument);
  EXPECT_THROW(border_samples(PolygonReference({}, 32), config, {1, 1}), std::invalid_argument);
  const std::vector<gold::QueryAnswer> lit(samples.queries.size());
  EXPECT_NEAR(displacement(samples, lit).buffer, 4.0 / 8, 1e-6);
}

}  // namespace
}  // namespace gnomon::slb
