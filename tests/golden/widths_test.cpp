// SPDX-License-Identifier: Apache-2.0
// No value of the unit ever leaves its stated width: all intermediates in unbounded integers, for any legal
// build, registers at the ends of their ranges and items at the ends of theirs.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <gnomon/golden/formats.hpp>
#include <map>
#include <set>
#include <string>

#include "tests/golden/cases.hpp"
#include "tests/golden/exact_oracle.hpp"
#include "tests/support/covering.hpp"
#include "tests/support/voxel_patterns.hpp"

namespace gnomon::golden_test {
namespace {

using exact::Integer;
using golden::HardwareConfig;
using golden::Register;
using golden::ValueFormat;
using stimulus::RegisterValues;

using Formats = std::map<std::string, ValueFormat>;

Formats formats_by_name(const HardwareConfig& config) {
  Formats formats;
  for (const ValueFormat& format : golden::value_formats(config)) formats[format.name] = format;
  return formats;
}

bool fits(const Integer& value, const ValueFormat& format) {
  const Integer range = Integer(1) << (format.is_signed ? format.width - 1 : format.width);
  return value < range && value >= (format.is_signed ? Integer(-range) : Integer(0));
}

/// The first value that does not fit, or nothing.
std::string misfit(const HardwareConfig& config, const RegisterValues& registers,
                   const std::vector<golden::VoxelItem>& items, const Formats& formats) {
  const exact::Unit unit(config, registers);
  for (const golden::VoxelItem& item : items) {
    for (const std::uint32_t code : {0u, (1u << config.depth_bits) - 2}) {
      for (const auto& [name, held] : unit.intermediates(item, code)) {
        if (!fits(held, formats.at(name))) return std::string(name) + " = " + held.str();
      }
    }
  }
  return "";
}

/// Every coordinate and component lowest or highest: the largest sums.
std::vector<golden::VoxelItem> corner_items(const HardwareConfig& config) {
  std::vector<golden::VoxelItem> items;
  const std::uint32_t far = (1u << config.position_bits()) - 1;
  const std::int32_t low = -(1 << (config.normal_bits - 1)), high = -low - 1;
  for (unsigned bits = 0; bits < 8; ++bits) {
    const auto p = [&](unsigned axis) { return (bits >> axis & 1) != 0 ? far : 0; };
    const auto n = [&](unsigned axis) { return (bits >> axis & 1) != 0 ? low : high; };
    items.push_back({{p(0), p(1), p(2)}, {n(0), n(1), n(2)}});
  }
  return items;
}

/// Rows wholly at one end: together with the corner items these give the largest magnitude of every sum.
std::vector<RegisterValues> end_registers(const HardwareConfig& config) {
  std::vector<RegisterValues> all(2);
  for (std::size_t i = 0; i < golden::kRegisterCount; ++i) {
    const auto reg = static_cast<Register>(i);
    all[0][i] = stimulus::register_min(reg, config);
    all[1][i] = stimulus::register_max(reg, config);
  }
  for (RegisterValues& values : all) {  // shifts of 0, so that nothing is made small
    const auto at = [&](Register reg) -> std::int64_t& { return values[static_cast<std::size_t>(reg)]; };
    at(Register::FacingShift) = at(Register::TiltShift) = at(Register::DeltaShift) = 0;
    at(Register::OffsetFactor) = stimulus::register_max(Register::OffsetFactor, config);
    at(Register::MarginSquared) = stimulus::register_max(Register::MarginSquared, config);
  }
  return all;
}

TEST(Widths, LargestSumsFitInEveryCornerBuild) {
  std::set<std::tuple<int, int, int, int>> seen;  // what widths depend on
  for (const HardwareConfig& config : stimulus::corner_configs()) {
    if (!seen.insert({config.position_bits(), config.normal_bits, config.matrix_frac_bits, config.depth_bits})
             .second)
      continue;
    for (const RegisterValues& registers : end_registers(config)) {
      ASSERT_EQ(misfit(config, registers, corner_items(config), formats_by_name(config)), "");
    }
  }
  EXPECT_GT(seen.size(), 100u);
}

RC_GTEST_PROP(WidthsProperty, ExtremeRegistersFit, (std::uint64_t seed)) {
  const Case c = any_case(seed, Content::Extreme, 4);
  stimulus::Random random(seed);
  auto items = stimulus::voxel_pattern(stimulus::Pattern::Corners, 6, c.registers, c.config, random);
  RC_ASSERT(misfit(c.config, c.registers, items, formats_by_name(c.config)) == "");
  RC_ASSERT(misfit(c.config, c.registers, c.items, formats_by_name(c.config)) == "");
}

/// The check bites: at the ends, none of these formats could be two bits narrower.
TEST(Widths, NarrowerFormatsAreFound) {
  const HardwareConfig config;
  for (const char* name : {"u_acc",
                           "u",
                           "g_u",
                           "g_d",
                           "u_step_product",
                           "u_step",
                           "d_step",
                           "g_d_coarse",
                           "d",
                           "d_moved",
                           "delta",
                           "delta_signed",
                           "delta_n",
                           "g_dn",
                           "g_un",
                           "margin_left_root",
                           "margin_left",
                           "tilt_squared",
                           "margin_right",
                           "u_moved_acc",
                           "u_moved"}) {
    Formats formats = formats_by_name(config);
    formats.at(name).width -= 2;
    std::string found;
    for (const RegisterValues& registers : end_registers(config)) {
      if (found.empty()) found = misfit(config, registers, corner_items(config), formats);
    }
    EXPECT_EQ(found.rfind(name, 0), 0u) << name << ": " << found;
  }
}

/// Nothing on the page goes unchecked: each format beyond items and registers is one of the oracle's values.
/// The perspective projection's, which stand last, have a test of their own.
TEST(Widths, EveryFormatIsExercised) {
  const HardwareConfig config;
  std::set<std::string> produced;
  for (const auto& value : exact::Unit(config, RegisterValues{}).intermediates({}, 0))
    produced.insert(value.name);
  const auto formats = golden::value_formats(config);
  for (std::size_t i = 2 + golden::kRegisterCount; formats.at(i).name != std::string("PROJECTION"); ++i) {
    EXPECT_TRUE(produced.contains(formats[i].name)) << formats[i].name;
  }
}

}  // namespace
}  // namespace gnomon::golden_test
