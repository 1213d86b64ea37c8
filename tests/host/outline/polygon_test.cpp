// SPDX-License-Identifier: Apache-2.0
// Polygon meshes drawn as they are.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "cases.hpp"
#include "host/outline/ears.hpp"
#include "sheets.hpp"
#include "winding.hpp"

namespace gnomon::outline::test {
namespace {

constexpr double kPixels = 96;

ObjectOutline polygons(const scene::ControlMesh& mesh, const LightFrame& frame) {
  return outlines_of_polygons({&mesh, 1}, frame)->at(0);
}

TEST(Polygons, WindingIsTheNumberOfSheets) {
  std::size_t asked = 0;
  std::size_t in_shadow = 0;
  for (const Case& c : all_cases()) {
    // Triangles alone: other faces of these cages are not flat.
    scene::ControlMesh mesh = c.mesh;
    mesh.face_sizes.clear();
    mesh.face_indices.clear();
    mesh.holes.clear();
    for (const Triangle& t : triangles_of(c.mesh)) {
      mesh.face_sizes.push_back(3);
      for (const std::uint32_t v : t) mesh.face_indices.push_back(static_cast<std::int32_t>(v));
    }
    for (const Light& light : all_lights()) {
      SCOPED_TRACE(c.name + ", " + light.name);
      const LightFrame frame = view_along(light.direction, box_of(mesh), kPixels);
      const ObjectOutline outline = polygons(mesh, frame);
      EXPECT_EQ(outline.statistics.open_parts, c.open ? 1U : 0U);
      const LoopSet loops(outline.loops);
      const Sheets sheets(corners_of(mesh), frame);
      std::mt19937 random(5);
      std::uniform_real_distribution<double> unit(0, kPixels);
      for (int i = 0; i < 100; ++i) {
        const double x = unit(random);
        const double y = unit(random);
        const Sheets::Count count = sheets.at(x, y);
        const int all = count.facing + count.averted;
        const int winding = loops.winding(x, y);
        EXPECT_EQ(winding >= 1, all > 0) << x << ", " << y << ": " << winding << ", not " << all;
        if (!c.open) {
          EXPECT_EQ(winding, count.facing);
        } else if (outline.statistics.doubled_parts > 0) {
          EXPECT_EQ(winding, all);
        }
        ++asked;
        in_shadow += all > 0 ? 1U : 0U;
      }
    }
  }
  EXPECT_EQ(asked, all_cases().size() * all_lights().size() * 100);
  EXPECT_GT(in_shadow * 8, asked);
}

TEST(Polygons, ABoxAlongAnAxisIsASquareAtItsNearFace) {
  const scene::ControlMesh mesh = box(0);
  const LightFrame frame = view_along({0, 0, -1}, box_of(mesh), kPixels);
  const ObjectOutline o = polygons(mesh, frame);
  ASSERT_EQ(o.loops.size(), 1U);
  const double side = 1.4 * kPixels / box_of(mesh).size().length();
  EXPECT_NEAR(signed_area(o.loops[0]), side * side, 1e-6);
  EXPECT_EQ(o.loops[0].size(), 4U);
  for (const Vertex& v : o.loops[0]) EXPECT_NEAR(v.depth, frame.code({0, 0, 0.7}), 1e-6);
}

TEST(Polygons, AnObliqueBoxIsAHexagon) {
  const scene::ControlMesh mesh = box(0);
  const ObjectOutline o = polygons(mesh, view_along({-1, -1, -1}, box_of(mesh), kPixels));
  ASSERT_EQ(o.loops.size(), 1U);
  EXPECT_EQ(o.loops[0].size(), 6U);
}

TEST(Polygons, SharpLimitSurfacesHaveTheSameOutline) {
  const scene::ControlMesh mesh = box(10);
  const surface::LimitSurface surface = limit_of(mesh, 1);
  for (const Light& light : all_lights()) {
    SCOPED_TRACE(light.name);
    const LightFrame frame = view_along(light.direction, surface.bounds(), kPixels);
    const ObjectOutline limit = outline_of(surface, frame);
    const ObjectOutline polygon = polygons(mesh, frame);
    ASSERT_EQ(limit.loops.size(), 1U);
    ASSERT_EQ(polygon.loops.size(), 1U);
    EXPECT_NEAR(signed_area(limit.loops[0]), signed_area(polygon.loops[0]), 0.01);
    EXPECT_NEAR(length(limit.loops[0]), length(polygon.loops[0]), 0.01);
  }
}

TEST(Polygons, FacesThatAreNotConvexAreCutByTheirEars) {
  scene::ControlMesh mesh;  // a comb
  const std::vector<Vec2> comb{{0, 0}, {6, 0}, {6, 3}, {5, 3}, {5, 1}, {4, 1}, {4, 3},
                               {3, 3}, {3, 1}, {2, 1}, {2, 3}, {1, 3}, {1, 1}, {0, 1}};
  for (const Vec2& p : comb) mesh.positions.emplace_back(p.x, p.y, 0.2 * p.x);
  mesh.face_sizes = {static_cast<std::int32_t>(comb.size())};
  for (std::int32_t i = 0; i < mesh.face_sizes[0]; ++i) mesh.face_indices.push_back(i);
  EXPECT_EQ(triangles_of(mesh).size(), comb.size() - 2);
  const ObjectOutline o = polygons(mesh, view_along({0, 0, -1}, box_of(mesh), kPixels));
  ASSERT_EQ(o.loops.size(), 1U);
  EXPECT_EQ(o.loops[0].size(), comb.size());
  const double scale = kPixels / box_of(mesh).size().length();
  EXPECT_NEAR(signed_area(o.loops[0]), 12 * scale * scale, 1e-6);
}

TEST(Polygons, HolesAndBoundariesCount) {
  scene::ControlMesh mesh = box(0);
  mesh.holes = {1};
  const ObjectOutline o = polygons(mesh, view_along({0.1, 0.2, -1}, box_of(mesh), kPixels));
  EXPECT_EQ(o.statistics.boundary_edges, 4U);
  EXPECT_EQ(o.statistics.open_parts, 1U);
  EXPECT_EQ(o.statistics.faces, 10U);
}

}  // namespace
}  // namespace gnomon::outline::test
