// SPDX-License-Identifier: Apache-2.0
// Every scene in scenes/ loads, and between them they hold what they are there to show.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "host/config/settings.hpp"
#include "host/scene/scene.hpp"
#include "host/scene/scene_file.hpp"

namespace gnomon::scene {
namespace {

/// By file name.
std::map<std::string, Scene> all_scenes() {
  std::map<std::string, Scene> scenes;
  for (const auto& entry : std::filesystem::directory_iterator(GNOMON_SCENES)) {
    if (!is_scene_file(entry.path())) continue;
    Result<Scene> scene = load_scene(entry.path());
    EXPECT_TRUE(scene.has_value()) << (scene ? "" : scene.error().message);
    if (scene) scenes.emplace(entry.path().filename().string(), std::move(*scene));
  }
  return scenes;
}

template <class Kind>
bool has_light(const Scene& scene) {
  return std::ranges::any_of(scene.lights, [](const Light& l) { return std::holds_alternative<Kind>(l); });
}

TEST(ExampleScenes, AllLoadWithoutAWarning) {
  const auto scenes = all_scenes();
  EXPECT_GE(scenes.size(), 10U);
  for (const auto& [name, scene] : scenes) {
    EXPECT_TRUE(scene.warnings.empty()) << name << ": " << scene.warnings.front();
    EXPECT_TRUE(fit_grid(scene, 256, voxel::Adjacency::N26).has_value()) << name;
    for (const Object& object : scene.objects)
      EXPECT_EQ(object.two_sided, object.ground) << name << " " << object.name;
  }
}

TEST(ExampleScenes, TheirParametersAreKnown) {
  for (const auto& entry : std::filesystem::directory_iterator(GNOMON_SCENES)) {
    if (!is_scene_file(entry.path())) continue;
    auto parameters = scene_parameters(entry.path());
    ASSERT_TRUE(parameters.has_value()) << entry.path();
    const std::vector<std::vector<config::Assignment>> sources{std::move(*parameters)};
    EXPECT_TRUE(config::Settings::resolve(sources).has_value()) << entry.path();
  }
}

TEST(ExampleScenes, TheirModelsRestOnTheGround) {
  for (const auto& [name, scene] : all_scenes()) {
    const Object& ground = scene.objects.back();
    ASSERT_TRUE(ground.ground) << name;
    for (const Object& object : scene.objects)
      EXPECT_GE(object.bounds.min.y, ground.bounds.min.y - 1e-9) << name;
  }
}

TEST(ExampleScenes, BetweenThemTheyShowEveryKindOfLight) {
  int points = 0, spots = 0, several = 0;
  for (const auto& [name, scene] : all_scenes()) {
    points += has_light<PointLight>(scene) ? 1 : 0;
    spots += has_light<SpotLight>(scene) ? 1 : 0;
    several += scene.lights.size() > 1 ? 1 : 0;
  }
  EXPECT_GE(points, 2);
  EXPECT_GE(spots, 2);
  EXPECT_GE(several, 1);
}

TEST(ExampleScenes, AreWhatTheyAreNamedFor) {
  const auto scenes = all_scenes();
  EXPECT_EQ(scenes.at("crowd.toml").objects.size(), 51U);  // with the ground
  EXPECT_EQ(scenes.at("chain.toml").objects.size(), 22U);  // twenty links, a star, the ground
  std::size_t sharp = 0;
  for (const Object& object : scenes.at("gears.toml").objects) sharp += object.mesh.creases.empty() ? 0U : 1U;
  EXPECT_EQ(sharp, 6U);
  EXPECT_EQ(scenes.at("knot.toml").objects.size(), 2U);
  EXPECT_EQ(scenes.at("star.toml").objects[0].statistics.largest_valence, 18U);
}

}  // namespace
}  // namespace gnomon::scene
