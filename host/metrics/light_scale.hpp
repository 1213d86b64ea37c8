// SPDX-License-Identifier: Apache-2.0
// How large surfaces are as a light sees them: the unit in which wrong areas and borders are measured.
#pragma once

#include "host/base/light.hpp"
#include "host/base/vec.hpp"

namespace gnomon::metrics {

/// Lengths and areas on the plane that a light's shadows are decided on. A directional light has the plane
/// across it, measured in voxels. A spot has the plane across its axis at distance 1, a point light the cube
/// around it whose sides lie at distance 1; what is farther away is smaller there, in proportion. Outside a
/// spot's cone, where that plane has no end, the scale is that of the cone's edge.
class LightScale {
 public:
  explicit LightScale(const Light& light);

  /// Of one of `parts` equal pieces of surface, at p; `across` is perpendicular to them and as long as they
  /// are large together (du x dv).
  double area(const Vec3& across, double parts, const Vec3& p) const;
  /// Of a short line. It is measured on the plane that its middle lies on.
  double length(const Vec3& a, const Vec3& b) const;

 private:
  /// The plane's axis for a ray, and the cosine between them.
  struct Axis {
    Vec3 axis;
    double cosine;
  };
  Axis axis_for(const Vec3& ray) const;

  bool directional_ = false;
  Vec3 way_{0, 0, 0};       ///< to a directional light; a spot's axis; zero for a point light
  Vec3 position_{0, 0, 0};  ///< of a spot or a point light
  double least_cosine_ = 0;
  double largest_area_ = 0;  ///< no piece is seen larger than the whole plane
};

}  // namespace gnomon::metrics
