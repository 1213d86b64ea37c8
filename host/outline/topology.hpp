// SPDX-License-Identifier: Apache-2.0
// How the sides of parametric faces lie on border curves, and which parts of a surface are closed. Does not
// depend on the light. Theory: docs/outline.md, "Which chain of edges".
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host/outline/outline.hpp"

namespace gnomon::outline {

/// A side of a face on its curve: t = a + b s.
struct SideOnCurve {
  std::uint32_t curve;
  double a, b;
  double at(double s) const { return a + b * s; }
};

/// Half of a curve where the sides of the faces that share it do not cancel.
struct BoundaryHalf {
  std::uint32_t curve;
  double t0, t1;
  int times;           ///< their sum, rising t
  std::uint32_t part;  ///< that they belong to
};

/// Faces connected by shared curves make a part.
struct Topology {
  std::vector<std::array<SideOnCurve, 4>> sides;  ///< of each face, numbered as in FaceTrace
  std::vector<std::uint32_t> part;                ///< of each face: the number of one of the part's faces
  std::vector<BoundaryHalf> boundary;
  std::uint32_t curves = 0;
  Statistics counts;  ///< faces, open_parts, boundary_edges, non_manifold_edges
};

Topology find_topology(const surface::LimitSurface& surface);

}  // namespace gnomon::outline
