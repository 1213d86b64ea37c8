// SPDX-License-Identifier: Apache-2.0
// The census notices every way in which a mesh can fail to be closed.
#include "host/mesh/edge_census.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace gnomon::mesh {
namespace {

/// A cube's six quads, one of them as two triangles.
std::vector<Corners> cube() {
  return {{0, 2, 3, 1}, {4, 5, 7, 6},     {0, 1, 5, 4},    {2, 6, 7, 3},
          {0, 4, 6, 2}, {1, 3, 7, kNone}, {1, 7, 5, kNone}};
}

TEST(EdgeCensus, OfACubeFindsItClosed) {
  const EdgeCensus census = edge_census(cube());
  EXPECT_EQ(census.edges, 13U);
  EXPECT_TRUE(census.closed());
}

TEST(EdgeCensus, AMissingFaceLeavesItsEdgesOpen) {
  std::vector<Corners> faces = cube();
  faces.erase(faces.begin());
  const EdgeCensus census = edge_census(faces);
  EXPECT_EQ(census.open, 4U);
  EXPECT_EQ(census.crowded + census.turned, 0U);
  EXPECT_FALSE(census.closed());
}

TEST(EdgeCensus, AFaceTooManyCrowdsItsEdges) {
  std::vector<Corners> faces = cube();
  faces.push_back({0, 2, 3, 1});
  const EdgeCensus census = edge_census(faces);
  EXPECT_EQ(census.crowded, 4U);
  EXPECT_FALSE(census.closed());
}

TEST(EdgeCensus, AFaceTheWrongWayRoundTurnsItsEdges) {
  std::vector<Corners> faces = cube();
  std::swap(faces[5][1], faces[5][2]);
  const EdgeCensus census = edge_census(faces);
  EXPECT_EQ(census.turned, 3U);
  EXPECT_EQ(census.open + census.crowded, 0U);
  EXPECT_FALSE(census.closed());
}

TEST(EdgeCensus, NothingIsNotClosed) {
  EXPECT_FALSE(edge_census({}).closed());
}

}  // namespace
}  // namespace gnomon::mesh
