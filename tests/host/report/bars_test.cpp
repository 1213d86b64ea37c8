// SPDX-License-Identifier: Apache-2.0
// Bars as SVG.
#include "host/report/bars.hpp"

#include <gmock/gmock.h>

#include <vector>

namespace gnomon::report {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Bars, SegmentsFollowEachOther) {
  const std::vector<Segment> segments{
      {"c-busy", "busy", 30}, {"c-hazard", "hazard", 0}, {"c-idle", "idle", 20}};
  const std::string svg = stacked_bar(segments, 100, "pass");
  EXPECT_THAT(svg, HasSubstr(R"(class="c-busy" x="0.00" y="0" width="300.00")"));
  EXPECT_THAT(svg, HasSubstr(R"(class="c-idle" x="300.00" y="0" width="200.00")"));
  EXPECT_THAT(svg, Not(HasSubstr("c-hazard"))) << "nothing is drawn for nothing";
}

TEST(Bars, TheSmallestPieceIsSeenAndStaysInside) {
  const std::vector<Segment> segments{{"c-busy", "", 1e9}, {"c-hazard", "", 1}};
  EXPECT_THAT(stacked_bar(segments, 1e9 + 1, ""),
              HasSubstr(R"(class="c-hazard" x="999.00" y="0" width="1.00")"));
}

TEST(Bars, TextIsEscaped) {
  EXPECT_THAT(waterfall_bar({"c-stage", "a<b & \"c\"", 1}, 0, 1, "<i>"),
              HasSubstr("a&lt;b &amp; &quot;c&quot;"));
  EXPECT_THAT(waterfall_bar({"c-stage", "", 1}, 0, 1, "<i>"), HasSubstr(R"(aria-label="&lt;i&gt;")"));
}

TEST(Bars, AnEmptyWholeDrawsNothing) {
  EXPECT_THAT(waterfall_bar({"c", "", 0}, 0, 0, ""), Not(HasSubstr("rect")));
}

}  // namespace
}  // namespace gnomon::report
