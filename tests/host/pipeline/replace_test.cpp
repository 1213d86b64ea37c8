// SPDX-License-Identifier: Apache-2.0
// Runs that cannot be done leave nothing; runs that can replace what an older one left.
#include <gmock/gmock.h>

#include <fstream>

#include "tests/host/pipeline/small_scene.hpp"

namespace gnomon::pipeline {
namespace {

using testing::HasSubstr;

TEST_F(RunTest, AnInterruptionLeavesNothing) {
  for (const std::string_view at : {"surface", "voxelize", "golden engine", "exact reference", "picture"}) {
    std::atomic<bool> abort = false;
    RunRequest stopped = request();
    stopped.abort = &abort;
    stopped.progress = [&](std::string_view stage, double) {
      if (stage == at) abort = true;
    };
    const auto outcome = run(stopped);
    ASSERT_FALSE(outcome) << at;
    EXPECT_EQ(outcome.error().message, "interrupted");
    EXPECT_TRUE(std::filesystem::is_empty(root_)) << at;
  }
}

TEST_F(RunTest, WhatCannotBeRunIsRefused) {
  RunRequest two_lights = request();
  two_lights.scene.lights.push_back(two_lights.scene.lights.front());
  EXPECT_THAT(run(two_lights).error().message, HasSubstr("2 lights"));

  RunRequest unknown = request();
  unknown.settings.technique = "magic";
  EXPECT_THAT(run(unknown).error().message, HasSubstr("technique=magic"));

  RunRequest narrow = request();
  narrow.settings.vpu.plane_log2 = 4;
  narrow.settings.vpu.depth_bits = 99;
  EXPECT_FALSE(run(narrow));

  RunRequest file = request();
  std::ofstream(output()) << "a file";
  EXPECT_THAT(run(file).error().message, HasSubstr("not a directory"));
}

TEST_F(RunTest, AnOlderRunIsReplacedAndOtherFilesStay) {
  ASSERT_TRUE(run(request()));
  std::ofstream(output() / "notes.txt") << "mine";
  RunRequest finer = request();
  finer.settings.res = 32;
  ASSERT_TRUE(run(finer));
  EXPECT_EQ(metrics()["grid"]["res"], 32);
  EXPECT_EQ(content("notes.txt"), "mine");
}

TEST_F(RunTest, AFailedRunLeavesTheOlderOne) {
  ASSERT_TRUE(run(request()));
  RunRequest broken = request();
  broken.settings.res = 32;
  broken.make_rtl = [](const auto&, const auto&) -> std::unique_ptr<sim::RtlEngine> {
    throw sim::ModelBuildError("no compiler");
  };
  const auto outcome = run(broken);
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().message, "no compiler");
  EXPECT_EQ(metrics()["grid"]["res"], 24);
}

}  // namespace
}  // namespace gnomon::pipeline
