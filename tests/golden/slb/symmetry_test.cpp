// SPDX-License-Identifier: Apache-2.0
// Symmetries of the whole unit, to the bit where the page says so.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "tests/golden/slb/displacement.hpp"

namespace gnomon::golden::slb::testing {
namespace {

SlbConfig configuration(int frac, int slope) {
  SlbConfig config;
  config.frac_bits = frac;
  config.slope_bits = slope;
  config.frags = 4;
  config.plane_log2 = 5;
  config.subpixel_bits = 12;
  config.query_bits = 11;
  return config;
}

using MapVertex = std::function<Vertex(const Vertex&)>;
using MapQuery = std::function<QueryPoint(const QueryPoint&)>;

Scene mapped(const Scene& scene, const MapVertex& map, bool reverse) {
  Scene result = scene;
  for (Object& object : result)
    for (Loop& loop : object) {
      std::transform(loop.begin(), loop.end(), loop.begin(), map);
      if (reverse) std::reverse(loop.begin(), loop.end());
    }
  return result;
}

/// Number of points that the two scenes answer differently, of many in every pixel with lines and some
/// elsewhere.
int differences(const Scene& first, const Scene& second, const MapQuery& map, const SlbConfig& config) {
  SlbModel a(config), b(config);
  draw(a, first);
  draw(b, second);
  EXPECT_EQ(a.counters().chains_dropped, 0u);
  Random random(12);
  const std::int64_t pixel = std::int64_t{1} << config.query_bits;
  int count = 0, asked = 0;
  for (int row = 0; row < config.side(); ++row)
    for (int column = 0; column < config.side(); ++column)
      for (int i = a.entry(column, row).count > 0 ? 400 : 2; i > 0; --i, ++asked) {
        const QueryPoint point{column * pixel + random.integer(0, pixel - 1),
                               row * pixel + random.integer(0, pixel - 1), 1};
        if (a.query(point, 0).shadow != b.query(map(point), 0).shadow) ++count;
      }
  EXPECT_GT(asked, 20'000);
  return count;
}

class Symmetry : public ::testing::TestWithParam<std::pair<int, int>> {
 protected:
  SlbConfig config = configuration(GetParam().first, GetParam().second);
  std::int64_t span = config.side() * config.subpixels();
  std::int64_t query_span = std::int64_t{config.side()} << config.query_bits;
  /// Coarse codes make differences visible; corners off every border.
  Scene scene(std::uint64_t seed) const { return shape("random 24-gon").make(config, seed); }
};

TEST_P(Symmetry, Mirror) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Scene mirror = mapped(
        scene(seed),
        [&](const Vertex& v) {
          return Vertex{span - v.x, v.y, 0};
        },
        true);
    EXPECT_EQ(differences(
                  scene(seed), mirror,
                  [&](const QueryPoint& q) {
                    return QueryPoint{query_span - 1 - q.x, q.y, q.depth};
                  },
                  config),
              0);
    const Scene upside = mapped(
        scene(seed),
        [&](const Vertex& v) {
          return Vertex{v.x, span - v.y, 0};
        },
        true);
    EXPECT_EQ(differences(
                  scene(seed), upside,
                  [&](const QueryPoint& q) {
                    return QueryPoint{q.x, query_span - 1 - q.y, q.depth};
                  },
                  config),
              0);
  }
}

TEST_P(Symmetry, QuarterTurn) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Scene turned = mapped(
        scene(seed),
        [&](const Vertex& v) {
          return Vertex{span - v.y, v.x, 0};
        },
        false);
    EXPECT_EQ(differences(
                  scene(seed), turned,
                  [&](const QueryPoint& q) {
                    return QueryPoint{query_span - 1 - q.y, q.x, q.depth};
                  },
                  config),
              0);
  }
}

TEST_P(Symmetry, SwappedMajors) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Scene swapped = mapped(
        scene(seed),
        [](const Vertex& v) {
          return Vertex{v.y, v.x, 0};
        },
        true);
    EXPECT_EQ(differences(
                  scene(seed), swapped,
                  [](const QueryPoint& q) {
                    return QueryPoint{q.y, q.x, q.depth};
                  },
                  config),
              0);
  }
}

TEST_P(Symmetry, WholePixelShiftChangesNoBit) {
  // Entries too: every fragment must be the same, two columns to the right and three rows up.
  for (const char* name : {"random 24-gon", "pixel corners", "gear, pitch 3 px"}) {
    Scene base = shape(name).make(config, 3);
    for (Object& object : base)
      for (Loop& loop : object)
        for (Vertex& v : loop) v = {v.x / 2, v.y / 2, 0};
    const Scene shifted = mapped(
        base,
        [&](const Vertex& v) {
          return Vertex{v.x + 2 * config.subpixels(), v.y + 3 * config.subpixels(), 0};
        },
        false);
    SlbModel a(config), b(config);
    draw(a, base);
    draw(b, shifted);
    int compared = 0;
    for (int row = 0; row + 3 < config.side(); ++row)
      for (int column = 0; column + 2 < config.side(); ++column) {
        EXPECT_EQ(a.entry(column, row), b.entry(column + 2, row + 3));
        compared += a.entry(column, row).count;
      }
    EXPECT_GT(compared, 20);
  }
}

TEST_P(Symmetry, SplittingAnEdgeAndTurningALoopChangeNoAnswer) {
  const auto identity = [](const QueryPoint& q) { return q; };
  int splits = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Scene even = scene(seed);
    for (Vertex& v : even[0][0]) v = {v.x & ~std::int64_t{7}, v.y & ~std::int64_t{7}, 0};
    Scene split = even;
    Loop& loop = split[0][0];
    for (std::size_t i = 0; i + 1 < loop.size(); i += 2) {
      // A lattice point on the edge: its middle, or a quarter of it.
      const Vertex a = loop[i], b = loop[i + 1];
      const std::int64_t parts = i % 4 == 0 ? 2 : 4;
      loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                  {a.x + (b.x - a.x) / parts, a.y + (b.y - a.y) / parts, 0});
      ++splits;
    }
    EXPECT_EQ(differences(even, split, identity, config), 0);
    Scene turned = even;
    std::rotate(turned[0][0].begin(), turned[0][0].begin() + 7, turned[0][0].end());
    EXPECT_EQ(differences(even, turned, identity, config), 0);
  }
  EXPECT_GT(splits, 80);
}

TEST_P(Symmetry, TheComparisonNoticesAHundredthOfAPixel) {
  const Scene moved = mapped(
      scene(1),
      [](const Vertex& v) {
        return Vertex{v.x + 40, v.y, 0};
      },
      false);
  EXPECT_GT(differences(
                scene(1), moved, [](const QueryPoint& q) { return q; }, config),
            0);
}

INSTANTIATE_TEST_SUITE_P(Widths, Symmetry,
                         ::testing::Values(std::pair{3, 3}, std::pair{4, 4}, std::pair{7, 7}, std::pair{4, 5},
                                           std::pair{6, 4}));

}  // namespace
}  // namespace gnomon::golden::slb::testing
