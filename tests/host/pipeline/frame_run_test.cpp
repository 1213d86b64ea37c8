// SPDX-License-Identifier: Apache-2.0
// A run with the frame buffer gives what it gives without, and costs what docs/frame-buffer.md says.
#include <gmock/gmock.h>

#include "host/pipeline/run.hpp"
#include "tests/host/pipeline/small_scene.hpp"

namespace gnomon::pipeline {
namespace {

using testing::HasSubstr;

class FrameRunTest : public RunTest {
 protected:
  /// voxels.npy and the figures of a golden run.
  std::pair<std::string, nlohmann::json> run_with(bool frame_buffer, const std::string& technique,
                                                  std::size_t lights) {
    const auto outcome = run(request_with(frame_buffer, technique, lights));
    if (!outcome) throw std::runtime_error(outcome.error().message);
    return {content("voxels.npy"), metrics()};
  }

  RunRequest request_with(bool frame_buffer, const std::string& technique, std::size_t lights) {
    RunRequest all = request();
    all.engine = EngineKind::Golden;
    all.settings.techniques = {technique};
    all.settings.frame_buffer = frame_buffer;
    all.scene.lights.resize(lights, DirectionalLight{Vec3(-0.5, -1, 0.3)});
    return all;
  }
};

TEST_F(FrameRunTest, StatesAndErrorsAreThoseWithoutIt) {
  for (const char* technique : {"voxel-offset", "voxel-topology"}) {
    for (const std::size_t lights : {1u, 3u}) {
      const auto [states, without] = run_with(false, technique, lights);
      const auto [kept, with_frame] = run_with(true, technique, lights);
      EXPECT_EQ(kept, states) << technique;
      EXPECT_EQ(with_frame["errors"], without["errors"]) << technique;
      EXPECT_EQ(with_frame["picture"], without["picture"]) << technique;
      EXPECT_FALSE(without["events"].contains("FRAME_KEPT"));
      const auto voxels = without["voxels"]["count"].get<std::uint64_t>();
      EXPECT_EQ(with_frame["events"]["FRAME_KEPT"], lights * voxels);
      EXPECT_EQ(with_frame["events"]["FRAME_OVERWRITTEN"], 0);
      for (const auto& [name, count] : without["events"].items()) {
        if (name == "COMMANDS") continue;
        EXPECT_EQ(with_frame["events"][name], count) << name;
      }
    }
  }
}

TEST_F(FrameRunTest, MemoryAndWordsAreThoseOfThePage) {
  const auto without = run_with(false, "voxel-offset", 1).second;
  const auto kept = run_with(true, "voxel-offset", 1).second;
  EXPECT_EQ(without["memory"]["frame_buffer_bits"], 0);
  EXPECT_EQ(kept["memory"]["frame_buffer_bits"], 512 * 136)
      << "24 voxels a side need 5 bits: 8 x 8 x 8 bricks";
  EXPECT_EQ(kept["memory"]["hardware_bits"].get<std::uint64_t>(),
            without["memory"]["hardware_bits"].get<std::uint64_t>() + 512ULL * 136);
  const auto bricks = kept["events"]["FRAME_BRICKS"].get<std::uint64_t>();
  EXPECT_EQ(kept["memory"]["result_stream_bits"].get<std::uint64_t>(), 64 * (3 * bricks + 1))
      << "and a fence";
  EXPECT_EQ(without["memory"]["result_stream_bits"].get<std::uint64_t>(),
            64 * (without["voxels"]["count"].get<std::uint64_t>() + 1));
  EXPECT_LT(3 * bricks, without["voxels"]["count"].get<std::uint64_t>() / 2);
  EXPECT_EQ(kept["hardware"]["EN_FRAME_BUFFER"], true);
  EXPECT_EQ(without["hardware"]["EN_FRAME_BUFFER"], false);
}

TEST_F(FrameRunTest, WhatCannotBeKeptIsRefused) {
  const auto slb = run(request_with(true, "slb", 1));
  ASSERT_FALSE(slb);
  EXPECT_THAT(slb.error().message, HasSubstr("frame_buffer=on keeps states of voxels"));
  const auto many = run(request_with(true, "voxel-offset", 9));
  ASSERT_FALSE(many);
  EXPECT_THAT(many.error().message, HasSubstr("for 9 lights at 32^3 voxels"));
}

}  // namespace
}  // namespace gnomon::pipeline
