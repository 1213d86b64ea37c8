// SPDX-License-Identifier: Apache-2.0
// How many sheets of a surface a ray of light meets, counted on a fine triangulation: shares nothing with the
// outliner but the limit surface.
#pragma once

#include <array>
#include <vector>

#include "host/outline/outline.hpp"

namespace gnomon::outline::test {

using Corners = std::array<Vec3, 3>;

/// Every face of the surface cut into 2 n^2 triangles.
std::vector<Corners> corners_of(const surface::LimitSurface& surface, int n);
/// Triangles fanned from the faces' first corners: for faces that are convex and flat.
std::vector<Corners> corners_of(const scene::ControlMesh& mesh);

/// Triangles as the plane sees them.
class Sheets {
 public:
  Sheets(const std::vector<Corners>& triangles, const LightFrame& frame);

  struct Count {
    int facing = 0;   ///< that face the light
    int averted = 0;  ///< that do not
  };
  Count at(double x, double y) const;

  Box3 bounds() const { return bounds_; }  ///< in the plane, z is 0

 private:
  using Seen = std::array<Vec2, 3>;
  std::vector<std::vector<Seen>> rows_;
  bool mirrored_;
  Box3 bounds_;
};

}  // namespace gnomon::outline::test
