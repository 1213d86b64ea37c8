// SPDX-License-Identifier: Apache-2.0
// gnomon sweep with the area of its points, and with the hardware within its system.
#include <gmock/gmock.h>

#include <fstream>

#include "tests/cli/sweep_fixture.hpp"

namespace gnomon {
namespace {

using test::SweepTest;
using testing::HasSubstr;

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST_F(SweepTest, AreaIsAFurtherAxisAndIsThatOfTheAreaCommand) {
  // The two planes share the projection unit's front end but for the width of addresses; error and memory are
  // two points', one of which a technique without hardware.
  spec_ = directory_.write("area.toml",
                           "scenes = [\"cube.obj\"]\n[fixed]\nres = 32\nplane = 32\n[axes]\n"
                           "technique = [\"voxel-offset\", \"plain-map\"]\noffset = [0.5, 1.0]\n");
  const nlohmann::json counts = figures("a", {"--area"});
  EXPECT_EQ(counts.at("measured"), 4);
  EXPECT_EQ(counts.at("area_points"), 2);
  const std::map<std::string, double> stored = figures_of("a", {"technique=voxel-offset", "offset=0.5"});
  EXPECT_GT(stored.at("area.luts"), 500);
  EXPECT_GT(stored.at("area.dsps"), 0);
  EXPECT_FALSE(stored.contains("area.clock_mhz")) << "nothing was placed";
  const std::map<std::string, double> map = figures_of("a", {"technique=plain-map", "offset=0.5"});
  EXPECT_FALSE(map.contains("area.luts"));
  EXPECT_GT(map.at("model.cycles.QUERY"), 500);
  EXPECT_LT(2 * map.at("model.cycles.QUERY"), map.at("software.queries"))
      << "samples are asked for no picture";

  const test::Outcome alone =
      test::run_gnomon({"area", "--seeds", "0", "--json", "--set", "technique=voxel-offset", "--set",
                        "res=32", "--set", "plane=32"});
  ASSERT_EQ(alone.status, 0) << alone.err;
  const nlohmann::json cells = nlohmann::json::parse(alone.out).at("cells");
  for (const char* kind : {"luts", "carries", "flip_flops", "dsps", "rams"})
    EXPECT_EQ(stored.at(std::string("area.") + kind), cells.at(kind)) << kind;

  const std::string page = text_of(directory_.path() / "a" / "report.html");
  EXPECT_THAT(page, HasSubstr(R"("z":"area.luts")"));
  EXPECT_THAT(text_of(directory_.path() / "a" / "points.csv"), HasSubstr(",area.luts,"));
  EXPECT_EQ(sweep("a", {"--seeds", "2"}).status, 2) << "seeds of what?";
}

TEST_F(SweepTest, TheSystemEngineIsTheSystem) {
  spec_ = directory_.write("system.toml",
                           "scenes = [\"cube.obj\"]\n[fixed]\nres = 32\nplane = 64\nsystem_hardware = "
                           "\"core\"\n[axes]\ntechnique = [\"voxel-offset\"]\n");
  EXPECT_EQ(figures("a", {"--engine", "system"}).at("measured"), 1);
  const std::map<std::string, double> stored = figures_of("a", {"technique=voxel-offset"});
  EXPECT_GT(stored.at("compare.words"), 1000);
  EXPECT_EQ(stored.at("compare.differing"), 0);
  EXPECT_GT(stored.at("system.cycles"), stored.at("rtl.cycles"));
  EXPECT_FALSE(stored.contains("confirm.cycle_error"))
      << "the units behind another front end are not predicted";
  const test::Outcome golden = sweep("a");
  EXPECT_EQ(golden.status, 2);
  EXPECT_THAT(golden.err, HasSubstr("holds the results of another specification"));
}

}  // namespace
}  // namespace gnomon
