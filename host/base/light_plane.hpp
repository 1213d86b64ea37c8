// SPDX-License-Identifier: Apache-2.0
// The plane perpendicular to a directional light on which its shadows are decided.
#pragma once

#include <cmath>

#include "host/base/vec.hpp"

namespace gnomon {

/// Unit vectors in grid coordinates, pairwise orthogonal.
struct LightAxes {
  Vec3 right, up, away;  ///< `away`: the way the light travels
};

/// `right` is the projection of the grid axis that lies best in the plane, so that a light parallel to an
/// axis sees the voxel columns; `up` makes right, up, away right-handed. `light` is not zero.
inline LightAxes light_axes(const Vec3& light) {
  const Vec3 away = light.normalized();
  int along = 0;
  for (int axis = 1; axis < 3; ++axis)
    if (std::abs(away[axis]) < std::abs(away[along])) along = axis;
  Vec3 axis(0, 0, 0);
  axis[along] = 1;
  const Vec3 right = (axis - away * away.dot(axis)).normalized();
  return {right, away.cross(right), away};
}

/// A square of pixels: point p is at (right.p / pitch + x1, up.p / pitch + y1).
struct LightPlane {
  LightAxes axes;
  double x1 = 0, y1 = 0;
  double pitch = 1;  ///< voxels per pixel
  int side = 0;      ///< pixels

  Vec2 pixel(const Vec3& p) const { return {axes.right.dot(p) / pitch + x1, axes.up.dot(p) / pitch + y1}; }
  /// The same area with `times` as many pixels on each side.
  LightPlane finer(int times) const { return {axes, x1 * times, y1 * times, pitch / times, side * times}; }
};

}  // namespace gnomon
