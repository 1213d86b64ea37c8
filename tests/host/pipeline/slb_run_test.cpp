// SPDX-License-Identifier: Apache-2.0
// Runs in which silhouettes decide: their shadows' borders are far finer than the plane.
#include <gmock/gmock.h>

#include "host/render/png_file.hpp"
#include "tests/host/pipeline/small_scene.hpp"

namespace gnomon::pipeline {
namespace {

class SlbRunTest : public RunTest {
 protected:
  RunRequest slb(const char* technique) const {
    RunRequest wanted = request();
    wanted.settings.techniques = {technique};
    wanted.settings.slb.plane_log2 = 5;
    return wanted;
  }
};

TEST_F(SlbRunTest, BordersAreFinerThanPixelsAndEveryWordIsCompared) {
  const auto outcome = run(slb("slb"));
  ASSERT_TRUE(outcome) << outcome.error().message;
  EXPECT_EQ(outcome->exit_status(), 0) << outcome->compare.text;
  const nlohmann::json m = metrics();
  EXPECT_EQ(m["compare"]["differing"], 0);
  // An answer a query, a fence, and the plane: a word and four raw words an entry.
  EXPECT_EQ(m["compare"]["words"].get<std::uint64_t>(),
            m["events"]["SLB_QUERIES"].get<std::uint64_t>() + 1 + 5ULL * 32 * 32);
  EXPECT_GT(m["slb"]["pixels_by_fragments"][1].get<std::uint64_t>(), 50u);
  EXPECT_EQ(m["slb"]["overflow_pixels"], 0);
  EXPECT_EQ(m["errors"]["shadow_maps"].size(), 2u);
  EXPECT_GT(m["errors"]["shadow_maps"][0]["ground"]["boundary_displacement"].get<double>(),
            20 * m["errors"]["fixed"]["ground"]["boundary_displacement"].get<double>());
  EXPECT_TRUE(render::read_png(output() / "memory.png"));
  EXPECT_EQ(m["events"]["SLB_OBJECTS"], 1) << "the ground casts nothing and is left out";
  EXPECT_EQ(m["hardware"]["EN_VPU_OFFSET"], false);
  EXPECT_EQ(m["hardware"]["EN_SLB"], true);
  EXPECT_TRUE(m["errors"]["double"].is_null());
  // A shadow map of the same plane is off by a quarter of a pixel.
  EXPECT_LT(m["errors"]["fixed"]["ground"]["boundary_displacement"].get<double>(), 0.02);
  EXPECT_LT(m["errors"]["fixed"]["all"]["share"].get<double>(), 0.02);
  EXPECT_EQ(m["errors"]["fixed"]["all"]["samples"], m["voxels"]["count"]);
  EXPECT_GT(m["picture"]["intersection_over_union"].get<double>(), 0.97);
}

TEST_F(SlbRunTest, FinerFractionsGiveFinerBorders) {
  const auto displacement = [&](int bits) {
    RunRequest wanted = slb("slb");
    wanted.settings.slb.frac_bits = wanted.settings.slb.slope_bits = bits;
    if (!run(wanted)) throw std::runtime_error("a run failed");
    return metrics()["errors"]["fixed"]["ground"]["boundary_displacement"].get<double>();
  };
  EXPECT_GT(displacement(3), 3 * displacement(7));
}

TEST_F(SlbRunTest, VoxelsDecideWhereNoFragmentIs) {
  const auto outcome = run(slb("slb+voxel"));
  ASSERT_TRUE(outcome) << outcome.error().message;
  EXPECT_EQ(outcome->exit_status(), 0) << outcome->compare.text;
  const nlohmann::json m = metrics();
  EXPECT_EQ(m["events"]["VOXELS_RESOLVED"], m["voxels"]["count"]);
  EXPECT_GT(m["events"]["SLB_QUERIES"].get<std::uint64_t>(), 1000u);
  EXPECT_EQ(m["registers"].size(), 18u);
  EXPECT_LT(m["errors"]["fixed"]["all"]["share"].get<double>(), 0.1);
}

TEST_F(SlbRunTest, AnAnswerThatDiffersIsShownAndFails) {
  RunRequest broken = slb("slb");
  broken.make_rtl = stand_in(sim::test::flip_bit(41, 55));
  const auto outcome = run(broken);
  ASSERT_TRUE(outcome) << outcome.error().message;
  EXPECT_EQ(outcome->exit_status(), 1);
  EXPECT_EQ(outcome->compare.differing, 1u);
  EXPECT_THAT(outcome->compare.text, testing::HasSubstr("QUERY"));
}

}  // namespace
}  // namespace gnomon::pipeline
