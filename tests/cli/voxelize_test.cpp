// SPDX-License-Identifier: Apache-2.0
// gnomon voxelize: what its files hold, and that they appear whole or not at all.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <openvdb/openvdb.h>
#include <sys/stat.h>

#include <array>
#include <cstring>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "host/scene/scene.hpp"
#include "host/voxel/voxelizer.hpp"
#include "tests/cli/run_gnomon.hpp"
#include "tests/host/scene/files.hpp"

namespace gnomon {
namespace {

namespace fs = std::filesystem;
using Row = std::array<std::int32_t, 3>;
using test::Outcome;
using test::run_gnomon;
using testing::HasSubstr;

std::string bytes_of(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

/// Reads what numpy.save writes for an int32 array of three columns.
std::vector<Row> read_npy(const fs::path& path) {
  const std::string bytes = bytes_of(path);
  EXPECT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
  const std::size_t length =
      static_cast<unsigned char>(bytes.at(8)) + 256U * static_cast<unsigned char>(bytes.at(9));
  const std::string header = bytes.substr(10, length);
  EXPECT_EQ((10 + length) % 64, 0U);
  EXPECT_EQ(header.back(), '\n');
  EXPECT_THAT(header, HasSubstr("'descr': '<i4'"));
  EXPECT_THAT(header, HasSubstr("'fortran_order': False"));
  const std::size_t at = header.find("'shape': (") + 10;
  const std::size_t count = std::stoul(header.substr(at));
  EXPECT_THAT(header, HasSubstr("(" + std::to_string(count) + ", 3)"));
  EXPECT_EQ(bytes.size(), 10 + length + count * sizeof(Row));
  std::vector<Row> rows(count);
  std::memcpy(rows.data(), bytes.data() + 10 + length, count * sizeof(Row));
  return rows;
}

class VoxelizeTest : public testing::Test {
 protected:
  VoxelizeTest() : model_(directory_.write("cube.obj", test::cube_text())) {}
  fs::path file(const std::string& name) const { return directory_.path() / name; }
  std::size_t files() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(directory_.path()), fs::directory_iterator()));
  }
  test::TempDir directory_;
  fs::path model_;
};

