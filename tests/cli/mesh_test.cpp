// SPDX-License-Identifier: Apache-2.0
// gnomon mesh: closed models give closed meshes, whole files or none.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "host/scene/obj_reader.hpp"
#include "tests/cli/run_gnomon.hpp"
#include "tests/host/scene/files.hpp"

namespace gnomon {
namespace {

namespace fs = std::filesystem;
using test::Outcome;
using test::run_gnomon;
using testing::HasSubstr;

std::string bytes_of(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

class MeshTest : public testing::Test {
 protected:
  MeshTest() : model_(directory_.write("cube.obj", test::cube_text())) {}
  std::string file(const std::string& name) const { return (directory_.path() / name).string(); }
  std::size_t files() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(directory_.path()), fs::directory_iterator()));
  }
  test::TempDir directory_;
  fs::path model_;
};

TEST_F(MeshTest, AClosedModelGivesAClosedMeshInBothFormats) {
  const Outcome outcome = run_gnomon(
      {"mesh", model_.string(), "--res", "40", "-o", file("c.obj"), "-o", file("c.ply"), "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const auto figures = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(figures.at("closed"), true);
  EXPECT_EQ(figures.at("open_edges"), 0);
  EXPECT_EQ(figures.at("crowded_edges"), 0);
  EXPECT_EQ(figures.at("turned_edges"), 0);
  EXPECT_EQ(figures.at("objects"), 1) << "no ground";
  const std::size_t vertices = figures.at("vertices");
  const std::size_t faces =
      figures.at("quads").get<std::size_t>() + figures.at("triangles").get<std::size_t>();
  EXPECT_GT(faces, 2000U);
  // A sphere's: vertices - edges + faces.
  EXPECT_EQ(vertices + faces - figures.at("edges").get<std::size_t>(), 2U);

  const auto read = scene::read_obj(file("c.obj"));
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->meshes.size(), 1U);
  EXPECT_EQ(read->meshes[0].face_sizes.size(), faces);
  EXPECT_EQ(read->meshes[0].positions.size(), vertices);
  EXPECT_EQ(read->total.boundary_edges, 0U);
  EXPECT_EQ(read->total.non_manifold_edges, 0U);
  // A cube of side 2: its limit surface lies within, in the model's own coordinates.
  for (const Vec3& p : read->meshes[0].positions) ASSERT_LT(p.length(), 1.01);
  EXPECT_THAT(bytes_of(file("c.ply")), HasSubstr("element vertex " + std::to_string(vertices) + "\n"));
}

TEST_F(MeshTest, AnOpenModelIsSaidToBeOpen) {
  directory_.write("sheet.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
  const Outcome outcome = run_gnomon({"mesh", file("sheet.obj"), "--res", "32", "-o", file("s.ply")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr(" open, 0 with more than two faces, 0 turned"));
}

TEST_F(MeshTest, TheResultDoesNotDependOnThreads) {
  for (const std::string threads : {"1", "2"}) {
    ASSERT_EQ(run_gnomon({"mesh", model_.string(), "--res", "40", "--set", "threads=" + threads, "-o",
                          file(threads + ".ply")})
                  .status,
              0);
  }
  EXPECT_EQ(bytes_of(file("1.ply")), bytes_of(file("2.ply")));
}

TEST_F(MeshTest, LeavesNothingWhereItCannotWrite) {
  const auto refuse = [&](const std::vector<std::string>& outputs, const std::string& words) {
    std::vector<std::string> arguments{"mesh", model_.string(), "--res", "16"};
    for (const std::string& output : outputs) arguments.insert(arguments.end(), {"-o", output});
    const Outcome outcome = run_gnomon(arguments);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(test::line_count(outcome.err), 1U) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(words));
    EXPECT_FALSE(fs::exists(file("a.obj")));
  };
  refuse({file("a.obj"), file("none/b.ply")}, "none is not a directory");
  refuse({file("a.obj"), file("a.stl")}, "a.stl: error: expected a name that ends in .obj or .ply");
  fs::create_directory(file("dir.ply"));
  refuse({file("a.obj"), file("dir.ply")}, "is a directory");
  EXPECT_EQ(files(), 2U);
}

}  // namespace
}  // namespace gnomon
