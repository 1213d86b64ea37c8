// SPDX-License-Identifier: Apache-2.0
// Techniques in software, run like all others: answered, measured, counted, and never taken for verified.
#include <gmock/gmock.h>

#include "tests/host/pipeline/small_scene.hpp"

namespace gnomon::pipeline {
namespace {

using testing::HasSubstr;

class SoftwareRunTest : public RunTest {
 protected:
  RunRequest with(std::vector<std::string> techniques) const {
    RunRequest made = request();
    made.settings.techniques = std::move(techniques);
    made.settings.res = 32;
    return made;
  }
  /// What metrics.json has of one of several techniques.
  static nlohmann::json part(const nlohmann::json& metrics, const std::string& technique) {
    for (const nlohmann::json& t : metrics.at("techniques"))
      if (t.at("technique") == technique) return t;
    ADD_FAILURE() << "no " << technique;
    return {};
  }
  static double displaced(const nlohmann::json& t) {
    return t.at("errors").at("fixed").at("boundary_displacement").get<double>() *
           t.at("errors").at("pitch").get<double>();
  }
  /// Why a run fails; empty if it does not.
  static std::string problem_of(const RunRequest& request) {
    const auto done = run(request);
    return done ? std::string() : done.error().message;
  }
};

TEST_F(SoftwareRunTest, StandsBesideTheHardwareOnTheSameAxes) {
  RunRequest made = with({"slb", "plain-map", "pcf", "raycast"});
  made.settings.slb.plane_log2 = 4;
  const auto done = run(made);
  ASSERT_TRUE(done) << done.error().message;
  const nlohmann::json m = metrics();
  ASSERT_EQ(m.at("techniques").size(), 4u);
  const auto slb_bits = m.at("memory").at("hardware_bits").get<std::uint64_t>();
  for (const char* name : {"plain-map", "pcf"}) {
    const nlohmann::json t = part(m, name);
    const nlohmann::json& software = t.at("software");
    const auto bits = t.at("memory").at("hardware_bits").get<std::uint64_t>();
    EXPECT_LE(bits, slb_bits) << name;
    EXPECT_GT(bits, slb_bits * 9 / 10) << name;
    EXPECT_EQ(software.at("memory_bits"), bits);
    EXPECT_GT(displaced(t), displaced(part(m, "slb"))) << name;
    EXPECT_LT(t.at("errors").at("fixed").at("boundary_displacement"), 0.35) << name;
    const auto reads =
        software.at("kernel").get<std::uint64_t>() * software.at("kernel").get<std::uint64_t>();
    const nlohmann::json& passes = t.at("cycles").at("by_pass");
    EXPECT_EQ(passes.at("QUERY").at("total"), reads * software.at("queries").get<std::uint64_t>());
    EXPECT_EQ(passes.at("DRAW").at("total"), software.at("drawn"));
    EXPECT_GT(software.at("drawn"), 0);
  }
  EXPECT_EQ(part(m, "plain-map").at("software").at("kernel"), 1);
  EXPECT_EQ(part(m, "pcf").at("software").at("kernel"), 3);
  EXPECT_LT(displaced(part(m, "pcf")), displaced(part(m, "plain-map")));
  EXPECT_THAT(content("report.html"), HasSubstr("texels; read a query"));
}

TEST_F(SoftwareRunTest, RaysAreAsGoodAsTheReference) {
  RunRequest made = with({"raycast"});
  made.scene.lights = {PointLight{{1.6, 0.3, 0.2}}};  // beside the cube: on several of its sides
  const auto done = run(made);
  ASSERT_TRUE(done) << done.error().message;
  const nlohmann::json m = metrics();
  ASSERT_GT(m.at("lights").at(0).at("views").size(), 1u);
  EXPECT_EQ(m.at("errors").at("fixed").at("unambiguous").at("mislabelled"), 0);
  EXPECT_GT(m.at("errors").at("fixed").at("unambiguous").at("samples"), 1000);
  EXPECT_LT(m.at("errors").at("fixed").at("all").at("share"), 0.005);
  EXPECT_LT(displaced(m), 0.02);
  EXPECT_GT(m.at("software").at("triangles"), 100);
  EXPECT_GT(m.at("memory").at("hardware_bits"), 1000);
  EXPECT_GT(m.at("software").at("queries"), 1000);
}

TEST_F(SoftwareRunTest, CoarseRaysAreWrongLikeEveryOtherTechnique) {
  RunRequest made = with({"raycast"});
  ASSERT_TRUE(run(made));
  const double fine = displaced(metrics());
  made.settings.ray_sag = 1;
  ASSERT_TRUE(run(made));
  EXPECT_GT(displaced(metrics()), 10 * fine);
}

TEST_F(SoftwareRunTest, IsNeverTakenForVerified) {
  RunRequest made = with({"pcf"});
  const auto done = run(made);
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_EQ(done->exit_status(), 0);
  const nlohmann::json compare = metrics().at("compare");
  EXPECT_EQ(compare.at("compared"), false);
  EXPECT_EQ(compare.at("words"), 0);
  EXPECT_THAT(compare.at("verdict").get<std::string>(), HasSubstr("software"));
}

TEST_F(SoftwareRunTest, TheMapHasTheMemoryOrTheSideItIsTold) {
  RunRequest made = with({"plain-map"});
  made.settings.maps.memory = "voxel-offset";
  made.settings.vpu.plane_log2 = 5;
  ASSERT_TRUE(run(made));
  EXPECT_EQ(metrics().at("software").at("side"), 36);  // 32^2 entries of 32 bits hold so many texels of 24
  made.settings.maps.side = 77;
  ASSERT_TRUE(run(made));
  EXPECT_EQ(metrics().at("memory").at("hardware_bits"), 77 * 77 * 24);
}

TEST_F(SoftwareRunTest, FramesAreAnsweredAnew) {
  RunRequest made = with({"pcf"});
  made.frames = 2;
  const auto done = run(made);
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_TRUE(std::filesystem::exists(output() / "frames" / "frame_0001.png"));
}

TEST_F(SoftwareRunTest, SaysWhatItCannotDo) {
  RunRequest lamp = with({"plain-map"});
  lamp.scene.lights = {PointLight{{0.5, 2.5, 0.7}}};
  EXPECT_THAT(problem_of(lamp), HasSubstr("technique=plain-map takes directional lights only"));
  RunRequest kept = with({"raycast"});
  kept.settings.frame_buffer = true;
  EXPECT_THAT(problem_of(kept), HasSubstr("frame_buffer=on"));
}

}  // namespace
}  // namespace gnomon::pipeline
