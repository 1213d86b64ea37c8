// SPDX-License-Identifier: Apache-2.0
// Cells and clocks as figures of a point, and what the front makes of them.
#include "host/sweep/area_figures.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/sweep/figures.hpp"

namespace gnomon::sweep {
namespace {

using testing::ElementsAre;

area::UnitEstimate unit(std::optional<area::Clock> clock) {
  return {{"unit", 3, {}}, {100, 20, 50, 2, 1}, std::move(clock)};
}

TEST(AreaFigures, AreCellsAlonePlacedOrNot) {
  area::Area area;
  area.add(unit(std::nullopt));
  const std::map<std::string, double> cells{
      {"area.luts", 300}, {"area.carries", 60}, {"area.flip_flops", 150}, {"area.dsps", 6}, {"area.rams", 3}};
  EXPECT_EQ(area_figures(area, 1000), cells);
  area::Area too_large;
  too_large.add(unit(area::Clock{{}, 9000, 7680}));
  EXPECT_EQ(area_figures(too_large, 1000), cells) << "no clock where a unit does not fit";
}

TEST(AreaFigures, AClockMakesCyclesATime) {
  area::Area area;
  area.add(unit(area::Clock{{40, 50, 60}, 100, 7680}));
  auto figures = area_figures(area, 1e6);
  EXPECT_EQ(figures.at("area.clock_mhz"), 50);
  EXPECT_EQ(figures.at("area.period_ns"), 20);
  EXPECT_DOUBLE_EQ(figures.at("area.seconds"), 0.02);
  figures = area_figures(area, std::nullopt);
  EXPECT_EQ(figures.at("area.clock_mhz"), 50);
  EXPECT_FALSE(figures.contains("area.seconds"));
}

Row row(double error, double bits, std::optional<double> luts) {
  Row row;
  row.scene = "cup.toml";
  row.configuration = "{}";
  row.figures = {{"errors.fixed.border_voxels", error}, {"memory.format_bits", bits}};
  if (luts) row.figures.emplace("area.luts", *luts);
  return row;
}

TEST(OnFront, AreaIsAThirdAxisWhereAnyPointHasOne) {
  EXPECT_THAT(on_front({row(1, 1, std::nullopt), row(1, 2, std::nullopt)}), ElementsAre(true, false));
  EXPECT_THAT(on_front({row(1, 1, 200), row(1, 2, 100), row(1, 3, 100)}), ElementsAre(true, true, false));
  EXPECT_THAT(on_front({row(1, 1, 200), row(1, 2, std::nullopt)}), ElementsAre(true, false));
}

}  // namespace
}  // namespace gnomon::sweep
