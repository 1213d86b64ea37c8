// SPDX-License-Identifier: Apache-2.0
// Triangles from rectangles of parameter space, without cracks where rectangles of different size meet.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "host/surface/limit_surface.hpp"

namespace gnomon::metrics {

/// A rectangle of one parametric face; bounds are dyadic fractions in [0,1].
struct ParamRect {
  std::uint32_t face;
  float u0, v0, u1, v1;
};

/// Triangles of one object. A border shared by rectangles of different size, in one face or in two, carries
/// every vertex that either side has on it, so the triangles of a closed surface close too
/// (docs/rendering.md, "No cracks").
struct ParametricMesh {
  Vec3 center;                                ///< what `points` are relative to, for precision in float
  std::vector<std::array<float, 3>> points;   ///< limit positions minus `center`, grid coordinates
  std::vector<std::array<float, 3>> normals;  ///< unit limit normals of the points, if asked for
  std::vector<std::array<float, 2>> params;   ///< (u, v) of each point in its triangle's face
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices into points; winding follows du x dv
  std::vector<std::uint32_t> rect_of_triangle;          ///< index into the given rectangles
};

/// `rects` must tile every face they name; any order. Multithreaded; the result does not depend on the thread
/// count.
ParametricMesh triangulate(const surface::LimitSurface& surface, std::span<const ParamRect> rects,
                           const Vec3& center, bool normals = false);

}  // namespace gnomon::metrics
