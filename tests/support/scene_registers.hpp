// SPDX-License-Identifier: Apache-2.0
// Register contents for tests: like a host would set them, and like nobody would.
#pragma once

#include <array>
#include <cstdint>
#include <gnomon/golden/codec.hpp>

#include "tests/support/random.hpp"

namespace gnomon::stimulus {

using RegisterValues = std::array<std::int64_t, golden::kRegisterCount>;

/// Smallest and largest content of a register.
std::int64_t register_min(golden::Register reg, const golden::HardwareConfig& config);
std::int64_t register_max(golden::Register reg, const golden::HardwareConfig& config);

using Row = std::array<std::int64_t, 3>;
struct Rotation {
  std::array<Row, 3> rows{};  ///< times `norm`
  std::int64_t norm = 1;
};
/// That of an integer quaternion; its entries are exact fractions of its norm.
Rotation random_rotation(Random& random);

/// Lowest, highest, next to those, 0, ±1 or any.
std::int64_t extreme_value(golden::Register reg, const golden::HardwareConfig& config, Random& random);

/// A random rotation, scaled so that the grid covers part of the plane and of the depth range, now and then
/// more than all of it; shifts that let the margin test use its bits.
RegisterValues scene_registers(const golden::HardwareConfig& config, Random& random);

/// Every register on its own: lowest, highest, next to those, 0, ±1 or any.
RegisterValues extreme_registers(const golden::HardwareConfig& config, Random& random);

}  // namespace gnomon::stimulus
