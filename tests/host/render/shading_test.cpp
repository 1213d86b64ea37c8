// SPDX-License-Identifier: Apache-2.0
// The shadow rule's terms, one by one.
#include "host/render/shading.hpp"

#include <gtest/gtest.h>

#include <array>
#include <span>
#include <stdexcept>

#include "host/render/picture.hpp"

namespace gnomon::render {
namespace {

const ShadingPoint kPoint = {{0, 0, 1}, {0, 0, 1}, {0, 1, 0}};
const Material kShiny = {{0.5f, 0.4f, 0.3f}, 0.5f, 10};
const Material kDull = {{0.5f, 0.4f, 0.3f}, 0.0f, 10};

Color lit_from(const Vec3& to_light, const Material& material, int corners_in_shadow) {
  const LightTerm light{to_light, light_share(corners_in_shadow)};
  return shade(kPoint, material, std::span(&light, 1));
}
Color lit_from_above(const Material& material, int corners_in_shadow) {
  return lit_from({0, 0, 1}, material, corners_in_shadow);
}

TEST(LightShare, HalvesWithEveryCornerAndEndsAtFour) {
  EXPECT_EQ(diffuse_share(0), 1.0);
  EXPECT_EQ(diffuse_share(1), 0.5);
  EXPECT_EQ(diffuse_share(2), 0.25);
  EXPECT_EQ(diffuse_share(3), 0.125);
  EXPECT_EQ(diffuse_share(4), 0.0);
  EXPECT_THROW(diffuse_share(5), std::invalid_argument);
  EXPECT_THROW(diffuse_share(-1), std::invalid_argument);
}

TEST(LightShare, OnlyAFullyLitSubpatchHasAHighlight) {
  for (int n = 0; n <= 4; ++n) {
    EXPECT_EQ(light_share(n).highlight, n == 0);
    const Color shiny = lit_from_above(kShiny, n);
    const Color dull = lit_from_above(kDull, n);
    if (n == 0)
      EXPECT_GT(shiny[0], dull[0]);
    else
      EXPECT_EQ(shiny, dull);
  }
}

TEST(Shade, KeepsTheAmbientTermWhole) {
  const Color ambient = lit_from_above(kDull, 4);
  const Color lit = lit_from_above(kDull, 0);
  for (int n = 0; n <= 4; ++n) {
    const Color color = lit_from_above(kDull, n);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(double{color[k] - ambient[k]}, double{lit[k] - ambient[k]} * diffuse_share(n), 1e-6);
  }
}

TEST(Shade, AwayFromTheLightThereIsAmbientLightOnly) {
  EXPECT_EQ(lit_from({0, 0, -1}, kShiny, 0), lit_from({0, 0, -1}, kShiny, 4));
}

TEST(Shade, LightsAddUpAndHaveSharesOfTheirOwn) {
  const Color ambient = lit_from_above(kShiny, 4);
  const Color alone = lit_from_above(kShiny, 0);
  const LightTerm lit{{0, 0, 1}, light_share(0)};
  const LightTerm dark{{0, 0, 1}, light_share(4)};
  const LightTerm half{{0, 0, 1}, light_share(1)};
  const double strength = light_strength(2);
  EXPECT_LT(strength, 1.0);
  EXPECT_GT(2 * strength, 1.0);
  const Color both = shade(kPoint, kShiny, std::array{lit, lit});
  const Color one = shade(kPoint, kShiny, std::array{dark, lit});
  const Color none = shade(kPoint, kShiny, std::array{dark, dark});
  const Color dim = shade(kPoint, kDull, std::array{half, dark});
  EXPECT_EQ(none, ambient);
  for (std::size_t k = 0; k < 3; ++k) {
    const double light = double{alone[k]} - double{ambient[k]};
    EXPECT_NEAR(double{one[k]} - double{ambient[k]}, strength * light, 1e-6);
    EXPECT_NEAR(double{both[k]} - double{ambient[k]}, 2 * strength * light, 1e-6);
    const double diffuse = double{lit_from_above(kDull, 0)[k]} - double{lit_from_above(kDull, 4)[k]};
    EXPECT_NEAR(double{dim[k]} - double{lit_from_above(kDull, 4)[k]}, strength * diffuse / 2, 1e-6);
  }
}

TEST(ToSrgb, HitsBothEndsAndTheKnownMiddle) {
  EXPECT_EQ(to_srgb(0), 0);
  EXPECT_EQ(to_srgb(1), 255);
  EXPECT_EQ(to_srgb(-3), 0);
  EXPECT_EQ(to_srgb(7), 255);
  EXPECT_EQ(to_srgb(0.2140411), 128 - 1);  // 0.5 encoded is 127.5, just missed
  EXPECT_EQ(to_srgb(1, 0.5), 255);
  EXPECT_EQ(to_srgb(0, -0.5), 0);
}

TEST(DitherNoise, StaysWithinHalfAByteAndIsBalanced) {
  double sum = 0;
  for (std::size_t y = 0; y < 64; ++y)
    for (std::size_t x = 0; x < 64; ++x) {
      const double noise = dither_noise(x, y);
      EXPECT_GE(noise, -0.5);
      EXPECT_LT(noise, 0.5);
      sum += noise;
    }
  EXPECT_NEAR(sum / 4096, 0, 0.02);
}

}  // namespace
}  // namespace gnomon::render
