// SPDX-License-Identifier: Apache-2.0
// Passes in perspective against the exact oracle: every plane entry and every result word, in any build;
// widths; and how far places and depths are from the truth.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <gnomon/golden/formats.hpp>
#include <gnomon/golden/stream.hpp>
#include <map>
#include <set>

#include "tests/golden/cases.hpp"
#include "tests/golden/perspective_oracle.hpp"
#include "tests/golden/run_stream.hpp"
#include "tests/support/voxel_patterns.hpp"

namespace gnomon::golden_test {
namespace {

using exact::Integer;
using exact::Rational;
using golden::HardwareConfig;
using golden::Register;
using golden::VoxelItem;
using golden::Word;
using stimulus::AllRegisters;

struct PerspectiveCase {
  HardwareConfig config;
  AllRegisters registers{};
  std::vector<VoxelItem> items;
};

PerspectiveCase perspective_case(std::uint64_t seed, int extreme_percent, std::size_t count,
                                 int max_plane_log2 = 7) {
  stimulus::Random random(seed);
  PerspectiveCase c;
  c.config = any_config(random, max_plane_log2);
  c.config.en_perspective = true;
  c.registers = stimulus::extreme_perspective_registers(c.config, extreme_percent, random);
  const auto pattern = static_cast<stimulus::Pattern>(random.between(0, stimulus::kPatternCount - 1));
  c.items = stimulus::voxel_pattern(pattern, count, stimulus::pattern_registers(c.registers, c.config),
                                    c.config, random);
  return c;
}

/// Projects the first two thirds of the items and resolves all, both ways.
void check_passes(const PerspectiveCase& c) {
  const exact::PerspectiveUnit unit(c.config, c.registers);
  const auto casters = std::span(c.items).first(c.items.size() * 2 / 3);
  golden::StreamWriter writer(c.config);
  writer.set_registers(Register::MatrixUx, c.registers);
  writer.project(casters);
  exact::Plane plane;
  for (const VoxelItem& item : casters) exact::project(plane, unit, item);
  std::vector<Word> expected;
  for (const bool two_sided : {false, true}) {
    writer.resolve(c.items, two_sided);
    for (const VoxelItem& item : c.items)
      expected.push_back(golden::encode(exact::resolve(plane, unit, item, two_sided)));
  }
  const Outcome outcome = run(c.config, writer.words());
  const Comparison comparison = compare(expected, outcome.results);
  RC_LOG() << comparison.first;
  RC_ASSERT(comparison.compared == 2 * c.items.size());
  RC_ASSERT(comparison.differ == 0u);
  std::vector<std::uint32_t> depths(outcome.plane.size(), golden::kEmpty);
  for (const auto& [entry, depth] : plane)
    depths[static_cast<std::size_t>(entry.second * c.config.plane_side() + entry.first)] = depth;
  RC_ASSERT(depths == outcome.plane);
}

RC_GTEST_PROP(Perspective, ScenePassesMatch, (std::uint64_t seed)) {
  check_passes(perspective_case(seed, 0, 40));
}
RC_GTEST_PROP(Perspective, MixedPassesMatch, (std::uint64_t seed)) {
  check_passes(perspective_case(seed, 8, 30));
}
RC_GTEST_PROP(Perspective, ExtremePassesMatch, (std::uint64_t seed)) {
  check_passes(perspective_case(seed, 60, 20));
}

using Formats = std::map<std::string, golden::ValueFormat>;

Formats formats_by_name(const HardwareConfig& config) {
  Formats formats;
  for (const auto& format : golden::value_formats(config)) formats[format.name] = format;
  return formats;
}

/// The first value that does not fit, or nothing. Notes what was seen.
std::string misfit(const PerspectiveCase& c, const Formats& formats, std::set<std::string>& seen) {
  const exact::PerspectiveUnit unit(c.config, c.registers);
  for (const VoxelItem& item : c.items) {
    for (const auto& [name, held] : unit.intermediates(item, 0xFFFFFF)) {
      const golden::ValueFormat& format = formats.at(name);
      const Integer range = Integer(1) << (format.is_signed ? format.width - 1 : format.width);
      seen.insert(name);
      if (held >= range || held < (format.is_signed ? Integer(-range) : Integer(0)))
        return std::string(name) + " = " + held.str();
    }
  }
  return "";
}

TEST(PerspectiveWidths, EveryValueFitsAndEveryFormatIsExercised) {
  std::set<std::string> seen;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const PerspectiveCase c = perspective_case(seed, static_cast<int>(seed % 4) * 25, 12, 12);
    ASSERT_EQ(misfit(c, formats_by_name(c.config), seen), "") << "seed " << seed;
  }
  const auto formats = golden::value_formats({});
  const auto first = std::find_if(formats.begin(), formats.end(),
                                  [](const auto& format) { return format.name == "CONE_SQUARED"; });
  ASSERT_NE(first, formats.end());
  std::size_t counted = 0;
  for (auto format = first + 1; format != formats.end(); ++format, ++counted)
    EXPECT_TRUE(seen.contains(format->name)) << format->name;
  EXPECT_EQ(counted, 32u);
}

/// The check above bites: where registers reach their ends, none of these formats could be two bits narrower.
TEST(PerspectiveWidths, NarrowerFormatsAreFound) {
  for (const char* name : {"w_acc", "w_high", "m", "seed",   "t",        "r",      "q_u",    "x_u",
                           "h",     "key",    "b", "g_w",    "q_dw",     "q_du",   "x_du",   "rho",
                           "q_c",   "rho_c",  "k", "w_step", "cone_sum", "h_step", "a_step", "delta_limit"}) {
    std::string found;
    for (std::uint64_t seed = 1; seed <= 4000 && found.empty(); ++seed) {
      const PerspectiveCase c = perspective_case(seed, 60, 4, 12);
      Formats formats = formats_by_name(c.config);
      formats.at(name).width -= 2;
      std::set<std::string> seen;
      const std::string wrong = misfit(c, formats, seen);
      if (wrong.rfind(std::string(name) + " ", 0) == 0) found = wrong;
    }
    EXPECT_NE(found, "") << name;
  }
}

Rational relative_reciprocal_error() {
  return Rational(Integer(1000), Integer(850000000));  // 2^-19.7 = 1.1759e-6
}

/// The page's bounds: of a place and of a depth against the exact division of the same registers' rows.
TEST(PerspectiveBounds, PlacesAndDepthsAreWithinTheirBounds) {
  std::size_t compared = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    const PerspectiveCase c = perspective_case(seed, 0, 20, 12);
    const exact::PerspectiveUnit unit(c.config, c.registers);
    for (const VoxelItem& item : c.items) {
      const exact::Sight sight = unit.see(item);
      const auto far = unit.plane().project(item);
      const Rational w = unit.w(item);
      if (sight.behind || abs(far[0] / w) >= (1 << c.config.plane_log2)) continue;
      const Rational x = far[0] / w;
      ASSERT_LE(abs(sight.x[0] - x), abs(x) * relative_reciprocal_error() + exact::power_of_two(-11))
          << "seed " << seed;
      const Rational scale = Rational(c.registers[static_cast<std::size_t>(Register::KeyScale)]) / 16;
      const Rational h = scale / w;
      if (h >= exact::power_of_two(c.config.depth_bits + 4)) continue;
      ASSERT_LE(abs(sight.h - h), h * relative_reciprocal_error() + Rational(1, 16)) << "seed " << seed;
      ++compared;
    }
  }
  EXPECT_GT(compared, 3000u);
}

