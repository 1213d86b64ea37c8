// SPDX-License-Identifier: Apache-2.0
// Whole objects against point in polygon: nasty loops, degenerate loops, loops leaving the plane.
#include <gtest/gtest.h>

#include "tests/golden/slb/compare.hpp"
#include "tests/golden/slb/displacement.hpp"
#include "tests/golden/slb/oracle.hpp"

namespace gnomon::golden::slb::testing {
namespace {

SlbConfig plane(int log2, int frags = 2, int frac = 4) {
  SlbConfig config;
  config.frac_bits = config.slope_bits = frac;
  config.plane_log2 = log2;
  config.frags = frags;
  config.subpixel_bits = config.query_bits = frac + 3;
  return config;
}

Vertex at(double x, double y, const SlbConfig& config) {
  return quantise({{x, y}}, config).front();
}

Comparison drawn(const Scene& scene, const SlbConfig& config, int per_pixel = 30) {
  SlbModel model(config);
  draw(model, scene);
  return compare(model, scene, per_pixel, 9);
}

TEST(Loops, NoAnswerIsWrongFarFromEveryEdge) {
  std::uint64_t compared = 0, wrong = 0;
  for (const Shape& s : shapes())
    for (const auto& [frac, slope] : {std::pair{3, 3}, {4, 4}, {7, 7}, {5, 3}, {4, 6}}) {
      SlbConfig config = plane(6, 2, frac);
      config.slope_bits = slope;
      const Comparison c = drawn(s.make(config, 77), config, 10);
      EXPECT_EQ(c.wrong_away, 0u) << s.name << " F=" << frac << " S=" << slope;
      EXPECT_EQ(c.wrong_far, 0u) << s.name << " F=" << frac << " S=" << slope;
      compared += c.compared;
      wrong += c.wrong;
    }
  EXPECT_EQ(compared, shapes().size() * 5 * 64 * 64 * 10);
  EXPECT_GT(wrong, 100u) << "the comparison must be able to find something";
}

TEST(Loops, SelfIntersectingLoopsOffAndOnTheLattice) {
  // Several random loops an object, corners on quarter pixels (often on borders), reaching beyond the plane.
  std::uint64_t compared = 0;
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    const SlbConfig config = plane(4, 4);
    Random random(seed);
    const std::int64_t lattice = seed % 2 == 0 ? config.subpixels() / 4 : 1;
    const std::int64_t cells = config.subpixels() / lattice;
    Scene scene(1);
    for (int loop = 0; loop < 3; ++loop) {
      Loop corners;
      for (int i = 0; i < 5; ++i)
        corners.push_back({random.integer(-8 * cells, 24 * cells) * lattice,
                           random.integer(-8 * cells, 24 * cells) * lattice});
      scene[0].push_back(corners);
    }
    const Comparison c = drawn(scene, config, 20);
    EXPECT_EQ(c.wrong_away, 0u) << "seed " << seed;
    EXPECT_EQ(c.wrong_far, 0u) << "seed " << seed;
    compared += c.compared;
  }
  EXPECT_EQ(compared, 120u * 256 * 20);
}

TEST(Loops, ABrokenWindingIsNoticed) {
  const SlbConfig config = plane(4);
  const Scene drawn_scene{{{at(3, 3, config), at(12, 3, config), at(12, 12, config), at(3, 12, config)}}};
  const Scene other{{{at(3, 3, config), at(12, 3, config), at(12, 9, config), at(3, 12, config)}}};
  SlbModel model(config);
  draw(model, drawn_scene);
  EXPECT_GT(compare(model, other, 4, 1).wrong_away, 0u);
  EXPECT_GT(compare(model, other, 4, 1).wrong_far, 0u);
}

TEST(Loops, RectanglesOnTheGridHaveNoError) {
  for (int frac = 3; frac <= 8; ++frac)
    for (const Rounding rounding : {Rounding::Better, Rounding::Published}) {
      SlbConfig config = plane(4, 1, frac);
      config.rounding = rounding;
      for (std::uint64_t i = 0; i < 10; ++i)
        EXPECT_EQ(drawn(shape("grid rectangle").make(config, i), config).wrong, 0u);
    }
}

TEST(Loops, HolesAndNestedLoops) {
  const SlbConfig config = plane(4);
  const auto square = [&](double low, double high, bool hole) {
    Loop loop{at(low, low, config), at(high, low, config), at(high, high, config), at(low, high, config)};
    if (hole) std::reverse(loop.begin(), loop.end());
    return loop;
  };
  const Comparison c = drawn(
      {{square(1, 15, false), square(3, 13, true), square(5, 11, false), square(5.5, 7.5, false)}}, config);
  EXPECT_EQ(c.wrong, 0u);
}

TEST(Loops, AClockwiseLoopCastsNothing) {
  const SlbConfig config = plane(4);
  SlbModel model(config);
  draw(model, {{{at(3.3, 3.1, config), at(4, 12, config), at(12.7, 10, config)}}});
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) {
      const std::int64_t half = std::int64_t{1} << (config.query_bits - 1);
      EXPECT_FALSE(model.query({(x * 2 + 1) * half, (y * 2 + 1) * half, 1}, 0).shadow);
    }
}

