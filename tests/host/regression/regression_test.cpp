// SPDX-License-Identifier: Apache-2.0
// Baselines: what is taken from metrics, what counts as a difference, and which files are refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <gnomon/golden/command.hpp>
#include <string>
#include <utility>
#include <vector>

#include "host/regression/baseline.hpp"
#include "host/regression/difference.hpp"
#include "host/regression/result_hashes.hpp"
#include "tests/host/scene/files.hpp"

namespace gnomon::regression {
namespace {

using Json = nlohmann::ordered_json;
using testing::ElementsAre;
using testing::HasSubstr;

Json technique(const std::string& name) {
  return Json::parse(R"({"technique": ")" + name + R"(", "compare": {"words": 1234},
    "cycles": {"total": 30, "by_pass": {"DRAW": {"total": 10, "causes": {"BUSY": 10}}, "FILL": {"total": 20}, "IDLE": {"total": 1}}},
    "errors": {"fixed": {"all": {"share": 0.25}, "unambiguous": {"share": 0.125}, "samples": {"share": null},
                         "boundary_displacement": 0.5}}})");
}

Json one_technique() {
  Json metrics = technique("slb");
  metrics["techniques"] = Json::array();
  return metrics;
}

const std::vector<std::string> kHash{"cafe"};

TEST(Figures, HoldWordsCyclesAndErrorsOfATechnique) {
  const Figures figures = figures_of(one_technique(), kHash);
  EXPECT_EQ(figures.size(), 8u);
  EXPECT_EQ(figures.at("slb.words"), 1234);
  EXPECT_EQ(figures.at("slb.results"), "cafe");
  EXPECT_EQ(figures.at("slb.cycles.DRAW"), 10);
  EXPECT_EQ(figures.at("slb.cycles.FILL"), 20);
  EXPECT_EQ(figures.at("slb.error.mislabelled"), 0.25);
  EXPECT_EQ(figures.at("slb.error.mislabelled_unambiguous"), 0.125);
  EXPECT_TRUE(figures.at("slb.error.mislabelled_samples").is_null());
  EXPECT_EQ(figures.at("slb.error.displacement"), 0.5);
}

TEST(Figures, HoldEveryTechniqueWithItsOwnHash) {
  Json metrics = one_technique();
  metrics["techniques"] = {technique("voxel-offset"), technique("slb")};
  metrics["techniques"][0]["cycles"] = nullptr;  // as without hardware
  const Figures figures = figures_of(metrics, std::vector<std::string>{"aa", "bb"});
  EXPECT_EQ(figures.at("voxel-offset.results"), "aa");
  EXPECT_EQ(figures.at("slb.results"), "bb");
  EXPECT_FALSE(figures.contains("voxel-offset.cycles.FILL"));
  EXPECT_THROW(figures_of(metrics, kHash), std::invalid_argument);
}

TEST(Compare, FindsNothingBetweenEquals) {
  const Figures figures = figures_of(one_technique(), kHash);
  const Comparison comparison = compare(figures, figures);
  EXPECT_EQ(comparison.compared, 8u);
  EXPECT_TRUE(comparison.differences.empty());
}

TEST(Compare, FindsWhatGrewAndWhatShrank) {
  const Figures was = figures_of(one_technique(), kHash);
  for (const auto& [name, value] :
       std::vector<std::pair<std::string, nlohmann::json>>{{"slb.cycles.FILL", 19},
                                                           {"slb.cycles.FILL", 21},
                                                           {"slb.error.displacement", 0.499},
                                                           {"slb.error.displacement", nullptr},
                                                           {"slb.results", "beef"},
                                                           {"slb.words", 0}}) {
    Figures is = was;
    is[name] = value;
    const Comparison comparison = compare(was, is);
    ASSERT_EQ(comparison.differences.size(), 1u) << name;
    EXPECT_EQ(comparison.differences.front().figure, name);
    EXPECT_EQ(comparison.differences.front().was, was.at(name));
    EXPECT_EQ(comparison.differences.front().is, value);
  }
}

TEST(Compare, FindsFiguresThatOnlyOneSideHas) {
  const Figures was = figures_of(one_technique(), kHash);
  Figures is = was;
  is.erase("slb.error.mislabelled_samples");  // null is a value, too
  is["slb.cycles.QUERY"] = 7;
  std::vector<std::string> lines;
  for (const Difference& difference : compare(was, is).differences) lines.push_back(to_text(difference));
  EXPECT_THAT(lines, ElementsAre("slb.cycles.QUERY: was nothing, is 7",
                                 "slb.error.mislabelled_samples: was nothing, is nothing"));
  EXPECT_EQ(compare(was, is).compared, 9u);
}

TEST(Compare, TakesTheLastDigitsOfNumbersForNoise) {
  const Figures was{{"error", 0.1}}, is{{"error", 0.1 * (1 + 1e-12)}}, other{{"error", 0.1 * (1 + 1e-8)}};
  EXPECT_TRUE(compare(was, is).differences.empty());
  EXPECT_EQ(compare(was, other).differences.size(), 1u);
}

TEST(BaselineFile, IsReadAsWritten) {
  Baseline baseline;
  baseline.settings = {"res=64", "technique=slb"};
  baseline.put({"b.toml", "1234", figures_of(one_technique(), kHash)});
  baseline.put({"a.toml", "5678", {{"slb.words", 3}}});
  baseline.put({"b.toml", "9999", figures_of(one_technique(), kHash)});
  const test::TempDir directory;
  const auto file = directory.write("baseline.json", to_text(baseline));
  const Result<Baseline> read = read_baseline(file);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->settings, baseline.settings);
  ASSERT_EQ(read->scenes.size(), 2u);
  EXPECT_EQ(read->scenes[0].scene, "b.toml");
  EXPECT_EQ(read->scenes[0].configuration, "9999");
  EXPECT_TRUE(compare(read->scenes[0].figures, baseline.scenes[0].figures).differences.empty());
  EXPECT_EQ(read->find("a.toml")->figures.size(), 1u);
  EXPECT_EQ(read->find("c.toml"), nullptr);
}

