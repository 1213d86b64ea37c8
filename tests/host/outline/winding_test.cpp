// SPDX-License-Identifier: Apache-2.0
// Loops close, run the right way round, and their winding number is the number of sheets.
#include "winding.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "cases.hpp"
#include "sheets.hpp"

namespace gnomon::outline::test {
namespace {

constexpr double kPixels = 96;

/// Edges, the closing one included, are no longer than they may be: a loop that does not close would need a
/// long one.
std::size_t expect_closed(const ObjectOutline& outline, double max_edge) {
  std::size_t edges = 0;
  for (const Loop& loop : outline.loops) {
    EXPECT_GE(loop.size(), 3U);
    for (std::size_t i = 0; i < loop.size(); ++i, ++edges) {
      const Vertex& b = loop[(i + 1) % loop.size()];
      const double e = std::hypot(b.x - loop[i].x, b.y - loop[i].y);
      EXPECT_GT(e, 0) << i;
      EXPECT_LE(e, max_edge) << i;
    }
  }
  return edges;
}

/// Random points, half of them near the loops.
class Points {
 public:
  Points(const Box3& area, const std::vector<Loop>& loops, unsigned seed)
      : area_(area), loops_(loops), random_(seed) {}
  Vec2 next() {
    near_ = !near_ && !loops_.empty();
    if (!near_)
      return {area_.min.x + (area_.size().x + 2) * unit_(random_) - 1,
              area_.min.y + (area_.size().y + 2) * unit_(random_) - 1};
    const Loop& loop = loops_[random_() % loops_.size()];
    const Vertex& v = loop[random_() % loop.size()];
    return {v.x + unit_(random_) - 0.5, v.y + unit_(random_) - 0.5};
  }

