// SPDX-License-Identifier: Apache-2.0
// The report and the table of a sweep.
#include "host/sweep/page.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "host/sweep/figures.hpp"

namespace gnomon::sweep {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

Row point(int f, double displacement) {
  return {"k" + std::to_string(f),
          "cup.toml",
          R"({"frac_bits":)" + std::to_string(f) + R"(,"slope_bits":7,"technique":"slb","light":"1,-1,0"})",
          "cup.toml --set frac_bits=" + std::to_string(f),
          "",
          "2026-01-01T00:00:00Z",
          {{"errors.fixed.border_voxels", displacement}, {"memory.format_bits", 1000.0 * f}},
          {}};
}

std::vector<Row> rows() {
  return {point(10, 0.01),
          point(3, 0.08),
          point(7, 0.02),
          {"k0",
           "cup.toml",
           R"({"frac_bits":99})",
           "cup.toml --set frac_bits=99",
           "<b>too wide</b>",
           "",
           {},
           {}}};
}

std::vector<Row> done() {
  std::vector<Row> rows = gnomon::sweep::rows();
  std::erase_if(rows, &Row::failed);
  return rows;
}

TEST(VariedParameters, AreThoseThatDifferNumbersAscending) {
  const std::vector<Varied> varied = varied_parameters(done());
  ASSERT_EQ(varied.size(), 1U);
  EXPECT_EQ(varied[0].key, "frac_bits");
  EXPECT_THAT(varied[0].values, ElementsAre("3", "7", "10"));
}

TEST(Csv, HasALineForEachDonePoint) {
  const std::string text = csv_table(rows());
  EXPECT_EQ(std::ranges::count(text, '\n'), 4);
  EXPECT_THAT(text,
              HasSubstr("scene,front,frac_bits,errors.fixed.border_voxels,memory.format_bits,command\n"));
  EXPECT_THAT(text, HasSubstr("cup.toml,1,3,0.08,3000,gnomon run cup.toml --set frac_bits=3\n"));
}

TEST(OnFront, IsEachScenesOwn) {
  std::vector<Row> three{point(3, 0.08), point(7, 0.09), point(7, 0.09)};
  three[2].scene = "star.toml";
  EXPECT_THAT(on_front(three), ElementsAre(true, false, true));
}

TEST(Csv, QuotesWhatNeedsIt) {
  std::vector<Row> one{point(3, 0.5), point(4, 0.5)};
  one[0].scene = "a, \"b\".obj";
  EXPECT_THAT(csv_table(one), HasSubstr("\"a, \"\"b\"\".obj\",1,3"));
}

TEST(Page, HoldsThePointsAndLoadsNothing) {
  const std::string page = sweep_page("widths & more", rows());
  EXPECT_THAT(page, HasSubstr("widths &amp; more"));
  EXPECT_THAT(page, HasSubstr("3 points measured, 1 failed"));
  EXPECT_THAT(page, HasSubstr(R"("flags":"cup.toml --set frac_bits=7","mark":true)"));
  EXPECT_THAT(page, HasSubstr(R"("flags":"cup.toml --set frac_bits=3","mark":false)"));
  EXPECT_THAT(page, HasSubstr(R"("x":"memory.format_bits")"));
  EXPECT_THAT(page, HasSubstr("uPlot"));
  EXPECT_THAT(page, HasSubstr("&lt;b&gt;too wide&lt;/b&gt;"));
  EXPECT_THAT(page, Not(HasSubstr("{{")));
  EXPECT_THAT(page, Not(HasSubstr("src=")));
  EXPECT_THAT(page, Not(HasSubstr("<link")));
}

/// Predicted cycles beside those taken, flagged points first.
TEST(Page, ShowsWhereModelAndHardwareDisagree) {
  std::vector<Row> two{point(3, 0.5), point(4, 0.4)};
  for (Row& row : two) {
    row.figures.insert({{"model.cycles", 1000}, {"rtl.cycles", 1000}, {"confirm.cycle_error", 0}});
    row.labels["confirmed"] = "agrees";
  }
  two[1].figures["rtl.cycles"] = 1021;
  two[1].figures["confirm.cycle_error"] = 0.0206;
  two[1].labels["confirmed"] = "flagged: predicted cycles are off by 2.06 %, more than 1.0 %";
  const std::string page = sweep_page("t", two);
  const std::string flagged = R"(<tr class="flagged"><td>1000</td><td>1021</td><td>2.0600 %</td>)";
  EXPECT_THAT(page, HasSubstr(flagged));
  EXPECT_LT(page.find(flagged), page.find("<tr><td>1000</td><td>1000</td><td>0.0000 %</td>"));
  EXPECT_THAT(csv_table(two), HasSubstr("confirm.cycle_error,errors"));
}

TEST(Page, NamesCannotEndItsScript) {
  std::vector<Row> one{point(3, 0.5)};
  one[0].scene = "</script><script>alert(1)";
  EXPECT_THAT(sweep_page("t", one), Not(HasSubstr("</script><script>alert")));
}

TEST(Page, OfFailuresAloneIsStillAPage) {
  std::vector<Row> failed = rows();
  std::erase_if(failed, [](const Row& row) { return !row.failed(); });
  EXPECT_THAT(sweep_page("t", failed), HasSubstr("0 points measured, 1 failed"));
}

}  // namespace
}  // namespace gnomon::sweep
