// SPDX-License-Identifier: Apache-2.0
// gnomon run: the whole way, from a cage to a report.
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

class RunTest : public testing::Test {
 protected:
  RunTest()
      : model_(directory_.write("cube.obj", test::cube_text())), results_(directory_.path() / "results") {}
  Outcome run(const std::vector<std::string>& more, const test::HowToRun& how = {}) const {
    std::vector<std::string> arguments{
        "run",   model_.string(),   "--set", "res=32", "--set",          "image_width=80",
        "--set", "image_height=60", "-q",    "-o",     results_.string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_gnomon(arguments, how);
  }
  nlohmann::json metrics() const { return nlohmann::json::parse(std::ifstream(results_ / "metrics.json")); }
  test::TempDir directory_;
  fs::path model_, results_;
};

TEST_F(RunTest, LeavesEverythingThatIsPromised) {
  const Outcome outcome = run({});
  ASSERT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, HasSubstr(" words compared, 0 differ\n" + (results_ / "report.html").string()));
  for (const char* name :
       {"report.html", "image.png", "reference.png", "error.png", "metrics.json", "voxels.npy"}) {
    EXPECT_GT(fs::file_size(results_ / name), 100U) << name;
  }
  const nlohmann::json m = metrics();
  EXPECT_EQ(m.at("grid").at("res"), 32);
  EXPECT_EQ(m.at("compare").at("differing"), 0);
  EXPECT_GT(m.at("compare").at("words"), 1000);
  EXPECT_EQ(m.at("lights").at(0).at("type"), "directional");
}

TEST_F(RunTest, PrintsItsFiguresAsJson) {
  const Outcome outcome = run({"--engine", "golden", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(nlohmann::json::parse(outcome.out), metrics());
}

TEST_F(RunTest, SetsSeveralTechniquesSideBySide) {
  const Outcome outcome = run({"--engine", "golden", "--set", "technique=voxel-topology,voxel-offset"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const nlohmann::json m = metrics();
  ASSERT_EQ(m.at("techniques").size(), 2U);
  EXPECT_EQ(m.at("technique"), "voxel-topology");
  EXPECT_EQ(m.at("techniques").at(1).at("technique"), "voxel-offset");
  EXPECT_THAT(m.at("command").at("line").get<std::string>(),
              HasSubstr("technique=voxel-topology,voxel-offset"));
  EXPECT_TRUE(fs::exists(results_ / "image-voxel-offset.png"));
  EXPECT_THAT(run({"--set", "technique=voxel-offset,magic"}).err, HasSubstr("technique=magic is unknown"));
}

TEST_F(RunTest, RefusesALightThatTheTechniqueDoesNotKnow) {
  const fs::path scene = directory_.write("lamp.toml",
                                          "[[models]]\npath = \"cube.obj\"\n[[lights]]\ntype = \"point\"\n"
                                          "position = [0, 5, 0]\n");
  const std::vector<std::string> wanted{"run",           scene.string(), "--set", "res=32",         "--set",
                                        "technique=slb", "-q",           "-o",    results_.string()};
  const Outcome outcome = run_gnomon(wanted);
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(test::line_count(outcome.err), 1U) << outcome.err;
  EXPECT_THAT(outcome.err,
              HasSubstr("light 1 is a point light, technique=slb takes directional lights only"));
  EXPECT_FALSE(fs::exists(results_));
}

TEST_F(RunTest, RefusesUnknownEnginesAndUnwritableOutput) {
  EXPECT_EQ(run({"--engine", "silicon"}).status, 2);
  EXPECT_FALSE(fs::exists(results_));
  directory_.write("results", "a file");
  const Outcome outcome = run({"--engine", "golden"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(test::line_count(outcome.err), 1U) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr(results_.string()));
}

TEST_F(RunTest, CtrlCLeavesNothing) {
  test::HowToRun how;
  how.interrupt_at = std::chrono::milliseconds(400);
  const Outcome outcome = run({"--engine", "golden", "--set", "res=1024", "--set", "threads=1"}, how);
  EXPECT_EQ(outcome.status, 130) << outcome.err;
  EXPECT_EQ(outcome.err, "gnomon: interrupted, nothing was written\n");
  EXPECT_EQ(std::distance(fs::directory_iterator(directory_.path()), fs::directory_iterator()), 1);
}

}  // namespace
}  // namespace gnomon
