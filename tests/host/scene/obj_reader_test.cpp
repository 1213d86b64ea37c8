// SPDX-License-Identifier: Apache-2.0
// Control cages as modellers write them.
#include "host/scene/obj_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>

#include "tests/host/scene/files.hpp"

namespace gnomon::scene {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

ObjModel read(std::string_view text) {
  const test::TempDir directory;
  Result<ObjModel> model = read_obj(directory.write("model.obj", text));
  if (!model) throw std::runtime_error(model.error().message);
  return std::move(*model);
}

const std::string kQuad = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(ObjReader, ReadsACube) {
  const ObjModel model = read(test::cube_text());
  ASSERT_EQ(model.meshes.size(), 1U);
  const ControlMesh& mesh = model.meshes[0];
  EXPECT_EQ(mesh.name, "model");
  EXPECT_EQ(mesh.positions.size(), 8U);
  EXPECT_EQ(mesh.positions[1], Vec3(1, -1, 1));
  EXPECT_THAT(mesh.face_sizes, ElementsAre(4, 4, 4, 4, 4, 4));
  EXPECT_THAT(std::vector(mesh.face_indices.begin(), mesh.face_indices.begin() + 4), ElementsAre(0, 1, 3, 2));
  EXPECT_EQ(mesh.boundary, Boundary::EdgeAndCorner);
  EXPECT_TRUE(model.warnings.empty());
  EXPECT_TRUE(is_closed(model.total));
}

TEST(ObjReader, ReadsEveryFormOfACorner) {
  for (const char* face :
       {"f 1 2 3 4", "f 1/9 2/9 3/9 4/9", "f 1//9 2//9 3//9 4//9", "f 1/9/9 2/9/9 3/9/9 4/9/9",
        "f 1/ 2/ 3/ 4/", "f 1// 2// 3// 4//", "f\t1 2\t 3  4 ", "  f 1 2 3 4", "f -4 -3 -2 -1",
        "f 1 -3/1 +3 4//2", "f 1 2 3 4 # quad"}) {
    SCOPED_TRACE(face);
    EXPECT_THAT(read(kQuad + face + "\n").meshes[0].face_indices, ElementsAre(0, 1, 2, 3));
  }
}

TEST(ObjReader, ReadsEveryFormOfANumber) {
  const ObjModel model = read("v +1 -2. .5\nv 1e1 2E+1 -.25e-1\nv 0.1 1e-320 -0\nf 1 2 3\n");
  const std::vector<Vec3>& p = model.meshes[0].positions;
  EXPECT_EQ(p[0], Vec3(1, -2, 0.5));
  EXPECT_DOUBLE_EQ(p[1].x, 10);
  EXPECT_DOUBLE_EQ(p[1].y, 20);
  EXPECT_DOUBLE_EQ(p[1].z, -0.025);
  EXPECT_DOUBLE_EQ(p[2].x, 0.1);
  EXPECT_NEAR(p[2].y, 0, 1e-300);
  EXPECT_EQ(p[2].z, 0);
}

TEST(ObjReader, KeepsDoublePrecision) {
  const ObjModel model =
      read("v 10000000.123456789 0 0\nv 10000001 0 0\nv 10000000 1 -3.14159265358979\nf 1 2 3\n");
  EXPECT_NEAR(model.meshes[0].positions[0].x, 10000000.123456789, 4e-9);
  EXPECT_NEAR(model.meshes[0].positions[2].z, -3.14159265358979, 2e-15);
}

TEST(ObjReader, IgnoresWhatIsNoCage) {
  const ObjModel model = read("mtllib C:\\models\\\n# by C:\\tools\\\n" + kQuad +
                              "vt 0 0\nvt bad\nvn 0 0 1\nusemtl red # one\ns off\ns 1\ng a b\nl 1 2\np 1\n"
                              "vp 0.1\nf 1/1/1 2/1/1 3/1/1 4/1/1\ncstype bspline\nend\n");
  EXPECT_EQ(model.total.faces, 1U);
  EXPECT_TRUE(model.warnings.empty());
}

TEST(ObjReader, ReadsEveryLineEnding) {
  std::string text = kQuad + "f 1 2 3 4";
  for (const std::string ending : {"\n", "\r\n", "\r"}) {
    std::string other;
    for (const char c : text) other += c == '\n' ? ending : std::string(1, c);
    EXPECT_EQ(read(other).total.faces, 1U);
    EXPECT_EQ(read(other + ending).total.vertices, 4U);
  }
}

TEST(ObjReader, JoinsContinuedLines) {
  EXPECT_THAT(read(kQuad + "f 1 \\\n2 3\\\r\n4\n").meshes[0].face_indices, ElementsAre(0, 1, 2, 3));
  // Not after a comment or a name: paths of Windows end in backslashes.
  const ObjModel model = read("# C:\\\n" + kQuad + "o C:\\\nf 1 2 3 4\n");
  EXPECT_EQ(model.meshes[0].name, "C:\\");
}

TEST(ObjReader, SkipsAByteOrderMark) {
  EXPECT_EQ(read("\xEF\xBB\xBF" + kQuad + "f 1 2 3 4\n").total.faces, 1U);
}

TEST(ObjReader, AcceptsColoursAndReportsWeights) {
  EXPECT_TRUE(read("v 0 0 0 1 0 0\nv 1 0 0 .5 .5 .5\nv 0 1 0 0 0 1\nf 1 2 3\n").warnings.empty());
  const ObjModel weighted = read("v 0 0 0 1\nv 1 0 0 0.5\nv 0 1 0\nf 1 2 3\n");
  ASSERT_EQ(weighted.warnings.size(), 1U);
  EXPECT_THAT(weighted.warnings[0], HasSubstr("weight"));
}

TEST(ObjReader, KeepsPolygonsOfAnySize) {
  constexpr int kSides = 1000;
  std::ostringstream vertices, face;
  for (int i = 0; i < kSides; ++i) {
    const double angle = i * 6.2831853 / kSides;
    vertices << "v " << std::cos(angle) << " " << std::sin(angle) << " 0\n";
    face << " " << i + 1;
  }
  const ObjModel model = read(vertices.str() + "f" + face.str() + "\n");
  EXPECT_THAT(model.meshes[0].face_sizes, ElementsAre(kSides));
  EXPECT_EQ(model.total.ngons, 1U);
  EXPECT_EQ(model.total.largest_face, static_cast<std::size_t>(kSides));
}

TEST(ObjReader, TakesFacesBeforeTheirVertices) {
  EXPECT_THAT(read("f 1 2 3 4\n" + kQuad).meshes[0].face_indices, ElementsAre(0, 1, 2, 3));
}

TEST(ObjReader, SplitsObjectsButNotGroups) {
  const std::string other = "v 5 0 0\nv 6 0 0\nv 6 1 0\nv 5 1 0\n";
  const ObjModel objects = read("o first thing\n" + kQuad + "f 1 2 3 4\no second\n" + other + "f 5 6 7 8\n");
  ASSERT_EQ(objects.meshes.size(), 2U);
  EXPECT_EQ(objects.meshes[0].name, "first thing");
  EXPECT_EQ(objects.meshes[1].name, "second");
  EXPECT_THAT(objects.meshes[1].face_indices, ElementsAre(0, 1, 2, 3));
  EXPECT_EQ(objects.meshes[1].positions[0], Vec3(5, 0, 0));
  EXPECT_EQ(objects.total.vertices, 8U);
  EXPECT_EQ(objects.total.unused_vertices, 0U);

  const ObjModel groups = read("g first\n" + kQuad + "f 1 2 3 4\ng second\n" + other + "f 5 6 7 8\n");
  EXPECT_EQ(groups.meshes.size(), 1U);
}

TEST(ObjReader, ReturnsToAnObjectOfTheSameName) {
  const ObjModel model =
      read("o a\n" + kQuad + "f 1 2 3\no b\nv 5 0 0\nv 6 0 0\nv 6 1 0\nf 5 6 7\no a\nf 1 3 4\n");
  ASSERT_EQ(model.meshes.size(), 2U);
  EXPECT_EQ(model.meshes[0].face_sizes.size(), 2U);
  EXPECT_EQ(model.total.boundary_edges, 4U + 3U);
}

TEST(ObjReader, JoinsObjectsThatShareAnEdge) {
  const ObjModel model = read(kQuad + "v 2 0 0\nv 2 1 0\no left\nf 1 2 3 4\no right\nf 2 5 6 3\n");
  ASSERT_EQ(model.meshes.size(), 1U);
  EXPECT_EQ(model.meshes[0].name, "left");
  EXPECT_EQ(model.total.boundary_edges, 6U);
  ASSERT_EQ(model.warnings.size(), 1U);
  EXPECT_THAT(model.warnings[0], HasSubstr("'right' shares edges with 'left'"));
}

TEST(ObjReader, KeepsObjectsApartThatShareAVertex) {
  const ObjModel model = read(kQuad + "v 2 1 0\nv 2 2 0\nv 1 2 0\no a\nf 1 2 3 4\no b\nf 3 5 6 7\n");
  EXPECT_EQ(model.meshes.size(), 2U);
  EXPECT_EQ(model.total.unused_vertices, 0U);
}

TEST(ObjReader, ReadsTags) {
  const ObjModel model =
      read(test::cube_text() +
           "t crease 2/1/0 0 1 2.5\nt crease 4/2/0 1 3 3 2 4 99\nt corner 2/1/0 0 7 inf\n"
           "t hole 1/0/0 2\nt interpolateboundary 1/0/0 2\nt facevaryinginterpolateboundary 1/0/0 1\n");
  const ControlMesh& mesh = model.meshes[0];
  ASSERT_EQ(mesh.creases.size(), 3U);
  std::map<std::pair<int, int>, float> creases;
  for (const ControlMesh::Crease& c : mesh.creases) creases[{c.v0, c.v1}] = c.sharpness;
  EXPECT_EQ((creases[{0, 1}]), 2.5F);
  EXPECT_EQ((creases[{1, 3}]), 4.F);
  EXPECT_EQ((creases[{2, 3}]), 10.F);
  ASSERT_EQ(mesh.corners.size(), 2U);
  EXPECT_EQ(mesh.corners[1].v, 7);
  EXPECT_EQ(mesh.corners[1].sharpness, 10.F);
  EXPECT_THAT(mesh.holes, ElementsAre(2));
  EXPECT_EQ(mesh.boundary, Boundary::EdgeOnly);
  EXPECT_EQ(read(kQuad + "f 1 2 3 4\nt interpolateboundary 1/0/0 0\n").meshes[0].boundary, Boundary::None);
  EXPECT_EQ(read(kQuad + "f 1 2 3 4\nt interpolateboundary 1/0/0 1\n").meshes[0].boundary,
            Boundary::EdgeAndCorner);
}

TEST(ObjReader, GivesTagsToTheRightObject) {
  const ObjModel model = read("v 9 9 9\no a\n" + kQuad +
                              "f 2 3 4 5\no b\nv 5 0 0\nv 6 0 0\nv 6 1 0\nf 6 7 8\nf 8 7 2\n"
                              "t crease 2/1/0 5 6 1\nt corner 1/1/0 6 3\nt hole 1/0/0 2\n");
  ASSERT_EQ(model.meshes.size(), 2U);
  EXPECT_TRUE(model.meshes[0].creases.empty());
  ASSERT_EQ(model.meshes[1].creases.size(), 1U);
  const ControlMesh& b = model.meshes[1];
  EXPECT_EQ(b.positions[static_cast<std::size_t>(b.creases[0].v0)], Vec3(5, 0, 0));
  EXPECT_EQ(b.positions[static_cast<std::size_t>(b.corners[0].v)], Vec3(6, 0, 0));
  EXPECT_THAT(b.holes, ElementsAre(1));
  EXPECT_EQ(model.total.unused_vertices, 1U);
}

TEST(ObjReader, ReportsWhatItRepaired) {
  const ObjModel model = read(test::cube_text() + "v 7 7 7\n");
  ASSERT_EQ(model.warnings.size(), 1U);
  EXPECT_EQ(model.warnings[0], "1 vertex belongs to no face and is ignored");
}

}  // namespace
}  // namespace gnomon::scene
