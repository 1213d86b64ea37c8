// SPDX-License-Identifier: Apache-2.0
// The narrowings of the unit, each under its name. All values of the unit fit 64 bits
// (docs/number-formats.md).
#pragma once

#include <algorithm>
#include <cstdint>

namespace gnomon::golden {

/// The low `width` bits of `bits`, read as unsigned. 0 <= width <= 64.
constexpr std::uint64_t low_bits(std::uint64_t bits, int width) {
  return width >= 64 ? bits : bits & ((std::uint64_t{1} << width) - 1);
}

/// The low `width` bits of `bits`, read as two's complement. 1 <= width <= 64.
constexpr std::int64_t sign_extend(std::uint64_t bits, int width) {
  const int unused = 64 - width;
  return static_cast<std::int64_t>(bits << unused) >> unused;
}

/// Drops `shift` fraction bits, rounding towards minus infinity. 0 <= shift <= 63.
constexpr std::int64_t narrow_floor(std::int64_t value, int shift) {
  return value >> shift;
}

/// The nearest value in low..high.
constexpr std::int64_t saturate(std::int64_t value, std::int64_t low, std::int64_t high) {
  return std::min(std::max(value, low), high);
}

/// |value| as unsigned; exact for every value.
constexpr std::uint64_t magnitude(std::int64_t value) {
  return value < 0 ? ~static_cast<std::uint64_t>(value) + 1 : static_cast<std::uint64_t>(value);
}

/// Drops `shift` bits of a magnitude (floor) and saturates the rest to `width` bits. 0 <= shift <= 63.
constexpr std::uint64_t narrow_magnitude(std::uint64_t value, int shift, int width) {
  return std::min(value >> shift, (std::uint64_t{1} << width) - 1);
}

constexpr bool fits_signed(std::int64_t value, int width) {
  return sign_extend(static_cast<std::uint64_t>(value), width) == value;
}
constexpr bool fits_unsigned(std::int64_t value, int width) {
  return value >= 0 &&
         low_bits(static_cast<std::uint64_t>(value), width) == static_cast<std::uint64_t>(value);
}

}  // namespace gnomon::golden
