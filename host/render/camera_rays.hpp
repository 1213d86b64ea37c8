// SPDX-License-Identifier: Apache-2.0
// From a camera to one ray per sample.
#pragma once

#include "host/base/vec.hpp"
#include "host/render/view.hpp"

namespace gnomon::render {

/// Unit directions through the picture plane; x runs 0..1 from left to right, y 0..1 from bottom to top.
class CameraRays {
 public:
  /// Throws std::invalid_argument where the camera has no direction (eye on target, up along the view, bad
  /// angle).
  CameraRays(const Camera& camera, double aspect);
  const Vec3& eye() const { return eye_; }
  Vec3 direction(double x, double y) const;

 private:
  Vec3 eye_, ahead_, right_, up_;  ///< right and up reach the picture's edge at distance 1
};

}  // namespace gnomon::render
