// SPDX-License-Identifier: Apache-2.0
// The reference against shapes whose shadows are known in closed form.
#include "host/metrics/exact_reference.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/host/metrics/fixtures.hpp"
#include "tests/host/metrics/known_shapes.hpp"

namespace gnomon::metrics {
namespace {

const std::vector<Vec3> kLights = {{0, 0, -1},  {1, 0, 0},     {0.3, -0.8, -0.5},
                                   {-1, 2, -3}, {1, 1, -0.05}, {0.02, 1, 0.03}};

TEST(ExactReference, AConvexSurfaceCastsNothingOnItself) {
  for (const bool sharp : {false, true}) {
    const auto surfaces = fixtures::surfaces({fixtures::box({10, 20, 30}, {70, 65, 60}, sharp)});
    const ExactReference dark(surfaces, {false}, DirectionalLight{{1, 1, 1}});
    const auto points = random_points(surfaces[0], 20000, 1);
    std::size_t compared = 0;
    std::size_t wrong = 0;
    for (const Vec3& travel : kLights) {
      const ExactReference reference = dark.relit(DirectionalLight{travel});
      const auto answers = reference.classify(points);
      for (std::size_t i = 0; i < points.size(); ++i, ++compared) {
        const bool faces = points[i].normal.dot(reference.to_light({})) > 1e-9;
        if (answers[i] != (faces ? Exact::Lit : Exact::Attached)) ++wrong;
      }
    }
    EXPECT_EQ(compared, 120000u);
    EXPECT_EQ(wrong, 0u);
  }
}

TEST(ExactReference, ATorusCastsItsKnownShadowOnItself) {
  const Vec3 center(64, 64, 64);
  const auto surfaces = fixtures::surfaces({fixtures::torus(center, 40, 15, 64, 32)});
  const std::vector<SurfaceQuery> points = random_points(surfaces[0], 2000, 2);
  const ExactReference dark(surfaces, {false}, DirectionalLight{{0, 0, 1}});
  std::size_t compared = 0;
  std::size_t cast = 0;
  std::size_t wrong = 0;
  for (const Vec3& travel : {Vec3(1, 0.2, -0.3), Vec3(1, 0, -0.05), Vec3(0.5, -1, -1)}) {
    const ExactReference reference = dark.relit(DirectionalLight{travel});
    const auto answers = reference.classify(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      ASSERT_LT(std::abs(torus_distance(points[i].point - center, 40, 15)), 0.002);
      if (points[i].normal.dot(reference.to_light({})) <= 0) {
        EXPECT_EQ(answers[i], Exact::Attached);
        continue;
      }
      const double gap = clearance(points[i].point - center, reference.to_light({}), 40, 15);
      if (std::abs(gap) < 0.02) continue;  // on the border itself
      ++compared;
      const Exact expected = gap < 0 ? Exact::Cast : Exact::Lit;
      if (expected == Exact::Cast) ++cast;
      if (answers[i] != expected) ++wrong;
    }
  }
  EXPECT_GT(compared, 2700u);
  EXPECT_GT(cast, 300u);
  EXPECT_EQ(wrong, 0u);
}

TEST(ExactReference, ABoxShadesTheGroundWhereSlabsSaySo) {
  const Box3 body(Vec3(90, 100, 20), Vec3(150, 140, 75));
  const auto surfaces = fixtures::surfaces(
      {fixtures::box(body.min, body.max, true), fixtures::sheet(4, 4, 250, 250, 20, 5, 3)});
  std::size_t compared = 0;
  std::size_t shadowed = 0;
  std::size_t wrong = 0;
  for (const Vec3& travel : {Vec3(0, 0, -1), Vec3(1, 0.5, -1), Vec3(-1, -0.3, -0.2)}) {
    const ExactReference reference(surfaces, {false, true}, DirectionalLight{travel});
    // The lift moves the border by at most itself in the light's plane, by more where that plane is seen at a
    // slant.
    const double band = 3 * reference.lift() / reference.to_light({}).z;
    for (SurfaceQuery& q : random_points(surfaces[1], 20000, 3)) {
      q.object = 1;
      const Vec3 start = q.point + Vec3(0, 0, 1e-6);
      Box3 larger = body;
      Box3 smaller = body;
      larger.min -= Vec3(band, band, band);
      larger.max += Vec3(band, band, band);
      smaller.min += Vec3(band, band, 0);
      smaller.max -= Vec3(band, band, band);
      const bool expected = meets_box(start, reference.to_light({}), body);
      if (meets_box(start, reference.to_light({}), larger) !=
          meets_box(start, reference.to_light({}), smaller))
        continue;
      ++compared;
      shadowed += expected ? 1u : 0u;
      if (in_shadow(reference.classify(q)) != expected) ++wrong;
    }
  }
  EXPECT_GT(compared, 55000u);
  EXPECT_GT(shadowed, 5000u);
  EXPECT_EQ(wrong, 0u);
}

TEST(ExactReference, TheBandOfTheBoxTestIsNarrowEnoughToSeeAShiftedBox) {
  const auto moved = fixtures::surfaces(
      {fixtures::box({90.2, 100, 20}, {150.2, 140, 75}, true), fixtures::sheet(4, 4, 250, 250, 20, 5, 3)});
  const ExactReference reference(moved, {false, true}, DirectionalLight{{0, 0, -1}});
  std::size_t wrong = 0;
  for (const SurfaceQuery& q : random_points(moved[1], 20000, 3)) {
    const bool expected = meets_box(q.point, {0, 0, 1}, Box3(Vec3(90, 100, 20), Vec3(150, 140, 75)));
    if (in_shadow(reference.classify({q.point, q.normal, 1})) != expected) ++wrong;
  }
  EXPECT_GT(wrong, 0u);
}

TEST(ExactReference, OpenSurfacesAreLitFromBothSides) {
  const auto surfaces = fixtures::surfaces({fixtures::rectangle(4, 4, 28, 28, 10)});
  const SurfaceQuery middle{{16, 16, 10}, {0, 0, 1}, 0};
  for (const double z : {-1.0, 1.0}) {
    EXPECT_EQ(ExactReference(surfaces, {true}, DirectionalLight{{0.2, 0.1, z}}).classify(middle), Exact::Lit);
    EXPECT_EQ(ExactReference(surfaces, {false}, DirectionalLight{{0.2, 0.1, z}}).classify(middle),
              z < 0 ? Exact::Lit : Exact::Attached);
  }
  // Along the light nothing is lit, on either kind.
  EXPECT_EQ(ExactReference(surfaces, {true}, DirectionalLight{{1, 0, 0}}).classify(middle), Exact::Attached);
}

TEST(ExactReference, CountsItsRays) {
  const auto surfaces = fixtures::surfaces({fixtures::box({10, 20, 30}, {70, 65, 60}, false)});
  const ExactReference reference(surfaces, {false}, DirectionalLight{{0, 0, -1}});
  const auto points = random_points(surfaces[0], 1000, 4);
  std::uint64_t facing = 0;
  for (const SurfaceQuery& q : points) facing += q.normal.z > 1e-9 ? 1 : 0;
  EXPECT_EQ(reference.classify(points).size(), 1000u);
  EXPECT_EQ(reference.rays(), facing);
}

TEST(ExactReference, RefusesALightWithoutDirection) {
  const auto surfaces = fixtures::surfaces({fixtures::rectangle(4, 4, 28, 28, 10)});
  EXPECT_THROW(ExactReference(surfaces, {true}, DirectionalLight{{0, 0, 0}}), std::invalid_argument);
  EXPECT_THROW(ExactReference(surfaces, {true}, DirectionalLight{{NAN, 0, 0}}), std::invalid_argument);
}

TEST(ExactReference, HalvingTheEdgesChangesNextToNothing) {
  const auto surfaces = fixtures::surfaces({fixtures::torus({32, 32, 32}, 20, 7, 12, 8)});
  const auto points = random_points(surfaces[0], 20000, 5);
  TessellationOptions finer;
  finer.sag /= 4;
  const DirectionalLight light{{1, 0.2, -0.3}};
  const auto usual = ExactReference(surfaces, {false}, light).classify(points);
  const auto fine = ExactReference(surfaces, {false}, light, finer).classify(points);
  std::size_t changed = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    changed += in_shadow(usual[i]) != in_shadow(fine[i]) ? 1u : 0u;
  EXPECT_LE(changed, 4u);  // 0.02 %
}

}  // namespace
}  // namespace gnomon::metrics
