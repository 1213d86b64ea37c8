// SPDX-License-Identifier: Apache-2.0
// Parameters: their values, their ranges, who wins.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <set>

#include "host/config/nearest.hpp"
#include "host/config/settings.hpp"

namespace gnomon::config {
namespace {

using testing::HasSubstr;

TEST(EditDistance, CountsEveryKindOfSlip) {
  EXPECT_EQ(edit_distance("", ""), 0U);
  EXPECT_EQ(edit_distance("res", "res"), 0U);
  EXPECT_EQ(edit_distance("res", "re"), 1U);
  EXPECT_EQ(edit_distance("res", "rest"), 1U);
  EXPECT_EQ(edit_distance("res", "rez"), 1U);
  EXPECT_EQ(edit_distance("res", "rse"), 1U);
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("plane", "planet"), 1U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
}

TEST(EditDistance, IsSymmetricAndBoundedByTheLongerWord) {
  rc::check("symmetry and bounds", [](const std::string& a, const std::string& b) {
    RC_ASSERT(edit_distance(a, b) == edit_distance(b, a));
    RC_ASSERT(edit_distance(a, b) <= std::max(a.size(), b.size()));
    RC_ASSERT((edit_distance(a, b) == 0) == (a == b));
  });
}

TEST(Suggestion, NamesTheNearestOrAll) {
  const std::vector<std::string_view> known{"res", "plane", "pitch"};
  EXPECT_EQ(suggestion("plain", known), "did you mean 'plane'?");
  EXPECT_EQ(suggestion("xyzzy", known), "expected one of res, plane, pitch");
}

TEST(Registry, IsSound) {
  std::set<std::string_view> keys;
  for (const Parameter& p : parameters()) {
    SCOPED_TRACE(p.key);
    EXPECT_TRUE(keys.insert(p.key).second);
    EXPECT_FALSE(p.help.empty());
    EXPECT_FALSE(p.range().empty());
    // Every default can be written, and read back as it was.
    const Result<Value> again = p.parse(to_text(p.preset));
    ASSERT_TRUE(again.has_value()) << again.error().message;
    EXPECT_TRUE(*again == p.preset);
  }
  for (const char* key : {"res", "adjacency", "plane", "frac_bits", "slope_bits", "frags", "depth_bits",
                          "technique", "surface", "ground", "light"}) {
    EXPECT_TRUE(keys.contains(key)) << key;
  }
}

std::string refusal(std::string_view key, std::string_view text) {
  const Result<const Parameter*> parameter = find_parameter(key);
  if (!parameter) return parameter.error().message;
  const Result<Value> value = (*parameter)->parse(text);
  return value ? "" : value.error().message;
}

TEST(Parse, RefusesWhatIsOutOfRange) {
  EXPECT_EQ(refusal("res", "9"), "res=9 is out of range 16..2048");
  EXPECT_EQ(refusal("res", "2049"), "res=2049 is out of range 16..2048");
  EXPECT_EQ(refusal("res", "99999999999999999999"), "res=99999999999999999999 is out of range 16..2048");
  EXPECT_EQ(refusal("res", "16"), "");
  EXPECT_EQ(refusal("res", "2048"), "");
  EXPECT_EQ(refusal("res", "64.5"), "res=64.5 is not an integer");
  EXPECT_EQ(refusal("res", ""), "res= is not an integer");
  EXPECT_EQ(refusal("adjacency", "8"), "adjacency=8 is out of range 6 | 18 | 26");
  EXPECT_EQ(refusal("plane", "300"),
            "plane=300 is out of range 0 | 16 | 32 | 64 | 128 | 256 | 512 | 1024 | 2048 | 4096");
  EXPECT_EQ(refusal("pitch", "0.1"), "pitch=0.1 is out of range 0.25..16");
  EXPECT_EQ(refusal("pitch", "nan"), "pitch=nan is not a finite number");
  EXPECT_EQ(refusal("ground", "yes"), "ground=yes is unknown or not in this build, expected on | off");
}

TEST(Parse, ReadsVectors) {
  const Parameter& light = **find_parameter("light");
  const std::array<double, 3> expected{1, -2.5, 0};
  for (const char* text : {"1,-2.5,0", "1 -2.5 0", "1, -2.5, 0", " 1,-2.5,0 "}) {
    EXPECT_TRUE((std::get<std::array<double, 3>>(*light.parse(text)) == expected)) << text;
  }
  EXPECT_THAT(refusal("light", "1,2"), HasSubstr("has 2 numbers, expected three"));
  EXPECT_THAT(refusal("light", "1,2,3,4"), HasSubstr("has 4 numbers"));
  EXPECT_THAT(refusal("light", "0,0,0"), HasSubstr("no direction"));
  EXPECT_THAT(refusal("light", "1,x,3"), HasSubstr("not a finite number"));
  EXPECT_THAT(refusal("light", "inf,0,0"), HasSubstr("not a finite number"));
}

TEST(Resolve, ASubcommandsOwnDefaultStays) {
  const std::vector<std::vector<Assignment>> sources{{{"ground", "off", "default"}}, {}};
  const auto settings = Settings::resolve(sources);
  ASSERT_TRUE(settings);
  EXPECT_FALSE(settings->is_on("ground"));
}

TEST(Find, NamesTheNearestKey) {
  EXPECT_EQ(refusal("rse", "1"), "unknown key 'rse', did you mean 'res'?");
  EXPECT_EQ(refusal("depth_bit", "1"), "unknown key 'depth_bit', did you mean 'depth_bits'?");
  EXPECT_THAT(refusal("technique", "ray-tracing"), HasSubstr("not in this build"));
}

TEST(Parse, AListHoldsEachWordOnce) {
  EXPECT_EQ(split("a,b,"), (std::vector<std::string_view>{"a", "b", ""}));
  EXPECT_THAT(refusal("technique", "slb,ray-tracing"), HasSubstr("technique=ray-tracing is unknown"));
  EXPECT_THAT(refusal("technique", "slb,"), HasSubstr("technique= is unknown"));
  EXPECT_THAT(refusal("technique", "slb,slb"), HasSubstr("names slb twice"));
  const std::vector<std::vector<Assignment>> sources{{{"technique", "slb,voxel-offset", "command line"}}};
  const auto settings = Settings::resolve(sources);
  ASSERT_TRUE(settings);
  EXPECT_EQ(settings->words("technique"), (std::vector<std::string>{"slb", "voxel-offset"}));
}

TEST(Settings, StrongerSourcesWin) {
  const std::vector<Assignment> file{
      {"res", "64", "s.toml:1"}, {"pitch", "2", "s.toml:2"}, {"margin", "1", "s.toml:3"}};
  const std::vector<Assignment> environment{{"res", "128", "environment"}, {"pitch", "3", "environment"}};
  const std::vector<Assignment> flags{{"res", "32", "command line"}, {"res", "256", "command line"}};
  const std::vector<std::vector<Assignment>> all{file, environment, flags};
  const Settings settings = Settings::resolve(all).value();
  EXPECT_EQ(settings.integer("res"), 256);
  EXPECT_EQ(settings.entry("res").origin, "command line");
  EXPECT_EQ(settings.number("pitch"), 3);
  EXPECT_EQ(settings.number("margin"), 1);
  EXPECT_EQ(settings.entry("margin").origin, "s.toml:3");
  EXPECT_EQ(settings.entry("depth_bits").origin, "default");
  EXPECT_THAT(settings.as_flags(), testing::ElementsAre("--set", "pitch=3", "--set", "margin=1"));
}

TEST(Settings, AChoicePresetsWhatNobodySets) {
  const auto with = [](const std::vector<Assignment>& assignments) {
    return Settings::resolve(std::vector<std::vector<Assignment>>{assignments}).value();
  };
  const Assignment slb4{"slb_preset", "slb4", "command line"};
  EXPECT_EQ(with({}).integer("frac_bits"), 7);
  const Settings both = with({slb4});
  EXPECT_EQ(both.integer("frac_bits"), 4);
  EXPECT_EQ(both.integer("slope_bits"), 4);
  EXPECT_EQ(both.entry("slope_bits").origin, "slb_preset=slb4");
  EXPECT_THAT(both.as_flags(), testing::ElementsAre("--set", "slb_preset=slb4"));
  // A key that is set keeps its value, be it stronger or weaker than the preset, and also where it says what
  // is the default without it.
  const Settings one = with({{"slope_bits", "7", "scene.toml:2"}, slb4});
  EXPECT_EQ(one.integer("frac_bits"), 4);
  EXPECT_EQ(one.integer("slope_bits"), 7);
  EXPECT_THAT(one.as_flags(), testing::ElementsAre("--set", "slb_preset=slb4", "--set", "slope_bits=7"));
}

TEST(Registry, ImpliedDefaultsAreLegal) {
  int implied = 0;
  for (const Parameter& choice : parameters()) {
    for (const Implied& each : choice.implies) {
      EXPECT_TRUE(choice.parse(each.word).has_value()) << choice.key;
      EXPECT_TRUE((*find_parameter(each.key))->parse(to_text(each.preset)).has_value()) << each.key;
      ++implied;
    }
  }
  EXPECT_EQ(implied, 2);
}

TEST(Settings, ErrorsNameTheirOrigin) {
  const std::vector<std::vector<Assignment>> range{{{"res", "9", "scene.toml:7"}}};
  EXPECT_EQ(Settings::resolve(range).error().message, "scene.toml:7: error: res=9 is out of range 16..2048");
  const std::vector<std::vector<Assignment>> unknown{{{"ress", "9", "command line"}}};
  EXPECT_EQ(Settings::resolve(unknown).error().message,
            "command line: error: unknown key 'ress', did you mean 'res'?");
}

TEST(Settings, TakesTheEnvironment) {
  const std::vector<std::string> environment{"HOME=/root", "GNOMON_SET_DEPTH_BITS=16", "GNOMON_SET_REZ=3",
                                             "GNOMON_CACHE_DIR=/x"};
  const std::vector<Assignment> found = environment_assignments(environment);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].key, "depth_bits");
  EXPECT_EQ(found[0].text, "16");
  EXPECT_EQ(found[1].key, "rez");
  EXPECT_EQ(found[1].origin, "environment GNOMON_SET_REZ");
  EXPECT_EQ((*find_parameter("depth_bits"))->environment(), "GNOMON_SET_DEPTH_BITS");
}

TEST(SetFlag, NeedsKeyAndValue) {
  const Assignment assignment = parse_set_flag("light=1,2,3").value();
  EXPECT_EQ(assignment.key, "light");
  EXPECT_EQ(assignment.text, "1,2,3");
  EXPECT_FALSE(parse_set_flag("res").has_value());
  EXPECT_FALSE(parse_set_flag("=3").has_value());
}

}  // namespace
}  // namespace gnomon::config