TEST(Loops, DegenerateLoopsAreIgnoredAndCounted) {
  const SlbConfig config = plane(4);
  SlbModel model(config);
  model.begin_object(1, true, 0);
  model.close_loop();                                                                  // empty
  model.loop(Loop{at(2, 2, config)});                                                  // one
  model.loop(Loop{at(2, 2, config), at(9, 9, config), at(9, 9, config)});              // two and a repeat
  model.loop(Loop{at(2.2, 2.2, config), at(2.8, 2.2, config), at(2.8, 2.8, config)});  // inside one pixel
  model.loop(Loop{at(1, 1, config), at(9.5, 6.25, config), at(1, 1, config)});         // there and back
  model.fill();
  model.end_object();
  const SlbCounters& c = model.counters();
  EXPECT_EQ(c.loops, 5u);
  EXPECT_EQ(c.loops_short, 3u);
  EXPECT_EQ(c.loops_tiny, 1u);
  // 0.6 px quantised: 26 to 102 and 28 to 102 of 128... the area follows from the lattice points themselves.
  const std::int64_t low = at(2.2, 2.2, config).x, high = at(2.8, 2.2, config).x;
  EXPECT_EQ(c.tiny_area2, static_cast<std::uint64_t>((high - low) * (high - low)));
  EXPECT_EQ(c.vertices_repeated, 2u);
  EXPECT_EQ(c.vertices, 1u + 3 + 3 + 3);
  EXPECT_EQ(c.fill_covered, 0u);
  Random random(4);
  for (int i = 0; i < 5000; ++i)
    EXPECT_FALSE(model.query({random.integer(0, 2047), random.integer(0, 2047), 1}, 0).shadow);
}

TEST(Loops, SpikesRepeatsAndStartsDoNotMatter) {
  const SlbConfig config = plane(5, 4);
  const Vertex a = at(4.3, 4.1, config), b = at(27.2, 6.6, config), c = at(20.4, 25.9, config);
  const Vertex out = at(30.1, 12.3, config);
  SlbModel plain(config), spiked(config);
  draw(plain, {{{a, b, c}}});
  draw(spiked, {{{b, b, out, b, c, c, c, a, a}}});
  Random random(8);
  const std::int64_t limit = std::int64_t{32} << config.query_bits;
  for (int i = 0; i < 50'000; ++i) {
    const QueryPoint point{random.integer(0, limit - 1), random.integer(0, limit - 1), 1};
    ASSERT_EQ(plain.query(point, 0).shadow, spiked.query(point, 0).shadow) << point.x << "," << point.y;
  }
}

TEST(Loops, OppositeDuplicateEdgesCancel) {
  // Two triangles make a square; their common diagonal must not show away from its ends.
  const SlbConfig config = plane(4, 2);
  const Vertex a = at(2.3, 2.6, config), b = at(13.1, 2.2, config), c = at(12.9, 13.4, config),
               d = at(2.2, 12.8, config);
  const Comparison parts = drawn({{{a, b, c}, {a, c, d}}}, config);
  EXPECT_EQ(parts.wrong_away, 0u);
  EXPECT_EQ(parts.wrong_far, 0u);
}

TEST(Loops, AnObjectAroundThePlaneCoversIt) {
  const SlbConfig config = plane(4);
  SlbModel model(config);
  const Scene scene{{{at(-9, -12, config), at(31, -14, config), at(30, 30, config), at(-15, 31, config)}}};
  draw(model, scene);
  EXPECT_EQ(model.counters().fill_covered, 256u);
  EXPECT_EQ(model.counters().chains, 0u);
  EXPECT_EQ(compare(model, scene, 5, 2).wrong, 0u);
}

TEST(Loops, TinyTriangleInsideAPixelCornerCastsItsShare) {
  // Over a pixel corner: four pixels with one chain each, no vertex inside two of them.
  const SlbConfig config = plane(4, 2, 7);
  const Comparison c =
      drawn({{{at(4.6, 4.7, config), at(5.5, 4.8, config), at(4.9, 5.6, config)}}}, config, 400);
  EXPECT_EQ(c.wrong_far, 0u);
}

TEST(Loops, WindingSaturatesVisibly) {
  const SlbConfig config = plane(3);
  SlbModel model(config);
  model.begin_object(0, true, 0);
  for (int i = 0; i < 130; ++i)
    model.loop(Loop{at(2.2, 1.5, config), at(3.9, 1.6, config), at(3.1, 3.5, config)});
  model.fill();
  model.end_object();
  EXPECT_GT(model.counters().winding_saturated, 0u);
  EXPECT_TRUE(model.sticky().winding_saturated);
}

}  // namespace
}  // namespace gnomon::golden::slb::testing
