// SPDX-License-Identifier: Apache-2.0
// Bare models and scene files.
#include "host/scene/scene.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "host/scene/limit_bounds.hpp"
#include "host/scene/scene_file.hpp"
#include "tests/host/scene/files.hpp"

namespace gnomon::scene {
namespace {

using testing::HasSubstr;

/// The way a directional light travels.
Vec3 way(const Scene& scene, std::size_t light) {
  return std::get<DirectionalLight>(scene.lights.at(light)).direction;
}

class SceneTest : public testing::Test {
 protected:
  SceneTest() { directory_.write("cube.obj", test::cube_text()); }
  Result<Scene> load(const std::string& name, std::string_view text, const SceneOptions& options = {}) const {
    return load_scene(directory_.write(name, text), options);
  }
  std::string error(const std::string& name, std::string_view text) const {
    const Result<Scene> scene = load(name, text);
    return scene ? "" : scene.error().message.substr(directory_.path().string().size() + 1);
  }
  test::TempDir directory_;
};

TEST_F(SceneTest, ABareObjGetsGroundLightAndCamera) {
  const Scene scene = load_scene(directory_.path() / "cube.obj").value();
  ASSERT_EQ(scene.objects.size(), 2U);
  EXPECT_EQ(scene.name, "cube");
  EXPECT_FALSE(scene.objects[0].ground);
  EXPECT_FALSE(scene.objects[0].two_sided);
  const Object& ground = scene.objects[1];
  EXPECT_TRUE(ground.ground);
  EXPECT_TRUE(ground.two_sided);
  ASSERT_EQ(scene.lights.size(), 1U);
  EXPECT_NEAR(way(scene, 0).length(), 1, 1e-12);
  EXPECT_LT(way(scene, 0).y, 0);
}

TEST_F(SceneTest, TheGroundTouchesTheLimitSurfaceAndCatchesTheShadow) {
  const Scene scene = load_scene(directory_.path() / "cube.obj").value();
  const Box3 model = scene.objects[0].bounds, ground = scene.objects[1].bounds;
  EXPECT_DOUBLE_EQ(ground.min.y, model.min.y);
  EXPECT_DOUBLE_EQ(ground.max.y, model.min.y);
  EXPECT_GT(model.min.y, -0.9);  // the control points lie at -1
  const Vec3 light = way(scene, 0);
  for (const double x : {model.min.x, model.max.x}) {
    for (const double z : {model.min.z, model.max.z}) {
      const Vec3 shadow = Vec3(x, model.max.y, z) + light * (model.size().y / -light.y);
      EXPECT_GT(shadow.x, ground.min.x);
      EXPECT_LT(shadow.x, ground.max.x);
      EXPECT_GT(shadow.z, ground.min.z);
      EXPECT_LT(shadow.z, ground.max.z);
    }
  }
  // Its normal points up, and its limit surface is the flat rectangle itself.
  const Box3 limit = limit_bounds(scene.objects[1].mesh, Mat4()).value();
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(limit.min[axis], ground.min[axis], 1e-9);
    EXPECT_NEAR(limit.max[axis], ground.max[axis], 1e-9);
  }
  const auto& m = scene.objects[1].mesh;
  const auto p = [&](std::size_t i) { return m.positions[static_cast<std::size_t>(m.face_indices[i])]; };
  EXPECT_GT((p(1) - p(0)).cross(p(2) - p(1)).y, 0);
}

TEST_F(SceneTest, AGrazingLightDoesNotBlowUpTheGround) {
  SceneOptions options;
  options.light = Vec3(1, -1e-4, 0);
  const Scene scene = load_scene(directory_.path() / "cube.obj", options).value();
  EXPECT_LT(scene.objects[1].bounds.size().x, 3 * scene.objects[0].bounds.size().x);
  options.light = Vec3(1, 1, 0);  // from below
  EXPECT_TRUE(load_scene(directory_.path() / "cube.obj", options).has_value());
}

TEST_F(SceneTest, OptionsChangeABareObj) {
  SceneOptions options;
  options.ground = false;
  options.light = Vec3(0, 0, -2);
  Scene scene = load_scene(directory_.path() / "cube.obj", options).value();
  EXPECT_EQ(scene.objects.size(), 1U);
  EXPECT_EQ(way(scene, 0), Vec3(0, 0, -1));

  options.surface = SurfaceKind::Polygons;
  scene = load_scene(directory_.path() / "cube.obj", options).value();
  EXPECT_NEAR(scene.objects[0].bounds.max.x, 1, 1e-9);
  EXPECT_NEAR(scene.objects[0].bounds.min.z, -1, 1e-9);

  options.ground = true;
  options.up = UpAxis::Z;
  options.light.reset();
  scene = load_scene(directory_.path() / "cube.obj", options).value();
  EXPECT_EQ(scene.objects[1].bounds.size().z, 0);
  EXPECT_LT(way(scene, 0).z, 0);
  EXPECT_EQ(scene.camera.up, Vec3(0, 0, 1));
}

TEST_F(SceneTest, TheCameraSeesTheWholeModel) {
  for (const double aspect : {0.5, 4.0 / 3.0, 3.0}) {
    SceneOptions options;
    options.image_aspect = aspect;
    const Scene scene = load_scene(directory_.path() / "cube.obj", options).value();
    const Camera& camera = scene.camera;
    const Vec3 forward = (camera.target - camera.eye).normalized();
    const Vec3 right = forward.cross(camera.up).normalized(), above = right.cross(forward);
    const double tan_vertical = std::tan(camera.fov * 3.14159265358979 / 360);
    const Box3 box = scene.objects[0].bounds;
    for (int i = 0; i < 8; ++i) {
      const Vec3 corner((i & 1) != 0 ? box.max.x : box.min.x, (i & 2) != 0 ? box.max.y : box.min.y,
                        (i & 4) != 0 ? box.max.z : box.min.z);
      const Vec3 p = corner - camera.eye;
      const double depth = p.dot(forward);
      EXPECT_GT(depth, 0);
      EXPECT_LT(std::abs(p.dot(above)), depth * tan_vertical);
      EXPECT_LT(std::abs(p.dot(right)), depth * tan_vertical * aspect);
    }
  }
}

TEST_F(SceneTest, ReadsToml) {
  const Scene scene = load("scene.toml", R"(
name = "two cubes"
[parameters]
res = 128
ground = false
light = [0, -1, 0.5]
[[models]]
path = "cube.obj"
name = "big"
scale = 2
[[models]]
path = "cube.obj"
translate = [5, 0, 0]
rotate = [0, 90, 0]
[[lights]]
type = "directional"
direction = [0, -2, 0]
[[lights]]
direction = [1, -1, 0]
[camera]
eye = [0, 5, 10]
target = [0, 0, 0]
fov = 45
)")
                          .value();
  EXPECT_EQ(scene.name, "two cubes");
  ASSERT_EQ(scene.objects.size(), 3U);
  EXPECT_EQ(scene.objects[0].name, "big");
  EXPECT_EQ(Vec3(1, -1, 1) * scene.objects[0].to_world, Vec3(2, -2, 2));
  EXPECT_NEAR((Vec3(1, 0, 0) * scene.objects[1].to_world - Vec3(5, 0, -1)).length(), 0, 1e-12);
  ASSERT_EQ(scene.lights.size(), 2U);
  EXPECT_EQ(way(scene, 0), Vec3(0, -1, 0));
  EXPECT_EQ(scene.camera.eye, Vec3(0, 5, 10));
  EXPECT_EQ(scene.camera.fov, 45);

  const auto parameters = scene_parameters(directory_.path() / "scene.toml").value();
  ASSERT_EQ(parameters.size(), 3U);
  std::map<std::string, config::Assignment> by_key;
  for (const config::Assignment& p : parameters) by_key[p.key] = p;
  EXPECT_EQ(by_key["res"].text, "128");
  EXPECT_THAT(by_key["res"].origin, HasSubstr("scene.toml:4"));
  EXPECT_EQ(by_key["ground"].text, "off");
  EXPECT_EQ(by_key["light"].text, "0,-1,0.5");
}

TEST_F(SceneTest, ReadsTheSameFromJson) {
  const Scene scene = load("scene.json", R"({"models": [{"path": "cube.obj",
    "matrix": [[0, -1, 0, 7], [1, 0, 0, 8], [0, 0, 1, 9], [0, 0, 0, 1]]}],
    "lights": [{"type": "directional", "direction": [0, 0, -1]}], "parameters": {"res": 64}})")
                          .value();
  EXPECT_EQ(scene.name, "scene");
  EXPECT_NEAR((Vec3(1, 0, 0) * scene.objects[0].to_world - Vec3(7, 9, 9)).length(), 0, 1e-12);
  EXPECT_EQ(scene_parameters(directory_.path() / "scene.json").value().at(0).text, "64");
}