TEST_F(VoxelizeTest, WritesNpyAndItsGrid) {
  const Outcome outcome = run_gnomon({"voxelize", model_.string(), "--res", "40", "--adjacency", "18", "-o",
                                      file("c.npy").string(), "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const std::vector<Row> rows = read_npy(file("c.npy"));
  EXPECT_TRUE(std::is_sorted(rows.begin(), rows.end()));
  EXPECT_EQ(std::adjacent_find(rows.begin(), rows.end()), rows.end());

  // The same as the library says, without a ground.
  scene::SceneOptions options;
  options.ground = false;
  const scene::Scene scene = scene::load_scene(model_, options).value();
  const voxel::Grid grid = scene::fit_grid(scene, 40, voxel::Adjacency::N18).value();
  std::vector<surface::LimitSurface> surfaces;
  surfaces.push_back(
      surface::LimitSurface::build(scene.objects[0].mesh, scene::to_grid(scene.objects[0], grid)).value());
  std::vector<Row> expected;
  const voxel::VoxelSet voxels = voxel::voxelize(surfaces, grid).value();
  for (const voxel::Voxel& v : voxels.voxels) expected.push_back({v.x, v.y, v.z});
  std::sort(expected.begin(), expected.end());
  EXPECT_GT(rows.size(), 1000U);
  EXPECT_EQ(rows, expected);

  const auto json = nlohmann::json::parse(bytes_of(file("c.json")));
  EXPECT_EQ(json.size(), 4U);
  EXPECT_EQ(json.at("res"), 40);
  EXPECT_EQ(json.at("adjacency"), 18);
  EXPECT_EQ(json.at("voxel_size"), grid.voxel_size);
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_EQ(json.at("origin").at(static_cast<std::size_t>(axis)), grid.origin[axis]);
  const auto figures = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(figures.at("voxels"), rows.size());
  EXPECT_EQ(figures.at("grid"), json);
}

TEST_F(VoxelizeTest, WritesVdbThatSaysTheSame) {
  ASSERT_EQ(run_gnomon({"voxelize", model_.string(), "--res", "40", "-o", file("c.npy").string(), "-o",
                        file("d.vdb").string()})
                .status,
            0);
  const auto json = nlohmann::json::parse(bytes_of(file("d.json")));
  openvdb::initialize();
  openvdb::io::File vdb(file("d.vdb").string());
  vdb.open();
  const auto grid = openvdb::gridPtrCast<openvdb::FloatGrid>(vdb.readGrid("density"));
  ASSERT_NE(grid, nullptr);
  EXPECT_EQ(grid->getGridClass(), openvdb::GRID_FOG_VOLUME);
  EXPECT_EQ(grid->background(), 0.0F);
  std::vector<Row> rows;
  for (auto value = grid->cbeginValueOn(); value; ++value) {
    EXPECT_EQ(*value, 1.0F);
    rows.push_back({value.getCoord().x(), value.getCoord().y(), value.getCoord().z()});
  }
  std::sort(rows.begin(), rows.end());
  EXPECT_EQ(rows, read_npy(file("c.npy")));
  // Voxel centre = origin + (i + 1/2) * voxel_size.
  const openvdb::Vec3d world = grid->indexToWorld(openvdb::Coord(3, 5, 7));
  const double size = json.at("voxel_size");
  for (int axis = 0; axis < 3; ++axis) {
    const double expected =
        json.at("origin").at(static_cast<std::size_t>(axis)).get<double>() + (3 + 2 * axis + 0.5) * size;
    EXPECT_NEAR(world[axis], expected, 1e-12);
  }
}

TEST_F(VoxelizeTest, PutsAGroundWhereAsked) {
  ASSERT_EQ(run_gnomon({"voxelize", model_.string(), "--res", "40", "-o", file("a.npy").string()}).status, 0);
  ASSERT_EQ(run_gnomon({"voxelize", model_.string(), "--res", "40", "--set", "ground=on", "-o",
                        file("b.npy").string()})
                .status,
            0);
  const std::vector<Row> bare = read_npy(file("a.npy")), grounded = read_npy(file("b.npy"));
  const auto lowest = [](const std::vector<Row>& rows) {
    std::map<int, std::size_t> layers;
    for (const Row& row : rows) ++layers[row[1]];
    return layers.begin()->second;
  };
  EXPECT_GT(lowest(grounded), 1000U);
  EXPECT_LT(lowest(bare), 1000U);
}

TEST_F(VoxelizeTest, TheResultDoesNotDependOnThreads) {
  for (const std::string threads : {"1", "2", "5"}) {
    ASSERT_EQ(run_gnomon({"voxelize", model_.string(), "--res", "64", "--set", "threads=" + threads, "-o",
                          file(threads + ".npy").string()})
                  .status,
              0);
  }
  EXPECT_EQ(bytes_of(file("1.npy")), bytes_of(file("2.npy")));
  EXPECT_EQ(bytes_of(file("1.npy")), bytes_of(file("5.npy")));
}

TEST_F(VoxelizeTest, ReplacesAnEarlierResult) {
  directory_.write("c.npy", "old");
  ASSERT_EQ(run_gnomon({"voxelize", model_.string(), "--res", "16", "-o", file("c.npy").string()}).status, 0);
  EXPECT_GT(read_npy(file("c.npy")).size(), 100U);
  EXPECT_EQ(files(), 3U);
}

TEST_F(VoxelizeTest, LeavesNothingWhereItCannotWrite) {
  const auto refuse = [&](const std::vector<std::string>& outputs, const std::string& words,
                          const test::HowToRun& how = {}) {
    std::vector<std::string> arguments{"voxelize", model_.string(), "--res", "16"};
    for (const std::string& output : outputs) arguments.insert(arguments.end(), {"-o", output});
    const Outcome outcome = run_gnomon(arguments, how);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(test::line_count(outcome.err), 1U) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(words));
    EXPECT_FALSE(fs::exists(file("a.npy")));
  };
  refuse({file("a.npy").string(), file("none/b.npy").string()}, "none is not a directory");
  refuse({file("a.npy").string(), file("a.png").string()}, "expected a name that ends in");
  fs::create_directory(file("dir.npy"));
  refuse({file("a.npy").string(), file("dir.npy").string()}, "is a directory");
  test::HowToRun nobody;
  nobody.as_nobody = true;
  refuse({file("a.npy").string()}, "Permission denied", nobody);
  // The .json beside the second file cannot replace a directory: the first file must not appear either.
  fs::create_directory(file("b.json"));
  refuse({file("a.npy").string(), file("b.npy").string()}, "b.json: error: is a directory");
  EXPECT_EQ(files(), 3U);
}

TEST_F(VoxelizeTest, RefusesVoxelsTooSmallForVdbAndWritesNothing) {
  std::string tiny;
  std::istringstream lines(test::cube_text());
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word;
    double x = 0, y = 0, z = 0;
    if (words >> word >> x >> y >> z && word == "v") {
      std::ostringstream scaled;
      scaled << "v " << 1e-30 * x << " " << 1e-30 * y << " " << 1e-30 * z;
      line = scaled.str();
    }
    tiny += line + "\n";
  }
  const fs::path model = directory_.write("tiny.obj", tiny);
  const Outcome outcome = run_gnomon({"voxelize", model.string(), "--res", "16", "-o", file("a.npy").string(),
                                      "-o", file("a.vdb").string()});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, HasSubstr("OpenVDB cannot hold voxels of size"));
  EXPECT_EQ(files(), 2U);
  EXPECT_EQ(run_gnomon({"voxelize", model.string(), "--res", "16", "-o", file("a.npy").string()}).status, 0);
}

TEST_F(VoxelizeTest, CtrlCLeavesNothing) {
  test::HowToRun how;
  how.interrupt_at = std::chrono::milliseconds(300);
  const Outcome outcome = run_gnomon(
      {"voxelize", model_.string(), "--res", "2048", "--set", "threads=1", "-o", file("a.vdb").string()},
      how);
  EXPECT_EQ(outcome.status, 130) << outcome.err;
  EXPECT_EQ(outcome.err, "gnomon: interrupted, nothing was written\n");
  EXPECT_EQ(files(), 1U);
}

}  // namespace
}  // namespace gnomon
