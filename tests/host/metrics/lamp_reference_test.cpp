// SPDX-License-Identifier: Apache-2.0
// Spot and point lights, and objects that throw or take no shadows, against shapes whose shadows are known in
// closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "host/metrics/exact_reference.hpp"
#include "tests/host/metrics/fixtures.hpp"
#include "tests/host/metrics/known_shapes.hpp"

namespace gnomon::metrics {
namespace {

double radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}

/// Answers at random points of a ground that is object `object`.
struct Tally {
  std::size_t compared = 0, dark = 0, wrong = 0;

  /// `expected(p)` is dark, lit, or neither where the point is on the border itself.
  template <class Expected>
  void add(const ExactReference& reference, const surface::LimitSurface& ground, std::uint32_t object,
           const Expected& expected) {
    for (SurfaceQuery& q : random_points(ground, 20000, 11)) {
      q.object = object;
      const std::optional<bool> shadow = expected(q.point);
      if (!shadow) continue;
      ++compared;
      dark += *shadow ? 1U : 0U;
      wrong += in_shadow(reference.classify(q)) != *shadow ? 1U : 0U;
    }
  }
};

/// A torus around the z axis, a ground under it, and a lamp on the axis: the shadow is a ring between two
/// circles.
struct RingShadow {
  static constexpr double kMajor = 20, kMinor = 6, kHeight = 40, kLamp = 100, kGround = 10;
  Vec3 lamp{64, 64, kLamp};
  std::vector<surface::LimitSurface> surfaces =
      fixtures::surfaces({fixtures::torus({64, 64, kHeight}, kMajor, kMinor, 64, 32),
                          fixtures::sheet(2, 2, 126, 126, kGround, 3, 3)});

