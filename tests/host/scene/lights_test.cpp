// SPDX-License-Identifier: Apache-2.0
// Lights of every kind, objects that throw or take no shadows, and what is refused of them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "host/scene/scene.hpp"
#include "tests/host/scene/files.hpp"

namespace gnomon::scene {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string kModel = "[[models]]\npath=\"cube.obj\"\n";

class LightsTest : public testing::Test {
 protected:
  LightsTest() { directory_.write("cube.obj", test::cube_text()); }
  Result<Scene> load(std::string_view text, const std::string& name = "s.toml",
                     const SceneOptions& options = {}) const {
    return load_scene(directory_.write(name, text), options);
  }
  /// The message without the directory; empty where the scene was taken.
  std::string error(std::string_view text, const std::string& name = "s.toml") const {
    const Result<Scene> scene = load(text, name);
    return scene ? "" : scene.error().message.substr(directory_.path().string().size() + 1);
  }
  test::TempDir directory_;
};

TEST_F(LightsTest, EveryKindIsReadInItsOrder) {
  const Scene scene = load(kModel + R"(
[[lights]]
type = "point"
position = [1, 5, 2]
[[lights]]
type = "spot"
position = [0, 4, 0]
direction = [0, -2, 0]
angle = 50
[[lights]]
type = "spot"
position = [3, 4, 0]
target = [0, 0, 0]
angle = 160
[[lights]]
type = "directional"
direction = [0, -3, 4]
)")
                          .value();
  ASSERT_EQ(scene.lights.size(), 4U);
  EXPECT_EQ(std::get<PointLight>(scene.lights[0]).position, Vec3(1, 5, 2));
  const auto& down = std::get<SpotLight>(scene.lights[1]);
  EXPECT_EQ(down.position, Vec3(0, 4, 0));
  EXPECT_EQ(down.direction, Vec3(0, -1, 0));
  EXPECT_EQ(down.half_angle, 25);
  const auto& aimed = std::get<SpotLight>(scene.lights[2]);
  EXPECT_NEAR((aimed.direction - Vec3(-0.6, -0.8, 0)).length(), 0, 1e-15);
  EXPECT_EQ(aimed.half_angle, 80);
  EXPECT_NEAR((std::get<DirectionalLight>(scene.lights[3]).direction - Vec3(0, -0.6, 0.8)).length(), 0,
              1e-15);
}

TEST_F(LightsTest, JsonHasTheSameKeys) {
  const Scene scene = load(R"({"models": [{"path": "cube.obj", "casts": false}],
    "lights": [{"type": "spot", "position": [0, 9, 0], "target": [0, 0, 0], "angle": 30},
               {"type": "point", "position": [4, 4, 4]}]})",
                           "s.json")
                          .value();
  ASSERT_EQ(scene.lights.size(), 2U);
  EXPECT_EQ(std::get<SpotLight>(scene.lights[0]).half_angle, 15);
  EXPECT_EQ(std::get<PointLight>(scene.lights[1]).position, Vec3(4, 4, 4));
  EXPECT_FALSE(scene.objects[0].casts);
}

TEST_F(LightsTest, ObjectsThrowAndTakeShadowsUnlessTheFileSaysNo) {
  const Scene scene = load(kModel + "casts=false\n" + kModel + "receives=false\ntranslate=[4,0,0]\n").value();
  ASSERT_EQ(scene.objects.size(), 3U);
  EXPECT_FALSE(scene.objects[0].casts);
  EXPECT_TRUE(scene.objects[0].receives);
  EXPECT_TRUE(scene.objects[1].casts);
  EXPECT_FALSE(scene.objects[1].receives);
  EXPECT_TRUE(scene.objects[2].ground && scene.objects[2].casts && scene.objects[2].receives);
}

TEST_F(LightsTest, TheLightOptionReplacesLightsOfEveryKind) {
  SceneOptions options;
  options.light = Vec3(0, -2, 0);
  const Scene scene =
      load(kModel + "[[lights]]\ntype=\"point\"\nposition=[0,9,0]\n", "s.toml", options).value();
  ASSERT_EQ(scene.lights.size(), 1U);
  EXPECT_EQ(std::get<DirectionalLight>(scene.lights[0]).direction, Vec3(0, -1, 0));
}

