// SPDX-License-Identifier: Apache-2.0
// Areas by the solid angle they fill: on a plane at distance 1, seen at an angle t off its axis, a unit of
// area fills cos^3 t.
#include "host/metrics/light_scale.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gnomon::metrics {
namespace {

constexpr double kLeastDistance = 1e-6;  ///< voxels: nearer than this to the light is at it

}  // namespace

LightScale::LightScale(const Light& light) {
  if (const auto* far_away = std::get_if<DirectionalLight>(&light)) {
    directional_ = true;
    way_ = far_away->direction * (-1.0 / far_away->direction.length());
  } else if (const auto* spot = std::get_if<SpotLight>(&light)) {
    position_ = spot->position;
    way_ = spot->direction.normalized();
    const double half = spot->half_angle * std::numbers::pi / 180;
    least_cosine_ = std::cos(half);
    largest_area_ = std::numbers::pi * std::tan(half) * std::tan(half);
  } else {
    position_ = std::get<PointLight>(light).position;
    least_cosine_ = 1 / std::numbers::sqrt3;
    largest_area_ = 4;
  }
}

LightScale::Axis LightScale::axis_for(const Vec3& ray) const {
  Vec3 axis = way_;
  if (axis == Vec3(0, 0, 0)) {
    int longest = 0;
    for (int k = 1; k < 3; ++k)
      if (std::abs(ray[k]) > std::abs(ray[longest])) longest = k;
    axis[longest] = ray[longest] < 0 ? -1 : 1;
  }
  return {axis, std::max(least_cosine_, ray.dot(axis) / std::max(kLeastDistance, ray.length()))};
}

double LightScale::area(const Vec3& across, double parts, const Vec3& p) const {
  if (directional_) return std::abs(across.dot(way_)) / parts;
  const Vec3 ray = p - position_;
  const double distance = std::max(kLeastDistance, ray.length());
  const double cosine = axis_for(ray).cosine;
  const double angle = std::abs(across.dot(ray)) / (distance * distance * distance);
  return std::min(largest_area_, angle / (cosine * cosine * cosine) / parts);
}

double LightScale::length(const Vec3& a, const Vec3& b) const {
  if (directional_) {
    const Vec3 step = b - a;
    return (step - way_ * step.dot(way_)).length();
  }
  const Vec3 middle = (a + b) * 0.5 - position_;
  const auto [axis, cosine] = axis_for(middle);
  const double depth = cosine * std::max(kLeastDistance, middle.length());
  // The central projection's derivative at the middle: along the plane, less what the ray moves on by.
  const Vec3 step = b - a;
  const double along = step.dot(axis);
  return ((step - axis * along) - (middle - axis * middle.dot(axis)) * (along / depth)).length() / depth;
}

}  // namespace gnomon::metrics
