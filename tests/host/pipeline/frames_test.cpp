// SPDX-License-Identifier: Apache-2.0
// A moving camera, and surfaces for other programs: what a run has found is used again, and nothing found
// anew.
#include <gmock/gmock.h>

#include <set>

#include "host/scene/obj_reader.hpp"
#include "tests/host/pipeline/small_scene.hpp"

namespace gnomon::pipeline {
namespace {

using testing::HasSubstr;

class FramesTest : public RunTest {
 protected:
  RunRequest wanted(const char* technique, std::uint32_t frames) const {
    RunRequest made = request();
    made.settings.techniques = {technique};
    made.settings.slb.plane_log2 = 5;
    made.frames = frames;
    return made;
  }
  std::set<std::string> names(const std::string& folder) const {
    std::set<std::string> all;
    for (const auto& entry : std::filesystem::directory_iterator(output() / folder))
      all.insert(entry.path().filename().string());
    return all;
  }
};

TEST_F(FramesTest, VoxelStatesAreFoundOnce) {
  ASSERT_TRUE(run(wanted("voxel-offset", 0)));
  const nlohmann::json still = metrics();
  EXPECT_TRUE(still["frames"].is_null());
  const auto outcome = run(wanted("voxel-offset", 3));
  ASSERT_TRUE(outcome) << outcome.error().message;
  EXPECT_THAT(names("frames"), testing::ElementsAre("frame_0000.png", "frame_0001.png", "frame_0002.png"));
  EXPECT_EQ(content("frames/frame_0000.png"), content("image.png")) << "the path begins where the camera is";
  EXPECT_NE(content("frames/frame_0001.png"), content("image.png"));
  const nlohmann::json m = metrics();
  EXPECT_EQ(m["frames"]["count"], 3);
  EXPECT_EQ(m["frames"]["command_words"], 0);
  EXPECT_EQ(m["frames"]["shadow_work"], 0);
  EXPECT_GT(m["frames"]["seconds_per_frame"].get<double>(), 0);
  EXPECT_EQ(m["events"], still["events"]) << "as much was projected and resolved as for one picture";
  EXPECT_THAT(content("report.html"), HasSubstr("3 frames, 0 events of shadow work"));
}

TEST_F(FramesTest, SilhouettesAreDrawnOnceAndAskedForEveryFrame) {
  for (const char* technique : {"slb", "slb+voxel"}) {
    SCOPED_TRACE(technique);
    ASSERT_TRUE(run(wanted(technique, 0)));
    const nlohmann::json still = metrics();
    const auto outcome = run(wanted(technique, 3));
    ASSERT_TRUE(outcome) << outcome.error().message;
    EXPECT_EQ(outcome->exit_status(), 0) << outcome->compare.text;
    EXPECT_EQ(content("frames/frame_0000.png"), content("image.png"));
    EXPECT_NE(content("frames/frame_0002.png"), content("image.png"));
    const nlohmann::json m = metrics();
    EXPECT_EQ(m["frames"]["shadow_work"], 0) << m["frames"]["shadow_work_events"];
    EXPECT_EQ(m["events"], still["events"]);
    const auto queries = m["frames"]["questions"]["SLB_QUERIES"].get<std::uint64_t>();
    EXPECT_GT(queries, 5000u);
    // An answer a query and a fence a frame, all of them compared.
    EXPECT_EQ(m["frames"]["result_words"], queries + 3);
    EXPECT_EQ(m["compare"]["words"].get<std::uint64_t>(),
              still["compare"]["words"].get<std::uint64_t>() + queries + 3);
  }
}

TEST_F(FramesTest, ADifferenceInALaterFrameIsShownAndFails) {
  ASSERT_TRUE(run(wanted("slb", 0)));
  const auto words = metrics()["compare"]["words"].get<std::uint64_t>();
  RunRequest broken = wanted("slb", 2);
  broken.make_rtl = stand_in(sim::test::flip_bit(words + 100, 55));
  const auto outcome = run(broken);
  ASSERT_TRUE(outcome) << outcome.error().message;
  EXPECT_EQ(outcome->exit_status(), 1);
  EXPECT_EQ(outcome->compare.differing, 1u);
  EXPECT_THAT(outcome->compare.text, HasSubstr("QUERY"));
}

TEST_F(FramesTest, AnInterruptionBetweenFramesLeavesNothing) {
  std::atomic<bool> abort = false;
  RunRequest interrupted = wanted("voxel-offset", 4);
  interrupted.abort = &abort;
  interrupted.progress = [&](std::string_view stage, double done) {
    if (stage == "frames" && done > 0.5) abort = true;
  };
  const auto outcome = run(interrupted);
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().message, "interrupted");
  EXPECT_TRUE(abort);
  EXPECT_TRUE(std::filesystem::is_empty(root_));
}

TEST_F(FramesTest, AShorterPathReplacesALongerOne) {
  ASSERT_TRUE(run(wanted("voxel-offset", 3)));
  ASSERT_TRUE(run(wanted("voxel-offset", 2)));
  EXPECT_EQ(names("frames").size(), 2u);
}

TEST_F(FramesTest, TheBufferOfSilhouettesHoldsOneLight) {
  RunRequest several = wanted("slb", 2);
  several.scene.lights.push_back(DirectionalLight{Vec3(1, -1, 0).normalized()});
  const auto outcome = run(several);
  ASSERT_FALSE(outcome);
  EXPECT_THAT(outcome.error().message,
              HasSubstr("has 2 lights, expected one with technique=slb and --frames"));
  several.settings.techniques = {"voxel-offset"};
  ASSERT_TRUE(run(several));
  EXPECT_EQ(content("frames/frame_0000.png"), content("image.png"));
}

TEST_F(FramesTest, EveryTechniqueHasFramesOfItsOwn) {
  RunRequest both = wanted("voxel-offset", 2);
  both.settings.techniques = {"voxel-offset", "slb"};
  ASSERT_TRUE(run(both));
  EXPECT_EQ(content("frames/frame_0000.png"), content("image.png"));
  EXPECT_EQ(content("frames-slb/frame_0000.png"), content("image-slb.png"));
  EXPECT_EQ(metrics()["techniques"][1]["frames"]["shadow_work"], 0);
}

class MeshesTest : public FramesTest {};

TEST_F(MeshesTest, SurfacesAndShadowsAreWrittenWhereAskedFor) {
  RunRequest asked = wanted("voxel-offset", 0);
  asked.settings.techniques = {"voxel-offset", "slb"};
  asked.scene.lights.push_back(DirectionalLight{Vec3(1, -1, 0).normalized()});
  asked.meshes = {mesh::MeshFormat::Ply, mesh::MeshFormat::Obj};
  const auto outcome = run(asked);
  ASSERT_TRUE(outcome) << outcome.error().message;
  const auto read = scene::read_obj(output() / "mesh.obj");
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->meshes.size(), 2u) << "the cube and its ground";
  EXPECT_EQ(read->meshes[0].name, "cube");
  EXPECT_EQ(read->statistics[0].boundary_edges, 0u);
  EXPECT_GT(read->statistics[1].boundary_edges, 50u);
  for (const char* name : {"mesh.ply", "mesh-slb.ply"}) {
    const std::string ply = content(name);
    EXPECT_THAT(ply.substr(0, 500),
                HasSubstr("property uchar shadow_0\nproperty uchar shadow_1\nelement face"));
  }
  EXPECT_NE(content("mesh.ply"), content("mesh-slb.ply")) << "the same surface, other shadows";
  EXPECT_EQ(content("mesh.ply").size(), content("mesh-slb.ply").size());
  asked.meshes.clear();
  std::filesystem::remove_all(output());
  ASSERT_TRUE(run(asked));
  EXPECT_FALSE(std::filesystem::exists(output() / "mesh.obj"));
}

}  // namespace
}  // namespace gnomon::pipeline