TEST_F(SceneTest, RestingModelsTouchTheGround) {
  const Scene scene = load("scene.toml",
                           "[[models]]\npath=\"cube.obj\"\nrest=true\ntranslate=[0,7,0]\n"
                           "[[models]]\npath=\"cube.obj\"\nrest=true\nscale=0.5\nrotate=[20,0,0]\n")
                          .value();
  ASSERT_EQ(scene.objects.size(), 3U);
  EXPECT_NEAR(scene.objects[0].bounds.min.y, 0, 1e-12);
  EXPECT_NEAR(scene.objects[1].bounds.min.y, 0, 1e-12);
  EXPECT_NEAR(scene.objects[2].bounds.min.y, 0, 1e-12);
  const Box3 again = limit_bounds(scene.objects[1].mesh, scene.objects[1].to_world).value();
  EXPECT_NEAR(again.min.y, 0, 1e-9);
  EXPECT_THAT(error("s.toml", "[[models]]\npath=\"cube.obj\"\nrest=3\n"),
              HasSubstr("s.toml:3: error: models/0/rest is not true or false"));
}

TEST_F(SceneTest, FindsModelsBesideTheSceneFile) {
  directory_.write("sub/part.obj", test::cube_text());
  EXPECT_TRUE(load("sub/scene.toml", "[[models]]\npath = \"part.obj\"\n").has_value());
  EXPECT_TRUE(load("sub/scene.toml", "[[models]]\npath = \"../cube.obj\"\n").has_value());
}

