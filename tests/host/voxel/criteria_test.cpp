// SPDX-License-Identifier: Apache-2.0
// The checkers themselves.
#include "criteria.hpp"

#include <gtest/gtest.h>

#include "host/voxel/voxel_key.hpp"
#include "voxelize_cages.hpp"

namespace gnomon::test {
namespace {

using voxel::Adjacency;
using voxel::VoxelSet;

TEST(Criteria, AHoleLeaks) {
  for (const Adjacency a : {Adjacency::N26, Adjacency::N18, Adjacency::N6}) {
    VoxelSet set = voxels_of(spindle(5), 64, a);
    EXPECT_EQ(separation(set).leaks, 0U);
    // Take away a voxel that has both sides next to it, as thinning finds them all.
    std::uint64_t leaking = 0;
    for (std::size_t i = 0; i < set.voxels.size() && leaking == 0; i += 97) {
      const auto taken = set.voxels[i];
      set.voxels.erase(set.voxels.begin() + static_cast<std::ptrdiff_t>(i));
      leaking = separation(set).leaks;
      set.voxels.insert(set.voxels.begin() + static_cast<std::ptrdiff_t>(i), taken);
    }
    EXPECT_GT(leaking, 1000U);
  }
}

TEST(Criteria, WhatLiesBeforeTheNormalsIsABay) {
  VoxelSet set = voxels_of(spindle(5), 64, Adjacency::N26);
  const Separation out = separation(set);
  for (auto& v : set.voxels) {
    for (float& n : v.normal) n = -n;
  }
  const Separation in = separation(set);
  EXPECT_GT(out.inside, 1000U);
  EXPECT_EQ(out.bays, 0U);
  EXPECT_EQ(in.inside, 0U);
  EXPECT_EQ(in.bays, out.inside);
}

TEST(Criteria, FarVoxelsAndGapsAreSeen) {
  const auto s = surfaces_of({spindle(5)}, 40);
  VoxelSet set = run(s, 40, Adjacency::N26);
  set.voxels.push_back(set.voxels.front());
  EXPECT_EQ(duplicates(set), 1U);
  set.voxels.back().x = 20;
  set.voxels.back().y = 20;
  set.voxels.back().z = 20;
  EXPECT_GT(coverage(s, set, 0.3).farthest_centre, 2);
  set.voxels.resize(set.voxels.size() / 2);
  EXPECT_GT(coverage(s, set, 0.3).uncovered, 100U);
}

TEST(Criteria, ThinningFindsWhatIsTooMuch) {
  VoxelSet set = voxels_of(spindle(4), 64, Adjacency::N26);
  const double lean = surplus(set);
  EXPECT_LT(lean, 0.2);
  const auto thick = DenseGrid(set).dilated();
  set.voxels.clear();
  for (std::uint16_t z = 0; z < 64; ++z) {
    for (std::uint16_t y = 0; y < 64; ++y) {
      for (std::uint16_t x = 0; x < 64; ++x) {
        if (thick.at(x, y, z) != 0) set.voxels.push_back(voxel::bare_voxel(voxel::pack(x, y, z)));
      }
    }
  }
  EXPECT_GT(surplus(set), 1);
}

}  // namespace
}  // namespace gnomon::test
