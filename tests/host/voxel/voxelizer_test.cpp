// SPDX-License-Identifier: Apache-2.0
// The voxelizer against the plain recursion, and what its voxels promise.
#include "host/voxel/voxelizer.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <ostream>

#include "cage_list.hpp"
#include "criteria.hpp"
#include "host/voxel/voxel_key.hpp"
#include "reference.hpp"
#include "voxelize_cages.hpp"

namespace gnomon::test {

void PrintTo(const NamedCage& c, std::ostream* os) {
  *os << c.name;
}

namespace {

using surface::LimitSurface;
using voxel::Adjacency;
using voxel::VoxelSet;

std::set<Coordinates> coordinates(const VoxelSet& set) {
  std::set<Coordinates> out;
  for (const auto& v : set.voxels) out.emplace(v.x, v.y, v.z);
  return out;
}

template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

class EveryCage : public testing::TestWithParam<NamedCage> {};
INSTANTIATE_TEST_SUITE_P(Cages, EveryCage, testing::ValuesIn(all_cages()),
                         [](const auto& i) { return i.param.name; });

TEST_P(EveryCage, IsExactlyTheCriterionsSet) {
  for (const std::uint32_t res : {16U, 50U}) {
    const auto s = surfaces_of({GetParam().mesh}, res);
    for (const Adjacency a : {Adjacency::N26, Adjacency::N18}) {
      const auto expected = reference_voxels(s, grid_of(res, a));
      const VoxelSet set = run(s, res, a);
      EXPECT_EQ(coordinates(set), expected.voxels);
      EXPECT_EQ(set.voxels.size(), expected.voxels.size()) << "duplicates";
      EXPECT_EQ(set.statistics.subpatches, expected.leaves);
      EXPECT_EQ(set.statistics.floor_hits, expected.floor_hits);
    }
  }
}

TEST_P(EveryCage, SeparatesInsideFromOutside) {
  for (const Adjacency a : {Adjacency::N26, Adjacency::N18, Adjacency::N6}) {
    const VoxelSet set = voxels_of(GetParam().mesh, 40, a);
    const Separation s = separation(set);
    EXPECT_EQ(s.leaks, 0U);
    EXPECT_EQ(s.inside > 0, GetParam().separating);
    EXPECT_EQ(s.bays, 0U);  // nothing is excused
  }
}

TEST_P(EveryCage, CoversTheSurfaceAndNothingElse) {
  constexpr std::uint32_t kRes = 28;
  const auto s = surfaces_of({GetParam().mesh}, kRes);
  for (const Adjacency a : {Adjacency::N26, Adjacency::N18, Adjacency::N6}) {
    const VoxelSet set = run(s, kRes, a);
    const Coverage c = coverage(s, set, 0.3);
    EXPECT_GT(c.samples, 1000U);
    EXPECT_EQ(c.uncovered, 0U);
    // Half a diagonal, and what the samples miss.
    EXPECT_LE(c.farthest_centre, 0.867 + 0.01);
    EXPECT_GT(c.own_voxel, a == Adjacency::N6 ? 0.99 : 0.4);
    EXPECT_EQ(duplicates(set), 0U);
  }
}

TEST_P(EveryCage, IsTheSameForEveryThreadCountAndFaceOrder) {
  for (const Adjacency a : {Adjacency::N26, Adjacency::N6}) {
    voxel::VoxelizerOptions one;
    one.threads = 1;
    one.subpatches = true;
    voxel::VoxelizerOptions four = one;
    four.threads = 4;
    const VoxelSet x = voxels_of(GetParam().mesh, 40, a, one);
    const VoxelSet y = voxels_of(shuffled(GetParam().mesh, 3), 40, a, four);
    EXPECT_TRUE(same_bytes(x.voxels, y.voxels));
    EXPECT_TRUE(same_bytes(x.subpatches, y.subpatches));
    EXPECT_EQ(x.statistics.evaluations, y.statistics.evaluations);
    EXPECT_FALSE(x.voxels.empty());
    EXPECT_EQ(x.statistics.subpatches, x.subpatches.size());
  }
}

TEST_P(EveryCage, RepresentativesAreTheirVoxelsLimitPoints) {
  constexpr std::uint32_t kRes = 36;
  const auto s = surfaces_of({GetParam().mesh}, kRes);
  const VoxelSet set = run(s, kRes, Adjacency::N26);
  for (const auto& v : set.voxels) {
    const Vec3 p = s[v.object].position(v.face, v.u, v.v);
    const Vec3 q(v.x + static_cast<double>(v.point[0]), v.y + static_cast<double>(v.point[1]),
                 v.z + static_cast<double>(v.point[2]));
    ASSERT_LT((p - q).length(), 2e-5);
    for (const float t : v.point) {
      ASSERT_TRUE(t >= 0 && t < 1);
      ASSERT_EQ(t * 65536, std::floor(t * 65536));
    }
    const Vec3 n(v.normal[0], v.normal[1], v.normal[2]);
    ASSERT_NEAR(n.length(), 1, 1e-6);
    ASSERT_GT(n.dot(s[v.object].normal(v.face, v.u, v.v)), 0.999);
  }
}

TEST_P(EveryCage, CoordinatesAloneAreTheSameVoxels) {
  const auto s = surfaces_of({GetParam().mesh}, 36);
  for (const Adjacency a : {Adjacency::N26, Adjacency::N18, Adjacency::N6}) {
    const VoxelSet full = run(s, 36, a);
    const auto bare = voxel::voxelize_coordinates(s, grid_of(36, a));
    ASSERT_TRUE(bare);
    std::set<Coordinates> c;
    for (const auto& v : bare->voxels) c.emplace(v.x, v.y, v.z);
    EXPECT_EQ(c, coordinates(full));
    EXPECT_EQ(bare->voxels.size(), full.voxels.size());
    EXPECT_EQ(bare->statistics.evaluations, full.statistics.evaluations);
  }
}

TEST_P(EveryCage, SubpatchesAreAdjacentAndTileTheFaces) {
  voxel::VoxelizerOptions o;
  o.subpatches = true;
  const auto s = surfaces_of({GetParam().mesh}, 40);
  const VoxelSet set = run(s, 40, Adjacency::N26, o);
  double area = 0;
  for (const auto& p : set.subpatches) {
    area += static_cast<double>(p.u1 - p.u0) * static_cast<double>(p.v1 - p.v0);
    const std::array<Vec2, 4> at{Vec2(p.u0, p.v0), Vec2(p.u1, p.v0), Vec2(p.u1, p.v1), Vec2(p.u0, p.v1)};
    for (std::size_t k = 0; k < 4; ++k) {
      const auto& v = set.voxels[p.corner[k]];
      const Vec3 q = s[p.object].position(p.face, at[k].x, at[k].y);
      ASSERT_LE(std::abs(q.x - v.x - 0.5), 0.5001);
      ASSERT_LE(std::abs(q.y - v.y - 0.5), 0.5001);
      ASSERT_LE(std::abs(q.z - v.z - 0.5), 0.5001);
      const auto& w = set.voxels[p.corner[(k + 1) % 4]];
      ASSERT_LE(std::max({std::abs(v.x - w.x), std::abs(v.y - w.y), std::abs(v.z - w.z)}), 1);
    }
  }
  EXPECT_NEAR(area, s[0].face_count(), 1e-6);
}

TEST(Voxelizer, EvaluatesAboutOncePerVoxel) {
  for (const auto& [mesh, limit] :
       {std::pair{torus(6, 5), 1.35}, std::pair{spindle(3), 1.4}, std::pair{spindle(7), 1.4},
        std::pair{torus(4, 80, 0.15), 1.4}, std::pair{prism(5), 1.4}}) {
    const VoxelSet set = voxels_of(mesh, 256, Adjacency::N26);
    EXPECT_LT(static_cast<double>(set.statistics.evaluations) / static_cast<double>(set.voxels.size()), limit)
        << mesh.name;
    EXPECT_EQ(set.statistics.floor_hits, 0U);
  }
}

// Generic surfaces pass close by many voxels' corners, but through none.
TEST(Voxelizer, EighteenNeighboursDoNotReachTheFloor) {
  for (const auto& mesh : {torus(6, 5), spindle(7), prism(5)}) {
    auto turned = mesh;
    for (Vec3& p : turned.positions) p = Vec3(p.x + 0.31 * p.y, p.y - 0.17 * p.z, p.z + 0.23 * p.x);
    EXPECT_EQ(voxels_of(turned, 200, Adjacency::N18).statistics.floor_hits, 0U) << mesh.name;
  }
}

// Most of the evaluations of N = 6 are spent where the surface bends within a voxel.
TEST(Voxelizer, EvaluatesFewMorePointsForSixNeighbours) {
  for (const auto& [mesh, limit] :
       {std::pair{torus(6, 5), 3.5}, std::pair{spindle(3), 3.3}, std::pair{prism(5), 2.1}}) {
    const VoxelSet set = voxels_of(mesh, 256, Adjacency::N6);
    EXPECT_LT(static_cast<double>(set.statistics.evaluations) / static_cast<double>(set.voxels.size()), limit)
        << mesh.name;
    EXPECT_EQ(set.statistics.floor_hits, 0U);
    for (const auto& v : set.voxels) {
      for (const float t : v.point) ASSERT_TRUE(t >= 0 && t < 1);
    }
  }
}

TEST(Voxelizer, LeavesOfSixNeighboursLieCloseToTheSurface) {
  voxel::VoxelizerOptions o;
  o.subpatches = true;
  for (const auto& mesh : {torus(6, 5), spindle(7), prism(5), bow_tie()}) {
    const auto s = surfaces_of({mesh}, 50);
    double farthest = 0;
    for (const auto& leaf : run(s, 50, Adjacency::N6, o).subpatches) {
      const auto at = [&](double x, double y) {
        return s[0].position(leaf.face, leaf.u0 + (leaf.u1 - leaf.u0) * x, leaf.v0 + (leaf.v1 - leaf.v0) * y);
      };
      const Vec3 p = at(0, 0);
      const Vec3 lower = (at(1, 0) - p).cross(at(1, 1) - p).normalized();
      const Vec3 upper = (at(1, 1) - p).cross(at(0, 1) - p).normalized();
      for (int i = 0; i < 16; ++i) {
        const int column = i % 4, row = i / 4;
        const double x = column / 4.0 + 0.125;
        const double y = row / 4.0 + 0.125;
        farthest = std::max(farthest, std::abs((at(x, y) - p).dot(x > y ? lower : upper)));
      }
    }
    EXPECT_LT(farthest, 0.02) << mesh.name;
  }
}

// A face whose corners all meet while its middle is far away: the criterion is content with the corners.
TEST(Voxelizer, SixNeighboursCoverAFoldedFace) {
  scene::ControlMesh folded = sheet(3, 3);
  ASSERT_EQ(folded.positions.size(), 16U);
  for (std::size_t i = 0; i < 16; ++i) {
    const double x = i % 4 % 3 == 0 ? 0 : 1;
    const double y = i / 4 % 3 == 0 ? 0 : 1;
    folded.positions[i] = Vec3(x, y, x + y - x * y);
  }
  const auto s = fitted({folded}, 120, 2);
  const VoxelSet thin = run(s, 120, Adjacency::N26);
  const VoxelSet cover = run(s, 120, Adjacency::N6);
  EXPECT_GT(coverage(s, thin, 0.4).uncovered, 0U);
  EXPECT_EQ(coverage(s, cover, 0.4).uncovered, 0U);
}

TEST(Voxelizer, SurplusOverAThinnedSetIsSmall) {
  for (const auto& mesh : {torus(6, 5), spindle(3), spindle(7)}) {
    EXPECT_LT(surplus(voxels_of(mesh, 128, Adjacency::N26)), 0.16) << mesh.name;
  }
}

TEST(Voxelizer, SmallestObjectKeepsASharedVoxel) {
  const auto mesh = spindle(4);
  const auto both = surfaces_of({mesh, mesh}, 60);
  const VoxelSet set = run(both, 60, Adjacency::N26);
  for (const auto& v : set.voxels) ASSERT_EQ(v.object, 0);
  EXPECT_EQ(coordinates(set), coordinates(voxels_of(mesh, 60, Adjacency::N26)));

  auto apart = mesh;
  for (Vec3& p : apart.positions) p.x += 3;
  const VoxelSet two = run(surfaces_of({mesh, apart}, 100), 100, Adjacency::N26);
  EXPECT_EQ(two.voxels.front().object, 0);
  EXPECT_EQ(two.voxels.back().object, 1);
  EXPECT_EQ(separation(two).leaks, 0U);
}

// Planes that lie exactly on voxel walls, along which the last bits of two faces would decide.
TEST(Voxelizer, PlanesOnVoxelWallsAreOneVoxelThick) {
  scene::ControlMesh box = spindle(3);
  const std::array<Vec3, 8> corners{Vec3(8, 8, 8),  Vec3(24, 8, 8),  Vec3(24, 24, 8),  Vec3(8, 24, 8),
                                    Vec3(8, 8, 24), Vec3(24, 8, 24), Vec3(24, 24, 24), Vec3(8, 24, 24)};
  box.positions.assign(corners.begin(), corners.end());
  box.face_sizes.assign(6, 4);
  box.face_indices = {0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7};
  for (std::size_t f = 0; f < 6; ++f) crease_face(box, f, 10);
  std::vector<LimitSurface> s;
  s.push_back(std::move(*LimitSurface::build(box, Mat4())));
  const VoxelSet set = run(s, 32, Adjacency::N26);
  // Voxels 8..24 on each axis: a shell of 17^3 - 15^3.
  EXPECT_EQ(set.voxels.size(), 17U * 17 * 17 - 15U * 15 * 15);
  EXPECT_EQ(separation(set).leaks, 0U);
  EXPECT_EQ(separation(run(s, 32, Adjacency::N6)).leaks, 0U);
}

TEST(Voxelizer, ReportsProgressUpToOne) {
  double last = 0;
  bool monotone = true;
  voxel::VoxelizerOptions o;
  o.progress = [&](double done) {
    monotone = monotone && done >= last;
    last = done;
  };
  voxels_of(torus(8, 6), 200, Adjacency::N26, o);
  EXPECT_TRUE(monotone);
  EXPECT_NEAR(last, 1, 1e-9);
}

}  // namespace
}  // namespace gnomon::test
