// SPDX-License-Identifier: Apache-2.0
// Shapes that a ray can be followed past without any mesh, and points to start from.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "host/metrics/exact_reference.hpp"

namespace gnomon::metrics {

/// `count` points spread over the faces of object 0.
inline std::vector<SurfaceQuery> random_points(const surface::LimitSurface& surface, std::size_t count,
                                               std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::uniform_int_distribution<std::uint32_t> face(0, surface.face_count() - 1);
  std::vector<SurfaceQuery> points;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t f = face(random);
    const double u = unit(random);
    const double v = unit(random);
    points.push_back({surface.position(f, u, v), surface.normal(f, u, v), 0});
  }
  return points;
}

/// Distance to a torus around the z axis; never more than the true one.
inline double torus_distance(const Vec3& p, double major, double minor) {
  return std::hypot(std::hypot(p.x, p.y) - major, p.z) - minor;
}

/// Smallest distance between the torus and the ray from a point on it, up to `reach`, once it has left the
/// surface it starts on.
inline double clearance(const Vec3& start, const Vec3& direction, double major, double minor,
                        double reach = 300) {
  double nearest = 1e9;
  double before = 0;
  bool leaving = true;
  double t = 0;
  while (t < reach) {
    t += 0.02;
    const double distance = torus_distance(start + direction * t, major, minor);
    leaving = leaving && distance > before;
    if (!leaving) nearest = std::min(nearest, distance);
    before = distance;
    if (distance > 10) t += distance - 10;
  }
  return nearest;
}

/// Does the ray from `p` meet the box before its length is `reach`? By slabs, exactly.
inline bool meets_box(const Vec3& p, const Vec3& direction, const Box3& box, double reach = 1e9) {
  double enter = 0;
  double leave = reach;
  for (int k = 0; k < 3; ++k) {
    if (direction[k] == 0) {
      if (p[k] < box.min[k] || p[k] > box.max[k]) return false;
      continue;
    }
    const double a = (box.min[k] - p[k]) / direction[k];
    const double b = (box.max[k] - p[k]) / direction[k];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter < leave;
}

}  // namespace gnomon::metrics
