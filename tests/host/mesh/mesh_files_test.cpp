// SPDX-License-Identifier: Apache-2.0
// What is written is what other programs read.
#include "host/mesh/mesh_files.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <sstream>

#include "cage_list.hpp"
#include "host/mesh/edge_census.hpp"
#include "host/scene/obj_reader.hpp"
#include "tests/host/scene/files.hpp"
#include "tests/host/voxel/voxelize_cages.hpp"

namespace gnomon::mesh {
namespace {

namespace fs = std::filesystem;

std::string bytes_of(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

SurfaceMesh mesh_of(const std::vector<scene::ControlMesh>& cages, const std::vector<std::string>& names,
                    const Vec3& origin = Vec3(0, 0, 0), double voxel_size = 1) {
  const auto surfaces = test::surfaces_of(cages, 32);
  voxel::VoxelizerOptions options;
  options.subpatches = true;
  voxel::VoxelSet set = test::run(surfaces, 32, voxel::Adjacency::N26, options);
  set.grid.origin = origin;
  set.grid.voxel_size = voxel_size;
  return surface_mesh(surfaces, set, names);
}

std::vector<Corners> faces_of(const scene::ControlMesh& mesh) {
  std::vector<Corners> faces;
  std::size_t at = 0;
  for (const std::int32_t size : mesh.face_sizes) {
    Corners face{kNone, kNone, kNone, kNone};
    for (std::size_t k = 0; k < static_cast<std::size_t>(size); ++k)
      face.at(k) = static_cast<std::uint32_t>(mesh.face_indices.at(at++));
    faces.push_back(face);
  }
  return faces;
}

class MeshFiles : public testing::Test {
 protected:
  fs::path file(const std::string& name) const { return directory_.path() / name; }
  test::TempDir directory_;
};

TEST_F(MeshFiles, OurOwnReaderTakesTheObjAndFindsItClosed) {
  const SurfaceMesh mesh =
      mesh_of({test::with_crease(test::prism(5), 10), test::torus(5, 4)}, {"a prism", "ring"});
  ASSERT_TRUE(write_obj(file("m.obj"), mesh));
  const auto model = scene::read_obj(file("m.obj"));
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_TRUE(model->warnings.empty());
  ASSERT_EQ(model->meshes.size(), 2U);
  EXPECT_EQ(model->meshes[0].name, "a_prism");
  EXPECT_EQ(model->meshes[1].name, "ring");
  std::size_t faces = 0;
  std::size_t vertices = 0;
  for (const scene::ControlMesh& read : model->meshes) {
    EXPECT_TRUE(edge_census(faces_of(read)).closed());
    faces += read.face_sizes.size();
    vertices += read.positions.size();
  }
  EXPECT_EQ(faces, mesh.faces.size());
  ASSERT_EQ(vertices, mesh.positions.size());
  const std::size_t first = model->meshes[0].positions.size();
  for (std::size_t i = 0; i < vertices; ++i) {
    const Vec3& read = i < first ? model->meshes[0].positions[i] : model->meshes[1].positions[i - first];
    ASSERT_LT((read - mesh.positions[i]).length(), 1e-3);
  }
}

TEST_F(MeshFiles, FarFromTheOriginTheObjKeepsAThousandthOfAVoxel) {
  const SurfaceMesh mesh = mesh_of({test::pyramid(4)}, {"p"}, {1e6, -3e7, 2}, 0.001);
  ASSERT_TRUE(write_obj(file("m.obj"), mesh));
  const auto model = scene::read_obj(file("m.obj"));
  ASSERT_TRUE(model) << model.error().message;
  ASSERT_EQ(model->meshes[0].positions.size(), mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    ASSERT_LT((model->meshes[0].positions[i] - mesh.positions[i]).length(), 1e-6);
}

/// The body of a PLY file, read from the front.
class Body {
 public:
  explicit Body(const std::string& bytes) : bytes_(bytes), at_(bytes.find("end_header\n") + 11) {}
  template <class T>
  T next() {
    T value;
    std::memcpy(&value, &bytes_.at(at_ + sizeof(T) - 1) - (sizeof(T) - 1), sizeof(T));
    at_ += sizeof(T);
    return value;
  }
  bool done() const { return at_ == bytes_.size(); }

 private:
  const std::string& bytes_;
  std::size_t at_;
};

TEST_F(MeshFiles, ThePlyHoldsVerticesNormalsShadowsAndFaces) {
  const SurfaceMesh mesh = mesh_of({test::with_crease(test::prism(5), 10)}, {"prism"});
  std::vector<VertexShadows> lights(2, VertexShadows(mesh.positions.size()));
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    lights[0][i] = i % 2;
    lights[1][i] = i % 3 == 0 ? 1 : 0;
  }
  ASSERT_TRUE(write_ply(file("m.ply"), mesh, lights));
  const std::string bytes = bytes_of(file("m.ply"));
  const std::string header = bytes.substr(0, bytes.find("end_header\n"));
  EXPECT_EQ(
      header,
      "ply\nformat binary_little_endian 1.0\ncomment gnomon: subpatches of limit surfaces\nelement vertex " +
          std::to_string(mesh.positions.size()) +
          "\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\nproperty float ny\n"
          "property float nz\nproperty uchar shadow_0\nproperty uchar shadow_1\nelement face " +
          std::to_string(mesh.faces.size()) + "\nproperty list uchar int vertex_indices\n");
  Body body(bytes);
  const auto normals = vertex_normals(mesh);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    for (int k = 0; k < 3; ++k) ASSERT_EQ(body.next<float>(), static_cast<float>(mesh.positions[i][k]));
    for (std::size_t k = 0; k < 3; ++k) ASSERT_EQ(body.next<float>(), normals[i][k]);
    ASSERT_EQ(body.next<std::uint8_t>(), i % 2);
    ASSERT_EQ(body.next<std::uint8_t>(), i % 3 == 0 ? 1 : 0);
  }
  for (const Corners& face : mesh.faces) {
    ASSERT_EQ(body.next<std::uint8_t>(), corner_count(face));
    for (std::size_t k = 0; k < corner_count(face); ++k)
      ASSERT_EQ(body.next<std::int32_t>(), static_cast<std::int32_t>(face[k]));
  }
  EXPECT_TRUE(body.done());
}

TEST_F(MeshFiles, TheNameDecidesTheFormat) {
  EXPECT_EQ(mesh_format("a/b.obj").value(), MeshFormat::Obj);
  EXPECT_EQ(mesh_format("b.ply").value(), MeshFormat::Ply);
  EXPECT_EQ(mesh_format("a/b.stl").error().message,
            "a/b.stl: error: expected a name that ends in .obj or .ply");
  EXPECT_FALSE(mesh_format("obj"));
}

TEST_F(MeshFiles, WhatCannotBeWrittenIsSaid) {
  const SurfaceMesh mesh = mesh_of({test::pyramid(4)}, {"p"});
  EXPECT_FALSE(write_obj(file("missing/m.obj"), mesh));
  EXPECT_FALSE(write_mesh(MeshFormat::Ply, "/dev/full", mesh, {}));
}

}  // namespace
}  // namespace gnomon::mesh
