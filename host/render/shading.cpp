// SPDX-License-Identifier: Apache-2.0
// All constants of the pictures' look that are not a material's or the camera's.
#include "host/render/shading.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "host/render/picture.hpp"

namespace gnomon::render {
namespace {

constexpr Color kSky = {0.30f, 0.33f, 0.38f};     ///< ambient from above
constexpr Color kBounce = {0.17f, 0.15f, 0.13f};  ///< ambient from below
constexpr Color kSun = {0.92f, 0.87f, 0.79f};
constexpr Color kHorizon = {0.90f, 0.89f, 0.87f};
constexpr Color kZenith = {0.50f, 0.57f, 0.66f};

Color blend(const Color& a, const Color& b, double t) {
  Color mixed{};
  for (std::size_t k = 0; k < 3; ++k) mixed[k] = static_cast<float>(a[k] + (b[k] - a[k]) * t);
  return mixed;
}

}  // namespace

LightShare light_share(int corners_in_shadow) {
  if (corners_in_shadow < 0 || corners_in_shadow > 4)
    throw std::invalid_argument("a subpatch has 0 to 4 corners in shadow");
  if (corners_in_shadow == 4) return {0.0, false};
  return {std::ldexp(1.0, -corners_in_shadow), corners_in_shadow == 0};
}

double diffuse_share(int corners_in_shadow) {
  return light_share(corners_in_shadow).diffuse;
}

double light_strength(std::size_t lights) {
  return lights < 2 ? 1.0 : std::pow(static_cast<double>(lights), -0.75);
}

Color shade(const ShadingPoint& point, const Material& material, std::span<const LightTerm> lights) {
  const Color ambient = blend(kBounce, kSky, 0.5 + 0.5 * point.normal.dot(point.up));
  const double strength = light_strength(lights.size());
  double diffuse = 0;
  double specular = 0;
  for (const LightTerm& light : lights) {
    const double facing = std::max(0.0, point.normal.dot(light.to_light));
    diffuse += strength * light.share.diffuse * facing;
    if (!light.share.highlight || facing == 0) continue;
    const Vec3 half = (light.to_light + point.to_eye).normalized();
    specular += strength * material.specular *
                std::pow(std::max(0.0, point.normal.dot(half)), double{material.shininess});
  }
  Color color{};
  for (std::size_t k = 0; k < 3; ++k)
    color[k] =
        static_cast<float>(material.diffuse[k] * (ambient[k] + kSun[k] * diffuse) + kSun[k] * specular);
  return color;
}

Color background(double height) {
  return blend(kHorizon, kZenith, std::clamp(height, 0.0, 1.0));
}

std::uint8_t to_srgb(double linear, double dither) {
  const double x = std::clamp(linear, 0.0, 1.0);
  const double encoded = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::clamp(std::lround(encoded * 255 + dither), 0L, 255L));
}

double dither_noise(std::size_t x, std::size_t y) {
  // Interleaved gradient noise: evenly spread among neighbours, no table.
  const double turn = 0.06711056 * static_cast<double>(x) + 0.00583715 * static_cast<double>(y);
  const double noise = 52.9829189 * (turn - std::floor(turn));
  return noise - std::floor(noise) - 0.5;
}

}  // namespace gnomon::render
