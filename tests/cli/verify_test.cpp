// SPDX-License-Identifier: Apache-2.0
// gnomon verify and gnomon wave, on real hardware models and on one with a fault built in.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/cli/run_gnomon.hpp"
#include "tests/host/scene/files.hpp"

namespace gnomon {
namespace {

namespace fs = std::filesystem;
using test::Outcome;
using test::run_gnomon;
using testing::HasSubstr;
using testing::MatchesRegex;

/// A fault that no stream of some length can miss: depths are rounded to nearest.
const std::vector<std::string> kFault{"--define", "GNOMON_MUTATE_ROUND_DEPTH"};

class VerifyTest : public testing::Test {
 protected:
  VerifyTest() : model_(directory_.write("cube.obj", test::cube_text())) {}
  fs::path file(const std::string& name) const { return directory_.path() / name; }
  Outcome gnomon(std::vector<std::string> arguments, const std::vector<std::string>& more = {}) const {
    arguments.insert(arguments.end(), {model_.string(), "--set", "res=32", "-q"});
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_gnomon(arguments);
  }
  test::TempDir directory_;
  fs::path model_;
};

TEST_F(VerifyTest, FindsSoundHardwareSound) {
  const Outcome outcome = gnomon({"verify"}, {"--junit", file("v.xml").string()});
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_THAT(outcome.out, MatchesRegex(".*cube.obj: [0-9]+ words compared, 0 differ .*\n"));
  EXPECT_EQ(outcome.err, "");
  std::ostringstream xml;
  xml << std::ifstream(file("v.xml")).rdbuf();
  EXPECT_THAT(xml.str(), HasSubstr("tests=\"1\" failures=\"0\""));
}

TEST_F(VerifyTest, ComparesTheSilhouetteLineBufferToo) {
  const std::vector<std::string> slb{"--set", "technique=slb", "--set", "plane=64", "--json"};
  const Outcome outcome = gnomon({"verify"}, slb);
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  const auto verdicts = nlohmann::json::parse(outcome.out);
  // Every stored entry is a word and four raw ones, beside an answer a voxel that faces the light.
  EXPECT_GT(verdicts.at(0).at("compare").at("words_compared"), 64 * 64 * 5 + 500);
  EXPECT_EQ(verdicts.at(0).at("compare").at("words_differing"), 0);
}

TEST_F(VerifyTest, ShowsTheFirstDifference) {
  const Outcome outcome = gnomon({"verify"}, kFault);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("reproduce: gnomon verify " + model_.string() +
                                     " --set res=32 --define GNOMON_MUTATE_ROUND_DEPTH"));
  std::vector<std::string> json = kFault;
  json.insert(json.end(), {"--json", "--junit", file("v.xml").string()});
  const auto verdicts = nlohmann::json::parse(gnomon({"verify"}, json).out);
  ASSERT_EQ(verdicts.size(), 1U);
  const auto& compare = verdicts[0].at("compare");
  EXPECT_FALSE(compare.at("passed").get<bool>());
  EXPECT_GT(compare.at("words_compared"), 100);
  std::ostringstream xml;
  xml << std::ifstream(file("v.xml")).rdbuf();
  EXPECT_THAT(xml.str(), HasSubstr("failures=\"1\""));
}

TEST_F(VerifyTest, TakesSeveralScenesAndLights) {
  const fs::path scene = directory_.write("two.toml",
                                          "[[models]]\npath = \"cube.obj\"\n[[lights]]\ndirection = [0, -1, "
                                          "0]\n[[lights]]\ndirection = [1, -1, 0.3]\n");
  const Outcome outcome = gnomon({"verify", scene.string()});
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_EQ(test::line_count(outcome.out), 3U) << outcome.out;
  EXPECT_THAT(outcome.out, HasSubstr("two.toml, light 2: "));
}

TEST_F(VerifyTest, AMissingCompilerIsAnError) {
  test::HowToRun how;
  how.environment = {"GNOMON_CXX=no-such-compiler"};
  const Outcome outcome = run_gnomon({"verify", model_.string(), "--set", "res=32", "-q"}, how);
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(test::line_count(outcome.err), 1U);
  EXPECT_THAT(outcome.err, HasSubstr("no-such-compiler"));
}

TEST_F(VerifyTest, WritesAWaveformOfAWindow) {
  const Outcome outcome = gnomon({"wave"}, {"--from", "50", "--to", "90", "-o", file("w.fst").string()});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, file("w.fst").string() + ": cycles 50 to 90\n");
  EXPECT_GT(fs::file_size(file("w.fst")), 1000U);
}

TEST_F(VerifyTest, WritesAWaveformOfTheFirstDifference) {
  const Outcome sound = gnomon({"wave"}, {"--first-difference", "-o", file("s.fst").string()});
  EXPECT_EQ(sound.status, 0) << sound.err;
  EXPECT_THAT(sound.out, HasSubstr("no difference, no waveform"));
  EXPECT_FALSE(fs::exists(file("s.fst")));

  std::vector<std::string> arguments = kFault;
  arguments.insert(arguments.end(), {"--first-difference", "-o", file("f.fst").string()});
  const Outcome faulty = gnomon({"wave"}, arguments);
  EXPECT_EQ(faulty.status, 1) << faulty.err;
  EXPECT_THAT(faulty.out, HasSubstr("f.fst: cycles "));
  EXPECT_TRUE(fs::exists(file("f.fst")));
}

}  // namespace
}  // namespace gnomon
