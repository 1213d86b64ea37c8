// SPDX-License-Identifier: Apache-2.0
// The projection of one view in double: what registers are rounded from, and what the methods in double use.
#pragma once

#include "host/base/vec.hpp"

namespace gnomon::plan {

/// Rows applied to a point in voxels (voxel i spans i..i+1). Parallel: u, v, d give entries and depth codes.
/// From a light's place: u and v are homogeneous, relative to the axis, and w goes below them.
struct Projection {
  Vec3 u, v, d;  ///< a voxel's step; orthogonal
  double u1 = 0, v1 = 0, d1 = 0;
  double pitch = 1;            ///< voxels per entry; in perspective the mean over the receivers
  double codes_per_voxel = 1;  ///< parallel alone: in perspective it changes with the distance
  int plane_side = 0;          ///< entries

  // Perspective (docs/vpu.md); z is the distance along the axis, in voxels.
  bool perspective = false;
  Vec3 eye{0, 0, 0}, axis{0, 0, 0};
  double w_scale = 1;          ///< z at w = 1
  double z_min = 0;            ///< what is nearer is behind
  double entries_a_slope = 1;  ///< entries per unit of the angle's tangent
  Vec2 centre{0, 0};           ///< entries, where the axis meets the plane
  double key_limit = 0, key_scale = 0;

  /// An entry's side: voxels, or, in perspective, at distance 1 along the axis.
  double pitch_on_plane() const { return perspective ? 1 / entries_a_slope : pitch; }
  double z(const Vec3& p) const { return axis.dot(p - eye); }
  bool behind(const Vec3& p) const { return perspective && z(p) < z_min; }
  /// The way the light travels at p, unit length.
  Vec3 beam(const Vec3& p) const { return perspective ? (p - eye).normalized() : d / codes_per_voxel; }
  /// Not behind.
  Vec2 entry(const Vec3& p) const {
    const Vec2 at(u.dot(p) + u1, v.dot(p) + v1);
    return perspective ? centre + at * (w_scale / z(p)) : at;
  }
  double depth(const Vec3& p) const {
    return perspective ? key_limit - key_scale * w_scale / z(p) : d.dot(p) + d1;
  }
  /// Depth codes that a short step away from the light takes at p.
  double codes_a_voxel(const Vec3& p) const {
    const double at = z(p);
    return perspective ? key_scale * w_scale / (at * at) : codes_per_voxel;
  }
};

}  // namespace gnomon::plan
