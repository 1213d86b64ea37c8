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
  RunRequest dark = request();
  dark.scene.lights.clear();
  EXPECT_THAT(run(dark).error().message, HasSubstr("has no lights"));

  RunRequest spot = request();
  spot.scene.lights.push_back(SpotLight{{0, 9, 0}, {0, -1, 0}, 20});
  spot.settings.techniques = {"voxel-offset", "slb"};
  EXPECT_THAT(run(spot).error().message,
              HasSubstr("light 2 is a spot light, technique=slb takes directional lights only"));

  RunRequest unknown = request();
  unknown.settings.techniques = {"magic"};
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
