// SPDX-License-Identifier: Apache-2.0
// metrics.json has the keys that scripts depend on, every one of them documented, and figures that add up.
#include "host/report/metrics_json.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <iterator>
#include <set>

#include "tests/host/report/sample_record.hpp"

namespace gnomon::report {
namespace {

using nlohmann::ordered_json;

TEST(Metrics, HasTheKeysOfTheContract) {
  const ordered_json m = metrics_json(sample_record());
  EXPECT_EQ(m["schema"], 1);
  EXPECT_EQ(m["grid"]["res"], 128);
  EXPECT_EQ(m["grid"]["origin"], ordered_json({-1.5, -1.0, -1.25}));
  EXPECT_EQ(m["grid"]["voxel_size"], 0.0234375);
  EXPECT_EQ(m["grid"]["adjacency"], 26);
  ASSERT_EQ(m["lights"].size(), 1u);
  EXPECT_EQ(m["lights"][0]["type"], "directional");
  EXPECT_EQ(m["lights"][0]["direction"], ordered_json({0.0, -1.0, 0.0}));
  EXPECT_EQ(m["compare"]["words"], 217001);
  EXPECT_EQ(m["compare"]["differing"], 0);
  EXPECT_EQ(m["parameters"]["res"]["value"], 128);
  EXPECT_EQ(m["parameters"]["res"]["origin"], "command line");
}

TEST(Metrics, LightsHaveTheirPlaceTheirErrorsAndTheirViews) {
  RunRecord record = lights_record();
  record.lights.emplace_back().light = PointLight{Vec3(1, 2, 3)};
  const ordered_json m = metrics_json(record);
  ASSERT_EQ(m["lights"].size(), 3u);
  const ordered_json& spot = m["lights"][1];
  EXPECT_EQ(spot["type"], "spot");
  EXPECT_EQ(spot["position"], ordered_json({0.0, 4.0, 1.0}));
  EXPECT_EQ(spot["angle"], 40.0);
  EXPECT_EQ(spot["not_reached"], 15000);
  EXPECT_EQ(spot["errors"]["fixed"], m["errors"]["fixed"]);
  ASSERT_EQ(spot["views"].size(), 1u);
  EXPECT_DOUBLE_EQ(spot["views"][0]["plane"]["share_hit"], 4000.0 / (128 * 128));
  EXPECT_DOUBLE_EQ(spot["views"][0]["plane"]["voxels_per_entry_hit"], 89000.0 / 4000);
  EXPECT_DOUBLE_EQ(m["plane"]["share_hit"], 31000.0 / (2 * 65536));
  EXPECT_DOUBLE_EQ(m["voxels"]["shadow_share"], 71000.0 / (3 * 217000));
  EXPECT_EQ(m["lights"][2]["type"], "point");
  EXPECT_EQ(m["lights"][2]["position"], ordered_json({1.0, 2.0, 3.0}));
}

TEST(Metrics, TheSystemEngineHasItsOwnFigures) {
  EXPECT_TRUE(metrics_json(sample_record())["system"].is_null());
  const ordered_json s = metrics_json(system_record())["system"];
  EXPECT_EQ(s["inside"], "core");
  EXPECT_EQ(s["firmware"]["instructions_per_job"], 550.0);
  EXPECT_EQ(s["firmware"]["log"], ordered_json({"firmware <0>", "second line"}));
  EXPECT_EQ(s["bus"][1]["writes"], 30);
  EXPECT_EQ(s["cache"]["CACHE_PLANE_MISSES"], 100);
  EXPECT_EQ(s["dram"]["bytes_per_cycle"], 8.0);
  EXPECT_NEAR(s["dram"]["row_hit_share"].get<double>(), 10000 / 10500.0, 1e-12);
}

TEST(Metrics, SeveralTechniquesStandSideBySide) {
  EXPECT_TRUE(metrics_json(sample_record())["techniques"].empty());
  const std::vector<RunRecord> records{sample_record(), topology_record()};
  const ordered_json m = metrics_json(records);
  ASSERT_EQ(m["techniques"].size(), 2u);
  EXPECT_EQ(m["technique"], "voxel-offset");
  EXPECT_EQ(m["techniques"][0]["errors"], m["errors"]);
  EXPECT_EQ(m["techniques"][1]["technique"], "voxel-topology");
  EXPECT_EQ(m["techniques"][1]["topology"], metrics_json(records[1])["topology"]);
}

TEST(Metrics, FiguresAddUp) {
  const ordered_json m = metrics_json(sample_record());
  std::uint64_t sum = 0;
  for (const auto& [name, pass] : m["cycles"]["by_pass"].items()) {
    std::uint64_t causes = 0;
    for (const auto& [cause, cycles] : pass["causes"].items()) causes += cycles.get<std::uint64_t>();
    EXPECT_EQ(pass["total"], causes) << name;
    sum += causes;
  }
  EXPECT_EQ(m["cycles"]["total"], sum);
  EXPECT_DOUBLE_EQ(m["run_time"]["seconds_at_clock"], static_cast<double>(sum) / 125e6);
  EXPECT_DOUBLE_EQ(m["run_time"]["simulation_mcycles_per_second"], static_cast<double>(sum) * 1e-6 / 0.11);
  EXPECT_DOUBLE_EQ(m["cycles"]["per_voxel"]["project"], (217004 + 130) / 217000.0);
  EXPECT_EQ(m["memory"]["plane_bits"], 256 * 256 * 32);
  EXPECT_DOUBLE_EQ(m["plane"]["share_hit"], 31000.0 / 65536);
  const ordered_json& all = m["errors"]["fixed"]["all"];
  EXPECT_EQ(all["mislabelled"].get<int>(), all["false_shadow"].get<int>() + all["false_lit"].get<int>());
  EXPECT_DOUBLE_EQ(all["share"], all["mislabelled"].get<double>() / 217000);
}

TEST(Metrics, TheSilhouetteLineBufferHasItsOwnFigures) {
  const ordered_json m = metrics_json(slb_record());
  EXPECT_TRUE(m["plane"].is_null());
  EXPECT_EQ(m["slb"]["pixels"], 65536);
  EXPECT_DOUBLE_EQ(m["cycles"]["slb"]["cycles_per_crossing"], 1.05);
  EXPECT_DOUBLE_EQ(m["cycles"]["slb"]["fill_pixels_per_cycle"], 12.0);
  EXPECT_DOUBLE_EQ(m["slb"]["queries_overflow_share"], 0.00025);
  EXPECT_EQ(m["run_time"]["cycles"], 258 + 2100 + 4000 + 1000005) << "reading the plane back decides nothing";
  EXPECT_EQ(m["memory"]["slb_plane_bits"], 65536 * 256);
  EXPECT_EQ(m["memory"]["hardware_bits"], 65536 * (256 + 11) + 256 * 8);
  EXPECT_EQ(m["hardware"]["FRAC_BITS"], 7);
  EXPECT_EQ(m["errors"]["shadow_maps"][1]["memory_bits"], 32768ull * 32768 * 20);
  EXPECT_TRUE(metrics_json(sample_record())["slb"].is_null());
}

TEST(Metrics, TopologyModeHasItsOwnFigures) {
  const ordered_json m = metrics_json(topology_record());
  EXPECT_TRUE(m["plane"].is_null());
  EXPECT_DOUBLE_EQ(m["topology"]["mean_list"], 9.0);
  EXPECT_DOUBLE_EQ(m["topology"]["quads_tested_per_uncertain"], 5.0);
  EXPECT_DOUBLE_EQ(m["cycles"]["topology"]["cycles_per_node"], 1.5);
  EXPECT_EQ(m["memory"]["hardware_bits"], 512 * 512 * 49 + 1000 + 2000);
}

TEST(Metrics, GoldenAloneHasNoCyclesAndNoVerdict) {
  const ordered_json m = metrics_json(golden_record());
  EXPECT_TRUE(m["cycles"].is_null());
  EXPECT_TRUE(m["run_time"]["seconds_at_clock"].is_null());
  EXPECT_EQ(m["compare"]["compared"], false);
  EXPECT_EQ(m["compare"]["words"], 0);
  EXPECT_EQ(m["compare"]["failed"], false);
}

TEST(Metrics, AComparisonWithoutWordsHasFailed) {
  CompareRecord compare{true, 0, 0, 0, "", false, nullptr};
  EXPECT_TRUE(compare.failed());
  EXPECT_THAT(verdict(compare), testing::HasSubstr("nothing is verified"));
  compare.words = 5;
  EXPECT_FALSE(compare.failed());
  EXPECT_EQ(verdict(compare), "5 words compared, 0 differ");
  compare.other_faults = 1;
  EXPECT_TRUE(compare.failed());
  compare = {true, 5, 1, 0, "", false, nullptr};
  EXPECT_TRUE(compare.failed());
}

TEST(Metrics, NothingIsDividedByZero) {
  RunRecord record;
  record.compare.compared = true;
  record.cycles = {{"PROJECT", {{"BUSY", 0}}}};
  const std::string text = metrics_json(record).dump();  // would write null for NaN and hide it
  EXPECT_TRUE(metrics_json(record)["errors"]["fixed"]["all"]["share"].is_null());
  EXPECT_TRUE(metrics_json(record)["plane"]["share_hit"].is_null());
  EXPECT_THAT(text, testing::Not(testing::HasSubstr("nan")));
}

TEST(Metrics, AMovingCameraIsToldByTheFrameAndItsShadowWorkByTheEvent) {
  RunRecord record = sample_record();
  EXPECT_EQ(metrics_json(record)["frames"]["count"], 36);
  EXPECT_EQ(metrics_json(record)["frames"]["seconds_per_frame"], 0.5);
  EXPECT_EQ(metrics_json(record)["frames"]["questions"]["SLB_QUERIES"], 6900);
  EXPECT_EQ(metrics_json(record)["frames"]["shadow_work"], 0);
  record.frames->shadow_work = {{"SLB_LOOPS", 3}, {"VOXELS_PROJECTED", 4}};
  EXPECT_EQ(metrics_json(record)["frames"]["shadow_work"], 7);
  record.frames.reset();
  EXPECT_TRUE(metrics_json(record)["frames"].is_null());
}

TEST(Metrics, PredictedCyclesStandBesideTheMeasuredOnes) {
  RunRecord record = sample_record();
  record.predicted_cycles.clear();
  EXPECT_TRUE(metrics_json(record)["cycles_predicted"].is_null());
  record.predicted_cycles = {
      {"cycles.IDLE.IDLE", 0}, {"cycles.PROJECT.BUSY", 10}, {"cycles.PROJECT.HAZARD", 5}};
  record.cycles = {{"IDLE", {{"IDLE", 9}}}, {"PROJECT", {{"BUSY", 10}, {"HAZARD", 2}}}};
  const auto json = metrics_json(record)["cycles_predicted"];
  EXPECT_EQ(json["total"], 15);
  EXPECT_EQ(json["by_pass"]["PROJECT"]["total"], 15);
  EXPECT_EQ(json["by_pass"]["PROJECT"]["causes"]["HAZARD"], 5);
  EXPECT_EQ(json["off"], 3);
  record.cycles.clear();
  EXPECT_TRUE(metrics_json(record)["cycles_predicted"]["off"].is_null());
}

/// Adds the names of all keys below `json`; free-form tables are named, not entered.
void collect(const ordered_json& json, std::set<std::string>& keys) {
  static const std::set<std::string> kFreeForm{
      "parameters",       "registers", "versions",           "events", "hardware", "by_pass",
      "first_difference", "questions", "shadow_work_events", "cache"};
  if (json.is_array() && !json.empty()) return collect(json.front(), keys);
  if (!json.is_object()) return;
  for (const auto& [key, value] : json.items()) {
    keys.insert(key);
    if (!kFreeForm.contains(key)) collect(value, keys);
  }
}

TEST(Metrics, EveryKeyIsDocumented) {
  std::ifstream file(GNOMON_REPORT_DOC);
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  ASSERT_FALSE(page.empty()) << GNOMON_REPORT_DOC;
  std::set<std::string> keys;
  collect(metrics_json(failing_record()), keys);
  collect(metrics_json(slb_record()), keys);
  collect(metrics_json(topology_record()), keys);
  collect(metrics_json(lights_record())["lights"][1], keys);
  collect(metrics_json(system_record())["system"], keys);
  ASSERT_GT(keys.size(), 100u);
  for (const std::string& key : keys) {
    const bool documented =
        page.find("`" + key) != std::string::npos || page.find("." + key) != std::string::npos;
    EXPECT_TRUE(documented) << key << " is missing from docs/report.md";
  }
}

}  // namespace
}  // namespace gnomon::report
