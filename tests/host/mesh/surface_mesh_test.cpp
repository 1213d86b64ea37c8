// SPDX-License-Identifier: Apache-2.0
// Closed cages give closed meshes on the limit surface; open ones are open where the cage is.
#include "host/mesh/surface_mesh.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <stdexcept>

#include "cage_list.hpp"
#include "host/mesh/edge_census.hpp"
#include "host/metrics/voxel_index.hpp"
#include "tests/host/voxel/voxelize_cages.hpp"

namespace gnomon::test {
void PrintTo(const NamedCage& c, std::ostream* os) {
  *os << c.name;
}
}  // namespace gnomon::test

namespace gnomon::mesh {
namespace {

constexpr std::uint32_t kRes = 40;

struct Voxelized {
  std::vector<surface::LimitSurface> surfaces;
  voxel::VoxelSet set;
};
Voxelized voxelized(const std::vector<scene::ControlMesh>& meshes, std::uint32_t res = kRes) {
  Voxelized out;
  out.surfaces = test::surfaces_of(meshes, res);
  voxel::VoxelizerOptions options;
  options.subpatches = true;
  out.set = test::run(out.surfaces, res, voxel::Adjacency::N26, options);
  return out;
}
SurfaceMesh mesh_of(const Voxelized& v) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < v.surfaces.size(); ++i) names.push_back("part" + std::to_string(i));
  return surface_mesh(v.surfaces, v.set, names);
}
Vec3 normal_of(const SurfaceMesh& mesh, std::uint32_t index) {
  return {mesh.normals[index][0], mesh.normals[index][1], mesh.normals[index][2]};
}

class Meshes : public testing::TestWithParam<test::NamedCage> {};
INSTANTIATE_TEST_SUITE_P(Cages, Meshes, testing::ValuesIn(test::all_cages()),
                         [](const auto& i) { return i.param.name; });

TEST_P(Meshes, AreClosedWhereTheCageIs) {
  const SurfaceMesh mesh = mesh_of(voxelized({GetParam().mesh}));
  const EdgeCensus census = edge_census(mesh.faces);
  EXPECT_GT(mesh.faces.size(), 200U);
  EXPECT_EQ(census.turned, 0U);
  if (GetParam().closed) {
    EXPECT_EQ(census.open, 0U);
    EXPECT_EQ(census.crowded, 0U);
    EXPECT_TRUE(census.closed());
  } else {
    EXPECT_GT(census.open, 20U);
  }
}

/// The volume under the faces: its sign says which way they turn.
double signed_volume(const SurfaceMesh& mesh) {
  double six = 0;
  for (const Corners& face : mesh.faces) {
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
      six += mesh.positions[face[a]].dot(mesh.positions[face[b]].cross(mesh.positions[face[c]]));
    };
    add(0, 1, 2);
    if (corner_count(face) == 4) add(0, 2, 3);
  }
  return six / 6;
}

/// A cube from -1 to 1 with infinitely sharp edges, wound outwards: its limit is the cube itself.
scene::ControlMesh sharp_cube() {
  scene::ControlMesh cube;
  for (int i = 0; i < 8; ++i)
    cube.positions.emplace_back((i & 1) * 2 - 1, (i >> 1 & 1) * 2 - 1, (i >> 2 & 1) * 2 - 1);
  cube.face_sizes.assign(6, 4);
  cube.face_indices = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
  for (std::size_t face = 0; face < 6; ++face) test::crease_face(cube, face, 10);
  return cube;
}

TEST(SurfaceMesh, ASharpBoxIsTheBox) {
  const scene::ControlMesh cube = sharp_cube();
  const SurfaceMesh mesh = mesh_of(voxelized({cube}));
  const double side = kRes - 4;  // two voxels of margin
  EXPECT_NEAR(signed_volume(mesh) / (side * side * side), 1, 1e-6);
  const Mat4 to_grid = test::fit_to_grid({cube}, kRes);
  std::size_t on_corners = 0;
  for (const Vec3& p : mesh.positions) {
    for (const Vec3& c : cube.positions) on_corners += (p - c * to_grid).length() < 1e-4 ? 1U : 0U;
  }
  EXPECT_EQ(on_corners, 8U) << "each corner is one vertex";
}

