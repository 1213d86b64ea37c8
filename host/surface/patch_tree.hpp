// SPDX-License-Identifier: Apache-2.0
// A parametric face as the bicubic polynomials it is made of. Theory: docs/limit-surface.md, "Polynomial
// pieces".
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host/surface/face_source.hpp"

namespace gnomon::surface {

/// Four numbers: x, y, z and padding that lets them be worked on two at a time.
struct Lane4 {
  std::array<double, 4> x;
};

/// c0 + u (c1 + u (c2 + u c3)), in this order of operations wherever a limit point is computed.
inline Lane4 cubic(const std::array<Lane4, 4>& c, double u) {
  Lane4 r;
  for (std::size_t k = 0; k < 4; ++k) r.x[k] = ((c[3].x[k] * u + c[2].x[k]) * u + c[1].x[k]) * u + c[0].x[k];
  return r;
}

/// The derivative of the above.
inline Lane4 cubic_slope(const std::array<Lane4, 4>& c, double u) {
  Lane4 r;
  for (std::size_t k = 0; k < 4; ++k) r.x[k] = (3 * c[3].x[k] * u + 2 * c[2].x[k]) * u + c[1].x[k];
  return r;
}

/// A cubic in u whose coefficients are cubics in v, both over [0,1]: c[i][j] belongs to u^i v^j.
struct Patch {
  std::array<std::array<Lane4, 4>, 4> c;

  /// The cubic in u at a fixed v, and its derivative by v.
  std::array<Lane4, 4> row(double v) const {
    return {cubic(c[0], v), cubic(c[1], v), cubic(c[2], v), cubic(c[3], v)};
  }
  std::array<Lane4, 4> row_slope(double v) const {
    return {cubic_slope(c[0], v), cubic_slope(c[1], v), cubic_slope(c[2], v), cubic_slope(c[3], v)};
  }
};

/// A quadtree over [0,1]^2. A leaf is one polynomial, or a piece so small that it is evaluated by Bfr
/// directly.
class PatchTree {
 public:
  PatchTree() = default;
  PatchTree(const FaceSource& source, ParametricFace face);

  /// A node found by its parameters, which it has turned into its own [0,1]^2.
  struct Hit {
    const Patch* patch;  ///< null where Bfr is to be asked
    double u, v;
    double scale;  ///< own parameters per parameter of the face, 2^level
  };
  /// Borders between nodes belong to the node above and to the right.
  Hit find(double u, double v) const;

  /// What is known of a rectangle of parameters.
  struct Region {
    const Patch* patch;       ///< the polynomial that the whole rectangle lies in, or null
    bool whole;               ///< the rectangle lies within one leaf
    double u0, v0, size;      ///< the node's own square
    double u_speed, v_speed;  ///< bounds of |dS/du|, |dS/dv| (largest coordinate) over the node
  };
  /// The smallest node that holds [u0,u1] x [v0,v1].
  Region region(double u0, double v0, double u1, double v1) const;

 private:
  struct Node {
    std::int32_t children = -1;  // first of four: (0,0) (1,0) (0,1) (1,1)
    std::int32_t patch = -1;
    double u_speed = 0, v_speed = 0;
  };
  struct Square;
  class Builder;

  std::vector<Node> nodes_;
  std::vector<Patch> patches_;
};

}  // namespace gnomon::surface
