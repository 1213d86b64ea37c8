// SPDX-License-Identifier: Apache-2.0
// A pinhole.
#include "host/render/camera_rays.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace gnomon::render {

CameraRays::CameraRays(const Camera& camera, double aspect) : eye_(camera.eye) {
  const Vec3 view = camera.target - camera.eye;
  const Vec3 side = view.cross(camera.up);
  if (!(side.length() > 1e-9 * view.length() * camera.up.length()))
    throw std::invalid_argument("the camera's view and up directions must differ");
  if (!(camera.fov_degrees > 0 && camera.fov_degrees < 180))
    throw std::invalid_argument("the camera's field of view must lie between 0 and 180 degrees");
  const double half_height = std::tan(camera.fov_degrees * std::numbers::pi / 360);
  ahead_ = view.normalized();
  right_ = side.normalized();
  up_ = right_.cross(ahead_) * half_height;
  right_ *= half_height * aspect;
}

Vec3 CameraRays::direction(double x, double y) const {
  return (ahead_ + right_ * (2 * x - 1) + up_ * (2 * y - 1)).normalized();
}

}  // namespace gnomon::render
