// SPDX-License-Identifier: Apache-2.0
// Points measured over shared work and run on a stand-in for the hardware.
#include "host/sweep/runner.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>

#include "host/sweep/confirm.hpp"
#include "tests/host/pipeline/small_scene.hpp"
#include "tests/host/scene/files.hpp"

namespace gnomon::sweep {
namespace {

using testing::HasSubstr;

class RunnerTest : public testing::Test {
 protected:
  RunnerTest() : store_(std::move(*Store::open(folder_.path() / "results.sqlite", {"n", "s", "1", "t"}))) {
    options_.task.load = [this](const std::filesystem::path&,
                                const config::Settings&) -> Result<scene::Scene> {
      return pipeline::small_scene(folder_.path());
    };
    options_.task.settings = [](const config::Settings& settings) {
      pipeline::RunSettings run;
      run.res = 24;
      run.techniques = settings.words("technique");
      run.slb.plane_log2 = std::countr_zero(static_cast<unsigned>(settings.integer("plane")));
      run.slb.frac_bits = static_cast<int>(settings.integer("frac_bits"));
      run.slb.slope_bits = static_cast<int>(settings.integer("slope_bits"));
      return run;
    };
  }
  static Task task(int frac_bits, int slope_bits) {
    const auto settings = config::Settings::resolve(
        {{std::vector<config::Assignment>{{"technique", "slb", "t"},
                                          {"plane", "32", "t"},
                                          {"frac_bits", std::to_string(frac_bits), "t"},
                                          {"slope_bits", std::to_string(slope_bits), "t"}}}});
    return {{0, *settings}, std::to_string(frac_bits) + std::to_string(slope_bits), "cube.obj"};
  }
  Row row(const std::string& key) const {
    for (Row& row : store_.rows()) {
      if (row.key == key) return row;
    }
    throw std::runtime_error("no such row");
  }

  test::TempDir folder_;
  Store store_;
  RunnerOptions options_;
};

TEST_F(RunnerTest, FinerWidthsGiveSmallerErrorsInTheOrderOfNoThread) {
  std::vector<Task> tasks;
  for (const int bits : {3, 4, 5, 6, 7}) tasks.push_back(task(bits, bits));
  const RunnerCounts counts = run_tasks(tasks, store_, options_);
  EXPECT_EQ(counts.done, 5U);
  EXPECT_EQ(counts.scenes, 1U);
  EXPECT_GT(row("33").figures.at("errors.fixed.border_voxels"),
            3 * row("77").figures.at("errors.fixed.border_voxels"));
  EXPECT_GT(row("77").figures.at("model.cycles.DRAW"), 0);
  EXPECT_FALSE(row("77").figures.contains("events.SLB_QUERIES"));

  // One at a time, the other way round: another takes the first step of everything shared.
  Store other = std::move(*Store::open(folder_.path() / "other.sqlite", {"n", "s", "1", "t"}));
  std::ranges::reverse(tasks);
  options_.jobs = 1;
  run_tasks(tasks, other, options_);
  const auto merged = store_.merge(other);
  ASSERT_TRUE(merged) << merged.error().message;
  EXPECT_EQ(merged->known, 5U) << "every figure is the same";
}

/// No surface, voxel or exact shadow depends on the bus and what lies behind it.
TEST_F(RunnerTest, WhatTheSystemIsLikeIsNoReasonForAnotherScene) {
  std::size_t keys = 0;
  for (const config::Parameter& parameter : config::parameters()) {
    if (!parameter.help.starts_with("engine system:") && !parameter.help.starts_with("system, ")) continue;
    EXPECT_TRUE(of_technique(parameter)) << parameter.key;
    ++keys;
  }
  EXPECT_GE(keys, 13U);
  std::vector<Task> tasks{task(5, 5), task(5, 5), task(5, 5)};
  tasks[1].point.settings = *config::Settings::resolve(
      {{std::vector<config::Assignment>{{"memory_latency", "100", "t"}, {"cache_kib", "32", "t"}}}});
  tasks[2].point.settings =
      *config::Settings::resolve({{std::vector<config::Assignment>{{"res", "25", "t"}}}});
  const auto groups = groups_of(tasks);
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0].size(), 2U);
}

TEST_F(RunnerTest, WhatTheHardwareAnswersOtherwiseIsFlagged) {
  const std::vector<Task> tasks{task(5, 5)};
  run_tasks(tasks, store_, options_);
  options_.task.make_rtl = pipeline::stand_in(sim::test::flip_bit(41, 55));
  EXPECT_EQ(confirm_tasks(tasks, store_, options_).failed, 1U);
  EXPECT_THAT(row("55").labels.at(std::string(kConfirmLabel)), HasSubstr("1 differ"));
  EXPECT_EQ(row("55").figures.at("confirm.differing"), 1);
  EXPECT_GT(row("55").figures.at("errors.fixed.all.samples"), 100) << "what was measured stays";

  // All words agree, cycles do not: the stand-in has none of DRAW.
  options_.task.make_rtl = pipeline::stand_in();
  EXPECT_EQ(confirm_tasks(tasks, store_, options_).failed, 1U);
  EXPECT_THAT(row("55").labels.at(std::string(kConfirmLabel)), HasSubstr("predicted cycles are off"));
  EXPECT_EQ(row("55").figures.at("confirm.differing"), 0);
}

TEST_F(RunnerTest, AMeasurementOnTheHardwareStandsBesideThePrediction) {
  options_.task.engine = pipeline::EngineKind::Rtl;
  options_.task.make_rtl = pipeline::stand_in();  // which has no cycles of DRAW
  const RunnerCounts counts = run_tasks({task(5, 5)}, store_, options_);
  EXPECT_EQ(counts.done, 1U);
  EXPECT_EQ(counts.flagged, 1U);
  EXPECT_GT(row("55").figures.at("model.cycles.DRAW"), 0);
  EXPECT_GT(row("55").figures.at("confirm.cycle_error"), 0.001);
  EXPECT_GT(row("55").figures.at("confirm.words"), 100);
  EXPECT_THAT(row("55").labels.at(std::string(kConfirmLabel)), HasSubstr("predicted cycles are off"));
}

TEST_F(RunnerTest, ASceneThatCannotBeLoadedFailsItsPoints) {
  options_.task.load = [](const std::filesystem::path&, const config::Settings&) -> Result<scene::Scene> {
    return fail("cube.obj:1: error: no cube");
  };
  EXPECT_EQ(run_tasks({task(3, 3), task(4, 4)}, store_, options_).failed, 2U);
  EXPECT_EQ(row("44").error, "cube.obj:1: error: no cube");
}

}  // namespace
}  // namespace gnomon::sweep
