// SPDX-License-Identifier: Apache-2.0
// Blinn-Phong in linear light, with the shadow rule of the subpatches (docs/rendering.md, "Shading").
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "host/base/vec.hpp"
#include "host/render/view.hpp"

namespace gnomon::render {

using Color = std::array<float, 3>;  ///< linear RGB

/// What a shadow leaves of the light's terms.
struct LightShare {
  double diffuse = 1;  ///< 0..1
  bool highlight = true;
};

/// n of a subpatch's four corners in shadow. Throws std::invalid_argument outside 0..4.
LightShare light_share(int corners_in_shadow);

/// One surface point as the camera sees it; unit vectors, `normal` on the camera's side.
struct ShadingPoint {
  Vec3 normal, to_eye, up;
};

/// One light at that point.
struct LightTerm {
  Vec3 to_light;  ///< unit length
  LightShare share;
};

/// Ambient light once, and each light's diffuse and specular terms; each counts
/// light_strength(lights.size()). Ambient light comes from a sky brighter than the ground, so that shadows
/// keep some shape.
Color shade(const ShadingPoint& point, const Material& material, std::span<const LightTerm> lights);

/// How strong each of several equal lights is, 1 for a single one: a scene with more lights is brighter where
/// all of them reach, and not white.
double light_strength(std::size_t lights);

/// Behind everything: `height` runs from 0 at the picture's bottom to 1 at its top.
Color background(double height);

/// Linear 0..1 to an sRGB byte, rounded to nearest after `dither` (in bytes, |dither| <= 1/2) is added.
std::uint8_t to_srgb(double linear, double dither = 0);

/// Noise for pixel (x, y) in [-1/2, 1/2), always the same: it keeps a slow gradient from showing steps.
double dither_noise(std::size_t x, std::size_t y);

}  // namespace gnomon::render
