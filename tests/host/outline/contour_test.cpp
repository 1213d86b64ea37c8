// SPDX-License-Identifier: Apache-2.0
// Outlines against the exact contour: distance, completeness, depth, edge lengths, independence of threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cases.hpp"
#include "exact_contour.hpp"
#include "winding.hpp"

namespace gnomon::outline::test {
namespace {

constexpr double kPixels = 96;
constexpr int kFine = 160;             // cells of the exact contour along a face
constexpr double kExactError = 0.001;  // pixels

struct Smooth {
  const char* name;
  scene::ControlMesh mesh;
};
std::vector<Smooth> smooth_cages() {
  return {{"sphere", gnomon::test::spindle(3)},
          {"poles of valence 5", gnomon::test::spindle(5)},
          {"torus", gnomon::test::torus(8, 6)},
          {"prism", gnomon::test::prism(5)}};
}

struct Offsets {
  double mean = 0, largest = 0, length = 0;
};

/// Distances of points of the outline, several an edge, from the exact contour.
Offsets offsets(const std::vector<Loop>& loops, const LoopSet& exact) {
  Offsets out;
  for (const Loop& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vertex& a = loop[i];
      const Vertex& b = loop[(i + 1) % loop.size()];
      const double e = std::hypot(b.x - a.x, b.y - a.y);
      for (const double s : {0.0, 0.2, 0.4, 0.6, 0.8}) {
        const double off = exact.distance(a.x + s * (b.x - a.x), a.y + s * (b.y - a.y), 1);
        out.largest = std::max(out.largest, off);
        out.mean += off * e / 5;
      }
      out.length += e;
    }
  out.mean /= out.length;
  return out;
}

TEST(Contour, EdgesFollowItWithinTheSag) {
  for (const Smooth& c : smooth_cages()) {
    const surface::LimitSurface surface = limit_of(c.mesh);
    const LightFrame frame = view_along({0.31, -0.83, -0.46}, surface.bounds(), kPixels);
    const LoopSet exact(exact_contour(surface, frame, kFine));
    for (const int frac_bits : {3, 4, 7}) {
      SCOPED_TRACE(std::string(c.name) + ", F = " + std::to_string(frac_bits));
      Options options;
      options.frac_bits = frac_bits;
      options.fit_pixels = false;
      options.min_edge = 0.05;
      const double sag = std::ldexp(0.25, -frac_bits);
      const Offsets o = offsets(outline_of(surface, frame, options).loops, exact);
      EXPECT_LE(o.largest, 1.1 * sag + kExactError);  // the curve is known at points
      EXPECT_LE(o.mean, 0.75 * sag);
    }
  }
}

TEST(Contour, BalancedEdgesAreCloserOnAverage) {
  for (const Smooth& c : smooth_cages()) {
    SCOPED_TRACE(c.name);
    const surface::LimitSurface surface = limit_of(c.mesh);
    const LightFrame frame = view_along({0.31, -0.83, -0.46}, surface.bounds(), kPixels);
    const LoopSet exact(exact_contour(surface, frame, kFine));
    Options options;
    options.frac_bits = 4;
    const ObjectOutline balanced = outline_of(surface, frame, options);
    options.fit_pixels = false;
    const ObjectOutline plain = outline_of(surface, frame, options);
    EXPECT_LT(offsets(balanced.loops, exact).mean, 0.7 * offsets(plain.loops, exact).mean);
    EXPECT_LT(offsets(balanced.loops, exact).largest, 2 * std::ldexp(0.25, -4));
  }
}

TEST(Contour, NothingOfItIsMissed) {
  for (const Smooth& c : smooth_cages())
    for (const Light& light : all_lights()) {
      SCOPED_TRACE(std::string(c.name) + ", " + light.name);
      const surface::LimitSurface surface = limit_of(c.mesh);
      const LightFrame frame = view_along(light.direction, surface.bounds(), kPixels);
      Options options;
      options.fit_pixels = false;
      options.min_edge = 0.03;
      const LoopSet found(outline_of(surface, frame, options).loops);
      std::size_t pieces = 0;
      for (const Loop& piece : exact_contour(surface, frame, 40)) {
        EXPECT_LT(found.distance(piece[0].x, piece[0].y, 1), 0.03);
        ++pieces;
      }
      EXPECT_GT(pieces, 100U);
    }
}

TEST(Contour, DepthIsThatOfTheSurface) {
  const surface::LimitSurface surface = limit_of(gnomon::test::torus(8, 6));
  const LightFrame frame = view_along({0.31, -0.83, -0.46}, surface.bounds(), kPixels);
  std::vector<Vertex> exact;
  for (const Loop& piece : exact_contour(surface, frame, kFine))
    exact.insert(exact.end(), piece.begin(), piece.end());
  std::size_t vertices = 0;
  for (const Loop& loop : outline_of(surface, frame).loops)
    for (std::size_t i = 0; i < loop.size(); i += 7, ++vertices) {
      const Vertex& v = loop[i];
      // The nearest point in space: two sheets may have contours at the same place of the plane.
      double best = 1e9;
      for (const Vertex& e : exact)
        best = std::min(best, std::hypot(v.x - e.x, v.y - e.y, (v.depth - e.depth) / 100));
      EXPECT_LT(best, 0.3);
    }
  EXPECT_GT(vertices, 20U);
}

TEST(Contour, EdgesAreAsLongAsTheRuleAllows) {
  const surface::LimitSurface surface = limit_of(gnomon::test::spindle(3));
  for (const int frac_bits : {3, 5, 7}) {
    Options options;
    options.frac_bits = frac_bits;
    options.fit_pixels = false;
    const ObjectOutline o =
        outline_of(surface, view_along({0.31, -0.83, -0.46}, surface.bounds(), kPixels), options);
    ASSERT_EQ(o.loops.size(), 1U);
    // About a circle: its radius from its length.
    const double perimeter = length(o.loops[0]);
    const double rule = std::sqrt(2 * perimeter / 6.2832 / std::ldexp(1.0, frac_bits));
    const double mean = perimeter / static_cast<double>(o.loops[0].size());
    EXPECT_GT(mean, 0.6 * std::min(rule, options.max_edge));
    EXPECT_LT(mean, 1.1 * std::max(rule, options.min_edge));
  }
}

TEST(Contour, FittedToPixelsThereIsOneVertexAStay) {
  const surface::LimitSurface surface = limit_of(gnomon::test::spindle(3));
  Options options;
  options.frac_bits = 12;  // edges as short as pixels let them be
  const ObjectOutline o =
      outline_of(surface, view_along({0.31, -0.83, -0.46}, surface.bounds(), 30), options);
  ASSERT_EQ(o.loops.size(), 1U);
  std::size_t twice = 0;
  for (std::size_t i = 0; i < o.loops[0].size(); ++i) {
    const Vertex& a = o.loops[0][i];
    const Vertex& b = o.loops[0][(i + 1) % o.loops[0].size()];
    twice += std::floor(a.x) == std::floor(b.x) && std::floor(a.y) == std::floor(b.y) ? 1U : 0U;
  }
  EXPECT_EQ(twice, 0U);
}

TEST(Contour, DoesNotDependOnThreads) {
  std::vector<surface::LimitSurface> surfaces;
  surfaces.push_back(limit_of(gnomon::test::torus(8, 6)));
  surfaces.push_back(limit_of(gnomon::test::prism(7)));
  surfaces.push_back(limit_of(cup()));
  const LightFrame frame = view_along({0.31, -0.83, -0.46}, surfaces[0].bounds(), kPixels);
  std::vector<std::vector<ObjectOutline>> results;
  for (const unsigned threads : {1U, 2U, 5U}) {
    Options options;
    options.threads = threads;
    results.push_back(*outlines(surfaces, frame, options));
  }
  std::size_t compared = 0;
  for (std::size_t r = 1; r < results.size(); ++r) {
    ASSERT_EQ(results[r].size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(results[r][i].object, i);
      ASSERT_EQ(results[r][i].loops.size(), results[0][i].loops.size());
      for (std::size_t l = 0; l < results[0][i].loops.size(); ++l) {
        const Loop& a = results[0][i].loops[l];
        const Loop& b = results[r][i].loops[l];
        EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Vertex& p, const Vertex& q) {
          return p.x == q.x && p.y == q.y && p.depth == q.depth;
        }));
        compared += a.size();
      }
    }
  }
  EXPECT_GT(compared, 300U);
}

TEST(Contour, SaysWhatIsWrong) {
  const surface::LimitSurface surface = limit_of(box(0));
  const LightFrame good = view_along({0, 0, -1}, surface.bounds(), kPixels);
  LightFrame flat = good;
  flat.depth = flat.x + flat.y;
  LightFrame broken = good;
  broken.y1 = std::nan("");
  Options fine;
  fine.frac_bits = 17;
  Options inverted;
  inverted.min_edge = 5;
  EXPECT_EQ(outlines({&surface, 1}, flat).error().message,
            "outline: the light frame's three rows do not span space");
  EXPECT_EQ(outlines({&surface, 1}, broken).error().message,
            "outline: the light frame has a number that is not finite");
  EXPECT_EQ(outlines({&surface, 1}, good, fine).error().message, "outline: frac_bits is 17, must be 1..16");
  EXPECT_EQ(outlines({&surface, 1}, good, inverted).error().message,
            "outline: edges of 5 to 4 pixels, must be 0 < min_edge <= max_edge");
}

}  // namespace
}  // namespace gnomon::outline::test
