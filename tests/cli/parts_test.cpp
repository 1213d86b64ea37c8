// SPDX-License-Identifier: Apache-2.0
// Parts of the program that no whole run shows.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/cli/junit.hpp"
#include "host/cli/progress.hpp"
#include "host/cli/vpu_settings.hpp"

namespace gnomon::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Progress, ShowsStagePercentAndTimeLeft) {
  EXPECT_EQ(progress_text("rtl", 0.25, 10), "rtl          [#####...............]  25 %  30 s left");
  EXPECT_EQ(progress_text("rtl", 0.5, 125), "rtl          [##########..........]  50 %  2 min 05 s left");
  EXPECT_EQ(progress_text("rtl", 0, 5), "rtl          [....................]   0 %");
  EXPECT_EQ(progress_text("rtl", 1, 5), "rtl          [####################] 100 %");
  EXPECT_EQ(progress_text("rtl", 1.7, 5), progress_text("rtl", 1, 5));
}

TEST(Junit, EscapesAndCounts) {
  const std::string xml = junit_xml("s", {{"a<b>", 1.5, ""}, {"c", 0, "x & \"y\" \x01"}});
  EXPECT_THAT(xml, HasSubstr("tests=\"2\" failures=\"1\""));
  EXPECT_THAT(xml, HasSubstr("name=\"a&lt;b&gt;\" time=\"1.500\"/>"));
  EXPECT_THAT(xml, HasSubstr("<failure>x &amp; &quot;y&quot; ?</failure>"));
  EXPECT_THAT(xml, Not(HasSubstr("a<b>")));
}

TEST(VpuSettings, DefaultsOfTheRegistryAreThoseOfThePlanner) {
  const plan::VpuSettings registry = vpu_settings(config::Settings::resolve({}).value());
  const plan::VpuSettings planner;
  EXPECT_EQ(registry.pitch, planner.pitch);
  EXPECT_EQ(registry.offset_factor, planner.offset_factor);
  EXPECT_EQ(registry.margin, planner.margin);
  EXPECT_EQ(registry.margin_tan_max, planner.margin_tan_max);
  EXPECT_EQ(registry.plane_log2, planner.plane_log2);
  EXPECT_EQ(registry.voxel_frac_bits, planner.voxel_frac_bits);
  EXPECT_EQ(registry.normal_bits, planner.normal_bits);
  EXPECT_EQ(registry.matrix_frac_bits, planner.matrix_frac_bits);
  EXPECT_EQ(registry.depth_bits, planner.depth_bits);
}

TEST(VpuSettings, EveryParameterArrives) {
  const std::vector<std::vector<config::Assignment>> flags{{{"pitch", "2", ""},
                                                            {"offset", "0.25", ""},
                                                            {"margin", "0.75", ""},
                                                            {"margin_tan_max", "5", ""},
                                                            {"plane", "512", ""},
                                                            {"voxel_frac_bits", "3", ""},
                                                            {"normal_bits", "7", ""},
                                                            {"matrix_frac_bits", "20", ""},
                                                            {"depth_bits", "16", ""}}};
  const plan::VpuSettings vpu = vpu_settings(config::Settings::resolve(flags).value());
  EXPECT_EQ(vpu.pitch, 2);
  EXPECT_EQ(vpu.offset_factor, 0.25);
  EXPECT_EQ(vpu.margin, 0.75);
  EXPECT_EQ(vpu.margin_tan_max, 5);
  EXPECT_EQ(vpu.plane_log2, 9);
  EXPECT_EQ(vpu.voxel_frac_bits, 3);
  EXPECT_EQ(vpu.normal_bits, 7);
  EXPECT_EQ(vpu.matrix_frac_bits, 20);
  EXPECT_EQ(vpu.depth_bits, 16);
}

}  // namespace
}  // namespace gnomon::cli
