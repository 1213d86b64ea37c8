// SPDX-License-Identifier: Apache-2.0
// The error of the buffer by width, through the engine.
#include "host/slb/error_report.hpp"

#include <gtest/gtest.h>

#include "tests/host/slb/shapes.hpp"

namespace gnomon::slb {
namespace {

EngineRun on_golden(const golden::HardwareConfig& config, std::span<const golden::Word> stream) {
  return run_golden(config, stream, [](double) {});
}

LoopScene shape(const char* name, const golden::slb::SlbConfig& config) {
  return test::from_golden(golden::slb::testing::shape(name).make(config, 3), config);
}

TEST(ErrorReport, TheErrorHalvesWithEveryFractionBit) {
  const golden::HardwareConfig config = test::hardware(test::small_plane(7));
  const LoopScene scene = shape("random 24-gon", config.slb_config());
  const auto configurations = report_configurations(config);
  ASSERT_EQ(configurations.size(), 6U);
  double last = 0;
  for (const golden::HardwareConfig& one : configurations) {
    EXPECT_EQ(one.slope_bits, one.frac_bits);
    const auto point = measure_error(scene, one, {2500, 1}, on_golden);
    ASSERT_TRUE(point) << point.error().message;
    EXPECT_LT(point->displacement.ratio(), 0.82) << one.frac_bits;
    EXPECT_GT(point->displacement.ratio(), 0.4) << one.frac_bits;
    EXPECT_NEAR(point->displacement.plain_map, 0.245, 0.03);
    if (last > 0) {
      EXPECT_NEAR(last / point->displacement.buffer, 2, 0.45) << one.frac_bits;
    }
    last = point->displacement.buffer;
    EXPECT_EQ(point->entries.size(), 4096U);
    EXPECT_FALSE(point->run.compare);
    const auto json = to_json(*point);
    EXPECT_EQ(json.at("frac_bits"), one.frac_bits);
    EXPECT_EQ(json.at("fine_map").at("memory_bits"), (std::uint64_t{4096} << (2 * one.frac_bits)) * 32);
    EXPECT_EQ(json.at("events").at("SLB_OBJECTS"), 1);
    EXPECT_FALSE(json.contains("compare"));
  }
}

TEST(ErrorReport, KeepsTheDistanceOfSlopeBits) {
  golden::HardwareConfig config = test::hardware(test::small_plane(7));
  config.slope_bits = 8;
  std::string widths;
  for (const auto& one : report_configurations(config))
    widths += std::to_string(one.frac_bits) + std::to_string(one.slope_bits) + " ";
  EXPECT_EQ(widths, "34 45 56 67 78 89 ");
  // What does not fit the words is left out: 2 (10 + 2 + 11) + 20 bits.
  config.slb_plane_log2 = 10;
  config.subpixel_bits = config.query_bits = 10;
  EXPECT_EQ(report_configurations(config).size(), 5U);
}

TEST(ErrorReport, RefusesWhatLiesOutsideTheGuardBand) {
  const golden::HardwareConfig config = test::hardware(test::small_plane(7));
  const auto point = measure_error({{0.5, {{{0, 0}, {200, 0}, {0, 1}}}}}, config, {1, 1}, on_golden);
  ASSERT_FALSE(point);
  EXPECT_NE(point.error().message.find("object 0, loop 0, vertex 1"), std::string::npos);
}

}  // namespace
}  // namespace gnomon::slb
