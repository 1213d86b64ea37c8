// SPDX-License-Identifier: Apache-2.0
// The pipelined reciprocal, for every mantissa: the page's formula word for word, and its error bound.
#include <gtest/gtest.h>
#include <verilated.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "Vreciprocal.h"

namespace gnomon::rtl_test {
namespace {

constexpr std::uint32_t kFirst = 1u << 23, kMantissas = 1u << 23;
constexpr unsigned kStages = 4;

/// docs/vpu.md, "Reciprocal".
std::uint32_t reciprocal(std::uint64_t m) {
  const std::uint64_t i = m >> 14 & 511u, o = 1024 + 2 * i + 1;
  const std::uint64_t seed = ((std::uint64_t{1} << 27) + o) / (2 * o);
  const std::uint64_t t = ((std::uint64_t{1} << 40) - m * seed) >> 15;
  return static_cast<std::uint32_t>(seed * t >> 16);
}

void clock(Vreciprocal& unit) {
  unit.clk_i = 0;
  unit.eval();
  unit.clk_i = 1;
  unit.eval();
}

TEST(Reciprocal, EveryMantissaOneACycle) {
  VerilatedContext context;
  Vreciprocal unit(&context);
  unit.en_i = 1;
  std::uint32_t differing = 0, compared = 0;
  double largest = 0;
  for (std::uint32_t step = 0; step < kMantissas + kStages - 1; ++step) {
    unit.m_i = kFirst + (step < kMantissas ? step : 0);
    clock(unit);
    if (step + 1 < kStages) continue;
    const std::uint32_t m = kFirst + step - (kStages - 1);
    differing += unit.r_o != reciprocal(m) ? 1u : 0u;
    // m stands for all of [m, m + 1): the error at both ends.
    const double r = std::ldexp(unit.r_o, -24);
    largest =
        std::max({largest, std::abs(r * std::ldexp(m, -23) - 1), std::abs(r * std::ldexp(m + 1.0, -23) - 1)});
    ++compared;
  }
  EXPECT_EQ(compared, kMantissas);
  EXPECT_EQ(differing, 0u);
  EXPECT_LT(std::log2(largest), -19.7);
  EXPECT_GT(std::log2(largest), -19.9);
}

TEST(Reciprocal, WaitsWithEverythingInItsStages) {
  VerilatedContext context;
  Vreciprocal unit(&context);
  constexpr std::array<std::uint32_t, 6> kValues{kFirst, 0xFFFFFF, 0xABCDEF, 0x800001, 0xC00000, 0xFFC000};
  unsigned taken = 0, given = 0;
  for (unsigned cycle = 0; given < kValues.size(); ++cycle) {
    ASSERT_LT(cycle, 100u);
    unit.en_i = cycle % 3 == 1;
    unit.m_i = unit.en_i != 0 && taken < kValues.size() ? kValues.at(taken) : kFirst + cycle;
    clock(unit);
    if (unit.en_i == 0) continue;
    if (++taken < kStages) continue;
    EXPECT_EQ(unit.r_o, reciprocal(kValues.at(given++)));
  }
}

}  // namespace
}  // namespace gnomon::rtl_test
