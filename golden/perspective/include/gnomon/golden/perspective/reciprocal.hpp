// SPDX-License-Identifier: Apache-2.0
// The reciprocal of docs/vpu.md: a table of 512 seeds and one Newton step.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace gnomon::golden::perspective {

inline constexpr int kMantissaBits = 24;    ///< of m (23 of them fraction) and of r (all of them)
inline constexpr int kSeedIndexBits = 9;    ///< below m's highest bit
inline constexpr int kSeedFracBits = 16;    ///< a seed has no others
inline constexpr int kNewtonFracBits = 24;  ///< of t = 2 - m * seed

/// 1 over the middle of the i-th interval of 1..2, rounded to nearest.
constexpr std::uint32_t seed(std::uint32_t i) {
  const std::uint64_t odd = (std::uint64_t{1} << (kSeedIndexBits + 1)) + 2 * std::uint64_t{i} + 1;
  return static_cast<std::uint32_t>(((std::uint64_t{1} << 27) + odd) / (2 * odd));
}

inline constexpr auto kSeeds = [] {
  std::array<std::uint32_t, std::size_t{1} << kSeedIndexBits> seeds{};
  for (std::uint32_t i = 0; i < seeds.size(); ++i) seeds[i] = seed(i);
  return seeds;
}();

/// 2^47 / m within a factor of 1 +- 2^-19.7, for 2^23 <= m < 2^24; below 2^24.
constexpr std::uint32_t reciprocal(std::uint32_t m) {
  const std::uint32_t low = m >> (kMantissaBits - 1 - kSeedIndexBits);
  const std::uint64_t start = kSeeds[low - (std::uint32_t{1} << kSeedIndexBits)];
  constexpr int kProductFrac = kMantissaBits - 1 + kSeedFracBits;
  const std::uint64_t t =
      ((std::uint64_t{2} << kProductFrac) - m * start) >> (kProductFrac - kNewtonFracBits);
  return static_cast<std::uint32_t>((start * t) >> (kSeedFracBits + kNewtonFracBits - kMantissaBits));
}

}  // namespace gnomon::golden::perspective
