// SPDX-License-Identifier: Apache-2.0
// The margin test against what it stands for, in double precision: delta > margin * tan(normal, light).
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>

#include "tests/golden/cases.hpp"
#include "tests/support/voxel_patterns.hpp"

namespace gnomon::golden_test {
namespace {

using golden::Gradient;
using golden::HardwareConfig;
using golden::Register;
using golden::Vpu;
using stimulus::RegisterValues;

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector row(const RegisterValues& values, Register first) {
  const auto i = static_cast<std::size_t>(first);
  return {static_cast<double>(values[i]), static_cast<double>(values[i + 1]),
          static_cast<double>(values[i + 2])};
}

struct Tally {
  int shadow = 0, lit = 0, in_band = 0, saturated = 0;
};

/// Truncations of the three scaled values, and rows that are orthogonal up to their rounding: the relative
/// error of each side.
struct Sides {
  double left, left_error, right, right_error;
};

Sides sides(const Vpu& vpu, const RegisterValues& registers, const golden::VoxelItem& item, const Gradient& g,
            double delta) {
  const Vector u = row(registers, Register::MatrixUx), d = row(registers, Register::MatrixDx);
  const Vector n{static_cast<double>(item.normal[0]), static_cast<double>(item.normal[1]),
                 static_cast<double>(item.normal[2])};
  const double along = std::abs(dot(n, d)) / std::sqrt(dot(d, d));
  const double across = std::sqrt(std::max(0.0, dot(n, n) - along * along));
  const auto step = [&](Register reg) { return std::ldexp(1.0, static_cast<int>(vpu.get(reg))); };
  const double margin = std::sqrt(static_cast<double>(vpu.get(Register::MarginSquared))) *
                        step(Register::DeltaShift) * step(Register::FacingShift) / step(Register::TiltShift) *
                        std::sqrt(dot(u, u) / dot(d, d));
  const double tilt = std::hypot(static_cast<double>(g.u), static_cast<double>(g.v));
  constexpr double kRows = 1e-4;
  return {.left = delta * along,
          .left_error = step(Register::DeltaShift) / delta +
                        step(Register::FacingShift) / std::abs(static_cast<double>(g.d)),
          .right = margin * across,
          .right_error = kRows + 1.5 * step(Register::TiltShift) / std::max(tilt, 1.0)};
}

TEST(Margin, IsDeltaAgainstMarginTimesTangent) {
  const HardwareConfig config;
  Tally tally;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    stimulus::Random random(seed);
    RegisterValues registers = stimulus::scene_registers(config, random);
    const auto set = [&](Register reg, std::int64_t value) {
      registers[static_cast<std::size_t>(reg)] = value;
    };
    set(Register::DeltaShift, random.between(0, 6));
    set(Register::MarginSquared, random.between(1, 1 << 24) >> random.between(0, 14));
    const Vpu vpu = make_vpu(config, registers);
    for (const auto& item : voxel_pattern(stimulus::Pattern::Uniform, 50, registers, config, random)) {
      const Gradient g = vpu.gradient(item);
      if (g.d == 0) continue;
      const std::int64_t delta = random.between(1, (1 << 20) - 1) >> random.between(0, 19);
      if (delta >> vpu.get(Register::DeltaShift) > 4095) {
        ++tally.saturated;
        continue;
      }
      const Sides s = sides(vpu, registers, item, g, static_cast<double>(delta));
      const bool shadow = vpu.exceeds_margin(static_cast<std::uint32_t>(delta), g);
      if (std::abs(s.left - s.right) <= s.left_error * s.left + s.right_error * s.right) {
        ++tally.in_band;
        continue;
      }
      ASSERT_EQ(shadow, s.left > s.right)
          << "seed " << seed << ", delta " << delta << ": " << s.left << " against " << s.right;
      ++(shadow ? tally.shadow : tally.lit);
    }
  }
  // The statement decides nearly all, and both ways.
  EXPECT_GT(tally.shadow, 1500);
  EXPECT_GT(tally.lit, 1500);
  EXPECT_LT(tally.in_band, (tally.shadow + tally.lit) / 10);
}

TEST(Margin, ZeroMarginMakesEveryDeltaShadow) {
  Vpu vpu{HardwareConfig{}};
  EXPECT_TRUE(vpu.exceeds_margin(1, {.u = 5, .v = -7, .d = -1}));
  EXPECT_FALSE(vpu.exceeds_margin(0, {.u = 5, .v = -7, .d = -1}));
}

TEST(Margin, EqualityIsLit) {
  Vpu vpu{HardwareConfig{}};
  vpu.set(Register::MarginSquared, 4);
  const Gradient g{.u = 3, .v = 4, .d = -5};  // (delta 5)^2 against 4 * 25
  EXPECT_FALSE(vpu.exceeds_margin(2, g));
  EXPECT_TRUE(vpu.exceeds_margin(3, g));
}

TEST(Margin, ShiftsFloorMagnitudesAndSaturate) {
  Vpu vpu{HardwareConfig{}};
  vpu.set(Register::MarginSquared, 1);
  vpu.set(Register::TiltShift, 2);
  EXPECT_TRUE(vpu.exceeds_margin(1, {.u = -3, .v = 3, .d = -1})) << "3 / 4 is floored to 0 whatever its sign";
  EXPECT_FALSE(vpu.exceeds_margin(1, {.u = -4, .v = 0, .d = -1}));
  vpu.set(Register::DeltaShift, 4);
  EXPECT_FALSE(vpu.exceeds_margin(15, {.u = 0, .v = 0, .d = -1000})) << "delta_n is 0";
  EXPECT_TRUE(vpu.exceeds_margin(16, {.u = 0, .v = 0, .d = -1000}));
  vpu.set(Register::FacingShift, 63);
  EXPECT_FALSE(vpu.exceeds_margin(0xFFFFF, {.u = 4, .v = 0, .d = -1000})) << "g_dn is 0";
  vpu.set(Register::FacingShift, 0);
  vpu.set(Register::TiltShift, 0);
  vpu.set(Register::DeltaShift, 0);
  vpu.set(Register::MarginSquared, golden::Word{4095} * 4095);
  const std::int64_t large = 1 << 20;  // saturates to 65535
  EXPECT_FALSE(vpu.exceeds_margin(4095, {.u = large, .v = 0, .d = -large}));
  EXPECT_FALSE(vpu.exceeds_margin(0xFFFFF, {.u = large, .v = 0, .d = -large})) << "delta_n saturates to 4095";
  EXPECT_TRUE(vpu.exceeds_margin(4095, {.u = 65534, .v = 0, .d = -large}));
}

}  // namespace
}  // namespace gnomon::golden_test
