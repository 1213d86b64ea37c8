// SPDX-License-Identifier: Apache-2.0
// Cells and clocks of a tiny module of known size; units and wrapper as text.
#include "host/area/area.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "host/area/wrapper.hpp"

namespace gnomon::area {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* kAdder = R"(module adder #(parameter int unsigned WIDTH = 4) (
  input logic [WIDTH-1:0] a_i, input logic [WIDTH-1:0] b_i, output logic [WIDTH-1:0] sum_o
);
  assign sum_o = a_i + b_i;
endmodule
)";
constexpr const char* kTiny = R"(// As other, but tiny.
module tiny #(parameter int unsigned WIDTH = 4) (
  input logic clk_i, input logic [WIDTH-1:0] a_i, input logic [WIDTH-1:0] b_i, output logic [WIDTH-1:0] sum_o
);
  logic [WIDTH-1:0] sum;
  adder #(.WIDTH(WIDTH)) u_adder (.a_i, .b_i, .sum_o(sum));
  always_ff @(posedge clk_i) sum_o <= sum;
endmodule
)";

/// An RTL folder with one module, and a cache.
class AreaTest : public testing::Test {
 protected:
  AreaTest() {
    std::string name = (fs::temp_directory_path() / "gnomon-area-XXXXXX").string();
    EXPECT_NE(mkdtemp(name.data()), nullptr);
    root_ = name;
    fs::create_directories(root_ / "rtl" / "common");
    write("common/assertions.svh", "");
    // A file that nothing names may be anything.
    write("gnomon.f", "// files\n+incdir+common\nadder.sv\ntiny/tiny.sv\nother.sv\n");
    write("adder.sv", kAdder);
    write("other.sv", "no Verilog, and not tiny");
    fs::create_directories(root_ / "rtl" / "tiny");
    write("tiny/tiny.sv", kTiny);
    tools_.rtl_dir = root_ / "rtl";
    tools_.cache_dir = root_ / "cache";
  }
  ~AreaTest() override { fs::remove_all(root_); }
  AreaTest(const AreaTest&) = delete;
  AreaTest& operator=(const AreaTest&) = delete;

  void write(const char* file, const std::string& text) const { std::ofstream(root_ / "rtl" / file) << text; }
  static Unit tiny(int width) { return {"tiny", 1, {{"WIDTH", width}}}; }

  fs::path root_;
  sim::Toolchain tools_;
};

TEST_F(AreaTest, CountsTheCellsOfAnAdder) {
  Estimator estimator(tools_);
  const auto eight = estimator.estimate(tiny(8), 0);
  ASSERT_TRUE(eight) << eight.error().message;
  EXPECT_EQ(eight->cells.flip_flops, 8u);
  EXPECT_GE(eight->cells.luts, 8u);
  EXPECT_LE(eight->cells.luts, 10u);
  EXPECT_EQ(eight->cells.dsps, 0u);
  EXPECT_FALSE(eight->clock);
  const auto twenty = estimator.estimate(tiny(20), 0);
  ASSERT_TRUE(twenty) << twenty.error().message;
  EXPECT_EQ(twenty->cells.flip_flops, 20u);
}

/// A part with an unsized literal at a port makes Yosys read the whole anew and forget its name.
TEST_F(AreaTest, FindsAModuleThatIsReadTwice) {
  write("tiny/tiny.sv", R"(module tiny #(parameter int unsigned WIDTH = 4) (
  input logic clk_i, input logic [WIDTH-1:0] a_i, output logic [WIDTH-1:0] sum_o
);
  logic [WIDTH-1:0] sum;
  adder #(.WIDTH(WIDTH)) u_adder (.a_i, .b_i('1), .sum_o(sum));
  always_ff @(posedge clk_i) sum_o <= sum;
endmodule
)");
  Estimator estimator(tools_);
  const auto eight = estimator.estimate(tiny(8), 1);
  ASSERT_TRUE(eight) << eight.error().message;
  EXPECT_EQ(eight->cells.flip_flops, 8u);
  EXPECT_TRUE(eight->clock && eight->clock->fits());
}