TEST_F(SceneTest, ALightOptionReplacesTheLightsOfTheFile) {
  SceneOptions options;
  options.light = Vec3(0, -3, 0);
  const Scene scene =
      load("scene.toml",
           "[[models]]\npath=\"cube.obj\"\n[[lights]]\ndirection=[1,0,0]\n[[lights]]\ndirection=[0,1,0]\n",
           options)
          .value();
  ASSERT_EQ(scene.lights.size(), 1U);
  EXPECT_EQ(way(scene, 0), Vec3(0, -1, 0));
}

TEST_F(SceneTest, AMirroringTransformKeepsTheOutsideOutside) {
  const Scene scene = load("scene.toml", "[[models]]\npath=\"cube.obj\"\nscale=[-1,1,1]\n").value();
  const ControlMesh& mesh = scene.objects[0].mesh;
  double volume = 0;
  for (std::size_t f = 0; f < 6; ++f) {
    const auto p = [&](std::size_t i) {
      return mesh.positions[static_cast<std::size_t>(mesh.face_indices[4 * f + i])] *
             scene.objects[0].to_world;
    };
    volume += p(0).dot(p(1).cross(p(2))) + p(0).dot(p(2).cross(p(3)));
  }
  EXPECT_NEAR(volume / 6, 8, 1e-12);
}