TEST(BaselineFile, IsRefusedInOneLineIfItIsNone) {
  const test::TempDir directory;
  for (
      const std::string text :
      {"", "[]", "{}", R"({"baseline_format": 2})", R"({"baseline_format": 1, "settings": 3, "scenes": {}})",
       R"({"baseline_format": 1, "settings": [], "scenes": {"a": {"configuration": "1", "figures": {"x": []}}}})"}) {
    const Result<Baseline> read = read_baseline(directory.write("bad.json", text));
    ASSERT_FALSE(read) << text;
    EXPECT_THAT(read.error().message, HasSubstr("bad.json: error: "));
    EXPECT_EQ(read.error().message.find('\n'), std::string::npos);
  }
  EXPECT_FALSE(read_baseline(directory.path() / "missing.json"));
}

TEST(ResultHashes, AreOfTheWordsOfEachEngine) {
  ResultHashes hashes;
  const auto factory = hashes.factory();
  const golden::HardwareConfig config;
  std::vector<golden::Word> words;
  const auto fence = [](std::uint32_t tag) {
    return std::vector<golden::Word>{
        golden::encode(golden::Header{static_cast<std::uint8_t>(golden::Op::Fence), 0, 0, tag})};
  };
  for (const std::uint32_t tag : {7u, 7u, 8u}) {
    const auto engine = factory(config);
    engine->submit(fence(tag));
    engine->drain(
        [&](std::span<const golden::Word> some) { words.insert(words.end(), some.begin(), some.end()); });
  }
  EXPECT_EQ(words.size(), 3u);
  const std::vector<std::string> all = hashes.hashes();
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0], all[1]);
  EXPECT_NE(all[0], all[2]);
}

}  // namespace
}  // namespace gnomon::regression