TEST_F(AreaTest, PlacesItWithSeveralSeedsAndKeepsWhatItFound) {
  Estimator estimator(tools_);
  const auto placed = estimator.estimate(tiny(8), 2);
  ASSERT_TRUE(placed) << placed.error().message;
  ASSERT_TRUE(placed->clock && placed->clock->fits());
  EXPECT_EQ(placed->clock->mhz.size(), 2u);
  EXPECT_GT(placed->clock->lowest(), 50);
  EXPECT_LT(placed->clock->highest(), 1000);
  EXPECT_GE(placed->clock->used, 8u + 17u);
  EXPECT_EQ(placed->clock->available, 7680u);
  EXPECT_EQ(estimator.runs(), 1);
  Estimator another(tools_);
  const auto again = another.estimate(tiny(8), 2);
  ASSERT_TRUE(again);
  EXPECT_EQ(another.runs(), 0);
  EXPECT_EQ(again->cells, placed->cells);
  EXPECT_EQ(again->clock->mhz, placed->clock->mhz);
  // Another text is another module, also below it.
  write("adder.sv", std::string(kAdder) + "// changed\n");
  ASSERT_TRUE(another.estimate(tiny(8), 2));
  EXPECT_EQ(another.runs(), 1);
}

TEST_F(AreaTest, ToolsOfAnotherVersionAreAskedAgain) {
  Estimator estimator(tools_);
  ASSERT_TRUE(estimator.estimate(tiny(8), 0));
  const std::string path = std::getenv("PATH");
  fs::create_directories(root_ / "bin");
  const fs::path another = root_ / "bin" / "yosys";
  std::ofstream(another) << "#!/bin/sh\nPATH='" << path
                         << "'\n[ \"$1\" = --version ] && exec echo another\nexec yosys \"$@\"\n";
  fs::permissions(another, fs::perms::owner_all);
  setenv("PATH", ((root_ / "bin").string() + ":" + path).c_str(), 1);
  EXPECT_TRUE(estimator.estimate(tiny(8), 0));
  setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(estimator.runs(), 2);
  EXPECT_TRUE(estimator.estimate(tiny(8), 0));
  EXPECT_EQ(estimator.runs(), 2);
}

TEST_F(AreaTest, SaysWhatTheToolSays) {
  Estimator estimator(tools_);
  write("tiny/tiny.sv", "module tiny (input logic clk_i; endmodule\n");
  const auto refused = estimator.estimate(tiny(8), 0);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, testing::AllOf(HasSubstr("tiny: yosys"), HasSubstr("ERROR")));
}

TEST(Clock, HasAMedianAndARange) {
  const Clock three{{30, 10, 20}, 0, 0}, four{{40, 10, 20, 30}, 0, 0};
  EXPECT_EQ(three.median(), 20);
  EXPECT_EQ(four.median(), 25);
  EXPECT_EQ(four.lowest(), 10);
  EXPECT_EQ(four.highest(), 40);
  EXPECT_FALSE(Clock().fits());
}

TEST(Area, SumsItsUnitsAndIsAsSlowAsTheSlowest) {
  Area area;
  EXPECT_FALSE(area.all_placed());
  EXPECT_FALSE(area.clock_mhz());
  area.add({{"a", 2, {}}, {10, 1, 3, 1, 0}, Clock{{50, 70, 60}, 100, 7680}});
  area.add({{"b", 1, {}}, {5, 0, 0, 0, 0}, Clock{{40, 45}, 100, 7680}});
  EXPECT_EQ(area.sum, (Cells{25, 2, 6, 2, 0}));
  EXPECT_EQ(area.clock_mhz(), 42.5);
  EXPECT_TRUE(area.all_placed());
  area.add({{"c", 1, {}}, {9000, 0, 0, 0, 0}, Clock{{}, 9000, 7680}});
  EXPECT_EQ(area.clock_mhz(), 42.5) << "of those that have one";
  EXPECT_FALSE(area.all_placed());
}

TEST(Wrapper, ConnectsEveryBitOnce) {
  const Unit unit{"m", 1, {{"W", 3}}};
  const std::string text =
      wrapper(unit, {{"a_i", 3, true}, {"clk_i", 1, true}, {"b_i", 1, true}, {"c_o", 5, false}});
  for (const char* part : {".a_i(in_q[2:0])", ".b_i(in_q[3:3])", ".c_o(out[4:0])", ".clk_i(clk_i)",
                           "m #(.W(3)) u_unit", "reg [4:0] in_q", "reg [5:0] out_q"})
    EXPECT_THAT(text, HasSubstr(part));
}

TEST(Units, AreThoseOfTheTechniqueWithItsWidths) {
  golden::HardwareConfig config;
  EXPECT_EQ(units_of(config).size(), 2u);
  config.en_vpu_offset = false;
  EXPECT_TRUE(units_of(config).empty());
  config.en_slb = true;
  config.frac_bits = 5;
  int encoders = 0;
  for (const Unit& unit : units_of(config)) {
    if (unit.module != "slb_line_encoder") continue;
    encoders += unit.count;
    EXPECT_EQ(unit.parameters.front(), (std::pair<std::string, int>{"FRAC_BITS", 5}));
  }
  EXPECT_EQ(encoders, 2);
}

}  // namespace
}  // namespace gnomon::area
