// SPDX-License-Identifier: Apache-2.0
// The lights of a scene, and what they do at a point. The same in world and in grid coordinates.
#pragma once

#include <cmath>
#include <numbers>
#include <variant>

#include "host/base/vec.hpp"

namespace gnomon {

struct DirectionalLight {
  Vec3 direction;  ///< the way the light travels, unit length
};

/// A cone with a hard edge: points outside it are not lit.
struct SpotLight {
  Vec3 position;
  Vec3 direction;         ///< the cone's axis, the way the light travels, unit length
  double half_angle = 0;  ///< between axis and edge, degrees, above 0 and at most 80
};

struct PointLight {
  Vec3 position;
};

using Light = std::variant<DirectionalLight, SpotLight, PointLight>;

/// The way the light travels at p, unit length; zero at the light itself.
inline Vec3 light_way(const Light& light, const Vec3& p) {
  if (const auto* directional = std::get_if<DirectionalLight>(&light)) return directional->direction;
  const Vec3 from = std::holds_alternative<SpotLight>(light) ? std::get<SpotLight>(light).position
                                                             : std::get<PointLight>(light).position;
  return (p - from).normalized();
}

/// False outside a spot's cone.
inline bool light_reaches(const Light& light, const Vec3& p) {
  const auto* spot = std::get_if<SpotLight>(&light);
  if (spot == nullptr) return true;
  return light_way(light, p).dot(spot->direction) >= std::cos(spot->half_angle * std::numbers::pi / 180);
}

/// The light after a change of coordinates that turns, moves and scales alike on all axes.
inline Light transformed(const Light& light, const Mat4& matrix) {
  const auto turned = [&](const Vec3& way) {
    Vec3 to;
    matrix.multDirMatrix(way, to);
    return to.normalized();
  };
  if (const auto* directional = std::get_if<DirectionalLight>(&light))
    return DirectionalLight{turned(directional->direction)};
  if (const auto* spot = std::get_if<SpotLight>(&light))
    return SpotLight{spot->position * matrix, turned(spot->direction), spot->half_angle};
  return PointLight{std::get<PointLight>(light).position * matrix};
}

}  // namespace gnomon
