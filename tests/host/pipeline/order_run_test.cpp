// SPDX-License-Identifier: Apache-2.0
// The order in which items are sent changes no answer, and brings more of them to a cache that is small.
#include <gmock/gmock.h>

#include "host/pipeline/run.hpp"
#include "tests/host/pipeline/small_scene.hpp"

namespace gnomon::pipeline {
namespace {

class OrderRunTest : public RunTest {
 protected:
  RunRequest request_for(const std::string& technique) const {
    RunRequest golden = request();
    golden.engine = EngineKind::Golden;
    golden.settings.techniques = {technique};
    golden.scene.lights.push_back(DirectionalLight{Vec3(-0.5, -1, 0.3)});
    return golden;
  }

  /// voxels.npy and figures of a golden run.
  std::pair<std::string, nlohmann::json> run_in(plan::ItemOrder order, RunRequest golden) const {
    golden.settings.order = order;
    const auto outcome = run(golden);
    if (!outcome) throw std::runtime_error(outcome.error().message);
    return {content("voxels.npy"), metrics()};
  }

  /// Compares runs in both orders.
  void expect_same(const RunRequest& golden, const std::string& which) const {
    const auto [states, as_given] = run_in(plan::ItemOrder::Surface, golden);
    const std::string given_stream = content("stream.gnomon");
    const auto [moved, by_tile] = run_in(plan::ItemOrder::Tile, golden);
    EXPECT_NE(content("stream.gnomon"), given_stream) << which;
    EXPECT_EQ(moved, states) << which;
    EXPECT_EQ(by_tile["errors"], as_given["errors"]) << which;
    EXPECT_EQ(by_tile["picture"], as_given["picture"]) << which;
    for (const auto& [name, count] : as_given["events"].items()) {
      if (name == "COMMANDS" || name == "PLANE_WRITES") continue;
      EXPECT_EQ(by_tile["events"][name], count) << which << name;
    }
  }
};

TEST_F(OrderRunTest, AnswersAreTheSameUnderSeveralLights) {
  for (const char* technique : {"voxel-offset", "voxel-topology", "slb", "slb+voxel"})
    expect_same(request_for(technique), technique);
}

TEST_F(OrderRunTest, AnswersAreTheSameFromPlacesAndInTheFrameBuffer) {
  for (const char* technique : {"voxel-offset", "voxel-topology"}) {
    RunRequest golden = request_for(technique);
    golden.settings.frame_buffer = true;
    golden.scene.lights.push_back(SpotLight{{2, 7, 1}, Vec3(-0.25, -1, -0.1).normalized(), 8});
    golden.scene.lights.push_back(PointLight{{-2.5, 3.5, 2}});
    expect_same(golden, technique);
  }
}

TEST_F(OrderRunTest, FramesAreAnsweredTheSame) {
  RunRequest golden = request_for("slb");
  golden.scene.lights.resize(1);
  golden.frames = 2;
  run_in(plan::ItemOrder::Surface, golden);
  const std::string as_given = content("frames/frame_0001.png");
  run_in(plan::ItemOrder::Tile, golden);
  EXPECT_EQ(content("frames/frame_0001.png"), as_given);
}

/// Cycles of the passes that make a picture, behind 4 KiB and 100 cycles away.
TEST_F(OrderRunTest, TilesTakeFewerCyclesBehindASmallCache) {
  for (const auto& [technique, share] :
       {std::pair("voxel-offset", 1.0), std::pair("voxel-topology", 0.75), std::pair("slb", 0.9)}) {
    RunRequest golden = request_for(technique);
    golden.scene.lights.resize(1);
    golden.settings.res = 48;
    golden.settings.memory_given = true;
    golden.settings.system.cache_log2 = 12;
    golden.settings.system.system.dram.latency = 100;
    const auto cycles = [&](plan::ItemOrder order) {
      const auto passes = run_in(order, golden).second["cycles_predicted"]["by_pass"];
      std::uint64_t sum = 0;
      for (const char* pass : {"PROJECT", "RESOLVE", "QUERY"})
        sum += passes[pass]["total"].get<std::uint64_t>();
      return static_cast<double>(sum);
    };
    EXPECT_LT(cycles(plan::ItemOrder::Tile), share * cycles(plan::ItemOrder::Surface)) << technique;
  }
}

}  // namespace
}  // namespace gnomon::pipeline
