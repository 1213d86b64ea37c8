// SPDX-License-Identifier: Apache-2.0
// Quads between voxels: closed where the surface is, and nothing dropped that has an area.
#include "host/voxel/subpatches.hpp"

#include <gtest/gtest.h>

#include <map>
#include <ostream>
#include <set>

#include "cage_list.hpp"
#include "voxelize_cages.hpp"

namespace gnomon::test {

void PrintTo(const NamedCage& c, std::ostream* os);  // in voxelizer_test.cpp

namespace {

using voxel::LimitQuad;
using voxel::VoxelQuad;

struct Voxelized {
  std::vector<surface::LimitSurface> surfaces;
  voxel::VoxelSet set;
};
Voxelized voxelized(const std::vector<scene::ControlMesh>& meshes, std::uint32_t res) {
  Voxelized out;
  out.surfaces = surfaces_of(meshes, res);
  voxel::VoxelizerOptions options;
  options.subpatches = true;
  out.set = run(out.surfaces, res, voxel::Adjacency::N26, options);
  return out;
}

/// Sides that an odd number of triangles have. Triangles with a repeated corner have each side twice, or
/// none.
template <class Point, class Quad, class Corner>
std::size_t open_sides(const std::vector<Quad>& quads, Corner corner) {
  std::map<std::pair<Point, Point>, int> sides;
  const auto add = [&](const Point& a, const Point& b) {
    if (a != b) ++sides[a < b ? std::pair(a, b) : std::pair(b, a)];
  };
  for (const Quad& q : quads) {
    // The diagonal has two triangles, or is a side of the only one.
    for (std::size_t i = 0; i < 4; ++i) add(corner(q, i), corner(q, (i + 1) % 4));
  }
  std::size_t open = 0;
  for (const auto& [side, count] : sides) open += count % 2 == 0 ? 0U : 1U;
  return open;
}

using Place = std::array<double, 3>;
std::size_t open_sides(const std::vector<LimitQuad>& quads) {
  return open_sides<Place>(quads, [](const LimitQuad& q, std::size_t i) {
    const Vec3& p = q.points[i];
    return Place{p.x, p.y, p.z};
  });
}

class Quads : public testing::TestWithParam<NamedCage> {};
INSTANTIATE_TEST_SUITE_P(Cages, Quads, testing::ValuesIn(all_cages()),
                         [](const auto& i) { return i.param.name; });

TEST_P(Quads, OfClosedSurfacesClose) {
  const Voxelized v = voxelized({GetParam().mesh}, 40);
  const auto quads = limit_quads(v.surfaces, v.set);
  EXPECT_GE(quads.size(), v.set.subpatches.size());
  if (GetParam().closed) {
    EXPECT_EQ(open_sides(quads), 0U);
  } else {
    EXPECT_GT(open_sides(quads), 0U);
  }
}

/// Sorted triangles with three distinct corners.
std::set<std::array<std::uint32_t, 3>> triangles(const VoxelQuad& q) {
  std::set<std::array<std::uint32_t, 3>> out;
  for (std::array t : {std::array{q[0], q[1], q[2]}, std::array{q[0], q[2], q[3]}}) {
    std::sort(t.begin(), t.end());
    if (t[0] != t[1] && t[1] != t[2]) out.insert(t);
  }
  return out;
}

TEST_P(Quads, BetweenVoxelsAreTheTrianglesOfTheLimitPoints) {
  const Voxelized v = voxelized({GetParam().mesh}, 40);
  const auto casting = casting_quads(v.surfaces, v.set);
  EXPECT_EQ(casting.statistics.subpatches, v.set.subpatches.size());
  std::set<std::array<std::uint32_t, 3>> all, kept;
  std::set<std::set<std::array<std::uint32_t, 3>>> distinct;
  for (const VoxelQuad& q : casting.quads) {
    for (const std::uint32_t corner : q) ASSERT_LT(corner, v.set.voxels.size());
    const auto of_quad = triangles(q);
    EXPECT_EQ(of_quad.size(), q[2] == q[3] ? 1U : 2U);
    kept.insert(of_quad.begin(), of_quad.end());
    distinct.insert(of_quad);
  }
  for (const LimitQuad& q : limit_quads(v.surfaces, v.set)) all.merge(triangles(q.voxels));
  EXPECT_EQ(kept, all);
  EXPECT_GT(all.size(), 400U);
  EXPECT_EQ(distinct.size(), casting.quads.size()) << "none is sent twice";
}

TEST(CastingQuads, SubpatchesOfDifferentSizeAreStitched) {
  const Voxelized v = voxelized({spindle(7), torus(5, 4)}, 64);
  const auto casting = casting_quads(v.surfaces, v.set);
  EXPECT_GT(casting.statistics.stitched, 100U);
  // Without the voxels of finer neighbours, sides stay open: the test above can fail.
  std::vector<VoxelQuad> plain;
  for (const voxel::Subpatch& s : v.set.subpatches)
    plain.push_back({s.corner[0], s.corner[1], s.corner[2], s.corner[3]});
  EXPECT_GT(open_sides<std::uint32_t>(plain, [](const VoxelQuad& q, std::size_t i) { return q[i]; }), 100U);
}

TEST(CastingQuads, CornersOfLimitQuadsLieInTheirVoxels) {
  const Voxelized v = voxelized({spindle(5), sheet(4, 3)}, 50);
  std::size_t compared = 0;
  for (const LimitQuad& q : limit_quads(v.surfaces, v.set)) {
    for (std::size_t i = 0; i < 4; ++i) {
      const voxel::Voxel& voxel = v.set.voxels[q.voxels[i]];
      const Vec3 inside = q.points[i] - Vec3(voxel.x, voxel.y, voxel.z);
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GE(inside[axis], -0x1p-16);
        EXPECT_LE(inside[axis], 1 + 0x1p-16);
        ++compared;
      }
    }
  }
  EXPECT_GE(compared, 12 * v.set.subpatches.size());
}

}  // namespace
}  // namespace gnomon::test