 private:
  Box3 area_;
  const std::vector<Loop>& loops_;
  std::mt19937 random_;
  std::uniform_real_distribution<double> unit_{0, 1};
  bool near_ = false;
};

struct Tally {
  std::size_t asked = 0, too_near = 0, in_shadow = 0, several = 0;
  std::size_t not_facing = 0, not_averted = 0, not_all = 0;  ///< winding numbers that are not this count
};

/// The winding number is at least 1 where there is a sheet, at every point that is not within `margin` of a
/// loop.
Tally expect_shadow(const ObjectOutline& outline, const Sheets& sheets, double margin, int points) {
  const LoopSet loops(outline.loops);
  Points next(sheets.bounds(), outline.loops, 7);
  Tally tally;
  for (int i = 0; i < points; ++i) {
    const Vec2 p = next.next();
    if (loops.distance(p.x, p.y, margin) < margin) {
      ++tally.too_near;
      continue;
    }
    ++tally.asked;
    const Sheets::Count count = sheets.at(p.x, p.y);
    const int all = count.facing + count.averted;
    const int winding = loops.winding(p.x, p.y);
    EXPECT_EQ(winding >= 1, all > 0) << "at " << p.x << ", " << p.y << ": " << winding << ", not " << all;
    tally.not_facing += winding != count.facing ? 1U : 0U;
    tally.not_averted += winding != count.averted ? 1U : 0U;
    tally.not_all += winding != all ? 1U : 0U;
    tally.in_shadow += all > 0 ? 1U : 0U;
    tally.several += winding > 1 ? 1U : 0U;
  }
  return tally;
}

/// For one part: it is the number of the sheets that face the light; for an open part, those that do not, or
/// all.
void expect_sheets(const ObjectOutline& outline, const Tally& tally) {
  if (outline.statistics.open_parts == 0) {
    EXPECT_EQ(tally.not_facing, 0U);
  } else if (outline.statistics.doubled_parts == 0) {
    EXPECT_EQ(std::min(tally.not_facing, tally.not_averted), 0U);
  } else {
    EXPECT_EQ(tally.not_all, 0U);
  }
}

class EveryCase : public testing::TestWithParam<std::size_t> {};

TEST_P(EveryCase, WindingIsTheNumberOfSheets) {
  const Case c = all_cases()[GetParam()];
  SCOPED_TRACE(c.name);
  const surface::LimitSurface surface = limit_of(c.mesh);
  const std::vector<Corners> triangles = corners_of(surface, 80);
  Tally all;
  for (const Light& light : all_lights()) {
    const LightFrame frame = view_along(light.direction, surface.bounds(), kPixels);
    const Sheets sheets(triangles, frame);
    for (const bool fit_pixels : {false, true}) {
      SCOPED_TRACE(light.name + (fit_pixels ? ", one vertex a pixel" : ""));
      Options options;
      options.fit_pixels = fit_pixels;
      if (!fit_pixels) options.min_edge = 0.1;
      const ObjectOutline outline = outline_of(surface, frame, options);
      EXPECT_EQ(outline.statistics.open_parts, c.open ? 1U : 0U);
      // Balanced edges' ends may be moved a little.
      EXPECT_EQ(expect_closed(outline, options.max_edge + (fit_pixels ? 0.1 : 0)),
                outline.statistics.vertices);
      const Tally tally = expect_shadow(outline, sheets, fit_pixels ? 0.12 : 0.03, 200);
      expect_sheets(outline, tally);
      all.asked += tally.asked;
      all.too_near += tally.too_near;
      all.in_shadow += tally.in_shadow;
      all.several += tally.several;
    }
  }
  EXPECT_GT(all.asked, 2000U);
  EXPECT_LT(all.too_near * 8, all.asked);
  EXPECT_GT(all.in_shadow * 10, all.asked);
}

std::string case_name(const testing::TestParamInfo<std::size_t>& info) {
  std::string name = all_cases()[info.param].name;
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return name;
}
INSTANTIATE_TEST_SUITE_P(Cases, EveryCase, testing::Range(std::size_t{0}, all_cases().size()), case_name);

TEST(Winding, TheCheckNoticesALoopTurnedOver) {
  const surface::LimitSurface surface = limit_of(gnomon::test::torus(8, 6));
  const LightFrame frame = view_along({0, 0, -1}, surface.bounds(), kPixels);
  ObjectOutline outline = outline_of(surface, frame);
  std::reverse(outline.loops[0].begin(), outline.loops[0].end());
  const LoopSet loops(outline.loops);
  const Sheets sheets(corners_of(surface, 8), frame);
  Points next(sheets.bounds(), outline.loops, 7);
  int differ = 0;
  for (int i = 0; i < 200; ++i) {
    const Vec2 p = next.next();
    differ += loops.winding(p.x, p.y) != sheets.at(p.x, p.y).facing ? 1 : 0;
  }
  EXPECT_GT(differ, 20);
}

TEST(Winding, ASphereIsOneLoopAnticlockwise) {
  for (const Light& light : all_lights()) {
    const surface::LimitSurface surface = limit_of(gnomon::test::spindle(3));
    const ObjectOutline o = outline_of(surface, view_along(light.direction, surface.bounds(), kPixels));
    ASSERT_EQ(o.loops.size(), 1U) << light.name;
    EXPECT_GT(signed_area(o.loops[0]), 0) << light.name;
  }
}

TEST(Winding, AHoleRunsClockwise) {
  const surface::LimitSurface surface = limit_of(gnomon::test::torus(8, 6));
  const ObjectOutline o = outline_of(surface, view_along({0, 0, -1}, surface.bounds(), kPixels));
  ASSERT_EQ(o.loops.size(), 2U);
  const double a = signed_area(o.loops[0]);
  const double b = signed_area(o.loops[1]);
  EXPECT_GT(std::max(a, b), 0);
  EXPECT_LT(std::min(a, b), 0);
  EXPECT_GT(a + b, 0);
}

TEST(Winding, AnObliqueTorusHasTwoSheetsSomewhere) {
  const surface::LimitSurface surface = limit_of(gnomon::test::torus(8, 6));
  const LightFrame frame = view_along({0, -0.9, -0.3}, surface.bounds(), kPixels);
  const ObjectOutline o = outline_of(surface, frame);
  const Tally tally = expect_shadow(o, Sheets(corners_of(surface, 60), frame), 0.06, 2000);
  expect_sheets(o, tally);
  EXPECT_GT(tally.several, 100U);
}

TEST(Winding, AMirroredViewHasTheSameShadow) {
  for (const bool mirrored : {false, true})
    for (const scene::ControlMesh& mesh : {cup(), gnomon::test::spindle(3), gnomon::test::sheet(3, 4)}) {
      SCOPED_TRACE(mesh.name);
      const surface::LimitSurface surface = limit_of(mesh);
      const LightFrame frame = view_along({0.3, -0.5, -0.8}, surface.bounds(), kPixels, mirrored);
      const ObjectOutline o = outline_of(surface, frame);
      const Tally tally = expect_shadow(o, Sheets(corners_of(surface, 60), frame), 0.12, 400);
      expect_sheets(o, tally);
      EXPECT_GT(tally.in_shadow, 50U);
    }
}

TEST(Winding, OnlyPartsThatNeedItAreSentTwice) {
  const auto doubled = [](const scene::ControlMesh& mesh, const Vec3& light) {
    const surface::LimitSurface surface = limit_of(mesh);
    return outline_of(surface, view_along(light, surface.bounds(), kPixels)).statistics.doubled_parts;
  };
  // A cup's rim is one simple curve in every view; a tube's two rims wind both ways.
  for (const Light& light : all_lights()) EXPECT_EQ(doubled(cup(), light.direction), 0U) << light.name;
  scene::ControlMesh tube = box(0);
  tube.holes = {0, 1};
  EXPECT_EQ(doubled(tube, {0.5, 0, -0.8}), 1U);
}

TEST(Winding, EdgeOnSheetsCastNothing) {
  const surface::LimitSurface surface = limit_of(plate());
  for (const Vec3& light : {Vec3(1, 0, 0), Vec3(0.3, 0.7, 0), Vec3(0, -1, 0)})
    EXPECT_TRUE(outline_of(surface, view_along(light, surface.bounds(), kPixels)).loops.empty());
  const ObjectOutline seen = outline_of(surface, view_along({0, 0, -1}, surface.bounds(), kPixels));
  ASSERT_EQ(seen.loops.size(), 1U);
  EXPECT_GT(signed_area(seen.loops[0]), 0);
}

TEST(Winding, SmallPiecesWithoutPolynomialsAreTheSame) {
  for (const auto& mesh : {gnomon::test::spindle(5), gnomon::test::prism(5)}) {
    const surface::LimitSurface fitted = limit_of(mesh, 100);
    const surface::LimitSurface direct = limit_of(mesh, 1);
    const Vec3 light(0.31, -0.83, -0.46);
    const ObjectOutline a = outline_of(fitted, view_along(light, fitted.bounds(), kPixels));
    const ObjectOutline b = outline_of(direct, view_along(light, direct.bounds(), kPixels));
    ASSERT_EQ(a.loops.size(), b.loops.size());
    for (std::size_t i = 0; i < a.loops.size(); ++i)
      EXPECT_NEAR(signed_area(a.loops[i]), signed_area(b.loops[i]), 0.05);
  }
}

}  // namespace
}  // namespace gnomon::outline::test
