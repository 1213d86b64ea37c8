// SPDX-License-Identifier: Apache-2.0
// gnomon run with a moving camera and with meshes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/cli/run_gnomon.hpp"
#include "tests/host/scene/files.hpp"

namespace gnomon {
namespace {

namespace fs = std::filesystem;
using test::Outcome;
using test::run_gnomon;
using testing::HasSubstr;

class RunWithFramesTest : public testing::Test {
 protected:
  RunWithFramesTest()
      : model_(directory_.write("cube.obj", test::cube_text())), results_(directory_.path() / "results") {}
  Outcome run(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{"run",      model_.string(),  "--set", "res=32",
                                       "--set",    "image_width=80", "--set", "image_height=60",
                                       "--engine", "golden",         "-o",    results_.string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_gnomon(arguments);
  }
  test::TempDir directory_;
  fs::path model_, results_;
};

TEST_F(RunWithFramesTest, WritesFramesAndMeshesAndSaysHowToDoItAgain) {
  const Outcome outcome = run({"--frames", "2", "--mesh", "ply", "--mesh", "obj"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  for (const char* name : {"frames/frame_0000.png", "frames/frame_0001.png", "mesh.ply", "mesh.obj"})
    EXPECT_GT(fs::file_size(results_ / name), 100U) << name;
  const auto m = nlohmann::json::parse(std::ifstream(results_ / "metrics.json"));
  EXPECT_EQ(m.at("frames").at("count"), 2);
  EXPECT_EQ(m.at("frames").at("shadow_work"), 0);
  EXPECT_THAT(m.at("command").at("line").get<std::string>(),
              HasSubstr("--frames 2 --mesh ply --mesh obj -o "));
}

TEST_F(RunWithFramesTest, RefusesWhatItCannotDo) {
  for (const std::vector<std::string>& wrong : std::vector<std::vector<std::string>>{
           {"--frames", "0"}, {"--frames", "many"}, {"--mesh", "stl"}, {"--mesh"}}) {
    const Outcome outcome = run(wrong);
    EXPECT_EQ(outcome.status, 2) << wrong[0];
    EXPECT_EQ(test::line_count(outcome.err), 1U) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(wrong[0]));
  }
  EXPECT_FALSE(fs::exists(results_));
}

}  // namespace
}  // namespace gnomon
