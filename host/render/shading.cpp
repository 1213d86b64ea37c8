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
constexpr Color kSun = {0.98f, 0.93f, 0.84f};
constexpr Color kHorizon = {0.83f, 0.85f, 0.87f};
constexpr Color kZenith = {0.46f, 0.55f, 0.66f};

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

Color shade(const ShadingPoint& point, const Material& material, const LightShare& share) {
  const Color ambient = blend(kBounce, kSky, 0.5 + 0.5 * point.normal.dot(point.up));
  const double facing = std::max(0.0, point.normal.dot(point.to_light));
  const double diffuse = share.diffuse * facing;
  double specular = 0;
  if (share.highlight && facing > 0) {
    const Vec3 half = (point.to_light + point.to_eye).normalized();
    specular =
        material.specular * std::pow(std::max(0.0, point.normal.dot(half)), double{material.shininess});
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

std::uint8_t to_srgb(double linear) {
  const double x = std::clamp(linear, 0.0, 1.0);
  const double encoded = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(encoded * 255));
}

}  // namespace gnomon::render
