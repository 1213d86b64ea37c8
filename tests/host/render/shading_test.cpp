// SPDX-License-Identifier: Apache-2.0
// The shadow rule's terms, one by one.
#include "host/render/shading.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "host/render/picture.hpp"

namespace gnomon::render {
namespace {

const ShadingPoint kTowardsLight = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 1, 0}};
const Material kShiny = {{0.5f, 0.4f, 0.3f}, 0.5f, 10};
const Material kDull = {{0.5f, 0.4f, 0.3f}, 0.0f, 10};

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
    const Color shiny = shade(kTowardsLight, kShiny, light_share(n));
    const Color dull = shade(kTowardsLight, kDull, light_share(n));
    if (n == 0)
      EXPECT_GT(shiny[0], dull[0]);
    else
      EXPECT_EQ(shiny, dull);
  }
}

TEST(Shade, KeepsTheAmbientTermWhole) {
  const Color ambient = shade(kTowardsLight, kDull, light_share(4));
  const Color lit = shade(kTowardsLight, kDull, light_share(0));
  for (int n = 0; n <= 4; ++n) {
    const Color color = shade(kTowardsLight, kDull, light_share(n));
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(double{color[k] - ambient[k]}, double{lit[k] - ambient[k]} * diffuse_share(n), 1e-6);
  }
}

TEST(Shade, AwayFromTheLightThereIsAmbientLightOnly) {
  ShadingPoint away = kTowardsLight;
  away.to_light = {0, 0, -1};
  EXPECT_EQ(shade(away, kShiny, light_share(0)), shade(away, kShiny, light_share(4)));
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
