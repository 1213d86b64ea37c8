// SPDX-License-Identifier: Apache-2.0
// A run leaves what it promises, agrees with itself, and cannot hide a difference.
#include "host/pipeline/run.hpp"

#include <gmock/gmock.h>

#include <atomic>
#include <cmath>
#include <gnomon/golden/golden_engine.hpp>
#include <gnomon/golden/stream_io.hpp>
#include <set>

#include "host/render/png_file.hpp"
#include "tests/host/pipeline/small_scene.hpp"

namespace gnomon::pipeline {
namespace {

using testing::HasSubstr;
using testing::Not;

std::set<std::string> names(const std::filesystem::path& directory) {
  std::set<std::string> all;
  for (const auto& entry : std::filesystem::directory_iterator(directory))
    all.insert(entry.path().filename().string());
  return all;
}

TEST_F(RunTest, LeavesEverythingAndAgrees) {
  const auto outcome = run(request());
  ASSERT_TRUE(outcome) << outcome.error().message;
  EXPECT_EQ(outcome->exit_status(), 0);
  EXPECT_GT(outcome->compare.words, 500u);
  EXPECT_EQ(outcome->compare.differing, 0u);
  EXPECT_THAT(names(root_), testing::ElementsAre("out"));
  EXPECT_THAT(names(output()), testing::ElementsAre("error.png", "image.png", "metrics.json", "reference.png",
                                                    "report.html", "stream.gnomon", "voxels.npy"));
  for (const char* picture : {"image.png", "reference.png", "error.png"}) {
    const auto image = render::read_png(output() / picture);
    ASSERT_TRUE(image) << picture;
    EXPECT_EQ(image->width, 64);
  }
  EXPECT_THAT(content("report.html"), HasSubstr(report::verdict(outcome->compare)));
  EXPECT_EQ(nlohmann::json(outcome->metrics), metrics());
}

TEST_F(RunTest, FiguresAreThoseOfTheScene) {
  ASSERT_TRUE(run(request()));
  const nlohmann::json m = metrics();
  const auto voxels = m["voxels"]["count"].get<std::uint64_t>();
  EXPECT_GT(voxels, 500u);
  EXPECT_EQ(m["grid"]["res"], 24);
  EXPECT_EQ(m["events"]["VOXELS_PROJECTED"], voxels);
  EXPECT_EQ(m["events"]["VOXELS_RESOLVED"], voxels);
  EXPECT_EQ(m["cycles"]["total"], 2 * voxels + 7);
  EXPECT_EQ(m["cycles"]["by_pass"]["RESOLVE"]["causes"]["HAZARD"], 7);
  EXPECT_EQ(m["registers"].size(), 18u);
  EXPECT_GT(m["voxels"]["shadow"].get<std::uint64_t>(), 50u) << "the cube casts a shadow";
  EXPECT_GT(m["plane"]["share_hit"].get<double>(), 0.05);
  EXPECT_NEAR(m["lights"][0]["direction"][1].get<double>(), -1 / std::hypot(0.45, 1, 0.4), 1e-9);
  EXPECT_EQ(m["objects"][0]["cage"]["faces"], 6);
  EXPECT_THAT(m["warnings"].dump(), HasSubstr("belongs to no face"));
  EXPECT_EQ(m["objects"][1]["ground"], true);
  EXPECT_EQ(m["stages"][0]["name"], "load");
  EXPECT_EQ(m["stages"][0]["wall_seconds"], 0.25);
  EXPECT_GT(m["run_time"]["host_peak_memory_bytes"].get<std::uint64_t>(), 1u << 20);
}

TEST_F(RunTest, ErrorsAreCountedOverAllVoxelsAndSmall) {
  ASSERT_TRUE(run(request()));
  const nlohmann::json errors = metrics()["errors"];
  for (const char* method : {"fixed", "double"}) {
    const nlohmann::json& e = errors[method];
    EXPECT_EQ(e["all"]["samples"], metrics()["voxels"]["count"]) << method;
    EXPECT_EQ(e["all"]["samples"].get<std::uint64_t>(),
              e["ground"]["all"]["samples"].get<std::uint64_t>() +
                  e["models"]["all"]["samples"].get<std::uint64_t>());
    EXPECT_LT(e["all"]["share"].get<double>(), 0.15) << method;
    EXPECT_LT(e["boundary_displacement"].get<double>(), 2.0) << method;
  }
  EXPECT_LT(errors["quantisation"]["share"].get<double>(), 0.05);
}

TEST_F(RunTest, TheStreamReplaysToTheSameAnswers) {
  ASSERT_TRUE(run(request()));
  const auto loaded = golden::load_stream(output() / "stream.gnomon");
  ASSERT_TRUE(std::holds_alternative<golden::StreamFile>(loaded));
  const auto& stream = std::get<golden::StreamFile>(loaded);
  const auto engine = golden::make_golden_engine(stream.config);
  std::size_t words = 0;
  engine->submit(stream.words);
  engine->drain([&](std::span<const golden::Word> results) { words += results.size(); });
  EXPECT_EQ(words, metrics()["compare"]["words"]);
  EXPECT_EQ(engine->counters().events.at("RESOLVED_SHADOW"), metrics()["voxels"]["shadow"]);
}

TEST_F(RunTest, GoldenAloneComparesNothing) {
  RunRequest golden = request();
  golden.engine = EngineKind::Golden;
  golden.make_rtl = [](const auto&, const auto&) -> std::unique_ptr<sim::RtlEngine> {
    throw std::logic_error("not asked for");
  };
  const auto outcome = run(golden);
  ASSERT_TRUE(outcome) << outcome.error().message;
  EXPECT_EQ(outcome->exit_status(), 0);
  EXPECT_TRUE(metrics()["cycles"].is_null());
  EXPECT_EQ(metrics()["compare"]["words"], 0);
  EXPECT_THAT(content("report.html"), HasSubstr("golden engine ran alone"));
}

/// Golden predicts the cycles of the memory that was asked for.
TEST_F(RunTest, AMemoryThatIsGivenIsPredicted) {
  RunRequest golden = request();
  golden.engine = EngineKind::Golden;
  const auto predicted = [&] {
    EXPECT_TRUE(run(golden));
    return metrics()["cycles_predicted"];
  };
  const auto on_chip = predicted();
  golden.settings.system.system.dram.latency = 1000;
  EXPECT_EQ(predicted(), on_chip) << "nobody has asked for it";
  golden.settings.memory_given = true;
  const auto far = predicted();
  EXPECT_GT(far["by_pass"]["RESOLVE"]["total"], on_chip["by_pass"]["RESOLVE"]["total"]);
  golden.settings.system.cache_log2 = 12;
  EXPECT_LT(predicted()["by_pass"]["CLEAR"]["total"], far["by_pass"]["CLEAR"]["total"]);
  golden.settings.techniques = {"voxel-topology"};
  EXPECT_GT(predicted()["by_pass"]["PROJECT"]["total"], 1'000) << "lists behind a cache";
}

TEST_F(RunTest, AWordThatDiffersIsShownAndFails) {
  RunRequest broken = request();
  broken.make_rtl = stand_in(sim::test::flip_bit(41, 54));
  const auto outcome = run(broken);
  ASSERT_TRUE(outcome) << outcome.error().message;
  EXPECT_EQ(outcome->exit_status(), 1);
  EXPECT_EQ(metrics()["compare"]["differing"], 1);
  EXPECT_EQ(metrics()["compare"]["first_difference"]["result_index"], 41);
  EXPECT_THAT(content("report.html"), HasSubstr("First difference: result word 41"));
  EXPECT_THAT(content("report.html"), HasSubstr("reproduce with: gnomon run cube.obj"));
  EXPECT_THAT(content("report.html"), Not(HasSubstr("verdict good")));
}

TEST_F(RunTest, ACorruptedGoldenWordFails) {
  RunRequest broken = request();
  broken.make_golden = [](const golden::HardwareConfig& config) {
    return std::make_unique<sim::test::AlteredEngine>(golden::make_golden_engine(config),
                                                      sim::test::flip_bit(100, 0));
  };
  const auto outcome = run(broken);
  ASSERT_TRUE(outcome) << outcome.error().message;
  EXPECT_EQ(outcome->exit_status(), 1);
  EXPECT_EQ(outcome->compare.differing, 1u);
}

TEST_F(RunTest, AMissingWordFails) {
  RunRequest broken = request();
  const auto count = run(broken)->compare.words;
  broken.make_rtl = stand_in(sim::test::drop(count - 1));
  const auto outcome = run(broken);
  ASSERT_TRUE(outcome) << outcome.error().message;
  EXPECT_EQ(outcome->exit_status(), 1);
  EXPECT_EQ(outcome->compare.differing, 0u);
  EXPECT_EQ(outcome->compare.other_faults, 1u);
}

TEST_F(RunTest, HardwareThatHangsOrSaysNothingFails) {
  RunRequest broken = request();
  broken.make_rtl = hanging_stand_in();
  const auto hung = run(broken);
  ASSERT_TRUE(hung) << hung.error().message;
  EXPECT_EQ(hung->exit_status(), 1);
  EXPECT_THAT(content("report.html"), HasSubstr("nothing moved for 1000 cycles"));

  broken.make_rtl = stand_in([](auto, auto) { return std::vector<golden::Word>{}; });
  const auto silent = run(broken);
  ASSERT_TRUE(silent) << silent.error().message;
  EXPECT_EQ(silent->exit_status(), 1);
  EXPECT_THAT(content("report.html"), HasSubstr("nothing is verified"));
}

TEST_F(RunTest, ACounterThatDiffersFails) {
  RunRequest broken = request();
  broken.make_golden = [](const golden::HardwareConfig& config) {
    auto engine = std::make_unique<sim::test::AlteredEngine>(
        golden::make_golden_engine(config), [](auto, golden::Word word) { return std::vector{word}; });
    engine->miscount("PLANE_WRITES");
    return engine;
  };
  const auto outcome = run(broken);
  ASSERT_TRUE(outcome) << outcome.error().message;
  EXPECT_EQ(outcome->exit_status(), 1);
  EXPECT_THAT(content("report.html"), HasSubstr("PLANE_WRITES"));
}

TEST_F(RunTest, AnInterruptionOfTheHardwareLeavesAPartialReport) {
  RunRequest cut = request();
  cut.make_rtl = nullptr;
  cut.settings.res = 130;  // as below
  cut.settings.vpu.plane_log2 = 9;
  cut.settings.techniques = {"voxel-offset", "voxel-topology"};
  std::atomic<bool> abort = false;
  cut.abort = &abort;
  cut.progress = [&](std::string_view stage, double) { abort = abort || stage == "rtl engine"; };
  const auto outcome = run(cut);
  ASSERT_TRUE(outcome) << outcome.error().message;
  EXPECT_TRUE(outcome->interrupted);
  EXPECT_THAT(outcome->compare.partial, HasSubstr("interrupted at cycle"));
  EXPECT_EQ(outcome->compare.differing, 0u);
  EXPECT_THAT(metrics()["compare"]["verdict"].get<std::string>(), HasSubstr("partial, interrupted at cycle"));
  EXPECT_EQ(metrics()["techniques"].size(), 0u) << "the second was not begun";
  EXPECT_THAT(content("report.html"), HasSubstr("partial, interrupted at cycle"));
}

TEST_F(RunTest, TheHardwareAgreesWithGolden) {
  RunRequest real = request();
  real.make_rtl = nullptr;
  // The build that every checkout has compiled already: 8 bits of voxel, 9 of plane.
  real.settings.res = 130;
  real.settings.vpu.plane_log2 = 9;
  const auto outcome = run(real);
  ASSERT_TRUE(outcome) << outcome.error().message;
  EXPECT_EQ(outcome->exit_status(), 0) << outcome->compare.text;
  EXPECT_GT(outcome->compare.words, 20000u);
  EXPECT_EQ(outcome->compare.differing, 0u);
  const nlohmann::json m = metrics();
  std::uint64_t sum = 0;
  for (const auto& [pass, row] : m["cycles"]["by_pass"].items()) sum += row["total"].get<std::uint64_t>();
  EXPECT_EQ(m["cycles"]["total"], sum);
  EXPECT_EQ(m["cycles_predicted"]["off"], 0);
  EXPECT_LE(m["cycles"]["per_voxel"]["project"].get<double>(), 1.05);
  EXPECT_LE(m["cycles"]["per_voxel"]["resolve"].get<double>(), 1.05);
}

}  // namespace
}  // namespace gnomon::pipeline
