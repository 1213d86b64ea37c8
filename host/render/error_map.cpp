// SPDX-License-Identifier: Apache-2.0
// Where two pictures of the same view disagree about the shadow.
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "host/render/picture.hpp"
#include "host/render/shading.hpp"

namespace gnomon::render {
namespace {

using metrics::MaskValue;

constexpr std::array<double, 3> kFalseShadow = {0.90, 0.05, 0.05};  // sRGB, 0..1
constexpr std::array<double, 3> kFalseLit = {0.05, 0.25, 0.95};

struct Wrong {
  double false_shadow = 0, false_lit = 0;  ///< shares of the pixel's samples
};

Wrong wrong_in_sample(const Picture& picture, const Picture& reference, std::size_t sample) {
  const std::size_t samples = picture.mask.size() / picture.lights;
  Wrong wrong;
  for (std::size_t at = sample; at < picture.mask.size(); at += samples) {
    const MaskValue given = picture.mask[at];
    const MaskValue exact = reference.mask[at];
    if (given == MaskValue::Shadow && exact == MaskValue::Lit) wrong.false_shadow += 1;
    if (given == MaskValue::Lit && exact == MaskValue::Shadow) wrong.false_lit += 1;
  }
  const double lights = std::max(1.0, wrong.false_shadow + wrong.false_lit);
  return {wrong.false_shadow / lights, wrong.false_lit / lights};
}

Wrong wrong_in_pixel(const Picture& picture, const Picture& reference, std::size_t px, std::size_t py,
                     std::size_t super) {
  const std::size_t row = static_cast<std::size_t>(picture.image.width) * super;
  const double weight = 1.0 / static_cast<double>(super * super);
  Wrong wrong;
  for (std::size_t sy = py * super; sy < (py + 1) * super; ++sy)
    for (std::size_t sx = px * super; sx < (px + 1) * super; ++sx) {
      const Wrong sample = wrong_in_sample(picture, reference, sy * row + sx);
      wrong.false_shadow += weight * sample.false_shadow;
      wrong.false_lit += weight * sample.false_lit;
    }
  return wrong;
}

/// Light grey with little contrast left, so that colour stands out.
double dimmed(const std::uint8_t* rgb) {
  const double grey = (0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]) / 255;
  return 0.55 + 0.40 * grey;
}

}  // namespace

Image error_map(const Picture& picture, const Picture& reference) {
  const std::size_t pixels =
      static_cast<std::size_t>(picture.image.width) * static_cast<std::size_t>(picture.image.height);
  if (picture.image.width != reference.image.width || picture.image.height != reference.image.height ||
      picture.mask.size() != reference.mask.size() || picture.lights != reference.lights ||
      picture.lights == 0 || pixels == 0)
    throw std::invalid_argument("the picture and its reference differ in size");
  const std::size_t samples_per_pixel = picture.mask.size() / picture.lights / pixels;
  const auto super = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(samples_per_pixel))));
  const auto width = static_cast<std::size_t>(picture.image.width);
  Image map{picture.image.width, picture.image.height, std::vector<std::uint8_t>(3 * pixels)};
  for (std::size_t p = 0; p < pixels; ++p) {
    const Wrong wrong = wrong_in_pixel(picture, reference, p % width, p / width, super);
    const double base = dimmed(&reference.image.rgb[3 * p]);
    const double rest = 1 - wrong.false_shadow - wrong.false_lit;
    for (std::size_t k = 0; k < 3; ++k) {
      const double value =
          rest * base + wrong.false_shadow * kFalseShadow[k] + wrong.false_lit * kFalseLit[k];
      map.rgb[3 * p + k] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
    }
  }
  return map;
}

}  // namespace gnomon::render
