// SPDX-License-Identifier: Apache-2.0
// gnomon sweep: points measured once, whatever happens on the way.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

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

constexpr const char* kSpec = R"(
scenes = ["cube.obj"]
[fixed]
res = 32
plane = 32
[axes]
technique = ["slb", "voxel-offset"]
frac_bits = [3, 5, 7]
)";

class SweepTest : public testing::Test {
 protected:
  SweepTest() {
    directory_.write("cube.obj", test::cube_text());
    spec_ = directory_.write("spec.toml", kSpec);
  }
  Outcome sweep(const std::string& output, const std::vector<std::string>& more = {},
                const test::HowToRun& how = {}) const {
    std::vector<std::string> arguments{"sweep", spec_.string(), "-o", (directory_.path() / output).string(),
                                       "-q"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_gnomon(arguments, how);
  }
  nlohmann::json figures(const std::string& output, std::vector<std::string> more = {}) const {
    more.emplace_back("--json");
    const Outcome outcome = sweep(output, more);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return nlohmann::json::parse(outcome.out, nullptr, false);
  }
  /// Everything but wall times, in an order of its own.
  std::string table(const std::string& output) const {
    sqlite3* database = nullptr;
    EXPECT_EQ(sqlite3_open((directory_.path() / output / "results.sqlite").c_str(), &database), SQLITE_OK);
    std::string text;
    const auto add = [](void* to, int count, char** values, char**) {
      for (int i = 0; i < count; ++i)
        *static_cast<std::string*>(to) += std::string(values[i] ? values[i] : "") + "|";
      *static_cast<std::string*>(to) += "\n";
      return 0;
    };
    const char* query =
        "SELECT key, configuration, status, error, name, value FROM point LEFT JOIN figure ON point.id = "
        "figure.point "
        "WHERE name IS NULL OR (name NOT LIKE 'seconds.%' AND name NOT LIKE 'host.%') ORDER BY key, name";
    EXPECT_EQ(sqlite3_exec(database, query, add, &text, nullptr), SQLITE_OK);
    sqlite3_close(database);
    return text;
  }
  test::TempDir directory_;
  fs::path spec_;
};

TEST_F(SweepTest, MeasuresEveryPointAndSharesTheScene) {
  const nlohmann::json first = figures("a");
  EXPECT_EQ(first.at("points"), 6);
  EXPECT_EQ(first.at("measured"), 6);
  EXPECT_EQ(first.at("failed"), 0);
  EXPECT_EQ(first.at("scenes"), 1);
  for (const char* name : {"report.html", "points.csv", "results.sqlite"})
    EXPECT_GT(fs::file_size(directory_.path() / "a" / name), 500U) << name;
  EXPECT_THAT(table("a"), HasSubstr("errors.fixed.all.share"));
  EXPECT_THAT(table("a"), HasSubstr("memory.hardware_bits"));

  const nlohmann::json again = figures("a");
  EXPECT_EQ(again.at("measured"), 0);
  EXPECT_EQ(again.at("missing"), 0);
}

TEST_F(SweepTest, IsTheSameAsARunOfThatPoint) {
  figures("a");
  const Outcome run =
      run_gnomon({"run", (directory_.path() / "cube.obj").string(), "--engine", "golden", "-q", "--json",
                  "-o", (directory_.path() / "run").string(), "--set", "technique=slb", "--set", "res=32",
                  "--set", "plane=32", "--set", "frac_bits=5"});
  ASSERT_EQ(run.status, 0) << run.err;
  const double displacement =
      nlohmann::json::parse(run.out).at("errors").at("fixed").at("boundary_displacement").get<double>();
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open((directory_.path() / "a" / "results.sqlite").c_str(), &database), SQLITE_OK);
  double stored = -1;
  const auto take = [](void* to, int, char** values, char**) {
    *static_cast<double*>(to) = std::stod(values[0]);
    return 0;
  };
  sqlite3_exec(database,
               "SELECT displacement FROM results WHERE technique = 'slb' AND "
               "json_extract(configuration, '$.frac_bits') = 5",
               take, &stored, nullptr);
  sqlite3_close(database);
  EXPECT_NEAR(stored, displacement, 1e-12);
}

