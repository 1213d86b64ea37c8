// SPDX-License-Identifier: Apache-2.0
// Runs with several lights of several kinds, with objects that cast or receive nothing, with several
// techniques.
#include <gmock/gmock.h>

#include "tests/host/pipeline/small_scene.hpp"

namespace gnomon::pipeline {
namespace {

std::uint64_t number(const nlohmann::json& value) {
  return value.get<std::uint64_t>();
}

TEST_F(RunTest, EveryLightHasItsOwnAnswers) {
  RunRequest two = request();
  two.scene.lights.push_back(DirectionalLight{Vec3(0, -1, 0)});
  const auto outcome = run(two);
  ASSERT_TRUE(outcome) << outcome.error().message;
  EXPECT_EQ(outcome->exit_status(), 0) << outcome->compare.text;
  const nlohmann::json m = metrics();
  const std::uint64_t voxels = number(m["voxels"]["count"]);
  EXPECT_EQ(m["compare"]["words"], 2 * (voxels + 1)) << "a state a voxel and a fence, for each light";
  ASSERT_EQ(m["lights"].size(), 2u);
  EXPECT_EQ(number(m["lights"][0]["shadow"]) + number(m["lights"][1]["shadow"]),
            number(m["voxels"]["shadow"]));
  EXPECT_NE(m["lights"][0]["shadow"], m["lights"][1]["shadow"]);
  EXPECT_EQ(m["errors"]["fixed"]["all"]["samples"], 2 * voxels);
  EXPECT_EQ(number(m["lights"][0]["errors"]["fixed"]["all"]["mislabelled"]) +
                number(m["lights"][1]["errors"]["fixed"]["all"]["mislabelled"]),
            number(m["errors"]["fixed"]["all"]["mislabelled"]));
  EXPECT_THAT(content("voxels.npy"), testing::HasSubstr(", 5), }"));
  EXPECT_EQ(m["hardware"]["EN_PERSPECTIVE"], false);

  // The first light's answers are those that it has alone.
  const auto first = m["lights"][0]["errors"];
  ASSERT_TRUE(run(request()));
  EXPECT_EQ(metrics()["errors"], first);
}

TEST_F(RunTest, SpotsAndPointLightsBesideADirectionalOne) {
  RunRequest three = request();
  three.settings.res = 48;
  three.scene.lights.push_back(SpotLight{{2, 7, 1}, Vec3(-0.25, -1, -0.1).normalized(), 8});
  three.scene.lights.push_back(PointLight{{-2.5, 3.5, 2}});
  for (const char* technique : {"voxel-offset", "voxel-topology"}) {
    three.settings.techniques = {technique};
    const auto outcome = run(three);
    ASSERT_TRUE(outcome) << outcome.error().message;
    EXPECT_EQ(outcome->exit_status(), 0) << outcome->compare.text;
    const nlohmann::json m = metrics();
    EXPECT_EQ(m["hardware"]["EN_PERSPECTIVE"], true);
    EXPECT_EQ(m["registers"].size(), 18u) << "the first view's, which is parallel";
    ASSERT_EQ(m["lights"].size(), 3u);
    EXPECT_GT(number(m["lights"][1]["not_reached"]), 500u);
    EXPECT_EQ(m["lights"][1]["views"][0]["name"], "spot");
    std::uint64_t asked = 0;
    for (const auto& view : m["lights"][2]["views"]) asked += number(view["receivers"]);
    EXPECT_EQ(asked, number(m["voxels"]["count"])) << "every voxel is on one side of a point light";
    const double limit = technique == std::string("voxel-offset") ? 0.02 : 0.002;
    for (const auto& light : m["lights"]) {
      EXPECT_LT(light["errors"]["fixed"]["unambiguous"]["share"].get<double>(), limit)
          << technique << light["type"];
      EXPECT_GT(number(light["shadow"]), 100u);
      const double displacement = light["errors"]["fixed"]["boundary_displacement"].get<double>();
      EXPECT_GT(displacement, 0.02) << "entries, whatever the light: " << light["type"];
      EXPECT_LT(displacement, 1.5);
    }
  }
}

TEST_F(RunTest, WhatCastsNothingAndWhatReceivesNothing) {
  ASSERT_TRUE(run(request()));
  const auto shadow_on_ground = [&] {
    return number(metrics()["events"]["RESOLVED_SHADOW"]) -
           number(metrics()["events"]["RESOLVED_FACING_AWAY"]);
  };
  EXPECT_GT(shadow_on_ground(), 30u);
  RunRequest ghost = request();
  ghost.scene.objects[0].casts = false;
  ASSERT_TRUE(run(ghost));
  EXPECT_EQ(shadow_on_ground(), 0u);
  EXPECT_LT(number(metrics()["events"]["VOXELS_PROJECTED"]), number(metrics()["voxels"]["count"]));
  EXPECT_EQ(metrics()["errors"]["fixed"]["unambiguous"]["mislabelled"], 0);

  RunRequest bright = request();
  bright.scene.objects[1].receives = false;
  ASSERT_TRUE(run(bright));
  EXPECT_LT(number(metrics()["events"]["VOXELS_RESOLVED"]), number(metrics()["voxels"]["count"]));
  EXPECT_EQ(metrics()["errors"]["fixed"]["all"]["samples"], metrics()["events"]["VOXELS_RESOLVED"])
      << "what receives nothing is not counted";

  bright.scene.objects[0].receives = false;
  EXPECT_THAT(run(bright).error().message, testing::HasSubstr("no light reaches anything"));
}

TEST_F(RunTest, SeveralTechniquesShareAScene) {
  RunRequest all = request();
  all.settings.techniques = {"voxel-topology", "slb+voxel", "voxel-offset"};
  all.settings.slb.plane_log2 = 5;
  const auto outcome = run(all);
  ASSERT_TRUE(outcome) << outcome.error().message;
  EXPECT_EQ(outcome->exit_status(), 0);
  const nlohmann::json m = metrics();
  ASSERT_EQ(m["techniques"].size(), 3u);
  EXPECT_EQ(m["technique"], "voxel-topology");
  EXPECT_EQ(m["techniques"][0]["errors"], m["errors"]);
  EXPECT_EQ(m["techniques"][1]["technique"], "slb+voxel");
  EXPECT_FALSE(m["techniques"][1]["slb"].is_null());
  for (const char* name : {"image-slb+voxel.png", "error-voxel-offset.png", "stream-slb+voxel.gnomon",
                           "voxels-voxel-offset.npy"})
    EXPECT_TRUE(std::filesystem::exists(output() / name)) << name;
  EXPECT_THAT(content("report.html"), testing::HasSubstr("Techniques side by side"));

  // One wrong word of one technique, the last.
  int made = 0;
  all.make_rtl = [&](const golden::HardwareConfig& config, const sim::RtlOptions& options) {
    return stand_in(++made == 3 ? sim::test::flip_bit(41, 54) : nullptr)(config, options);
  };
  const auto wrong = run(all);
  ASSERT_TRUE(wrong) << wrong.error().message;
  EXPECT_EQ(wrong->exit_status(), 1);
  EXPECT_EQ(metrics()["compare"]["failed"], false);
  EXPECT_EQ(metrics()["techniques"][2]["compare"]["failed"], true);
  EXPECT_THAT(content("report.html"), testing::HasSubstr("class=\"verdict bad\""));
}

}  // namespace
}  // namespace gnomon::pipeline
