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
  Outcome run(const std::vector<std::string>& more, const std::string& engine = "golden") const {
    std::vector<std::string> arguments{"run",      model_.string(),  "--set", "res=32",
                                       "--set",    "image_width=80", "--set", "image_height=60",
                                       "--engine", engine,           "-o",    results_.string()};
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

/// A frame of a kept scene asks for states. What the passes count must be the same however many frames
/// follow, on hardware in cycles, too.
TEST_F(RunWithFramesTest, WithAFrameBufferFramesCostLookupsAndNoShadowWork) {
  const auto figures = [&](const char* engine, const char* technique, const char* frames) {
    const Outcome outcome =
        run({"--set", std::string("technique=") + technique, "--set", "frame_buffer=on", "--set", "res=24",
             "--set", "image_width=48", "--set", "image_height=36", "--frames", frames},
            engine);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return nlohmann::json::parse(std::ifstream(results_ / "metrics.json"));
  };
  int compared = 0;
  for (const std::string engine : {"golden", "rtl"}) {
    for (const char* technique : {"voxel-offset", "voxel-topology"}) {
      SCOPED_TRACE(engine + ", " + technique);
      const auto one = figures(engine.c_str(), technique, "1"),
                 many = figures(engine.c_str(), technique, "5");
      EXPECT_EQ(many.at("events"), one.at("events"));
      EXPECT_EQ(many.at("frames").at("shadow_work"), 0) << many.at("frames").at("shadow_work_events");
      const auto asked = [](const nlohmann::json& m) {
        return m.at("frames").at("questions").at("FRAME_BRICKS").get<std::uint64_t>();
      };
      EXPECT_GT(asked(one), 10U);
      EXPECT_GT(asked(many), 4 * asked(one));
      ++compared;
      if (engine == "golden") continue;
      EXPECT_EQ(many.at("compare").at("differing"), 0);
      EXPECT_EQ(many.at("compare").at("words").get<std::uint64_t>() -
                    one.at("compare").at("words").get<std::uint64_t>(),
                many.at("frames").at("result_words").get<std::uint64_t>() -
                    one.at("frames").at("result_words").get<std::uint64_t>());
      for (const char* pass : {"CLEAR", "PROJECT", "RESOLVE"})
        EXPECT_EQ(many.at("cycles").at("by_pass").at(pass), one.at("cycles").at("by_pass").at(pass)) << pass;
    }
  }
  EXPECT_EQ(compared, 4);
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
