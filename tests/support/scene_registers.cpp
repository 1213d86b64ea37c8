// SPDX-License-Identifier: Apache-2.0
// Integers only, so that a seed means the same on every machine.
#include "tests/support/scene_registers.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>

namespace gnomon::stimulus {
namespace {

using golden::HardwareConfig;
using golden::Register;
using golden::RegisterFormat;

std::int64_t& at(RegisterValues& values, Register reg) {
  return values[static_cast<std::size_t>(reg)];
}

void clamp_register(RegisterValues& values, Register reg, const HardwareConfig& config) {
  at(values, reg) = std::clamp(at(values, reg), register_min(reg, config), register_max(reg, config));
}

/// Three coefficients of `scale`, and the constant that puts the grid's centre at `centre`.
void set_row(RegisterValues& values, Register first, const Row& row, std::int64_t norm, std::int64_t scale,
             std::int64_t centre, const HardwareConfig& config) {
  const auto start = static_cast<std::size_t>(first);
  const std::int64_t middle = std::int64_t{1} << (config.position_bits() - 1);
  std::int64_t constant = centre;
  for (std::size_t i = 0; i < 3; ++i) {
    values[start + i] = row[i] * scale / norm;
    clamp_register(values, static_cast<Register>(start + i), config);
    constant -= values[start + i] * middle;
  }
  values[start + 3] = constant;
  clamp_register(values, static_cast<Register>(start + 3), config);
}

/// The shift that brings sums of this row and a normal to about 16 bits.
std::int64_t gradient_shift(const RegisterValues& values, Register first, const HardwareConfig& config) {
  const auto start = static_cast<std::size_t>(first);
  std::int64_t largest = 0;
  for (std::size_t i = 0; i < 3; ++i) largest = std::max(largest, std::abs(values[start + i]));
  const int bits = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(largest))) + config.normal_bits;
  return std::max(0, bits - 16);
}

void set_offset_and_margin(RegisterValues& values, const HardwareConfig& config, Random& random) {
  const int ulps = config.voxel_frac_bits + 16 - config.normal_bits;  // one voxel along a unit normal
  at(values, Register::OffsetFactor) = (std::int64_t{1} << std::max(0, ulps)) * random.between(2, 9) / 4;
  if (random.chance(20)) {  // far enough to leave what was projected
    at(values, Register::OffsetFactor) = random.between(0, register_max(Register::OffsetFactor, config));
  }
  at(values, Register::FacingShift) = gradient_shift(values, Register::MatrixDx, config);
  at(values, Register::TiltShift) = gradient_shift(values, Register::MatrixUx, config);
  const std::int64_t delta_shift = random.between(0, std::max(0, config.depth_bits - 8));
  at(values, Register::DeltaShift) = delta_shift;
  // Squares of the deltas that the shift leaves, at most: larger margins would excuse everything.
  const std::int64_t margin_bits =
      random.between(0, std::min<std::int64_t>(24, 2 * (config.depth_bits - delta_shift)));
  at(values, Register::MarginSquared) = random.between(0, (std::int64_t{1} << margin_bits) - 1);
  at(values, Register::DeltaMax) =
      register_max(Register::DeltaMax, config) >> random.between(0, config.depth_bits / 2);
  if (random.chance(10)) at(values, Register::DeltaMax) = at(values, Register::MarginSquared) = 0;
  for (const Register reg : {Register::OffsetFactor, Register::FacingShift, Register::TiltShift}) {
    clamp_register(values, reg, config);
  }
}

std::int64_t extreme_value(std::int64_t low, std::int64_t high, Random& random) {
  switch (random.between(0, 7)) {
    case 0:
      return low;
    case 1:
      return high;
    case 2:
      return low + 1;
    case 3:
      return high - 1;
    case 4:
      return 0;
    case 5:
      return 1;
    case 6:
      return low < 0 ? -1 : high / 2;
    default:
      return random.between(low, high);
  }
}

}  // namespace

Rotation random_rotation(Random& random) {
  const std::int64_t a = random.between(1, 9);
  const std::int64_t b = random.between(-9, 9), c = random.between(-9, 9), d = random.between(-9, 9);
  Rotation r;
  r.norm = a * a + b * b + c * c + d * d;
  r.rows[0] = {a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)};
  r.rows[1] = {2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)};
  r.rows[2] = {2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d};
  return r;
}

std::int64_t register_min(Register reg, const HardwareConfig& config) {
  const RegisterFormat format = register_format(reg, config);
  return format.is_signed ? -(std::int64_t{1} << (format.width - 1)) : 0;
}

std::int64_t register_max(Register reg, const HardwareConfig& config) {
  const RegisterFormat format = register_format(reg, config);
  return (std::int64_t{1} << (format.is_signed ? format.width - 1 : format.width)) - 1;
}

std::int64_t extreme_value(Register reg, const HardwareConfig& config, Random& random) {
  return extreme_value(register_min(reg, config), register_max(reg, config), random);
}

RegisterValues scene_registers(const HardwareConfig& config, Random& random) {
  const int f = config.matrix_frac_bits, p = config.position_bits(), d = config.depth_bits;
  const Rotation rotation = random_rotation(random);
  // The grid's side covers 1/64 to 3/2 of the plane's side: many voxels an entry to many entries empty.
  const std::int64_t whole = std::int64_t{1} << (f + config.plane_log2 - p);
  const std::int64_t scale =
      std::max<std::int64_t>(whole * random.between(4, 6) / 4 >> random.between(0, 6), 1);
  const std::int64_t half_plane = std::int64_t{1} << (f + config.plane_log2 - 1);
  RegisterValues values{};
  set_row(values, Register::MatrixUx, rotation.rows[0], rotation.norm, scale, half_plane, config);
  set_row(values, Register::MatrixVx, rotation.rows[1], rotation.norm, scale, half_plane, config);
  const std::int64_t depth_scale = (std::int64_t{1} << (d + 4)) * random.between(2, 5) / 8;
  const std::int64_t half_depth = std::int64_t{1} << (d + p + 3);
  set_row(values, Register::MatrixDx, rotation.rows[2], rotation.norm, depth_scale, half_depth, config);
  set_offset_and_margin(values, config, random);
  return values;
}

RegisterValues extreme_registers(const HardwareConfig& config, Random& random) {
  RegisterValues values{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto reg = static_cast<Register>(i);
    values[i] = extreme_value(reg, config, random);
  }
  return values;
}

}  // namespace gnomon::stimulus
