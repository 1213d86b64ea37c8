// SPDX-License-Identifier: Apache-2.0
// Surfaces that reach out of the grid.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "criteria.hpp"
#include "reference.hpp"
#include "voxelize_cages.hpp"

namespace gnomon::test {
namespace {

using surface::LimitSurface;
using voxel::Adjacency;
using voxel::VoxelSet;

// A smooth cube's control points reach a third of its half side beyond it.
TEST(Voxelizer, AcceptsASurfaceWhoseControlPointsAreOutside) {
  for (const Adjacency a : {Adjacency::N26, Adjacency::N18, Adjacency::N6}) {
    const VoxelSet set = run(fitted({spindle(3)}, 40, -3), 40, a);
    EXPECT_EQ(separation(set).leaks, 0U);
    for (const auto& v : set.voxels) ASSERT_LT(std::max({v.x, v.y, v.z}), 40);
  }
}

TEST(Voxelizer, RefusesExactlyTheSurfacesThatLeaveTheGrid) {
  constexpr int kRes = 20;
  std::size_t refused = 0;
  std::size_t accepted = 0;
  const auto inside = [](int c) { return c >= 0 && c < kRes; };
  const auto check = [&](const std::vector<LimitSurface>& s, Adjacency a) {
    const bool fits =
        std::ranges::all_of(reference_voxels(s, grid_of(kRes, a)).voxels, [&](const Coordinates& c) {
          return inside(std::get<0>(c)) && inside(std::get<1>(c)) && inside(std::get<2>(c));
        });
    (fits ? accepted : refused) += 1;
    EXPECT_EQ(voxel::voxelize(s, grid_of(kRes, a)).has_value(), fits);
    EXPECT_EQ(voxel::voxelize_coordinates(s, grid_of(kRes, a)).has_value(), fits);
    if (a == Adjacency::N26) {  // N = 6 begins with the same points
      EXPECT_EQ(voxel::voxelize(s, grid_of(kRes, Adjacency::N6)).has_value(), fits);
    }
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (int shift = -6; shift <= 6; ++shift) {
      Mat4 move;
      move[3][axis] = shift;
      std::vector<LimitSurface> s;
      s.push_back(std::move(*LimitSurface::build(spindle(5), fit_to_grid({spindle(5)}, kRes, 1) * move)));
      for (const Adjacency a : {Adjacency::N26, Adjacency::N18}) check(s, a);
    }
  }
  EXPECT_GT(accepted, 20U);
  EXPECT_GT(refused, 20U);
}

TEST(Voxelizer, NamesTheSamePointOutsideForEveryThreadCount) {
  const auto s = surfaces_of({spindle(3), torus(5, 4)}, 300);
  for (const Adjacency a : {Adjacency::N26, Adjacency::N18, Adjacency::N6}) {
    std::set<std::string> messages;
    for (const unsigned threads : {1U, 2U, 4U}) {
      voxel::VoxelizerOptions o;
      o.threads = threads;
      const auto outside = voxel::voxelize(s, grid_of(200, a), o);
      ASSERT_FALSE(outside);
      messages.insert(outside.error().message);
    }
    EXPECT_EQ(messages.size(), 1U);
    EXPECT_NE(messages.begin()->find("outside the grid 0..200"), std::string::npos) << *messages.begin();
  }
}

TEST(Voxelizer, RefusesGridsItCannotHold) {
  const auto s = surfaces_of({spindle(3)}, 64);
  EXPECT_FALSE(voxel::voxelize(s, grid_of(0, Adjacency::N26)));
  EXPECT_FALSE(voxel::voxelize_coordinates(s, grid_of(70000, Adjacency::N26)));
  EXPECT_TRUE(voxel::voxelize({}, grid_of(32, Adjacency::N26))->voxels.empty());
}

}  // namespace
}  // namespace gnomon::test
