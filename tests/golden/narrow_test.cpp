// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstdint>
#include <gnomon/golden/narrow.hpp>
#include <limits>

namespace gnomon::golden {
namespace {

constexpr std::int64_t kMin = std::numeric_limits<std::int64_t>::min();
constexpr std::int64_t kMax = std::numeric_limits<std::int64_t>::max();

TEST(Narrow, FloorGoesTowardsMinusInfinity) {
  EXPECT_EQ(narrow_floor(7, 2), 1);
  EXPECT_EQ(narrow_floor(-8, 2), -2);
  EXPECT_EQ(narrow_floor(-7, 2), -2);
  EXPECT_EQ(narrow_floor(-6, 2), -2) << "half-way below zero";
  EXPECT_EQ(narrow_floor(6, 2), 1) << "half-way above zero";
  EXPECT_EQ(narrow_floor(-1, 63), -1);
  EXPECT_EQ(narrow_floor(kMin, 63), -1);
  EXPECT_EQ(narrow_floor(kMax, 62), 1);
  EXPECT_EQ(narrow_floor(5, 0), 5);
}

TEST(Narrow, LowBitsAndSignExtension) {
  EXPECT_EQ(low_bits(0xFFFF, 4), 15u);
  EXPECT_EQ(low_bits(~std::uint64_t{0}, 64), ~std::uint64_t{0});
  EXPECT_EQ(low_bits(5, 0), 0u);
  EXPECT_EQ(sign_extend(0x8, 4), -8);
  EXPECT_EQ(sign_extend(0x17, 4), 7);
  EXPECT_EQ(sign_extend(1, 1), -1);
  EXPECT_EQ(sign_extend(static_cast<std::uint64_t>(kMin), 64), kMin);
}

TEST(Narrow, Magnitudes) {
  EXPECT_EQ(magnitude(-5), 5u);
  EXPECT_EQ(magnitude(kMin), std::uint64_t{1} << 63);
  EXPECT_EQ(narrow_magnitude(0x12345, 4, 16), 0x1234u);
  EXPECT_EQ(narrow_magnitude(0x12345, 0, 16), 0xFFFFu) << "saturates";
  EXPECT_EQ(narrow_magnitude(~std::uint64_t{0}, 63, 12), 1u);
}

TEST(Narrow, SaturationKeepsTheEnds) {
  EXPECT_EQ(saturate(-1, 0, 9), 0);
  EXPECT_EQ(saturate(0, 0, 9), 0);
  EXPECT_EQ(saturate(9, 0, 9), 9);
  EXPECT_EQ(saturate(kMax, 0, 9), 9);
}

TEST(Narrow, Fits) {
  EXPECT_TRUE(fits_signed(-8, 4));
  EXPECT_FALSE(fits_signed(-9, 4));
  EXPECT_TRUE(fits_signed(7, 4));
  EXPECT_FALSE(fits_signed(8, 4));
  EXPECT_TRUE(fits_unsigned(15, 4));
  EXPECT_FALSE(fits_unsigned(16, 4));
  EXPECT_FALSE(fits_unsigned(-1, 4));
}

}  // namespace
}  // namespace gnomon::golden
