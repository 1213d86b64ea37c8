// SPDX-License-Identifier: Apache-2.0
// Rectangles of any size stitch into surfaces without cracks.
#include "host/metrics/parametric_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "host/metrics/tessellation.hpp"
#include "tests/host/metrics/fixtures.hpp"

namespace gnomon::metrics {
namespace {

struct EdgeCount {
  std::size_t edges = 0;
  std::size_t open = 0;  ///< without exactly two triangles that run through it in opposite directions
};

/// Vertices are the same where they are equal to the bit, as the ray caster sees them.
EdgeCount count_edges(const ParametricMesh& mesh) {
  std::map<std::array<float, 3>, int> ids;
  const auto id = [&](std::uint32_t point) {
    return ids.try_emplace(mesh.points[point], static_cast<int>(ids.size())).first->second;
  };
  std::map<std::pair<int, int>, std::pair<int, int>> edges;
  for (const auto& triangle : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = id(triangle[k]);
      const int b = id(triangle[(k + 1) % 3]);
      auto& [forward, backward] = edges[{std::min(a, b), std::max(a, b)}];
      ++(a < b ? forward : backward);
    }
  EdgeCount count;
  count.edges = edges.size();
  for (const auto& [edge, uses] : edges)
    if (uses != std::pair(1, 1)) ++count.open;
  return count;
}

/// Every face cut differently: face f into 1 + f % 3 columns (1, 2 or 4) and as many rows of another count.
std::vector<ParamRect> uneven_rects(const surface::LimitSurface& surface) {
  std::vector<ParamRect> rects;
  for (std::uint32_t face = 0; face < surface.face_count(); ++face) {
    const int columns = 1 << (face % 4);
    const int rows = 1 << (face / 2 % 3);
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i) {
        const auto at = [](int k, int n) { return static_cast<float>(k) / static_cast<float>(n); };
        rects.push_back({face, at(i, columns), at(j, rows), at(i + 1, columns), at(j + 1, rows)});
      }
  }
  return rects;
}

class Stitching : public testing::TestWithParam<int> {
 protected:
  static scene::ControlMesh mesh(int which) {
    switch (which) {
      case 0:
        return fixtures::box({8, 8, 8}, {24, 24, 24}, false);
      case 1:
        return fixtures::box({8, 8, 8}, {24, 24, 24}, true);
      case 2:
        return fixtures::prism(3, {16, 16, 16}, 10, 12, false);
      case 3:
        return fixtures::prism(5, {16, 16, 16}, 10, 12, true);
      default:
        return fixtures::torus({16, 16, 16}, 9, 4, 8, 6);
    }
  }
};

TEST_P(Stitching, UnevenRectanglesOfAClosedSurfaceLeaveNoCrack) {
  const auto surfaces = fixtures::surfaces({mesh(GetParam())});
  const ParametricMesh stitched = triangulate(surfaces[0], uneven_rects(surfaces[0]), {16, 16, 16});
  const EdgeCount count = count_edges(stitched);
  EXPECT_GT(count.edges, 30u);
  EXPECT_EQ(count.open, 0u);
}

TEST_P(Stitching, AdaptiveTessellationsLeaveNoCrack) {
  const auto surfaces = fixtures::surfaces({mesh(GetParam())});
  TessellationOptions options;
  options.sag = 0.02;
  const Tessellation cells = tessellate(surfaces, options);
  const EdgeCount count = count_edges(triangulate(surfaces[0], cells.rects[0], {16, 16, 16}));
  EXPECT_GT(count.edges, 30u);
  EXPECT_EQ(count.open, 0u);
}

INSTANTIATE_TEST_SUITE_P(Shapes, Stitching, testing::Range(0, 5));

TEST(ParametricMesh, TheCrackCounterSeesAMissingTriangleAndAnUnstitchedBorder) {
  const auto surfaces = fixtures::surfaces({fixtures::box({8, 8, 8}, {24, 24, 24}, false)});
  ParametricMesh missing = triangulate(surfaces[0], uneven_rects(surfaces[0]), {16, 16, 16});
  missing.triangles.pop_back();
  EXPECT_EQ(count_edges(missing).open, 3u);

  // Two meshes of the same surface laid side by side know nothing of each other's vertices.
  std::vector<ParamRect> rects = uneven_rects(surfaces[0]);
  const auto split = std::find_if(rects.begin(), rects.end(), [](const ParamRect& r) { return r.face == 3; });
  ParametricMesh joined = triangulate(surfaces[0], std::span(rects.begin(), split), {16, 16, 16});
  const ParametricMesh rest = triangulate(surfaces[0], std::span(split, rects.end()), {16, 16, 16});
  const auto first = static_cast<std::uint32_t>(joined.points.size());
  joined.points.insert(joined.points.end(), rest.points.begin(), rest.points.end());
  for (const auto& t : rest.triangles) joined.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  EXPECT_GT(count_edges(joined).open, 0u);
}

TEST(ParametricMesh, NamesRectangleParameterAndNormalOfEveryVertex) {
  const auto surfaces = fixtures::surfaces({fixtures::prism(5, {16, 16, 16}, 10, 12, false)});
  const std::vector<ParamRect> rects = uneven_rects(surfaces[0]);
  const Vec3 center(16, 16, 16);
  const ParametricMesh mesh = triangulate(surfaces[0], rects, center, true);
  ASSERT_EQ(mesh.rect_of_triangle.size(), mesh.triangles.size());
  ASSERT_EQ(mesh.normals.size(), mesh.points.size());
  std::size_t compared = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const ParamRect& r = rects[mesh.rect_of_triangle[t]];
    for (const std::uint32_t corner : mesh.triangles[t]) {
      const auto [u, v] = mesh.params[corner];
      EXPECT_TRUE(r.u0 <= u && u <= r.u1 && r.v0 <= v && v <= r.v1);
      const Vec3 p = surfaces[0].position(r.face, double{u}, double{v}) - center;
      EXPECT_EQ(mesh.points[corner],
                (std::array{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)}));
      const Vec3 n = surfaces[0].normal(r.face, double{u}, double{v});
      EXPECT_EQ(mesh.normals[corner][2], static_cast<float>(n.z));
      ++compared;
    }
  }
  EXPECT_GT(compared, 300u);
}

}  // namespace
}  // namespace gnomon::metrics