  /// The tangents from the lamp to the tube's circle, where they meet the ground. Points closer than `band`
  /// to either have no answer.
  static std::optional<bool> dark(const Vec3& p, double band) {
    const double middle = std::atan2(kMajor, kLamp - kHeight);
    const double half = std::asin(kMinor / std::hypot(kMajor, kLamp - kHeight));
    const double near = (kLamp - kGround) * std::tan(middle - half);
    const double far = (kLamp - kGround) * std::tan(middle + half);
    const double r = std::hypot(p.x - 64, p.y - 64);
    if (std::abs(r - near) < band || std::abs(r - far) < band) return std::nullopt;
    return r > near && r < far;
  }
};

TEST(LampReference, ATorusUnderALampThrowsARing) {
  const RingShadow scene;
  for (const Light& light : {Light{PointLight{scene.lamp}}, Light{SpotLight{scene.lamp, {0, 0, -1}, 60}}}) {
    Tally tally;
    tally.add(ExactReference(scene.surfaces, {false, true}, light), scene.surfaces[1], 1,
              [](const Vec3& p) { return RingShadow::dark(p, 0.02); });
    EXPECT_GT(tally.compared, 19900U);
    EXPECT_GT(tally.dark, 3000U);
    EXPECT_EQ(tally.wrong, 0U);
  }
}

TEST(LampReference, TheRingTestSeesALampThatIsATenthOfAVoxelOff) {
  RingShadow scene;
  scene.lamp.x += 0.1;
  Tally tally;
  tally.add(ExactReference(scene.surfaces, {false, true}, PointLight{scene.lamp}), scene.surfaces[1], 1,
            [](const Vec3& p) { return RingShadow::dark(p, 0.02); });
  EXPECT_GT(tally.wrong, 0U);
}

TEST(LampReference, ATorusCastsItsKnownShadowOnItself) {
  const Vec3 center(64, 64, 64);
  const auto surfaces = fixtures::surfaces({fixtures::torus(center, 40, 15, 64, 32)});
  const auto points = random_points(surfaces[0], 2000, 2);
  const ExactReference dark(surfaces, {false}, PointLight{{0, 0, 0}});
  std::size_t compared = 0, cast = 0, wrong = 0;
  // Outside, in the hole, and close to the tube.
  for (const Vec3& lamp : {Vec3(160, 90, 80), Vec3(64, 64, 66), Vec3(124, 64, 70)}) {
    const ExactReference reference = dark.relit(PointLight{lamp});
    const auto answers = reference.classify(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec3 way = lamp - points[i].point;
      if (points[i].normal.dot(way) <= 0) {
        EXPECT_EQ(answers[i], Exact::Attached);
        continue;
      }
      const double gap = clearance(points[i].point - center, way.normalized(), 40, 15, way.length());
      if (std::abs(gap) < 0.02) continue;
      ++compared;
      cast += gap < 0 ? 1U : 0U;
      wrong += answers[i] != (gap < 0 ? Exact::Cast : Exact::Lit) ? 1U : 0U;
    }
  }
  EXPECT_GT(compared, 1500U);
  EXPECT_GT(cast, 100U);
  EXPECT_EQ(wrong, 0U);
}

TEST(LampReference, ABoxShadesTheGroundOnlyWhereItLiesBeforeTheLamp) {
  const Box3 body(Vec3(90, 100, 20), Vec3(150, 140, 75));
  const auto surfaces = fixtures::surfaces(
      {fixtures::box(body.min, body.max, true), fixtures::sheet(4, 4, 250, 250, 10, 5, 3)});
  const auto grown = [&](double by) { return Box3(body.min - Vec3(by), body.max + Vec3(by)); };
  std::size_t dark = 0;
  // Above, beside and below the top, and under the box.
  for (const Vec3& lamp : {Vec3(60, 80, 200), Vec3(60, 80, 40), Vec3(120, 120, 15)}) {
    Tally tally;
    tally.add(ExactReference(surfaces, {false, true}, PointLight{lamp}), surfaces[1], 1,
              [&](const Vec3& p) -> std::optional<bool> {
                const Vec3 way = lamp - p;
                const auto meets = [&](double by) {
                  return meets_box(p, way.normalized(), grown(by), way.length());
                };
                if (meets(0.05) != meets(-0.05)) return std::nullopt;
                return meets(0);
              });
    EXPECT_GT(tally.compared, 19500U);
    EXPECT_EQ(tally.wrong, 0U);
    dark += tally.dark;
  }
  EXPECT_GT(dark, 5000U);
}

TEST(LampReference, NothingBehindALampThrowsAShadow) {
  const auto surfaces =
      fixtures::surfaces({fixtures::rectangle(4, 4, 60, 60, 40), fixtures::sheet(4, 4, 60, 60, 10, 2, 2)});
  const SurfaceQuery below{{30, 32, 10}, {0, 0, 1}, 1};
  for (const Light& light :
       {Light{PointLight{{32, 32, 39.9}}}, Light{SpotLight{{32, 32, 39.9}, {0, 0, -1}, 30}}})
    EXPECT_EQ(ExactReference(surfaces, {true, true}, light).classify(below), Exact::Lit);
  for (const Light& light :
       {Light{PointLight{{32, 32, 40.1}}}, Light{SpotLight{{32, 32, 40.1}, {0, 0, -1}, 30}}})
    EXPECT_EQ(ExactReference(surfaces, {true, true}, light).classify(below), Exact::Cast);
}

TEST(LampReference, ALampInsideAClosedObjectLightsNothingOutside) {
  const auto surfaces = fixtures::surfaces(
      {fixtures::box({20, 20, 20}, {40, 40, 40}, true), fixtures::sheet(2, 2, 62, 62, 10, 2, 2)});
  const ExactReference reference(surfaces, {false, true}, PointLight{{30, 31, 32}});
  for (const SurfaceQuery& q : random_points(surfaces[0], 2000, 3))
    EXPECT_EQ(reference.classify(q), Exact::Attached);
  for (SurfaceQuery& q : random_points(surfaces[1], 2000, 4)) {
    q.object = 1;
    EXPECT_EQ(reference.classify(q), Exact::Cast);
  }
}

TEST(LampReference, AConvexSurfaceCastsNothingOnItself) {
  const auto surfaces = fixtures::surfaces({fixtures::box({10, 20, 30}, {70, 65, 60}, false)});
  const ExactReference dark(surfaces, {false}, PointLight{{0, 0, 0}});
  const auto points = random_points(surfaces[0], 20000, 1);
  std::size_t wrong = 0;
  for (const Vec3& lamp : {Vec3(40, 40, 61), Vec3(5, 5, 5), Vec3(90, 42, 45), Vec3(40, 1e5, 2e5)}) {
    const auto answers = dark.relit(PointLight{lamp}).classify(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const bool faces = points[i].normal.dot((lamp - points[i].point).normalized()) > 1e-9;
      wrong += answers[i] != (faces ? Exact::Lit : Exact::Attached) ? 1U : 0U;
    }
  }
  EXPECT_EQ(wrong, 0U);
}

TEST(LampReference, AConeEndsInACircleOnTheGround) {
  const auto surfaces = fixtures::surfaces({fixtures::sheet(2, 2, 126, 126, 10, 3, 3)});
  for (const double half : {5.0, 20.0, 45.0}) {
    const double radius = 40 * std::tan(radians(half));
    Tally tally;
    tally.add(ExactReference(surfaces, {true}, SpotLight{{60, 66, 50}, {0, 0, -1}, half}), surfaces[0], 0,
              [&](const Vec3& p) -> std::optional<bool> {
                const double r = std::hypot(p.x - 60, p.y - 66);
                if (std::abs(r - radius) < 1e-9) return std::nullopt;
                return r > radius;
              });
    EXPECT_EQ(tally.compared, 20000U);
    EXPECT_LT(tally.dark, 20000U);
    EXPECT_EQ(tally.wrong, 0U) << half;
  }
}

TEST(LampReference, ATiltedConeEndsInItsEllipse) {
  const auto surfaces = fixtures::surfaces({fixtures::sheet(2, 2, 126, 126, 10, 3, 3)});
  const double tilt = radians(30), half = radians(20), height = 40;
  const ExactReference reference(surfaces, {true},
                                 SpotLight{{40, 64, 10 + height}, {std::sin(tilt), 0, -std::cos(tilt)}, 20});
  // Where the cone's two outermost rays meet the ground, and the ellipse's half width between them.
  const double from = height * std::tan(tilt - half), to = height * std::tan(tilt + half);
  const double middle = (from + to) / 2, long_half = (to - from) / 2;
  const double wide_half =
      height * std::sin(half) / std::sqrt(std::cos(tilt) * std::cos(tilt) - std::sin(half) * std::sin(half));
  Tally tally;
  tally.add(reference, surfaces[0], 0, [&](const Vec3& p) -> std::optional<bool> {
    const double at = std::hypot((p.x - 40 - middle) / long_half, (p.y - 64) / wide_half);
    if (std::abs(at - 1) < 1e-9) return std::nullopt;
    return at > 1;
  });
  EXPECT_EQ(tally.compared, 20000U);
  EXPECT_GT(tally.dark, 5000U);
  EXPECT_LT(tally.dark, 19000U);
  EXPECT_EQ(tally.wrong, 0U);
  EXPECT_EQ(reference.classify({{120, 64, 10}, {0, 0, 1}, 0}), Exact::Outside);
  EXPECT_EQ(reference.classify({{40 + middle, 64, 10}, {0, 0, 1}, 0}), Exact::Lit);
}

TEST(LampReference, NothingBehindASpotIsLit) {
  const auto surfaces = fixtures::surfaces({fixtures::rectangle(4, 4, 60, 60, 40)});
  const ExactReference reference(surfaces, {true}, SpotLight{{32, 32, 30}, {0, 0, -1}, 80});
  EXPECT_EQ(reference.classify({{32, 32, 40}, {0, 0, 1}, 0}), Exact::Outside);
}

TEST(LampReference, ALampFarAwayIsADirectionalLight) {
  const auto surfaces = fixtures::surfaces({fixtures::torus({32, 32, 32}, 20, 7, 12, 8)});
  const auto points = random_points(surfaces[0], 20000, 5);
  const Vec3 travel = Vec3(1, 0.2, -0.3).normalized();
  const ExactReference parallel(surfaces, {false}, DirectionalLight{travel});
  const auto expected = parallel.classify(points);
  const auto answers = parallel.relit(PointLight{Vec3(32, 32, 32) - travel * 1e6}).classify(points);
  std::size_t differing = 0;
  for (std::size_t i = 0; i < points.size(); ++i) differing += answers[i] != expected[i] ? 1U : 0U;
  EXPECT_LE(differing, 10U);
  const auto near = parallel.relit(PointLight{Vec3(32, 32, 32) - travel * 100}).classify(points);
  differing = 0;
  for (std::size_t i = 0; i < points.size(); ++i) differing += near[i] != expected[i] ? 1U : 0U;
  EXPECT_GT(differing, 100U);
}

TEST(LampReference, ObjectsThatDoNotCastAreNotThere) {
  const auto surfaces = fixtures::surfaces({fixtures::box({20, 20, 20}, {40, 40, 40}, true),
                                            fixtures::box({20, 20, 50}, {40, 40, 60}, true),
                                            fixtures::sheet(2, 2, 62, 62, 10, 2, 2)});
  const Light light = DirectionalLight{{0, 0, -1}};
  const SurfaceQuery ground{{30, 30, 10}, {0, 0, 1}, 2}, top{{30, 30, 40}, {0, 0, 1}, 0};
  const ExactReference all(surfaces, {false, false, true}, light);
  EXPECT_EQ(all.classify(ground), Exact::Cast);
  EXPECT_EQ(all.classify(top), Exact::Cast);
  const ExactReference one(surfaces, {{false, false, true}, {true, false, true}, {}}, light);
  EXPECT_EQ(one.classify(ground), Exact::Cast);
  EXPECT_EQ(one.classify(top), Exact::Lit);
  EXPECT_LT(one.triangles(), all.triangles());
  const ExactReference none(surfaces, {{false, false, true}, {false, false, false}, {}}, light);
  EXPECT_EQ(none.classify(ground), Exact::Lit);
  EXPECT_EQ(none.triangles(), 0U);
}

TEST(LampReference, ObjectsThatDoNotReceiveAreLitWhereTheyFaceALightThatReachesThem) {
  const auto surfaces = fixtures::surfaces(
      {fixtures::box({20, 20, 20}, {40, 40, 40}, true), fixtures::box({20, 20, 50}, {40, 40, 60}, true)});
  const ReferenceObjects objects{{}, {}, {false, true}};
  const SurfaceQuery top{{30, 30, 40}, {0, 0, 1}, 0}, bottom{{30, 30, 20}, {0, 0, -1}, 0};
  const ExactReference reference(surfaces, objects, DirectionalLight{{0, 0, -1}});
  EXPECT_EQ(reference.classify(top), Exact::Lit);
  EXPECT_EQ(reference.classify(bottom), Exact::Attached);
  EXPECT_EQ(ExactReference(surfaces, {false, false}, DirectionalLight{{0, 0, -1}}).classify(top),
            Exact::Cast);
  const ExactReference narrow = reference.relit(SpotLight{{60, 30, 80}, {0, 0, -1}, 10});
  EXPECT_EQ(narrow.classify(top), Exact::Outside);
  EXPECT_FALSE(reference.receives(0));
  EXPECT_TRUE(reference.receives(1));
}

TEST(LampReference, RefusesALampWithoutAPlaceOrAWay) {
  const auto surfaces = fixtures::surfaces({fixtures::rectangle(4, 4, 28, 28, 10)});
  const auto make = [&](const Light& light) { return ExactReference(surfaces, {true}, light); };
  EXPECT_THROW(make(PointLight{{NAN, 0, 0}}), std::invalid_argument);
  EXPECT_THROW(make(PointLight{{0, INFINITY, 0}}), std::invalid_argument);
  EXPECT_THROW(make(SpotLight{{0, 0, 0}, {0, 0, 0}, 20}), std::invalid_argument);
  EXPECT_THROW(make(SpotLight{{0, NAN, 0}, {0, 0, 1}, 20}), std::invalid_argument);
}

}  // namespace
}  // namespace gnomon::metrics
