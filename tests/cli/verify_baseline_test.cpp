// SPDX-License-Identifier: Apache-2.0
// gnomon verify --baseline: a baseline that was just measured holds; one that was altered, either way, or
// that was measured with other parameters, or on hardware with a fault, does not.
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
using Json = nlohmann::ordered_json;

class BaselineTest : public testing::Test {
 protected:
  BaselineTest()
      : model_(directory_.write("cube.obj", test::cube_text())), file_(directory_.path() / "baseline.json") {}

  Outcome update(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"verify",       model_.string(), "--baseline",
                                       file_.string(), "--update",      "-q"};
    for (const char* const setting : {"res=32", "image_width=16", "image_height=16"})
      arguments.insert(arguments.end(), {"--set", setting});
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_gnomon(arguments);
  }
  Outcome check(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"verify", "--baseline", file_.string(), "-q"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_gnomon(arguments);
  }
  std::string text() const {
    std::ostringstream text;
    text << std::ifstream(file_).rdbuf();
    return text.str();
  }
  Json& figures(Json& baseline) const { return baseline["scenes"]["cube.obj"]["figures"]; }
  void write(const Json& baseline) const { std::ofstream(file_) << baseline.dump(1); }

  test::TempDir directory_;
  fs::path model_, file_;
};

TEST_F(BaselineTest, HoldsOnceMeasured) {
  const Outcome written = update();
  ASSERT_EQ(written.status, 0) << written.out << written.err;
  EXPECT_THAT(written.out, MatchesRegex("cube.obj: [0-9]+ figures taken\n"));
  const Outcome outcome = check({"--junit", (directory_.path() / "v.xml").string()});
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_THAT(outcome.out, MatchesRegex("cube.obj: 1[0-9] figures compared, 0 differ\n"));
  EXPECT_EQ(outcome.err, "");
  EXPECT_TRUE(fs::exists(directory_.path() / "v.xml"));
  const std::string before = text();
  EXPECT_EQ(run_gnomon({"verify", "--baseline", file_.string(), "--update", "-q"}).status, 0);
  EXPECT_EQ(text(), before);
}

TEST_F(BaselineTest, NoticesFiguresThatChangedEitherWay) {
  ASSERT_EQ(update().status, 0);
  const Json baseline = Json::parse(text());
  const auto project = [&](std::int64_t by, double displacement) {
    Json altered = baseline;
    Json& cycles = figures(altered)["voxel-offset.cycles.PROJECT"];
    cycles = cycles.get<std::int64_t>() + by;
    Json& error = figures(altered)["voxel-offset.error.displacement"];
    error = error.get<double>() + displacement;
    write(altered);
    return check();
  };
  for (const std::int64_t by : {-1, 1}) {
    const Outcome outcome = project(by, 0);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.out, MatchesRegex("cube.obj: [0-9]+ figures compared, 1 differ\n"
                                          "cube.obj: voxel-offset.cycles.PROJECT: was [0-9]+, is [0-9]+\n"));
  }
  for (const double by : {-1e-3, 1e-3}) {
    const Outcome outcome = project(0, by);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.out, HasSubstr("\ncube.obj: voxel-offset.error.displacement: was "));
    EXPECT_EQ(test::line_count(outcome.out), 2U);
  }
  Json altered = baseline;
  figures(altered)["voxel-offset.results"] = "0123";
  figures(altered).erase("voxel-offset.words");
  write(altered);
  const Outcome outcome = check({"--json"});
  EXPECT_EQ(outcome.status, 1);
  const Json verdicts = Json::parse(outcome.out);
  ASSERT_EQ(verdicts.size(), 1U);
  EXPECT_EQ(verdicts[0].at("differences").size(), 2U);
  EXPECT_FALSE(verdicts[0].at("passed").get<bool>());
}

TEST_F(BaselineTest, OfAnotherConfigurationIsRefusedInOneLine) {
  ASSERT_EQ(update().status, 0);
  const auto refused = [&](const std::vector<std::string>& more, const std::string& why) {
    const Outcome outcome = check(more);
    EXPECT_EQ(outcome.status, 2) << why;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(test::line_count(outcome.err), 1U) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(why));
  };
  refused({"--set", "res=48"}, "cube.obj was measured with configuration");
  refused({directory_.write("other.obj", test::cube_text()).string()}, "does not hold other.obj");
  directory_.write("cube.obj", test::cube_text() + "# as before, with a remark\n");
  refused({}, "cube.obj was measured with configuration");
  write({{"baseline_format", 1}, {"settings", Json::array()}, {"scenes", Json::object()}});
  refused({}, "holds no scene");
  fs::remove(file_);
  refused({}, "baseline.json");
}

TEST_F(BaselineTest, FaultyHardwareNeitherPassesNorBecomesABaseline) {
  const std::vector<std::string> fault{"--define", "GNOMON_MUTATE_ROUND_DEPTH"};
  const Outcome outcome = update(fault);
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_FALSE(fs::exists(file_));
  ASSERT_EQ(update().status, 0);
  EXPECT_EQ(check(fault).status, 1);
}

TEST_F(BaselineTest, NeedsAFileToUpdate) {
  EXPECT_EQ(run_gnomon({"verify", model_.string(), "--update"}).status, 2);
  EXPECT_EQ(run_gnomon({"verify", "--update", "--baseline", file_.string()}).status, 2);
  EXPECT_EQ(run_gnomon({"verify"}).status, 2);
}

}  // namespace
}  // namespace gnomon
