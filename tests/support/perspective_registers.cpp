// SPDX-License-Identifier: Apache-2.0
// Integers only, so that a seed means the same on every machine.
#include "tests/support/perspective_registers.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdlib>
#include <gnomon/golden/vpu.hpp>

namespace gnomon::stimulus {
namespace {

using golden::HardwareConfig;
using golden::Register;

/// A light, its plane's axes, and how far it is from the grid's middle.
struct Stand {
  Rotation axes;
  Row light{};  ///< where all rows vanish, in item coordinates
  std::int64_t distance = 0;
};

std::int64_t& at(AllRegisters& values, Register reg) {
  return values[static_cast<std::size_t>(reg)];
}

void set(AllRegisters& values, Register reg, std::int64_t value, const HardwareConfig& config) {
  at(values, reg) = std::clamp(value, register_min(reg, config), register_max(reg, config));
}

/// In the grid's middle, anywhere in it, at its border or up to three grids away.
std::int64_t any_distance(std::int64_t side, Random& random) {
  switch (random.between(0, 5)) {
    case 0:
      return random.between(0, 3);
    case 1:
      return random.between(0, side / 2);
    case 2:
      return random.between(side * 2, side * 3);
    default:
      return random.between(side / 2, side);
  }
}

Stand any_stand(const HardwareConfig& config, Random& random) {
  const std::int64_t side = std::int64_t{1} << config.position_bits();
  Stand stand{.axes = random_rotation(random), .distance = any_distance(side, random)};
  for (std::size_t i = 0; i < 3; ++i)
    stand.light[i] = side / 2 - stand.axes.rows[2][i] * stand.distance / stand.axes.norm;
  return stand;
}

/// Coefficients of row * scale / norm, and the constant that makes the row vanish at the light.
void set_row(AllRegisters& values, Register first, const Row& row, std::int64_t scale, const Stand& stand,
             const HardwareConfig& config) {
  const auto start = static_cast<std::size_t>(first);
  std::int64_t constant = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    set(values, static_cast<Register>(start + i), row[i] * scale / stand.axes.norm, config);
    constant -= values[start + i] * stand.light[i];
  }
  set(values, static_cast<Register>(start + 3), constant, config);
}

/// The shift that leaves about 16 of `bits`.
std::int64_t shift_to_16(std::int64_t bits) {
  return std::max<std::int64_t>(0, bits - 16);
}

void set_keys(AllRegisters& values, const HardwareConfig& config, Random& random) {
  const std::int64_t scale = register_max(Register::KeyScale, config) >> random.between(4, 8);
  const std::int64_t codes = std::int64_t{1} << (config.depth_bits + 4);
  set(values, Register::KeyScale, scale, config);
  // The farthest voxels, w about 1, get a code near the last, now and then beyond.
  set(values, Register::KeyLimit, scale + codes * random.between(6, 10) / 8, config);
}

}  // namespace

AllRegisters perspective_registers(const HardwareConfig& config, Random& random) {
  const RegisterValues base = scene_registers(config, random);
  AllRegisters values{};
  std::copy(base.begin(), base.end(), values.begin());
  const int f = config.matrix_frac_bits, p = config.position_bits();
  const Stand stand = any_stand(config, random);
  const std::int64_t side = std::int64_t{1} << p;
  // w = 1 at 2^far ulps from the light: a little behind the grid's middle.
  const int far = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(stand.distance + side / 2)));
  set(values, Register::Projection, random.chance(50) ? 3 : 1, config);
  set_row(values, Register::MatrixWx, stand.axes.rows[2], std::int64_t{1} << (f + p - far), stand, config);
  // Entries per unit of slope: an eighth to one and a half of the plane.
  const std::int64_t entries = (std::int64_t{1} << config.plane_log2) * random.between(1, 12) / 8;
  const std::int64_t scale = std::max<std::int64_t>(entries << f >> far, 1);
  set_row(values, Register::MatrixUx, stand.axes.rows[0], scale, stand, config);
  set_row(values, Register::MatrixVx, stand.axes.rows[1], scale, stand, config);
  set(values, Register::WNear, random.between(0, side / 8), config);
  for (const Register centre : {Register::CentreU, Register::CentreV})
    set(values, centre, config.plane_side() / 2 + random.between(-2, 2), config);
  set_keys(values, config, random);
  for (std::size_t i = 0; i < 3; ++i)
    set(values, static_cast<Register>(static_cast<std::size_t>(Register::LightX) + i), 8 * stand.light[i] + 4,
        config);
  const std::int64_t radius = entries * 256 * random.between(1, 8) / 8;
  set(values, Register::ConeSquared, radius * radius, config);
  set(values, Register::FacingShift, shift_to_16(far + 3 + config.normal_bits), config);
  const auto bits = std::bit_width(static_cast<std::uint64_t>(scale));
  set(values, Register::TiltShift, shift_to_16(static_cast<std::int64_t>(bits) + config.normal_bits), config);
  set(values, Register::DeltaMax, register_max(Register::DeltaMax, config) >> random.between(0, 6), config);
  return values;
}

AllRegisters extreme_perspective_registers(const HardwareConfig& config, int percent, Random& random) {
  AllRegisters values = perspective_registers(config, random);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto reg = static_cast<Register>(i);
    if (random.chance(percent)) values[i] = extreme_value(reg, config, random);
  }
  at(values, Register::Projection) |= golden::kProjectionPerspective;
  return values;
}

RegisterValues pattern_registers(const AllRegisters& registers, const HardwareConfig& config) {
  RegisterValues values{};
  std::copy_n(registers.begin(), values.size(), values.begin());
  for (std::size_t i = 0; i < 3; ++i) {
    const auto reg = static_cast<std::size_t>(Register::MatrixDx) + i;
    values[reg] = std::clamp(registers[static_cast<std::size_t>(Register::MatrixWx) + i],
                             register_min(static_cast<Register>(reg), config),
                             register_max(static_cast<Register>(reg), config));
  }
  return values;
}

golden::topology::ProjectionRegisters projection_registers(const AllRegisters& registers,
                                                           const HardwareConfig& config) {
  golden::Vpu vpu(config);
  for (std::size_t i = 0; i < registers.size(); ++i)
    vpu.set(static_cast<Register>(i), static_cast<golden::Word>(registers[i]));
  golden::topology::ProjectionRegisters result;
  for (std::size_t i = 0; i < result.matrix.size(); ++i) result.matrix[i] = vpu.get(static_cast<Register>(i));
  result.offset_factor = vpu.get(Register::OffsetFactor);
  result.perspective = vpu.light().registers();
  return result;
}

}  // namespace gnomon::stimulus
