// SPDX-License-Identifier: Apache-2.0
// Points and their keys.
#include "host/sweep/points.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "host/sweep/key.hpp"
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