TEST_F(LightsTest, LightsInsideTheSceneAndInsideObjectsAreTaken) {
  for (const char* place : {"[0,0,0]", "[0,0.83,0]", "[0,-50,0]", "[1e4,1e4,1e4]"}) {
    EXPECT_EQ(error(kModel + "[[lights]]\ntype=\"point\"\nposition=" + place + "\n"), "") << place;
  }
}

TEST_F(LightsTest, RefusesWhatIsNoLight) {
  const std::string spot = kModel + "[[lights]]\ntype=\"spot\"\n";
  const std::string whole_spot = spot + "position=[0,5,0]\ntarget=[0,0,0]\n";
  const std::string point = kModel + "[[lights]]\ntype=\"point\"\n";
  const std::vector<std::pair<std::string, std::string>> cases{
      {kModel + "lights=3\n", "s.toml:3: error: unknown key 'models/0/lights'"},
      {"lights=[3]\n" + kModel, "s.toml:1: error: lights/0 is not a table"},
      {kModel + "[[lights]]\ntype=\"sopt\"\n",
       "s.toml:4: error: lights/0/type = \"sopt\" is no type of light, did you mean 'spot'?"},
      {kModel + "[[lights]]\ntype=\"area\"\n",
       "s.toml:4: error: lights/0/type = \"area\" is no type of light, expected one of directional, spot, "
       "point"},
      {kModel + "[[lights]]\ntype=2\n", "s.toml:4: error: lights/0/type = 2 is not a text"},
      {kModel + "[[lights]]\nposition=[0,1,0]\n",
       "s.toml:3: error: lights/0 has a position but no type, expected type = \"spot\" or \"point\""},
      {kModel + "[[lights]]\ndirection=[1,0,0]\nangel=3\n",
       "s.toml:5: error: unknown key 'lights/0/angel', did you mean 'angle'?"},
      {kModel + "[[lights]]\ndirection=[1,0,0]\nangle=30\n",
       "s.toml:5: error: lights/0/angle: a directional light has no angle, expected direction"},
      {point + "position=[0,9,0]\ntarget=[0,0,0]\n",
       "s.toml:6: error: lights/0/target: a point light has no target, expected position"},
      {point, "s.toml:3: error: lights/0 is a point light and has no position"},
      {point + "position=[0,9]\n",
       "s.toml:5: error: lights/0/position = [0,9] is not a list of three numbers"},
      {point + "position=[0,nan,0]\n", "s.toml:5: error: lights/0/position/1 = nan is not a finite number"},
      {point + "position=[0,inf,0]\n", "s.toml:5: error: lights/0/position/1 = inf is not a finite number"},
      {point + "position=[0,1e100,0]\n", "s.toml:5: error: lights/0/position is farther away than 1e+90"},
      {point + "position=[0,1e6,0]\n",
       "s.toml: error: lights/0 is more than 10000 times the models' size away"},
      {spot, "s.toml:3: error: lights/0 is a spot light and has no position"},
      {spot + "position=[0,5,0]\nangle=30\n",
       "s.toml:3: error: lights/0 is a spot light and has neither direction nor target"},
      {spot + "position=[0,5,0]\ndirection=[0,0,0]\nangle=30\n",
       "s.toml:6: error: lights/0/direction is no direction: its length is zero"},
      {spot + "position=[0,5,0]\ntarget=[0,5,0]\nangle=30\n",
       "s.toml:6: error: lights/0/target is where the light is"},
      {whole_spot + "direction=[0,-1,0]\nangle=30\n",
       "s.toml:6: error: lights/0/target next to direction, expected one or the other"},
      {whole_spot, "s.toml:3: error: lights/0 is a spot light and has no angle"},
      {whole_spot + "angle=0\n", "s.toml:7: error: lights/0/angle = 0 is out of range"},
      {whole_spot + "angle=-20\n", "s.toml:7: error: lights/0/angle = -20 is out of range"},
      {whole_spot + "angle=160.5\n",
       "s.toml:7: error: lights/0/angle = 160.5 is out of range, expected above 0 and at most 160 degrees"},
      {whole_spot + "angle=nan\n", "s.toml:7: error: lights/0/angle = nan is not a finite number"},
      {whole_spot + "angle=\"wide\"\n", "s.toml:7: error: lights/0/angle = \"wide\" is not a finite number"},
      {kModel + "[[lights]]\ndirection=[1e200,0,0]\n",
       "s.toml:4: error: lights/0/direction is too long for a direction"},
      {kModel + "casts=1\n", "s.toml:3: error: models/0/casts is not true or false"},
      {kModel + "recieves=false\n",
       "s.toml:3: error: unknown key 'models/0/recieves', did you mean 'receives'?"},
  };
  for (const auto& [text, expected] : cases) {
    const std::string message = error(text);
    EXPECT_THAT(message, StartsWith(expected)) << text;
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
}

TEST_F(LightsTest, RefusesASceneOfWhichNothingTakesShadows) {
  SceneOptions bare;
  bare.ground = false;
  const std::string text = kModel + "receives=false\n";
  EXPECT_THAT(load(text, "s.toml", bare).error().message,
              HasSubstr("s.toml: error: no object receives shadows"));
  EXPECT_TRUE(load(text).has_value());
}

TEST(Lights, ReachAndTurnTheSameInEveryCoordinates) {
  const SpotLight spot{{1, 2, -3}, Vec3(0, -3, 4).normalized(), 30};
  const std::vector<Light> lights{DirectionalLight{Vec3(1, -2, 2) / 3}, spot, PointLight{{4, 4, 4}}};
  Mat4 turn, scale, move;
  turn.setEulerAngles(Vec3(0.3, 1.1, -0.7));
  scale.setScale(2.5);
  move.setTranslation(Vec3(7, -8, 9));
  const Mat4 there = turn * scale * move;
  int reached = 0;
  for (const Light& light : lights) {
    const Light moved = transformed(light, there);
    for (int i = 0; i < 1000; ++i) {
      const int x = i % 10, y = i / 10 % 10, z = i / 100;
      const Vec3 p(x - 4.5, y - 4.5, z - 4.5);
      Vec3 way;
      turn.multDirMatrix(light_way(light, p), way);
      EXPECT_NEAR((light_way(moved, p * there) - way).length(), 0, 1e-12);
      EXPECT_EQ(light_reaches(moved, p * there), light_reaches(light, p));
      reached += light_reaches(light, p) ? 1 : 0;
    }
  }
  EXPECT_GT(reached, 2010);  // the two that reach everything, and what is in the cone
  EXPECT_LT(reached, 2500);
  EXPECT_TRUE(light_reaches(spot, spot.position + spot.direction));
  EXPECT_FALSE(light_reaches(spot, spot.position - spot.direction));
  EXPECT_EQ(light_way(spot, spot.position), Vec3(0, 0, 0));
}

/// Where the ray from a lamp through p meets the plane y = floor.
Vec3 shadow_of(const Vec3& p, const Vec3& lamp, double floor) {
  return lamp + (p - lamp) * ((lamp.y - floor) / (lamp.y - p.y));
}

TEST_F(LightsTest, TheGroundHoldsTheShadowsThatALampThrows) {
  const Vec3 lamp(2, 4, 0.5);
  for (const char* light : {"type=\"point\"\nposition=[2,4,0.5]\n",
                            "type=\"spot\"\nposition=[2,4,0.5]\ntarget=[0,0,0]\nangle=120\n"}) {
    const Scene scene = load(kModel + "[[lights]]\n" + light).value();
    const Box3 model = scene.objects[0].bounds, ground = scene.objects[1].bounds;
    int inside = 0;
    for (const double x : {model.min.x, model.max.x}) {
      for (const double z : {model.min.z, model.max.z}) {
        const Vec3 shadow = shadow_of({x, model.max.y, z}, lamp, model.min.y);
        inside += ground.intersects(Vec3(shadow.x, ground.min.y, shadow.z)) ? 1 : 0;
      }
    }
    EXPECT_EQ(inside, 4);
    EXPECT_LT(ground.size().x, 3 * model.size().x);
  }
}

TEST_F(LightsTest, ALampBelowATopDoesNotBlowUpTheGround) {
  for (const char* place : {"[0,0,0]", "[3,0.1,0]", "[3,0.8,0]", "[0,-9,0]"}) {
    const Scene scene = load(kModel + "[[lights]]\ntype=\"point\"\nposition=" + place + "\n").value();
    const Box3 model = scene.objects[0].bounds, ground = scene.objects[1].bounds;
    EXPECT_LT(ground.size().x, 3.5 * model.size().x) << place;
    EXPECT_LT(ground.size().z, 3.5 * model.size().z) << place;
    EXPECT_GT(ground.size().x, model.size().x) << place;
  }
}

}  // namespace
}  // namespace gnomon::scene
