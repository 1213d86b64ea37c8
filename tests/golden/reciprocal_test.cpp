// SPDX-License-Identifier: Apache-2.0
// The reciprocal over all mantissas: its formula, its error bound, its range (docs/vpu.md, "Reciprocal").
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <gnomon/golden/perspective/reciprocal.hpp>

#include "tests/golden/perspective_oracle.hpp"

namespace gnomon::golden_test {
namespace {

namespace perspective = golden::perspective;

constexpr std::uint32_t kFirst = 1u << 23, kEnd = 1u << 24;

/// (r m - 1) with 47 fraction bits: r is below or above 1/m by so much of it.
std::int64_t excess(std::uint32_t m, std::uint64_t r) {
  return static_cast<std::int64_t>(r * m) - (std::int64_t{1} << 47);
}

TEST(Reciprocal, ErrorIsBelowItsBoundForAllMantissas) {
  std::int64_t least = 0, most = 0;
  std::uint32_t lowest = kEnd, highest = 0;
  for (std::uint32_t m = kFirst; m < kEnd; ++m) {
    const std::uint32_t r = perspective::reciprocal(m);
    lowest = std::min(lowest, r);
    highest = std::max(highest, r);
    least = std::min(least, excess(m, r));
    most = std::max(most, excess(m + 1, r));  // what the floor of w to m may have cut off
  }
  const double bound = std::exp2(47 - 19.7);
  EXPECT_LT(-static_cast<double>(least), bound);
  EXPECT_LT(static_cast<double>(most), std::exp2(47 - 23) * 1.001);
  EXPECT_NEAR(47 - std::log2(-static_cast<double>(least)), 19.82, 0.01) << "the page's figure";
  EXPECT_EQ(lowest, 8388606u);
  EXPECT_EQ(highest, 16777200u);
}

TEST(Reciprocal, IsThatOfThePage) {
  using exact::Rational;
  std::size_t compared = 0;
  for (std::uint32_t interval = 0; interval < 512; ++interval) {
    const std::uint32_t first = kFirst + (interval << 14);
    for (const std::uint32_t m :
         {first, first + 1, first + 8191, first + 8192, first + 12345, first + 16383}) {
      const Rational r = exact::reciprocal(Rational(m) * exact::power_of_two(-23));
      ASSERT_EQ(r * exact::power_of_two(24), Rational(perspective::reciprocal(m))) << m;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 3072u);
  EXPECT_EQ(perspective::seed(0), 65472u);
  EXPECT_EQ(perspective::seed(511), 32784u);
}

}  // namespace
}  // namespace gnomon::golden_test
