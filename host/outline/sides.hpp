// SPDX-License-Identifier: Apache-2.0
// Which sheets of a part have to be counted so that its shadow is where there is one. Theory:
// docs/outline.md, "Which chain of edges".
#pragma once

#include <span>

#include "host/outline/outline.hpp"

namespace gnomon::outline {

enum class Sides : std::uint8_t {
  Facing,   ///< those that face the light: the boundary winds nowhere clockwise
  Averted,  ///< those that do not: the boundary winds nowhere anticlockwise
  Both,
};

/// How often the border of a face's stretch is sent: 1 as it runs, -1 backwards.
constexpr int stretch_times(Sides sides, bool plus) {
  if (plus) return sides == Sides::Averted ? 0 : 1;
  return sides == Sides::Facing ? 0 : -1;
}
/// How often the contour is sent.
constexpr int contour_times(Sides sides) {
  return sides == Sides::Both ? 2 : 1;
}

/// A straight piece of the boundary of a part in the plane, with its orientation: `times` as the part's faces
/// add up. All pieces of a part close.
struct BoundaryPiece {
  Vec2 a, b;
  int times;
};

/// `mirrored`: faces that face the light run clockwise.
Sides sides_to_send(std::span<const BoundaryPiece> boundary, bool mirrored);

}  // namespace gnomon::outline