/// To first order: of the step, so much as w changes.
TEST(PerspectiveBounds, OffsetPointsAreTheImageToFirstOrder) {
  std::size_t compared = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const PerspectiveCase c = perspective_case(seed, 0, 20, 12);
    const exact::PerspectiveUnit unit(c.config, c.registers);
    const Rational factor =
        Rational(c.registers[static_cast<std::size_t>(Register::OffsetFactor)]) * exact::power_of_two(-16);
    for (const VoxelItem& item : c.items) {
      const exact::Sight sight = unit.see(item);
      if (sight.behind) continue;
      const auto here = unit.plane().project(item), slope = unit.plane().gradient(item);
      const Rational w = unit.w(item);
      Rational turn = 0;  // change of w
      for (std::size_t i = 0; i < 3; ++i)
        turn += factor * item.normal[i] * c.registers[static_cast<std::size_t>(Register::MatrixWx) + i] *
                exact::power_of_two(-c.config.matrix_frac_bits - c.config.position_bits());
      const Rational x = here[0] / w, rho = turn / w;
      const Rational step = (factor * slope[0] - x * turn) / w;
      const Rational side = Integer(1) << c.config.plane_log2;
      if (abs(x) >= side || abs(step) >= side || abs(rho) >= 1) continue;
      const auto moved = unit.move(item, sight, false, 0);
      const Rational floor_of_step = (1 + abs(x) * exact::power_of_two(-c.config.position_bits())) / abs(w) *
                                     exact::power_of_two(-c.config.matrix_frac_bits);
      const Rational narrowings =
          3 * exact::power_of_two(-12) + abs(x) * exact::power_of_two(-19) +
          abs(rho) * exact::power_of_two(-11) + floor_of_step +
          (2 * abs(x * rho) + abs(factor * slope[0] / w)) * relative_reciprocal_error();
      ASSERT_LE(abs(moved.fine[0] - sight.fine[0] - step), narrowings) << "seed " << seed;
      // The exact image: what is left is rho times the step, to first order.
      const Rational image = (here[0] + factor * slope[0]) / (w + turn) - x;
      ASSERT_LE(abs(image - step), abs(rho) * abs(image)) << "seed " << seed;
      ++compared;
    }
  }
  EXPECT_GT(compared, 2000u);
}

/// With PERSPECTIVE clear, hardware that has the projection answers as hardware that has not.
RC_GTEST_PROP(Perspective, OrthographicWordsDoNotChange, (std::uint64_t seed)) {
  const Case c = any_case(seed, seed % 3 == 0 ? Content::Mixed : Content::Scene, 40);
  HardwareConfig with = c.config;
  with.en_perspective = true;
  stimulus::Random random(seed);
  AllRegisters others = stimulus::extreme_perspective_registers(with, 50, random);
  const auto stream = [&](const HardwareConfig& config) {
    golden::StreamWriter writer(config);
    if (config.en_perspective) {
      writer.set_registers(Register::MatrixUx, others);
      writer.set_register(Register::Projection, golden::kProjectionCone);
    }
    writer.set_registers(Register::MatrixUx, c.registers);
    writer.project(c.items);
    writer.resolve(c.items, true);
    writer.fence(3, false);
    return writer.take();
  };
  const Outcome a = run(c.config, stream(c.config)), b = run(with, stream(with));
  RC_ASSERT(a.results == b.results);
  RC_ASSERT(a.plane == b.plane);
}

}  // namespace
}  // namespace gnomon::golden_test
