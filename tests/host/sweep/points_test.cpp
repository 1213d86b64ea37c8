// SPDX-License-Identifier: Apache-2.0
// Points and their keys.
#include "host/sweep/points.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "host/sweep/key.hpp"
#include "host/sweep/task.hpp"
#include "tests/host/scene/files.hpp"

namespace gnomon::sweep {
namespace {

using testing::HasSubstr;

Spec widths() {
  Spec spec;
  spec.name = "widths";
  spec.scenes = {"a.obj", "b.obj"};
  spec.fixed = {{"technique", "slb"}};
  spec.axes = {{"frac_bits", {"3", "4", "5"}}, {"slope_bits", {"3", "4", "5"}}};
  return spec;
}

const std::vector<std::vector<config::Assignment>> kNoParameters(2);

TEST(Points, AreScenesTimesCombinations) {
  const auto points = expand(widths(), kNoParameters);
  ASSERT_TRUE(points);
  ASSERT_EQ(points->size(), 18U);
  EXPECT_EQ((*points)[0].scene, 0U);
  EXPECT_EQ((*points)[9].scene, 1U);
  EXPECT_EQ((*points)[1].settings.integer("frac_bits"), 3);
  EXPECT_EQ((*points)[1].settings.integer("slope_bits"), 4);
  for (const Point& point : *points) EXPECT_EQ(point.settings.word("technique"), "slb");
}

TEST(Points, HoldTheConstraints) {
  Spec spec = widths();
  spec.constraints = {"slope_bits >= frac_bits"};
  const auto points = expand(spec, kNoParameters);
  ASSERT_TRUE(points);
  EXPECT_EQ(points->size(), 12U);
  spec.constraints.emplace_back("slope_bits < frac_bits");
  const auto none = expand(spec, kNoParameters);
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().message, HasSubstr("no combination"));
}

TEST(Points, ListedOnesOverrideWhatIsFixedAndRepetitionsAreMeasuredOnce) {
  Spec spec = widths();
  spec.list = {{{"technique", "voxel-offset"}}, {{"frac_bits", "3"}, {"slope_bits", "3"}}};
  const auto points = expand(spec, kNoParameters);
  ASSERT_TRUE(points);
  EXPECT_EQ(points->size(), 20U);
  EXPECT_EQ((*points)[9].settings.word("technique"), "voxel-offset");
}

TEST(Points, SceneFilesParametersAreWeaker) {
  Spec spec = widths();
  const std::vector<std::vector<config::Assignment>> parameters{
      {{"res", "64", "a.toml"}, {"frac_bits", "8", "a.toml"}}, {}};
  const auto points = expand(spec, parameters);
  ASSERT_TRUE(points);
  EXPECT_EQ((*points)[0].settings.integer("res"), 64);
  EXPECT_EQ((*points)[0].settings.integer("frac_bits"), 3);
  EXPECT_EQ((*points)[9].settings.integer("res"), 256);
}

TEST(Points, TooManyAreRefused) {
  Spec spec = widths();
  std::vector<std::string> many;
  many.reserve(4000);
  for (int i = 0; i < 4000; ++i) many.push_back(std::to_string(i));
  spec.axes = {{"seed", many}, {"threads", many}};
  const auto points = expand(spec, kNoParameters);
  ASSERT_FALSE(points);
  EXPECT_THAT(points.error().message, HasSubstr("expected a [sample]"));
}

TEST(Keys, TellPointsApartAndNothingElse) {
  const auto points = expand(widths(), kNoParameters);
  ASSERT_TRUE(points);
  std::set<std::string> keys;
  for (const Point& point : *points)
    keys.insert(point_key(point.scene == 0 ? "s" : "t", point.settings, "1"));
  EXPECT_EQ(keys.size(), points->size());

  const auto settings = [](const std::vector<config::Assignment>& assignments) {
    const std::vector<std::vector<config::Assignment>> sources{assignments};
    return *config::Settings::resolve(sources);
  };
  EXPECT_EQ(point_key("s", settings({}), "1"), point_key("s", settings({{"threads", "7", "t"}}), "1"));
  EXPECT_NE(point_key("s", settings({}), "1"), point_key("s", settings({{"res", "64", "t"}}), "1"));
  EXPECT_NE(point_key("s", settings({}), "1"), point_key("s", settings({}), "2"));
  EXPECT_EQ(point_key("s", settings({}), "1").size(), 32U);
}

/// Of some parameters a default that is given is not the same as none; the command must say so too.
TEST(Keys, KnowWhatWasGiven) {
  const auto settings = [](std::vector<config::Assignment> assignments) {
    const std::vector<std::vector<config::Assignment>> sources{std::move(assignments)};
    return *config::Settings::resolve(sources);
  };
  const auto key = [&](std::vector<config::Assignment> assignments) {
    return point_key("s", settings(std::move(assignments)), "1");
  };
  const std::string none = key({});
  EXPECT_NE(key({{"memory_latency", "20", "t"}}), none) << "cycles of the system";
  EXPECT_EQ(key({{"memory_latency", "20", "t"}}), key({{"cache_kib", "0", "t"}}));
  EXPECT_EQ(key({{"cache_kib", "8", "t"}}), key({{"cache_kib", "8", "t"}, {"memory_latency", "20", "t"}}));
  EXPECT_EQ(key({{"plane", "0", "t"}, {"pitch", "1.4", "t"}}), none);
  const config::Assignment mode{"technique", "voxel-topology", "t"};
  EXPECT_NE(key({mode, {"pitch", "1.4", "t"}}), key({mode}));
  const std::string light = config::to_text(settings({}).entry("light").value);
  EXPECT_NE(key({{"light", light, "t"}}), none) << "it replaces the scene's own";
  Task task;
  task.scene = "cup.toml";
  task.point.settings = settings({{"cache_kib", "0", "t"}, {"light", light, "t"}});
  EXPECT_EQ(row_of(task).flags, "cup.toml  --set light=" + light + " --set cache_kib=0");
}

TEST(Keys, ScenesAreKnownByContent) {
  const test::TempDir folder;
  const std::vector<std::filesystem::path> a{folder.write("a", "one"), folder.write("b", "two")};
  const std::vector<std::filesystem::path> b{folder.write("c", "one"), folder.write("d", "two")};
  EXPECT_EQ(scene_hash(a), scene_hash(b));
  folder.write("d", "three");
  EXPECT_NE(scene_hash(a), scene_hash(b));
  const std::vector<std::filesystem::path> none{folder.path() / "none"};
  EXPECT_THROW(scene_hash(none), std::runtime_error);
}

}  // namespace
}  // namespace gnomon::sweep