TEST_F(SceneTest, RefusesUnknownKeysNamingTheNearest) {
  EXPECT_EQ(error("s.toml", "nmae = \"x\"\n[[models]]\npath=\"cube.obj\"\n"),
            "s.toml:1: error: unknown key 'nmae', did you mean 'name'?");
  EXPECT_EQ(error("s.toml", "[[models]]\npath=\"cube.obj\"\n\ntranslat = [1,2,3]\n"),
            "s.toml:4: error: unknown key 'models/0/translat', did you mean 'translate'?");
  EXPECT_EQ(
      error("s.toml", "[[models]]\npath=\"cube.obj\"\n[[lights]]\ndirection=[1,0,0]\ncolour=1\n"),
      "s.toml:5: error: unknown key 'lights/0/colour', expected one of type, direction, position, target, "
      "angle");
  EXPECT_EQ(error("s.json", R"({"model": []})"),
            "s.json: error: unknown key 'model', did you mean 'models'?");
}

TEST_F(SceneTest, RefusesMalformedSceneFiles) {
  const std::string model = "[[models]]\npath=\"cube.obj\"\n";
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "s.toml:"},  // place below
      {"name = \n", "s.toml:1: error: "},
      {"name = \"a\"\nname = \"b\"\n", "s.toml:2: error: "},
      {"models = 3\n", "s.toml:1: error: models is not a list"},
      {"models = [3]\n", "s.toml:1: error: models/0 is not a table"},
      {"[[models]]\nname=\"x\"\n", "s.toml:1: error: models/0 has no path"},
      {"[[models]]\npath=3\n", "s.toml:2: error: models/0/path = 3 is not a text"},
      {model + "translate=[1,2]\n",
       "s.toml:3: error: models/0/translate = [1,2] is not a list of three numbers"},
      {model + "translate=[1,2,\"x\"]\n",
       "s.toml:3: error: models/0/translate/2 = \"x\" is not a finite number"},
      {model + "translate=[1,2,inf]\n", "s.toml:3: error: models/0/translate/2"},
      {model + "scale=0\n", "s.toml:1: error: models/0 is flattened"},
      {model + "matrix=[[1,0,0,0],[0,1,0,0],[0,0,1,0]]\n",
       "s.toml:3: error: models/0/matrix is not a list of four rows"},
      {model + "matrix=[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,1,1]]\n",
       "s.toml:3: error: models/0/matrix is not affine"},
      {model + "matrix=[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]\nscale=2\n",
       "s.toml:4: error: models/0/scale next to matrix"},
      {model + "[[lights]]\ntype=\"directional\"\n", "s.toml:3: error: lights/0 has no direction"},
      {model + "[[lights]]\ndirection=[0,0,0]\n", "s.toml:4: error: lights/0/direction is no direction"},
      {model + "[camera]\neye=[0,0,1]\n", "s.toml:3: error: camera has no target"},
      {model + "[camera]\neye=[0,0,1]\ntarget=[0,0,1]\n",
       "s.toml:3: error: camera looks along its up direction"},
      {model + "[camera]\neye=[0,0,1]\ntarget=[0,0,0]\nfov=200\n",
       "s.toml:6: error: camera/fov = 200 is out of range"},
      {model + "[parameters]\nres={a=1}\n", "s.toml:4: error: parameters/res is not a value"},
      {"[parameters]\nres=64\n", "s.toml:1: error: no models found"},
  };
  for (const auto& [text, expected] : cases) {
    const std::string message = error("s.toml", text);
    EXPECT_THAT(message, HasSubstr(text.empty() ? "no models found" : expected)) << text;
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
  EXPECT_THAT(error("s.json", "{\"models\": [\n{\"path\": }]}"), HasSubstr("s.json:2: error: "));
  EXPECT_THAT(error("s.json", "[1, 2]"), HasSubstr("s.json: error: expected a table"));
  EXPECT_THAT(load_scene(directory_.path() / "none.toml").error().message, HasSubstr("No such file"));
}

TEST_F(SceneTest, NamesTheModelFileThatCannotBeRead) {
  directory_.write("bad.obj", "v 0 0 0\nf 1 2 3\n");
  EXPECT_THAT(error("s.toml", "[[models]]\npath=\"bad.obj\"\n"), HasSubstr("bad.obj:2: error: "));
  EXPECT_THAT(error("s.toml", "[[models]]\npath=\"none.obj\"\n"),
              HasSubstr("none.obj: error: cannot be read"));
}

}  // namespace
}  // namespace gnomon::scene