TEST_F(SweepTest, ShardsMergeToTheSameTable) {
  figures("whole");
  for (const char* shard : {"1/3", "2/3", "3/3"}) {
    const Outcome outcome = sweep("parts", {"--shard", shard});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
  }
  EXPECT_FALSE(fs::exists(directory_.path() / "parts" / "results.sqlite"));
  ASSERT_EQ(sweep("parts", {"--merge"}).status, 0);
  EXPECT_EQ(table("parts"), table("whole"));
  ASSERT_EQ(sweep("parts", {"--merge"}).status, 0);
  EXPECT_EQ(table("parts"), table("whole"));
}

TEST_F(SweepTest, GoesOnWhereItWasInterrupted) {
  figures("whole");
  test::HowToRun interrupted;
  interrupted.interrupt_at = std::chrono::milliseconds(250);
  const Outcome cut = sweep("cut", {"-j", "1"}, interrupted);
  EXPECT_TRUE(cut.status == 130 || cut.status == 0) << cut.status << cut.err;
  figures("cut");
  EXPECT_EQ(table("cut"), table("whole"));
}

TEST_F(SweepTest, AFailedPointIsARowAndDoesNotStopTheRest) {
  spec_ =
      directory_.write("odd.toml",
                       "scenes = [\"cube.obj\"]\n[fixed]\nres = 32\ntechnique = \"slb\"\n[axes]\nplane = "
                       "[32, 4096]\nfrac_bits = [8]\nslope_bits=[9]\nsubpixel_bits = [16]\nframes = [1]\n");
  const Outcome unknown = sweep("x");
  EXPECT_EQ(unknown.status, 2);
  EXPECT_THAT(unknown.err, HasSubstr("unknown key 'frames'"));
  EXPECT_FALSE(fs::exists(directory_.path() / "x"));
  spec_ = directory_.write("odd.toml",
                           "scenes = [\"cube.obj\"]\n[fixed]\nres = 32\ntechnique = \"slb\"\nplane = "
                           "32\n[axes]\nsubpixel_bits = [0, 16]\ndepth_bits = [20, 24]\n");
  const nlohmann::json counts = figures("x");
  EXPECT_EQ(counts.at("points"), 4);
  EXPECT_EQ(counts.at("measured").get<int>() + counts.at("failed").get<int>(), 4);
  EXPECT_GT(counts.at("failed"), 0);
  EXPECT_GT(counts.at("measured"), 0);
  EXPECT_EQ(figures("x").at("failed"), 0);
  EXPECT_EQ(figures("x", {"--retry"}).at("failed"), counts.at("failed"));
}

TEST_F(SweepTest, RefusesWhatItCannotUse) {
  figures("a");
  spec_ = directory_.write("spec.toml", std::string(kSpec) + "slope_bits = [4]\n");
  const Outcome other = sweep("a");
  EXPECT_EQ(other.status, 2);
  EXPECT_THAT(other.err, HasSubstr("--extend"));
  EXPECT_EQ(figures("a", {"--extend"}).at("measured"), 6);
  for (const char* shard : {"0/3", "4/3", "1", "1/", "a/b"})
    EXPECT_EQ(sweep("b", {"--shard", shard}).status, 2) << shard;
  EXPECT_EQ(sweep("c", {"--merge"}).status, 2);
  spec_ = directory_.write("spec.toml", "scenes = [\"none.obj\"]\n[axes]\nres = [32]\n");
  const Outcome none = sweep("d");
  EXPECT_EQ(none.status, 2);
  EXPECT_EQ(test::line_count(none.err), 1U);
}

}  // namespace
}  // namespace gnomon
