// SPDX-License-Identifier: Apache-2.0
// gnomon slb: answers, figures, messages, report.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "host/render/png_file.hpp"
#include "host/slb/polygon_reference.hpp"
#include "tests/cli/run_gnomon.hpp"
#include "tests/host/scene/files.hpp"

namespace gnomon {
namespace {

namespace fs = std::filesystem;
using test::Outcome;
using test::run_gnomon;
using testing::AllOf;
using testing::HasSubstr;

constexpr const char* kSquare = R"({"objects":[{"depth":0.25,"loops":[[[10,10],[50,10],[50,50],[10,50]]]}]})";

std::string content(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

class SlbTest : public testing::Test {
 protected:
  fs::path file(const std::string& name) const { return directory_.path() / name; }
  Outcome slb(const std::string& loops, const std::string& queries,
              std::vector<std::string> more = {}) const {
    directory_.write("l.json", loops);
    directory_.write("q.csv", queries);
    more.insert(more.begin(), {"slb", "--loops", file("l.json").string(), "--queries", file("q.csv").string(),
                               "-o", file("r.csv").string()});
    return run_gnomon(more);
  }
  /// Exit status 2, one line on stderr, no answers.
  void expect_refusal(const Outcome& outcome, const std::string& words) const {
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(test::line_count(outcome.err), 1U) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(words));
    EXPECT_EQ(outcome.out, "");
    EXPECT_FALSE(fs::exists(file("r.csv")));
  }
  test::TempDir directory_;
};

TEST_F(SlbTest, AnswersARowAQuery) {
  const Outcome outcome =
      slb(kSquare,
          "20,20,1\n20,20,0.25\n9.999,20,1\n10.001,20,0.5\n49.999,49.999,0.3\n60,60,1\n-3,20,1\n200,20,1\n",
          {"--set", "plane=64"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(content(file("r.csv")), "1\n0\n0\n1\n1\n0\n0\n0\n");
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("8 queries, 3 in shadow"), HasSubstr("plane=64 frac_bits=7")));
}

/// A file of random polygons and one of queries along their borders.
struct Case {
  slb::LoopScene scene;
  std::vector<slb::Receiver> receivers;
  std::string loops, queries;
};
Case random_case(std::uint64_t seed, int queries) {
  std::mt19937_64 random(seed);
  const auto between = [&](double low, double high) {
    return low + (high - low) * std::ldexp(static_cast<double>(random() >> 11), -53);
  };
  Case made;
  nlohmann::json objects = nlohmann::json::array();
  for (const double depth : {0.5, 0.25}) {
    slb::Loop loop;
    for (int i = 0; i < 24; ++i) {
      const double angle = (i + between(0, 0.9)) / 24 * 6.283185307179586, radius = between(8, 26);
      loop.emplace_back(28 + 16 * depth + radius * std::cos(angle), 32 + radius * std::sin(angle));
    }
    nlohmann::json vertices = nlohmann::json::array();
    for (const Vec2& v : loop) vertices.push_back({v.x, v.y});
    objects.push_back({{"depth", depth}, {"loops", {vertices}}});
    made.scene.push_back({depth, {loop}});
  }
  made.loops = nlohmann::json{{"objects", objects}}.dump();
  std::ostringstream rows;
  rows.precision(17);
  for (int i = 0; i < queries; ++i) {
    const slb::Receiver r{between(0, 64), between(0, 64), between(0, 1)};
    made.receivers.push_back(r);
    rows << r.x << "," << r.y << "," << r.z << "\n";
  }
  made.queries = rows.str();
  return made;
}

TEST_F(SlbTest, AgreesWithExactPolygonsAwayFromTheBorder) {
  for (const int bits : {4, 7}) {
    const Case made = random_case(static_cast<std::uint64_t>(bits), 20000);
    const std::string width = std::to_string(bits);
    ASSERT_EQ(slb(made.loops, made.queries,
                  {"--set", "plane=64", "--set", "frac_bits=" + width, "--set", "slope_bits=" + width, "-q"})
                  .status,
              0);
    const std::string answers = content(file("r.csv"));
    ASSERT_EQ(answers.size(), 40000U);
    const slb::PolygonReference reference(made.scene, 64);
    std::size_t wrong = 0, shadows = 0;
    for (std::size_t i = 0; i < made.receivers.size(); ++i) {
      const slb::Receiver& r = made.receivers[i];
      const bool expected = reference.in_shadow({r.x, r.y}, r.z);
      shadows += expected ? 1U : 0U;
      wrong += (answers[2 * i] == '1') == expected ? 0U : 1U;
    }
    EXPECT_GT(shadows, 2000U);
    // About 400 px of border in 4096 px, off by 0.2 * 2^-F px.
    EXPECT_LT(wrong, bits == 4 ? 40U : 8U);
  }
}

TEST_F(SlbTest, PrintsFiguresAsJson) {
  const Outcome outcome =
      slb(kSquare, "20,20,1\n", {"--set", "plane=64", "--set", "slb_preset=slb4", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto figures = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(figures.at("engine"), "golden");
  EXPECT_EQ(figures.at("queries"), 1);
  EXPECT_EQ(figures.at("shadow"), 1);
  EXPECT_THAT(figures.at("configuration").get<std::string>(), HasSubstr("frac_bits=4 slope_bits=4"));
  EXPECT_EQ(figures.at("events").at("SLB_VERTICES"), 4);
  EXPECT_EQ(figures.at("overflow").at("chains_dropped"), 0);
  EXPECT_EQ(figures.at("memory").at("bits_per_pixel"), 152);
  EXPECT_EQ(figures.at("memory").at("stored_bits_per_pixel"), 256);
  EXPECT_TRUE(figures.at("cycles").empty());
  EXPECT_GT(figures.at("seconds").at("total"), 0);
  EXPECT_FALSE(figures.contains("compare"));
}

TEST_F(SlbTest, TheHardwareGivesTheSameAnswers) {
  const Case made = random_case(3, 5000);
  const std::vector<std::string> plane{"--set", "plane=64"};
  ASSERT_EQ(slb(made.loops, made.queries, plane).status, 0);
  const std::string expected = content(file("r.csv"));
  const Outcome outcome =
      slb(made.loops, made.queries, {"--set", "plane=64", "--engine", "rtl", "--json", "-q"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(content(file("r.csv")), expected);
  const auto figures = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(figures.at("engine"), "rtl");
  EXPECT_GE(figures.at("compare").at("words_compared"), 5000);
  EXPECT_EQ(figures.at("compare").at("words_differing"), 0);
  EXPECT_LE(figures.at("cycles_per_query"), 1.02);
  EXPECT_GE(figures.at("cycles_per_query"), 1);
  EXPECT_GE(figures.at("cycles").at("QUERY").at("BUSY"), 5000);
}

TEST_F(SlbTest, ADifferenceIsTold) {
  // Fine teeth: chains of one pixel follow each other closely, and this hardware forgets to forward them.
  nlohmann::json teeth = nlohmann::json::array();
  for (int i = 0; i < 80; ++i) {
    const double angle = i * 6.283185307179586 / 80, radius = i % 2 == 0 ? 4.5 : 6.5;
    teeth.push_back({8.1 + radius * std::cos(angle), 8.2 + radius * std::sin(angle)});
  }
  const std::string loops = nlohmann::json{{"objects", {{{"depth", 0.5}, {"loops", {teeth}}}}}}.dump();
  std::string queries;
  for (int row = 0; row < 64; ++row) {
    for (int column = 0; column < 64; ++column)
      queries += std::to_string(column * 0.25 + 0.1) + "," + std::to_string(row * 0.25 + 0.1) + ",1\n";
  }
  const std::vector<std::string> set{"--set", "plane=16", "--set", "slb_preset=slb4"};
  ASSERT_EQ(slb(loops, queries, set).status, 0);
  const std::string expected = content(file("r.csv"));
  std::vector<std::string> more = set;
  more.insert(more.end(), {"--engine", "rtl", "--define", "GNOMON_MUTATE_NO_FORWARDING"});
  const Outcome outcome = slb(loops, queries, more);
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("first difference: result word "), HasSubstr("4097 words compared, "),
                    HasSubstr("the answers written are golden's"), HasSubstr("reproduce: gnomon slb --loops"),
                    HasSubstr("--define GNOMON_MUTATE_NO_FORWARDING")));
  EXPECT_EQ(content(file("r.csv")), expected);
}

TEST_F(SlbTest, WarnsOfWhatCastsNothing) {
  const Outcome outcome = slb(
      R"({"objects":[{"depth":0,"loops":[[[10,10],[10,50],[50,50],[50,10]],[[1,1],[2,1],[2,2],[1,1]]]}]})",
      "20,20,1\n", {"--set", "plane=64"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(content(file("r.csv")), "0\n");
  EXPECT_THAT(
      outcome.err,
      AllOf(HasSubstr("warning: "), HasSubstr("object 0, loop 0 (objects[0].loops[0]): signed area -1600"),
            HasSubstr("loop 1 (objects[0].loops[1]): the last vertex repeats the first")));
}

TEST_F(SlbTest, RefusesBadFilesInOneLine) {
  const std::string l = file("l.json").string(), q = file("q.csv").string();
  expect_refusal(slb(R"({"objects":[{"depth":0,"loops":[[[0,0],[1,0]]]}]})", "1,1,1\n"),
                 l + ": error: object 0, loop 0 (objects[0].loops[0]): 2 vertices, expected three or more");
  // A closing vertex that would be worth a note, and a fault behind it.
  expect_refusal(slb(R"({"objects":[{"depth":0,"loops":[[[0,0],[1,0],[0,1],[0,0]],[[0,0],[500,0],[0,1]]]}]})",
                     "1,1,1\n", {"--set", "plane=64"}),
                 l + ": error: object 0, loop 1, vertex 1 (objects[0].loops[1][1]): x=500 lies outside");
  expect_refusal(
      slb(R"({"objects":[{"depth":0,"loops":[[[0,0],[NaN,0],[0,1]]]}]})", "1,1,1\n"),
      l + ":1: error: object 0, loop 0, vertex 1 (objects[0].loops[0][1]): NaN is not a finite number");
  expect_refusal(slb(kSquare, ""), q + ": error: holds no queries");
  expect_refusal(slb(kSquare, "1,1,1\n1,1\n"), q + ":2: error: 2 columns, expected three: x,y,z");
  expect_refusal(slb(kSquare, "1,1,1\n1,x,1\n"), q + ":2: error: y is 'x'");
}

TEST_F(SlbTest, RefusesBadUsageInOneLine) {
  expect_refusal(slb(kSquare, "1,1,1\n", {"--set", "plane=65"}), "plane=65 is out of range");
  expect_refusal(slb(kSquare, "1,1,1\n", {"--set", "frac_bits=2"}), "frac_bits=2 is out of range 3..8");
  expect_refusal(slb(kSquare, "1,1,1\n", {"--set", "plane=4096"}), "no hardware has these parameters");
  expect_refusal(slb(kSquare, "1,1,1\n", {"--engine", "silver"}), "--engine");
  expect_refusal(run_gnomon({"slb", "--loops", file("l.json").string()}), "slb needs --queries");
  expect_refusal(run_gnomon({"slb", "--loops", file("l.json").string(), "--queries", file("q.csv").string()}),
                 "--queries needs -o");
  expect_refusal(run_gnomon({"slb", "--loops", file("none.json").string(), "--queries",
                             file("q.csv").string(), "-o", file("r.csv").string()}),
                 "none.json: error: cannot be read");
  expect_refusal(run_gnomon({"slb", "--loops", file("l.json").string(), "--queries",
                             file("none.csv").string(), "-o", file("r.csv").string()}),
                 "none.csv: error: cannot be read");
  expect_refusal(run_gnomon({"slb", "--loops", file("l.json").string(), "--queries", file("q.csv").string(),
                             "-o", file("none/r.csv").string()}),
                 "none is not a directory");
}

TEST_F(SlbTest, FindsAPlaneThatHoldsTheLoops) {
  const Outcome outcome =
      slb(R"({"objects":[{"depth":0.25,"loops":[[[10,10],[100,10],[100,50]]]}]})", "99,20,1\n", {"--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(nlohmann::json::parse(outcome.out).at("configuration").get<std::string>(),
              HasSubstr("plane=128 "));
  EXPECT_EQ(content(file("r.csv")), "1\n");
}

TEST_F(SlbTest, WritesAReport) {
  const Case made = random_case(9, 1);
  directory_.write("l.json", made.loops);
  const fs::path report = file("report");
  const Outcome outcome = run_gnomon({"slb", "--loops", file("l.json").string(), "--report", report.string(),
                                      "--set", "plane=64", "--set", "slope_bits=8"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("report.html"));
  const auto metrics = nlohmann::json::parse(content(report / "metrics.json"));
  ASSERT_EQ(metrics.at("points").size(), 6U);
  for (const auto& point : metrics.at("points")) {
    EXPECT_EQ(point.at("slope_bits"), point.at("frac_bits").get<int>() + 1);
    EXPECT_LT(point.at("ratio"), 0.75);
    EXPECT_NEAR(point.at("plain_map").at("displacement"), 0.245, 0.03);
    EXPECT_LT(point.at("buffer").at("memory_bits"), point.at("fine_map").at("memory_bits"));
  }
  const auto picture = render::read_png(report / "detail_f7.png");
  ASSERT_TRUE(picture);
  EXPECT_EQ(picture->width, 576);
  const std::string page = content(report / "report.html");
  EXPECT_THAT(page, AllOf(HasSubstr("Error, memory, cycles"), HasSubstr("data:image/png;base64,iVBOR"),
                          HasSubstr("<svg class=\"chart\"")));
  EXPECT_EQ(page.find("{{"), std::string::npos);
  EXPECT_EQ(page.find("http://"), std::string::npos);
}

}  // namespace
}  // namespace gnomon
