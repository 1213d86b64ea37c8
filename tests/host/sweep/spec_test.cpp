// SPDX-License-Identifier: Apache-2.0
// Specifications as people write them, and as they miswrite them.
#include "host/sweep/spec.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host/scene/files.hpp"

namespace gnomon::sweep {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class SpecFile : public testing::Test {
 protected:
  Result<Spec> read(const std::string& text) { return read_spec(folder_.write("s.toml", text)); }
  Axis axis(const std::string& line) {
    const auto spec = read("scenes = [\"a.obj\"]\n[axes]\n" + line + "\n");
    EXPECT_TRUE(spec) << spec.error().message;
    return spec ? spec->axes.front() : Axis{};
  }
  std::string refusal(const std::string& text) {
    const auto spec = read(text);
    EXPECT_FALSE(spec);
    return spec ? "" : spec.error().message;
  }
  test::TempDir folder_;
};

TEST_F(SpecFile, IsReadWhole) {
  const auto spec = read(R"(
name = "widths"
scenes = ["a.obj", "sub/b.toml"]
constraints = ["slope_bits >= frac_bits"]
[fixed]
technique = "slb"
plane = 256
[axes]
slope_bits = [3, 4]
frac_bits = { from = 3, to = 5 }
[sample]
method = "latin-hypercube"
points = 4
seed = 7
[[list]]
frac_bits = 8
slope_bits = 9
)");
  ASSERT_TRUE(spec) << spec.error().message;
  EXPECT_EQ(spec->name, "widths");
  ASSERT_EQ(spec->scenes.size(), 2U);
  EXPECT_EQ(spec->scenes[1].filename(), "b.toml");
  EXPECT_EQ(spec->fixed, (Assignments{{"technique", "slb"}, {"plane", "256"}}));
  ASSERT_EQ(spec->axes.size(), 2U);
  EXPECT_EQ(spec->axes[0].key, "frac_bits");
  EXPECT_THAT(spec->axes[0].values, ElementsAre("3", "4", "5"));
  EXPECT_EQ(spec->sample.method, Method::LatinHypercube);
  EXPECT_EQ(spec->sample.points, 4U);
  EXPECT_EQ(spec->sample.seed, 7U);
  EXPECT_THAT(spec->list, ElementsAre(Assignments{{"frac_bits", "8"}, {"slope_bits", "9"}}));
  EXPECT_THAT(spec->constraints, ElementsAre("slope_bits >= frac_bits"));
}

TEST_F(SpecFile, AxesTakeStepsCountsAndLists) {
  EXPECT_THAT(axis("slope_bits = { from = 3, to = 8, step = 2 }").values, ElementsAre("3", "5", "7"));
  EXPECT_THAT(axis("pitch = { from = 0.5, to = 2, count = 3, scale = \"log\" }").values,
              ElementsAre("0.5", "1", "2"));
  EXPECT_THAT(axis("pitch = { from = 1, to = 2, step = 0.25 }").values,
              ElementsAre("1", "1.25", "1.5", "1.75", "2"));
  EXPECT_THAT(axis("frac_bits = { from = 3, to = 8, count = 9 }").values,
              ElementsAre("3", "4", "5", "6", "7", "8"));
  EXPECT_THAT(axis("light = [[1, -1, 0], [0, -1, 0.5]]").values, ElementsAre("1,-1,0", "0,-1,0.5"));
  EXPECT_THAT(axis("technique = [\"slb\", \"slb\", \"voxel-offset\"]").values,
              ElementsAre("slb", "voxel-offset"));
}

TEST_F(SpecFile, RefusalsNameLineAndRemedy) {
  const std::string scenes = "scenes = [\"a.obj\"]\n";
  EXPECT_THAT(refusal(scenes), HasSubstr("has no points"));
  EXPECT_THAT(refusal("[axes]\nres = [64]\n"), HasSubstr("has no 'scenes'"));
  EXPECT_THAT(refusal(scenes + "[axis]\nres = [64]\n"), HasSubstr("did you mean 'axes'?"));
  EXPECT_THAT(refusal(scenes + "[axes]\nfrac_bit = [4]\n"),
              HasSubstr("s.toml:3: error: unknown key 'frac_bit'"));
  EXPECT_THAT(refusal(scenes + "[axes]\nfrac_bits = [4, 99]\n"), HasSubstr("99 is out of range 3..8"));
  EXPECT_THAT(refusal(scenes + "[axes]\nfrac_bits = { from = 5, to = 3 }\n"),
              HasSubstr("smaller than 'from'"));
  EXPECT_THAT(refusal(scenes + "[axes]\nfrac_bits = { from = 3, too = 5 }\n"),
              HasSubstr("did you mean 'to'?"));
  EXPECT_THAT(refusal(scenes + "[axes]\nfrac_bits = []\n"), HasSubstr("expected a list"));
  EXPECT_THAT(refusal(scenes + "[axes]\npitch = { from = 1, to = 2 }\n"),
              HasSubstr("neither 'count' nor 'step'"));
  EXPECT_THAT(refusal(scenes + "[axes]\ntechnique = { from = 1, to = 2 }\n"), HasSubstr("takes words"));
  EXPECT_THAT(refusal(scenes + "[fixed]\nres = 64\n[axes]\nres = [64]\n"), HasSubstr("stands in [fixed]"));
  EXPECT_THAT(refusal(scenes + "[axes]\nres = [64]\n[sample]\nmethod = \"random\"\n"),
              HasSubstr("has no 'points'"));
  EXPECT_THAT(refusal(scenes + "[axes]\nres = [64]\n[sample]\npoints = 3\n"), HasSubstr("as its axes make"));
  EXPECT_THAT(refusal("constraints = [\"res <\"]\n" + scenes + "[axes]\nres = [64]\n"),
              HasSubstr("s.toml:1: error: in \"res <\""));
  EXPECT_THAT(refusal("scenes = []\n[axes]\nres = [64]\n"), HasSubstr("expected a list of files"));
}

TEST_F(SpecFile, IsNotThere) {
  const auto spec = read_spec(folder_.path() / "none.toml");
  ASSERT_FALSE(spec);
  EXPECT_THAT(spec.error().message, HasSubstr("none.toml: error:"));
}

}  // namespace
}  // namespace gnomon::sweep
