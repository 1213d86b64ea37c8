// SPDX-License-Identifier: Apache-2.0
// The contour inside one parametric face. Theory: docs/outline.md, "Signs" to "Arcs".
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host/outline/facing.hpp"

namespace gnomon::outline {

/// The contour inside a face, and which stretches of its four sides bound what faces the light. Sides as in
/// surface::Borders: 0: v = 0, 1: u = 1, 2: v = 1, 3: u = 0; s is the other parameter.
struct FaceTrace {
  /// An end of an arc: a point inside the face, or a crossing of one of its sides.
  struct End {
    bool border;
    std::uint32_t index;
  };
  /// From one crossing to the next, with what faces the light on the left in (u, v).
  struct Arc {
    End from, to;
  };
  struct Crossing {
    std::uint32_t side;
    double s;
  };
  /// Part of a side, from..to as the face's border runs anticlockwise.
  struct Stretch {
    std::uint32_t side;
    double from, to;
    bool plus;  ///< faces the light
  };

  std::vector<Vertex> points;
  std::vector<Crossing> crossings;
  std::vector<Arc> arcs;
  std::vector<Stretch> stretches;  ///< the whole border, in its order
  std::size_t cells = 0;
};

/// `size`: pixels, the widest cell that the contour is searched in.
FaceTrace trace_face(const surface::LimitSurface& surface, const LightView& view, std::uint32_t face,
                     double size);

}  // namespace gnomon::outline
