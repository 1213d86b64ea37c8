// SPDX-License-Identifier: Apache-2.0
// How far a piece of surface can lie from the plane through its corners.
#pragma once

#include "host/base/vec.hpp"
#include "host/surface/patch_tree.hpp"

namespace gnomon::voxel {

/// Bounds of the second derivatives over a rectangle of a polynomial, each coordinate on its own, in units of
/// the rectangle's sides.
struct Bend {
  Vec3 uu, uv, vv;

  /// Of the rectangle [u0, u1] x [v0, v1] in the patch's own parameters.
  static Bend of(const surface::Patch& patch, double u0, double u1, double v0, double v1);

  /// A bound of the distance between the middle of any part of the rectangle and the middle of the part's
  /// diagonals. `u` and `v` are the part's sides, 1 is the whole rectangle.
  double sag(double u, double v) const {
    return (uu * (u * u) + uv * (2 * u * v) + vv * (v * v)).length() / 8;
  }
};

}  // namespace gnomon::voxel