TEST(SurfaceMesh, NormalsFollowTheSurfaceAndSplitAtCreases) {
  const SurfaceMesh smooth = mesh_of(voxelized({test::spindle(5)}));
  EXPECT_EQ(smooth.normals.size(), smooth.positions.size()) << "one normal a vertex";
  const SurfaceMesh creased = mesh_of(voxelized({test::with_crease(test::spindle(5), 10)}));
  EXPECT_GT(creased.normals.size(), creased.positions.size() + 20);
  std::size_t compared = 0;
  for (const SurfaceMesh* mesh : {&smooth, &creased}) {
    for (std::size_t f = 0; f < mesh->faces.size(); ++f) {
      const Corners& face = mesh->faces[f];
      const Vec3 a = mesh->positions[face[1]] - mesh->positions[face[0]];
      const Vec3 b = mesh->positions[face[2]] - mesh->positions[face[0]];
      const Vec3 across = a.cross(b);
      if (across.length() < 1e-3) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 normal = normal_of(*mesh, mesh->face_normals[f][k]);
        EXPECT_NEAR(normal.length(), 1, 1e-5);
        EXPECT_GT(normal.dot(across.normalized()), 0.5);
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 3000U);
}

TEST(SurfaceMesh, NormalsOfVerticesAreTheMeanOfTheSides) {
  const SurfaceMesh smooth = mesh_of(voxelized({test::spindle(5)}));
  const auto means = vertex_normals(smooth);
  ASSERT_EQ(means.size(), smooth.positions.size());
  for (std::size_t f = 0; f < smooth.faces.size(); ++f)
    for (std::size_t k = 0; k < corner_count(smooth.faces[f]); ++k)
      for (std::size_t axis = 0; axis < 3; ++axis)
        ASSERT_NEAR(means[smooth.faces[f][k]][axis], smooth.normals[smooth.face_normals[f][k]][axis], 2e-3);
  SurfaceMesh folded;
  folded.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  folded.normals = {{0, 0, 1}, {1, 0, 0}, {0, 0, -1}};
  folded.faces = {{0, 1, 2, kNone}, {0, 2, 3, kNone}};
  folded.face_normals = {{0, 0, 0, kNone}, {1, 2, 1, kNone}};
  const auto mixed = vertex_normals(folded);
  EXPECT_NEAR(mixed[0][0], std::sqrt(0.5), 1e-6);
  EXPECT_NEAR(mixed[0][2], std::sqrt(0.5), 1e-6);
  EXPECT_NEAR(std::abs(mixed[2][2]), 1, 1e-6) << "where normals cancel, one of them";
}

TEST(SurfaceMesh, ObjectsThatTouchStayApart) {
  // The same cage twice: every point of one is a point of the other.
  const Voxelized v = voxelized({test::spindle(4), test::spindle(4), test::pyramid(4)});
  const SurfaceMesh mesh = mesh_of(v);
  ASSERT_EQ(mesh.objects.size(), 3U);
  EXPECT_EQ(mesh.objects[2].name, "part2");
  EXPECT_TRUE(edge_census(mesh.faces).closed());
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t end = i < 2 ? mesh.objects[i + 1].first_face : mesh.faces.size();
    EXPECT_TRUE(
        edge_census(
            std::span(mesh.faces).subspan(mesh.objects[i].first_face, end - mesh.objects[i].first_face))
            .closed());
  }
}

TEST(SurfaceMesh, WithoutStitchingItWouldBeOpen) {
  const Voxelized v = voxelized({test::spindle(7)}, 64);
  const SurfaceMesh mesh = mesh_of(v);
  const auto quads = std::ranges::count_if(mesh.faces, [](const Corners& f) { return corner_count(f) == 4; });
  EXPECT_GT(static_cast<std::size_t>(quads), mesh.faces.size() / 4);
  EXPECT_LT(static_cast<std::size_t>(quads), v.set.subpatches.size() - 100) << "some are stitched";
}

TEST(SurfaceMesh, EveryVertexHasTheStateOfItsVoxel) {
  const Voxelized v = voxelized({test::prism(5), test::sheet(4, 3)});
  const SurfaceMesh mesh = mesh_of(v);
  const metrics::VoxelIndex index(v.set);
  std::size_t own = 0;
  ASSERT_EQ(mesh.voxels.size(), mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    ASSERT_LT(mesh.voxels[i], v.set.voxels.size());
    own += mesh.voxels[i] == index.answering(mesh.positions[i]) ? 1U : 0U;
  }
  // Points on a wall between voxels may fall to either side in single precision.
  EXPECT_GT(own, mesh.positions.size() * 98 / 100);
  std::vector<golden::VoxelState> states(v.set.voxels.size(), golden::VoxelState::Lit);
  for (std::size_t i = 0; i < states.size(); i += 3) states[i] = golden::VoxelState::Shadow;
  const auto shadows = vertex_shadows(mesh, states);
  ASSERT_EQ(shadows.size(), mesh.positions.size());
  for (std::size_t i = 0; i < shadows.size(); ++i) ASSERT_EQ(shadows[i], mesh.voxels[i] % 3 == 0 ? 1 : 0);
}

TEST(SurfaceMesh, WorldCoordinatesAreTheGridsMovedAndScaled) {
  Voxelized v = voxelized({test::pyramid(3)});
  const SurfaceMesh in_grid = mesh_of(v);
  v.set.grid.origin = {10, -20, 30};
  v.set.grid.voxel_size = 0.25;
  const SurfaceMesh in_world = mesh_of(v);
  ASSERT_EQ(in_world.positions.size(), in_grid.positions.size());
  EXPECT_EQ(in_world.spacing, 0.25);
  for (std::size_t i = 0; i < in_grid.positions.size(); ++i)
    ASSERT_LT((in_world.positions[i] - (Vec3(10, -20, 30) + in_grid.positions[i] * 0.25)).length(), 1e-12);
  EXPECT_EQ(in_world.voxels, in_grid.voxels);
}

TEST(SurfaceMesh, DoesNotDependOnTheNumberOfThreads) {
  const Voxelized v = voxelized({test::torus(5, 4), test::prism(5)});
  const SurfaceMesh more = mesh_of(v);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
  const SurfaceMesh one = mesh_of(v);
  EXPECT_EQ(one.faces, more.faces);
  EXPECT_EQ(one.positions, more.positions);
  EXPECT_EQ(one.normals, more.normals);
  EXPECT_EQ(one.voxels, more.voxels);
}

TEST(SurfaceMesh, RefusesWhatIsMissing) {
  Voxelized v = voxelized({test::pyramid(3)});
  EXPECT_THROW(surface_mesh(v.surfaces, v.set, {}), std::invalid_argument);
  v.set.subpatches.clear();
  EXPECT_THROW(mesh_of(v), std::invalid_argument);
}

}  // namespace
}  // namespace gnomon::mesh
