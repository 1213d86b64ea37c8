// SPDX-License-Identifier: Apache-2.0
// Counts over masks made by hand.
#include "host/metrics/image_error.hpp"

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>
#include <vector>

namespace gnomon::metrics {
namespace {

constexpr auto kB = MaskValue::Background;
constexpr auto kL = MaskValue::Lit;
constexpr auto kS = MaskValue::Shadow;

TEST(MaskError, CountsEachKindOverReceiversOnly) {
  const std::array mask = {kB, kL, kL, kL, kS, kS, kS, kS, kS, kL};
  const std::array exact = {kB, kL, kL, kS, kS, kS, kS, kL, kL, kL};
  const MaskError error = mask_error(mask, exact);
  EXPECT_EQ(error.receivers, 9u);
  EXPECT_EQ(error.false_shadow, 2u);
  EXPECT_EQ(error.false_lit, 1u);
  EXPECT_EQ(error.both_shadow, 3u);
  EXPECT_DOUBLE_EQ(error.false_shadow_share(), 2.0 / 9);
  EXPECT_DOUBLE_EQ(error.false_lit_share(), 1.0 / 9);
  EXPECT_DOUBLE_EQ(error.iou(), 3.0 / 6);
}

TEST(MaskError, PerfectAndEmptyMasks) {
  const std::array lit = {kB, kL, kL};
  EXPECT_DOUBLE_EQ(mask_error(lit, lit).iou(), 1.0);
  EXPECT_DOUBLE_EQ(mask_error({}, {}).false_lit_share(), 0.0);
}

TEST(MaskError, RefusesMasksOfDifferentViews) {
  const std::array one = {kB, kL};
  const std::array other = {kL, kL};
  EXPECT_THROW(mask_error(one, other), std::invalid_argument);
  EXPECT_THROW(mask_error(std::span(one).first(1), other), std::invalid_argument);
}

TEST(Rmse, IsInUnitsOfFullScale) {
  const std::vector<std::uint8_t> black(12, 0);
  std::vector<std::uint8_t> other(12, 0);
  EXPECT_DOUBLE_EQ(rmse(black, other), 0.0);
  for (std::size_t i = 0; i < 3; ++i) other[i] = 255;
  EXPECT_DOUBLE_EQ(rmse(black, other), 0.5);
  EXPECT_THROW(rmse(black, std::vector<std::uint8_t>(3)), std::invalid_argument);
}

}  // namespace
}  // namespace gnomon::metrics
