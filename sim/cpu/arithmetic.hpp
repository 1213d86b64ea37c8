// SPDX-License-Identifier: Apache-2.0
// Multiplication and division of RV32M, at the ends of their ranges too.
#pragma once

#include <cstdint>
#include <limits>

namespace gnomon::sim::cpu {

constexpr std::int32_t as_signed(std::uint32_t value) {
  return static_cast<std::int32_t>(value);
}

/// Bits 63:32 of the product; each factor is signed or not.
constexpr std::uint32_t high_product(std::int64_t a, std::int64_t b) {
  // Modulo 2^64 the product's bits do not depend on signs, once the factors are extended to 64 bits.
  return static_cast<std::uint32_t>(static_cast<std::uint64_t>(a) * static_cast<std::uint64_t>(b) >> 32U);
}
constexpr std::uint32_t mulh(std::uint32_t a, std::uint32_t b) {
  return high_product(as_signed(a), as_signed(b));
}
constexpr std::uint32_t mulhsu(std::uint32_t a, std::uint32_t b) {
  return high_product(as_signed(a), b);
}
constexpr std::uint32_t mulhu(std::uint32_t a, std::uint32_t b) {
  return high_product(a, b);
}

/// Whether a / b does not fit: −2^31 / −1.
constexpr bool division_overflows(std::uint32_t a, std::uint32_t b) {
  return as_signed(a) == std::numeric_limits<std::int32_t>::min() && as_signed(b) == -1;
}
constexpr std::uint32_t div(std::uint32_t a, std::uint32_t b) {
  if (b == 0) return ~0U;
  return division_overflows(a, b) ? a : static_cast<std::uint32_t>(as_signed(a) / as_signed(b));
}
constexpr std::uint32_t divu(std::uint32_t a, std::uint32_t b) {
  return b == 0 ? ~0U : a / b;
}
constexpr std::uint32_t rem(std::uint32_t a, std::uint32_t b) {
  if (b == 0) return a;
  return division_overflows(a, b) ? 0 : static_cast<std::uint32_t>(as_signed(a) % as_signed(b));
}
constexpr std::uint32_t remu(std::uint32_t a, std::uint32_t b) {
  return b == 0 ? a : a % b;
}

constexpr std::uint32_t shift_right_arithmetic(std::uint32_t value, std::uint32_t amount) {
  return static_cast<std::uint32_t>(as_signed(value) >> (amount & 31U));
}

}  // namespace gnomon::sim::cpu
