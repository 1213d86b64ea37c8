// SPDX-License-Identifier: Apache-2.0
// Red and blue appear where they should, and nowhere else.
#include <gtest/gtest.h>

#include <stdexcept>

#include "host/render/picture.hpp"

namespace gnomon::render {
namespace {

using metrics::MaskValue;

Picture grey(int width, int height, int supersample, MaskValue mask) {
  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  const auto samples = pixels * static_cast<std::size_t>(supersample) * static_cast<std::size_t>(supersample);
  return {{width, height, std::vector<std::uint8_t>(3 * pixels, 128)}, std::vector<MaskValue>(samples, mask)};
}

std::array<int, 3> pixel(const Image& image, std::size_t index) {
  return {image.rgb[3 * index], image.rgb[3 * index + 1], image.rgb[3 * index + 2]};
}

TEST(ErrorMap, IsGreyWhereBothAgree) {
  const Picture lit = grey(4, 3, 2, MaskValue::Lit);
  const Image map = error_map(lit, lit);
  for (std::size_t p = 0; p < 12; ++p) {
    const auto [r, g, b] = pixel(map, p);
    EXPECT_EQ(r, g);
    EXPECT_EQ(g, b);
  }
}

TEST(ErrorMap, FalseShadowIsRedAndFalseLitBlue) {
  const Picture lit = grey(2, 2, 1, MaskValue::Lit);
  Picture given = lit;
  given.mask[1] = MaskValue::Shadow;
  const Image red = error_map(given, lit);
  EXPECT_GT(pixel(red, 1)[0], pixel(red, 1)[2] + 150);
  const Image blue = error_map(lit, given);
  EXPECT_GT(pixel(blue, 1)[2], pixel(blue, 1)[0] + 150);
  for (const std::size_t p : {std::size_t{0}, std::size_t{2}, std::size_t{3}})
    EXPECT_EQ(pixel(red, p), pixel(blue, p));
}

TEST(ErrorMap, BlendsByTheShareOfSamplesInThePixel) {
  const Picture lit = grey(2, 1, 2, MaskValue::Lit);
  Picture given = lit;
  given.mask[2] = MaskValue::Shadow;  // bottom row of samples, second pixel
  const Image map = error_map(given, lit);
  EXPECT_EQ(pixel(map, 0)[0], pixel(map, 0)[1]);
  const int difference = pixel(map, 1)[0] - pixel(map, 1)[1];
  EXPECT_GT(difference, 20);
  EXPECT_LT(difference, 100);
}

TEST(ErrorMap, RefusesPicturesOfDifferentSize) {
  EXPECT_THROW(error_map(grey(2, 2, 1, MaskValue::Lit), grey(2, 3, 1, MaskValue::Lit)),
               std::invalid_argument);
  EXPECT_THROW(error_map(grey(2, 2, 1, MaskValue::Lit), grey(2, 2, 2, MaskValue::Lit)),
               std::invalid_argument);
  EXPECT_THROW(error_map({}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace gnomon::render
