// SPDX-License-Identifier: Apache-2.0
// Does a point of the surface face the light? Theory: docs/outline.md, "Signs".
#pragma once

#include <cstdint>
#include <optional>

#include "host/outline/outline.hpp"

namespace gnomon::outline {

/// Cosines up to this are edge-on, and edge-on does not face the light. Far above rounding errors (1e-11),
/// far below what could move a contour visibly.
inline constexpr double kEdgeOn = 1e-9;

/// What is wrong with a frame: a number that is not finite, or rows that do not span space.
std::optional<Error> check(const LightFrame& frame);

inline bool faces_light(double cosine) {
  return cosine > kEdgeOn;
}

/// A light frame taken apart: everything else asks this one.
class LightView {
 public:
  explicit LightView(const LightFrame& frame);

  const LightFrame& frame() const { return frame_; }
  /// Towards the light, unit length.
  const Vec3& to_light() const { return to_light_; }
  /// The picture is not the one the light sees but its mirror image: what faces the light runs clockwise.
  bool mirrored() const { return mirrored_; }
  /// Pixels per unit of length across the view, the larger of the two axes'.
  double scale() const { return scale_; }
  /// Depth codes of a pixel's length along the light.
  double codes_per_pixel() const { return codes_per_pixel_; }
  Vertex vertex(const Vec3& p) const;

 private:
  LightFrame frame_;
  Vec3 to_light_;
  bool mirrored_;
  double scale_, codes_per_pixel_;
};

/// How a place of a surface stands to the light.
struct Stance {
  double cosine;  ///< of normal and direction to the light
  Vec3 du, dv;
};

Stance stance(const surface::LimitSurface& surface, const LightView& view, const surface::Place& place);

}  // namespace gnomon::outline
