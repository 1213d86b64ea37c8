// SPDX-License-Identifier: Apache-2.0
// Counts and winding.
#include "host/scene/mesh_topology.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <sstream>

#include "host/scene/obj_reader.hpp"
#include "tests/host/scene/files.hpp"

namespace gnomon::scene {
namespace {

ControlMesh mesh_of(std::vector<Vec3> positions, const std::vector<std::vector<std::int32_t>>& faces) {
  ControlMesh mesh;
  mesh.positions = std::move(positions);
  for (const auto& face : faces) {
    mesh.face_sizes.push_back(static_cast<std::int32_t>(face.size()));
    mesh.face_indices.insert(mesh.face_indices.end(), face.begin(), face.end());
  }
  return mesh;
}

ControlMesh cube() {
  return mesh_of(
      {{-1, -1, 1}, {1, -1, 1}, {-1, 1, 1}, {1, 1, 1}, {-1, 1, -1}, {1, 1, -1}, {-1, -1, -1}, {1, -1, -1}},
      {{0, 1, 3, 2}, {2, 3, 5, 4}, {4, 5, 7, 6}, {6, 7, 1, 0}, {1, 7, 5, 3}, {6, 0, 2, 4}});
}

/// A flat n x n grid of unit quads.
ControlMesh plate(int n) {
  std::vector<Vec3> positions;
  std::vector<std::vector<std::int32_t>> faces;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) positions.emplace_back(i, j, 0);
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const int v = j * (n + 1) + i;
      faces.push_back({v, v + 1, v + n + 2, v + n + 1});
    }
  }
  return mesh_of(std::move(positions), faces);
}

/// A band of `n` quads whose ends meet with a half turn.
ControlMesh moebius(int n) {
  std::vector<Vec3> positions;
  std::vector<std::vector<std::int32_t>> faces;
  for (int i = 0; i < n; ++i) {
    const double a = 6.283185307179586 * i / n;
    const Vec3 out(std::cos(a), std::sin(a), 0);
    const Vec3 side = out * (0.3 * std::cos(a / 2)) + Vec3(0, 0, 0.3 * std::sin(a / 2));
    positions.push_back(out + side);
    positions.push_back(out - side);
  }
  for (int i = 0; i < n; ++i) {
    const bool last = i + 1 == n;
    const int next = last ? 0 : 2 * i + 2;
    faces.push_back({2 * i, next + (last ? 1 : 0), next + (last ? 0 : 1), 2 * i + 1});
  }
  return mesh_of(std::move(positions), faces);
}

void turn(ControlMesh& mesh, std::size_t face) {
  auto first = mesh.face_indices.begin();
  for (std::size_t f = 0; f < face; ++f) first += mesh.face_sizes[f];
  std::reverse(first + 1, first + mesh.face_sizes[face]);
}

TEST(Measure, CountsAClosedMesh) {
  const MeshStatistics s = measure(cube());
  EXPECT_EQ(s.vertices, 8U);
  EXPECT_EQ(s.faces, 6U);
  EXPECT_EQ(s.quads, 6U);
  EXPECT_EQ(s.edges, 12U);
  EXPECT_EQ(s.boundary_edges + s.non_manifold_edges + s.inconsistent_edges + s.degenerate_faces, 0U);
  EXPECT_EQ(s.extraordinary_vertices, 8U);
  EXPECT_EQ(s.largest_valence, 3U);
  EXPECT_TRUE(is_closed(s));
}

TEST(Measure, CountsAnOpenMesh) {
  const MeshStatistics s = measure(plate(3));
  EXPECT_EQ(s.edges, 24U);
  EXPECT_EQ(s.boundary_edges, 12U);
  EXPECT_EQ(s.extraordinary_vertices, 0U);
  EXPECT_FALSE(is_closed(s));
}

TEST(Measure, CountsNonManifoldEdges) {
  const MeshStatistics s = measure(
      mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}));
  EXPECT_EQ(s.non_manifold_edges, 1U);
  EXPECT_EQ(s.boundary_edges, 6U);
  EXPECT_EQ(s.triangles, 3U);
}

TEST(Measure, CountsFacesWithoutArea) {
  const MeshStatistics s =
      measure(mesh_of({{1e7, 0, 0}, {1e7 + 1, 0, 0}, {1e7 + 2, 0, 0}, {1e7, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(s.degenerate_faces, 1U);
}

TEST(Orient, LeavesASoundMeshAlone) {
  ControlMesh mesh = cube();
  EXPECT_EQ(orient(mesh), 0U);
  EXPECT_EQ(mesh.face_indices, cube().face_indices);
}

TEST(Orient, TurnsAnInsideOutMesh) {
  ControlMesh mesh = cube();
  reverse_winding(mesh);
  EXPECT_EQ(orient(mesh), 6U);
  EXPECT_EQ(mesh.face_indices, cube().face_indices);
}

TEST(Orient, TurnsTheFewerFacesOfAnOpenMesh) {
  ControlMesh mesh = plate(4);
  for (const std::size_t face : {0U, 5U, 6U, 15U}) turn(mesh, face);
  EXPECT_GT(measure(mesh).inconsistent_edges, 0U);
  EXPECT_EQ(orient(mesh), 4U);
  EXPECT_EQ(mesh.face_indices, plate(4).face_indices);
}

TEST(Orient, RepairsAnyTurnedFacesOfAClosedMesh) {
  rc::check("orient undoes turned faces", [] {
    ControlMesh mesh = cube();
    const auto turned = *rc::gen::container<std::vector<bool>>(6, rc::gen::arbitrary<bool>());
    for (std::size_t face = 0; face < 6; ++face) {
      if (turned[face]) turn(mesh, face);
    }
    orient(mesh);
    RC_ASSERT(mesh.face_indices == cube().face_indices);
  });
}

TEST(Orient, LeavesWhatNoWindingCures) {
  ControlMesh mesh = moebius(9);
  EXPECT_EQ(measure(mesh).inconsistent_edges, 1U);
  orient(mesh);
  EXPECT_EQ(measure(mesh).inconsistent_edges, 1U);

  std::ostringstream text;
  for (const Vec3& p : mesh.positions) text << "v " << p.x << " " << p.y << " " << p.z << "\n";
  for (std::size_t f = 0; f < 9; ++f) {
    text << "f";
    for (std::size_t i = 0; i < 4; ++i) text << " " << mesh.face_indices[4 * f + i] + 1;
    text << "\n";
  }
  const test::TempDir directory;
  const Result<ObjModel> model = read_obj(directory.write("moebius.obj", text.str()));
  ASSERT_TRUE(model.has_value());
  EXPECT_EQ(model->total.unorientable_edges, 1U);
}

}  // namespace
}  // namespace gnomon::scene
