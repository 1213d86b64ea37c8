// SPDX-License-Identifier: Apache-2.0
// Runs in topology mode: away from the border nothing is wrong.
#include <gmock/gmock.h>

#include "tests/host/pipeline/small_scene.hpp"

namespace gnomon::pipeline {
namespace {

RunRequest in_topology_mode(RunRequest request) {
  request.settings.techniques = {"voxel-topology"};
  request.settings.res = 48;
  return request;
}

TEST_F(RunTest, TopologyModeIsRightAwayFromTheBorder) {
  const auto outcome = run(in_topology_mode(request()));
  ASSERT_TRUE(outcome) << outcome.error().message;
  EXPECT_EQ(outcome->exit_status(), 0) << outcome->compare.text;
  const nlohmann::json m = metrics();
  EXPECT_EQ(m["compare"]["words"].get<std::uint64_t>(), m["voxels"]["count"].get<std::uint64_t>() + 1);
  EXPECT_EQ(m["errors"]["fixed"]["unambiguous"]["mislabelled"], 0);
  EXPECT_GT(m["errors"]["fixed"]["unambiguous"]["samples"].get<std::uint64_t>(), 1000u);
  EXPECT_EQ(m["errors"]["double"]["unambiguous"]["mislabelled"], 0);
  EXPECT_EQ(m["voxels"]["shadow"], m["events"]["TOPOLOGY_SHADOW"]);
  EXPECT_EQ(m["topology"]["fallbacks"], 0);
  EXPECT_GT(m["topology"]["mean_list"].get<double>(), 2);
  EXPECT_LT(m["topology"]["quads_tested_per_uncertain"].get<double>(), 10);
  EXPECT_TRUE(m["plane"].is_null());
  EXPECT_EQ(m["hardware"]["EN_VPU_TOPOLOGY"], true);
}

TEST_F(RunTest, APoolThatIsTooSmallFallsBackAndSaysSo) {
  RunRequest narrow = in_topology_mode(request());
  narrow.settings.topology.nodes_log2 = 8;
  const auto outcome = run(narrow);
  ASSERT_TRUE(outcome) << outcome.error().message;
  EXPECT_GT(metrics()["topology"]["nodes_dropped"].get<std::uint64_t>(), 1000u);
  EXPECT_GT(metrics()["topology"]["fallbacks"].get<std::uint64_t>(), 100u);
}

}  // namespace
}  // namespace gnomon::pipeline
