// SPDX-License-Identifier: Apache-2.0
// Entry, depth, gradient, offset and margin test of one voxel, against exact rationals, for registers like a
// host's and for registers at the ends of their ranges.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/golden/cases.hpp"
#include "tests/golden/exact_oracle.hpp"

namespace gnomon::golden_test {
namespace {

using exact::Integer;
using golden::Accumulators;
using golden::Gradient;
using golden::PlanePoint;
using golden::Register;
using golden::VoxelItem;
using golden::Vpu;

void expect_same_landing(const exact::Unit& unit, const exact::Landing& expected, const PlanePoint& actual) {
  RC_ASSERT(Integer(actual.u) == expected.u);
  RC_ASSERT(Integer(actual.v) == expected.v);
  RC_ASSERT(actual.on_plane == unit.on_plane(expected));
  RC_ASSERT(actual.depth == unit.saturated(expected.d));
  RC_ASSERT(actual.saturated == unit.saturates(expected.d));
}

void check_case(const Case& c, stimulus::Random& random) {
  const exact::Unit unit(c.config, c.registers);
  const Vpu vpu = make_vpu(c.config, c.registers);
  const std::int64_t last_code = (std::int64_t{1} << c.config.depth_bits) - 2;
  for (const VoxelItem& item : c.items) {
    const auto point = unit.project(item);
    const Accumulators acc = vpu.accumulate(item);
    expect_same_landing(unit, unit.land(point), vpu.land(acc));
    for (const int sign : {1, -1}) {
      auto exact_gradient = unit.gradient(item);
      for (auto& component : exact_gradient) component *= sign;
      const Gradient g = vpu.gradient(item);
      const Gradient signed_g{.u = sign * g.u, .v = sign * g.v, .d = sign * g.d};
      RC_ASSERT((signed_g.d > 0) == (exact_gradient[2] > 0));
      RC_ASSERT((signed_g.d == 0) == (exact_gradient[2] == 0));
      expect_same_landing(unit, unit.land_offset(point, exact_gradient), vpu.land_offset(acc, signed_g));
      const std::int64_t delta = random.between(1, last_code) >> random.between(0, c.config.depth_bits - 1);
      RC_ASSERT(vpu.exceeds_margin(static_cast<std::uint32_t>(delta), signed_g) ==
                unit.exceeds_margin(delta, exact_gradient));
    }
  }
}

RC_GTEST_PROP(Landing, SceneRegistersMatchExactArithmetic, (std::uint64_t seed)) {
  stimulus::Random random(seed);
  check_case(any_case(seed, Content::Scene, 20), random);
}

RC_GTEST_PROP(Landing, MixedRegistersMatchExactArithmetic, (std::uint64_t seed)) {
  stimulus::Random random(seed);
  check_case(any_case(seed, Content::Mixed, 20), random);
}

RC_GTEST_PROP(Landing, ExtremeRegistersMatchExactArithmetic, (std::uint64_t seed)) {
  stimulus::Random random(seed);
  check_case(any_case(seed, Content::Extreme, 20), random);
}

/// One ulp below, on, and above entry and depth borders, and half-way between them, on both sides of zero.
TEST(Landing, BordersTiesAndNegativeHalves) {
  const golden::HardwareConfig config;
  Vpu vpu(config);
  const std::int64_t one = std::int64_t{1} << config.matrix_frac_bits;
  const std::int64_t code = std::int64_t{1} << (config.position_bits() + 4);
  struct Border {
    std::int64_t u, expected_u, d, expected_depth;
    bool on_plane, saturated;
  };
  const Border borders[] = {
      {0, 0, 0, 0, true, false},
      {-1, -1, -1, 0, false, true},
      {one - 1, 0, code - 1, 0, true, false},
      {one, 1, code, 1, true, false},
      {one / 2, 0, code / 2, 0, true, false},
      {one + one / 2, 1, code + code / 2, 1, true, false},
      {-one / 2, -1, -code / 2, 0, false, true},
      {-one - one / 2, -2, -code - code / 2, 0, false, true},
      {-one, -1, -code, 0, false, true},
      {512 * one - 1, 511, 0xFFFFE * code, 0xFFFFE, true, false},
      {512 * one, 512, 0xFFFFF * code - 1, 0xFFFFE, false, false},
      {512 * one + 1, 512, 0xFFFFF * code, 0xFFFFE, false, true},
  };
  for (const Border& border : borders) {
    const PlanePoint point = vpu.land({.u = border.u, .v = 0, .d = border.d});
    EXPECT_EQ(point.u, border.expected_u);
    EXPECT_EQ(point.depth, border.expected_depth);
    EXPECT_EQ(point.on_plane, border.on_plane) << border.u;
    EXPECT_EQ(point.saturated, border.saturated) << border.d;
  }
}

/// Floor at each of the named places: the sum of floors is not the floor of the sum.
TEST(Landing, OffsetFloorsTwice) {
  const golden::HardwareConfig config;
  Vpu vpu(config);
  const std::int64_t one = std::int64_t{1} << config.matrix_frac_bits;
  vpu.set(Register::OffsetFactor, 1 << 15);  // half an ulp a unit
  // -1/2 is floored to -1 of the accumulator, which drops the sum below the border although only 1/2 is
  // missing.
  EXPECT_EQ(vpu.land_offset({.u = one, .v = one, .d = 0}, {.u = -1, .v = 1, .d = 0}).u, 0);
  EXPECT_EQ(vpu.land_offset({.u = one, .v = one, .d = 0}, {.u = -1, .v = 1, .d = 0}).v, 1);
  // g_d of -1 is floored to -1/16 code first, half of that to -1/16 again.
  const std::int64_t code = std::int64_t{1} << (config.position_bits() + 4);
  EXPECT_EQ(vpu.land_offset({.u = 0, .v = 0, .d = 7 * code}, {.u = 0, .v = 0, .d = -1}).depth, 6u);
  EXPECT_EQ(vpu.land_offset({.u = 0, .v = 0, .d = 7 * code}, {.u = 0, .v = 0, .d = 1}).depth, 7u);
}

TEST(Landing, RegistersTakeTheirLowBitsOnly) {
  const golden::HardwareConfig config;
  Vpu vpu(config);
  vpu.set(Register::MatrixUx, 0xFFFFFFFFFF800000);  // 24 bits: 0x800000
  EXPECT_EQ(vpu.get(Register::MatrixUx), -(1 << 23));
  vpu.set(Register::MatrixUx, 0xABCDEF0000000001);
  EXPECT_EQ(vpu.get(Register::MatrixUx), 1);
  vpu.set(Register::DeltaMax, ~golden::Word{0});
  EXPECT_EQ(vpu.get(Register::DeltaMax), (1 << 20) - 1);
  vpu.set(Register::TiltShift, 0x7F);
  EXPECT_EQ(vpu.get(Register::TiltShift), 63);
}

}  // namespace
}  // namespace gnomon::golden_test
