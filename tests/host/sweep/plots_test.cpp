// SPDX-License-Identifier: Apache-2.0
// Plots as files: what is drawn, and that it is SVG and PNG.
#include "host/sweep/plots.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "host/sweep/chart.hpp"
#include "tests/host/scene/files.hpp"

namespace gnomon::sweep {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

std::size_t occurrences(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

Row point(int f, int s, double error) {
  Row row;
  row.key = std::to_string(f) + std::to_string(s);
  row.scene = "cup <1>.toml";
  row.configuration = R"({"technique":"slb","frac_bits":)" + std::to_string(f) + R"(,"slope_bits":)" +
                      std::to_string(s) + "}";
  row.figures = {{"errors.fixed.border_voxels", error},
                 {"errors.fixed.ground.boundary_displacement", error},
                 {"memory.format_bits", 1000.0 * (f + s)}};
  return row;
}

std::vector<Row> rows() {
  return {point(3, 4, 0.16), point(4, 4, 0.08), point(5, 4, 0.04), point(5, 7, 0.05)};
}

TEST(Scale, IsLogarithmicWhereValuesDifferByMuch) {
  const Scale narrow({1, 8}), wide({1, 1000}), zero({0, 1000}), whole({3, 4, 9}, Scale::Kind::Whole),
      forced({1, 2}, Scale::Kind::Logarithmic);
  EXPECT_FALSE(narrow.logarithmic());
  EXPECT_TRUE(wide.logarithmic());
  EXPECT_FALSE(zero.logarithmic());
  EXPECT_TRUE(forced.logarithmic());
  EXPECT_THAT(wide.ticks(), ElementsAre(1, 10, 100, 1000));
  EXPECT_THAT(whole.ticks(), ElementsAre(3, 4, 5, 6, 7, 8, 9));
  EXPECT_NEAR(wide.at(std::sqrt(1000.0)), 0.5, 1e-12);
  EXPECT_GT(zero.at(0), 0);
  EXPECT_LT(zero.at(1000), 1);
  EXPECT_NEAR(Scale({2, 2}).at(2), 0.5, 1e-12);
}

TEST(ShortNumber, HasFourDigitsAndAPrefix) {
  EXPECT_EQ(short_number(1234567), "1.235 M");
  EXPECT_EQ(short_number(2000), "2 k");
  EXPECT_EQ(short_number(0.0125), "0.0125");
}

TEST(Plots, DrawEveryPointAndRingThePublished) {
  const std::vector<Plot> plots = plots_of(rows());
  ASSERT_THAT(plots, SizeIs(3));
  EXPECT_EQ(plots[0].name, "cup <1>-error-memory-format_bits");
  EXPECT_EQ(plots[1].name, "cup <1>-error-frac_bits");
  EXPECT_EQ(plots[2].name, "cup <1>-error-slope_bits");
  const std::string& scatter = plots[0].svg;
  // Four points, the ring, three lines of the legend.
  EXPECT_EQ(occurrences(scatter, "<circle"), 4U + 1 + 3);
  EXPECT_EQ(occurrences(scatter, "r=\"9\""), 1U);
  EXPECT_EQ(occurrences(scatter, "opacity"), 1U) << "5/7 costs more than 5/4 and errs more";
  EXPECT_THAT(scatter, HasSubstr("ringed: published"));
  EXPECT_THAT(scatter, HasSubstr("cup &lt;1>.toml: error against memory, bits of the formats"));
  EXPECT_THAT(plots[1].svg, HasSubstr("stroke-dasharray"));
  EXPECT_THAT(plots[1].svg, HasSubstr("slope_bits 7"));
  EXPECT_THAT(plots[2].svg, Not(HasSubstr("stroke-dasharray")));
  for (const Plot& plot : plots) EXPECT_THAT(plot.svg, Not(HasSubstr("nan")));
}

TEST(Plots, RingNothingWhereAllIsPublished) {
  std::vector<Row> published{point(4, 4, 0.08), point(7, 7, 0.02)};
  EXPECT_THAT(plots_of(published)[0].svg, Not(HasSubstr("ringed")));
  for (Row& row : published) row.configuration = R"({"technique":"raycast"})";
  published.push_back(point(4, 4, 0.08));
  const std::string svg = plots_of(published)[0].svg;
  EXPECT_THAT(svg, Not(HasSubstr("r=\"9\"")));
  EXPECT_THAT(svg, HasSubstr(">raycast<")) << "a technique needs no key";
}

TEST(Plots, OfNothingAreNone) {
  EXPECT_THAT(plots_of({}), SizeIs(0));
  std::vector<Row> failed = rows();
  for (Row& row : failed) row.error = "too wide";
  EXPECT_THAT(plots_of(failed), SizeIs(0));
}

TEST(Plots, AreWrittenAsSvgAndPng) {
  const test::TempDir folder;
  const auto drawn = write_plots({{"a", plots_of(rows())[0].svg}}, folder.path() / "plots");
  ASSERT_TRUE(drawn) << drawn.error().message;
  ASSERT_TRUE(*drawn) << "rsvg-convert is missing: Debian package librsvg2-bin";
  std::ifstream png(folder.path() / "plots" / "a.png", std::ios::binary);
  std::string magic(8, ' ');
  png.read(magic.data(), 8);
  EXPECT_EQ(magic, "\x89PNG\r\n\x1a\n");
  EXPECT_GT(std::filesystem::file_size(folder.path() / "plots" / "a.svg"), 1000U);
  EXPECT_FALSE(write_plots({{"a", ""}}, "/proc/none/plots"));
  const auto broken = write_plots({{"b", "no picture"}}, folder.path() / "plots");
  ASSERT_TRUE(broken);
  EXPECT_FALSE(*broken);
}

}  // namespace
}  // namespace gnomon::sweep
