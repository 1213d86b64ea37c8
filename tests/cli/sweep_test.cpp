// SPDX-License-Identifier: Apache-2.0
// gnomon sweep: points measured once, whatever happens on the way.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "host/sweep/measurement.hpp"
#include "tests/cli/sweep_fixture.hpp"

namespace gnomon {
namespace {

namespace fs = std::filesystem;
using test::Outcome;
using test::run_gnomon;
using testing::HasSubstr;

using test::SweepTest;

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

/// Every figure that a sweep has of a point, its short way's and a run's.
TEST_F(SweepTest, IsTheSameAsARunOfThatPoint) {
  const std::vector<std::vector<std::string>> points{
      {"technique=slb", "frac_bits=3", "slope_bits=9", "frags=1"},
      {"technique=slb", "frac_bits=6", "slope_bits=3", "frags=4", "rounding=published", "query_bits=12"},
      {"technique=slb", "frac_bits=8", "slope_bits=8", "frags=2", "subpixel_bits=16", "depth_bits=12"},
      {"technique=voxel-offset"}};
  std::string spec = "scenes = [\"cube.obj\"]\n[fixed]\nres = 32\nplane = 32\n";
  for (const auto& point : points) {
    spec += "[[list]]\n";
    for (const std::string& setting : point) {
      const auto [key, value] =
          std::pair(setting.substr(0, setting.find('=')), setting.substr(setting.find('=') + 1));
      const bool number = value.find_first_not_of("0123456789") == std::string::npos;
      spec += key + " = " + (number ? value : '"' + value + '"') + "\n";
    }
  }
  spec_ = directory_.write("points.toml", spec);
  ASSERT_EQ(figures("a").at("measured"), points.size());
  std::size_t compared = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::vector<std::string> arguments{
        "run", (directory_.path() / "cube.obj").string(), "--engine", "golden", "-q", "--json",
        "-o",  (directory_.path() / "run").string()};
    for (const std::string& setting : points[i]) arguments.insert(arguments.end(), {"--set", setting});
    arguments.insert(arguments.end(), {"--set", "res=32", "--set", "plane=32"});
    const Outcome run = run_gnomon(arguments);
    ASSERT_EQ(run.status, 0) << run.err;
    const sweep::Measurement expected = sweep::measurement_of(nlohmann::ordered_json::parse(run.out));
    const std::map<std::string, double> stored = figures_of("a", points[i]);
    EXPECT_TRUE(stored.contains("errors.fixed.boundary_displacement"));
    for (const auto& [name, value] : stored) {
      if (name.starts_with("seconds.") || name.starts_with("host.") || name.starts_with("model.") ||
          name == "memory.format_bits")
        continue;
      ASSERT_TRUE(expected.figures.contains(name)) << name;
      EXPECT_EQ(value, expected.figures.at(name)) << name << " of point " << i;
      ++compared;
    }
  }
  EXPECT_GT(compared, 200U);
}

TEST_F(SweepTest, IsWholeAfterKill9AndGoesOn) {
  spec_ = directory_.write(
      "many.toml",
      "scenes = [\"cube.obj\"]\n[fixed]\nres = 32\nplane = 32\ntechnique = \"slb\"\n[axes]\n"
      "frac_bits = [3, 4, 5, 6, 7, 8]\nslope_bits = [3, 4, 5, 6, 7, 8, 9]\nfrags = [1, 2, 3, 4]\n");
  ASSERT_EQ(figures("whole").at("measured"), 168);
  const fs::path results = directory_.path() / "cut" / "results.sqlite";
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    const std::string output = (directory_.path() / "cut").string();
    execl(GNOMON_PROGRAM, GNOMON_PROGRAM, "sweep", spec_.c_str(), "-o", output.c_str(), "-q", "-j", "1",
          nullptr);
    _exit(126);
  }
  while (rows_of(results) < 5 && waitpid(child, nullptr, WNOHANG) == 0) usleep(500);
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  const int kept = rows_of(results);
  ASSERT_GE(kept, 5);
  ASSERT_LT(kept, 168) << "it had ended before it was killed";
  EXPECT_FALSE(fs::exists(directory_.path() / "cut" / "report.html"));
  EXPECT_EQ(figures("cut").at("measured"), 168 - kept);
  EXPECT_EQ(table("cut"), table("whole"));
  EXPECT_GT(test::line_count(table("cut")), 168U * 30);
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

TEST_F(SweepTest, ConfirmsOnTheHardware) {
  spec_ = directory_.write(
      "one.toml", "scenes = [\"cube.obj\"]\n[fixed]\nres = 32\ntechnique = \"slb\"\n[axes]\nplane = [64]\n");
  const nlohmann::json counts = figures("a", {"--confirm", "front", "--plots"});
  EXPECT_EQ(counts.at("confirmed"), 1);
  EXPECT_EQ(counts.at("flagged"), 0);
  const std::map<std::string, double> stored = figures_of("a", {"plane=64"});
  EXPECT_GT(stored.at("confirm.words"), 500);
  EXPECT_EQ(stored.at("confirm.differing"), 0);
  EXPECT_LE(stored.at("confirm.cycle_error"), 0.001);
  EXPECT_GT(stored.at("rtl.cycles.DRAW"), 100);
  EXPECT_EQ(figures("a", {"--confirm", "all"}).at("confirmed"), 0) << "it was confirmed already";
  std::ifstream page(directory_.path() / "a" / "report.html");
  const std::string text{std::istreambuf_iterator<char>(page), {}};
  EXPECT_THAT(text, HasSubstr("Confirmed on the hardware"));
  EXPECT_EQ(sweep("b", {"--confirm", "some"}).status, 2);
}

TEST_F(SweepTest, RefusesWhatItCannotUse) {
  figures("a");
  spec_ = directory_.write("spec.toml", std::string(test::kSweepSpec) + "slope_bits = [4]\n");
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
