// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <gnomon/golden/config.hpp>
#include <gnomon/golden/formats.hpp>
#include <gnomon/golden/golden_engine.hpp>
#include <stdexcept>

namespace gnomon::golden {
namespace {

std::string message(const HardwareConfig& config) {
  return config.check().value_or("legal");
}

TEST(Config, DefaultIsLegal) {
  EXPECT_EQ(message({}), "legal");
}

TEST(Config, EachRangeIsCheckedAtBothEnds) {
  struct Case {
    int HardwareConfig::*member;
    const char* name;
    int low, high;
  };
  const Case cases[] = {{&HardwareConfig::voxel_bits, "VOXEL_BITS", 4, 11},
                        {&HardwareConfig::voxel_frac_bits, "VOXEL_FRAC_BITS", 0, 6},
                        {&HardwareConfig::normal_bits, "NORMAL_BITS", 4, 12},
                        {&HardwareConfig::matrix_frac_bits, "MATRIX_FRAC_BITS", 12, 28},
                        {&HardwareConfig::depth_bits, "DEPTH_BITS", 8, 24},
                        {&HardwareConfig::plane_log2, "PLANE_LOG2", 4, 12}};
  // The middle of all ranges, so that no rule about two parameters interferes.
  const HardwareConfig middle{
      .voxel_bits = 4, .voxel_frac_bits = 0, .normal_bits = 4, .matrix_frac_bits = 22};
  for (const Case& c : cases) {
    for (const int value : {c.low, c.high}) {
      HardwareConfig config = middle;
      config.*c.member = value;
      EXPECT_EQ(message(config), "legal") << c.name << "=" << value;
    }
    for (const int value : {c.low - 1, c.high + 1, -1, 1 << 20}) {
      HardwareConfig config = middle;
      config.*c.member = value;
      EXPECT_EQ(message(config), std::string(c.name) + "=" + std::to_string(value) + " is out of range " +
                                     std::to_string(c.low) + ".." + std::to_string(c.high));
    }
  }
}

TEST(Config, RulesAboutSeveralParameters) {
  EXPECT_EQ(message({.voxel_bits = 11, .voxel_frac_bits = 6, .normal_bits = 4}),
            "VOXEL_BITS + VOXEL_FRAC_BITS = 17 exceeds 16");
  EXPECT_EQ(message({.voxel_bits = 11, .voxel_frac_bits = 5, .normal_bits = 5}), "legal");
  EXPECT_EQ(message({.voxel_bits = 11, .voxel_frac_bits = 5, .normal_bits = 6}),
            "3 * (VOXEL_BITS + VOXEL_FRAC_BITS + NORMAL_BITS) = 66 exceeds the 63 bits of a voxel item");
  EXPECT_EQ(message({.voxel_bits = 11, .voxel_frac_bits = 0, .matrix_frac_bits = 13}), "legal");
  EXPECT_EQ(message({.voxel_bits = 11, .voxel_frac_bits = 0, .matrix_frac_bits = 12}),
            "MATRIX_FRAC_BITS=12 is below VOXEL_BITS + VOXEL_FRAC_BITS + 2 = 13");
}

TEST(Config, SlbParametersCountOnlyWithTheUnit) {
  const HardwareConfig with{.en_slb = true};
  EXPECT_NE(HardwareConfig{}, with);
  int HardwareConfig::*const members[] = {&HardwareConfig::slb_plane_log2, &HardwareConfig::frac_bits,
                                          &HardwareConfig::slope_bits,     &HardwareConfig::frags_per_pixel,
                                          &HardwareConfig::subpixel_bits,  &HardwareConfig::query_bits};
  for (const auto member : members) {
    for (const bool en_slb : {false, true}) {
      HardwareConfig same{.en_slb = en_slb}, other{.en_slb = en_slb};
      other.*member = 99;
      EXPECT_EQ(same == other, !en_slb);
      EXPECT_EQ(other.check().has_value(), en_slb);
    }
  }
  EXPECT_EQ((HardwareConfig{.slb_rounding = slb::Rounding::Published}), HardwareConfig{});
  EXPECT_NE((HardwareConfig{.en_slb = true, .slb_rounding = slb::Rounding::Published}), with);
}

TEST(Config, SlbRules) {
  EXPECT_EQ(message({.en_slb = true}), "legal");
  EXPECT_EQ(message({.en_slb = true, .slb_plane_log2 = 2}), "SLB_PLANE_LOG2=2 is out of range 3..12");
  EXPECT_EQ(message({.en_slb = true, .slb_plane_log2 = 13}), "SLB_PLANE_LOG2=13 is out of range 3..12");
  EXPECT_EQ(message({.en_slb = true, .frac_bits = 9}), "FRAC_BITS=9 is out of range 3..8");
  EXPECT_EQ(message({.en_slb = true, .subpixel_bits = 9}), "SUBPIXEL_BITS=9 is out of range 10..16");
  EXPECT_EQ(message({.en_slb = true, .query_bits = 17}), "QUERY_BITS=17 is out of range 10..16");
  EXPECT_EQ(message({.en_slb = true, .frac_bits = 3, .slope_bits = 9, .subpixel_bits = 9}),
            "SUBPIXEL_BITS=9 is below SLOPE_BITS - FRAC_BITS + 4 = 10");
  EXPECT_EQ(message({.depth_bits = 24, .en_slb = true, .subpixel_bits = 11}),
            "a vertex needs 2 (SLB_PLANE_LOG2 + 2 + SUBPIXEL_BITS) + DEPTH_BITS = 66 bits, 64 at most");
  EXPECT_EQ(message({.depth_bits = 24, .en_slb = true, .query_bits = 11}),
            "a query needs 2 (SLB_PLANE_LOG2 + 2 + QUERY_BITS) + DEPTH_BITS = 66 bits, 64 at most");
  EXPECT_EQ(message({.depth_bits = 24, .en_slb = true}), "legal");
}

TEST(Config, EngineRefusesWhatCheckRefuses) {
  try {
    make_golden_engine({.depth_bits = 25});
    FAIL() << "an illegal build was accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "DEPTH_BITS=25 is out of range 8..24");
  }
}

/// All values of all parameters but those that no width depends on.
TEST(Config, NoLegalBuildNeedsMoreThan62Bits) {
  int legal = 0, widest = 0;
  for (int voxel = 4; voxel <= 11; ++voxel)
    for (int frac = 0; frac <= 6; ++frac)
      for (int normal = 4; normal <= 12; ++normal)
        for (int matrix = 12; matrix <= 28; ++matrix)
          for (int depth = 8; depth <= 24; ++depth) {
            const HardwareConfig config{voxel, frac, normal, matrix, depth, 9, true};
            if (config.check()) continue;
            ++legal;
            for (const ValueFormat& format : value_formats(config)) widest = std::max(widest, format.width);
          }
  EXPECT_EQ(widest, 62);
  EXPECT_GT(legal, 80000);
}

}  // namespace
}  // namespace gnomon::golden
