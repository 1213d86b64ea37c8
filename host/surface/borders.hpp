// SPDX-License-Identifier: Apache-2.0
// Which face answers for a point on a border. Theory: docs/limit-surface.md, "One owner per border point".
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host/surface/cage.hpp"
#include "host/surface/face_source.hpp"

namespace gnomon::surface {

/// Maps every border point of every parametric face to the one place where it is evaluated.
class Borders {
 public:
  /// `faces` are the parametric faces, those of one cage face together and in order of their sub-faces.
  Borders(const Cage& cage, const FaceSource& source, const std::vector<ParametricFace>& faces);

  /// `u` or `v` (or both) must be 0 or 1. Exact for dyadic parameters.
  Place owner(std::uint32_t face, double u, double v) const;

  /// Edges and vertices of the cage whose faces do not meet: OpenSubdiv gives them different limits there,
  /// each side keeps its own.
  std::uint32_t torn() const { return torn_; }

 private:
  friend class BorderBuilder;

  // Along half a side the owner's parameters are linear in the side's own: u = u0 + du * t.
  struct Piece {
    std::uint32_t face;
    float u0, du, v0, dv;
  };
  // Sides: 0: v = 0, 1: u = 1, 2: v = 1, 3: u = 0; the parameter is the other coordinate. Two pieces each: t
  // <= 1/2, t > 1/2.
  struct FaceBorder {
    std::array<std::array<Piece, 2>, 4> sides;
    std::array<Piece, 4> corners;
  };
  std::vector<FaceBorder> faces_;
  std::uint32_t torn_ = 0;
};

}  // namespace gnomon::surface
