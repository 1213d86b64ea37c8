// SPDX-License-Identifier: Apache-2.0
// Which face answers for a point on a border. Theory: docs/limit-surface.md, "One owner per border point".
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host/surface/cage.hpp"
#include "host/surface/face_source.hpp"

namespace gnomon::surface {

/// A border point, the same for every face that has it: a point of a shared curve, or a shared vertex.
struct BorderSpot {
  bool vertex = false;
  std::uint32_t id = 0;  ///< of the vertex or of the curve
  double t = 0;          ///< along the curve, 0..1
};

/// Maps every border point of every parametric face to the one place where it is evaluated.
class Borders {
 public:
  /// `faces` are the parametric faces, those of one cage face together and in order of their sub-faces.
  Borders(const Cage& cage, const FaceSource& source, const std::vector<ParametricFace>& faces);

  /// `u` or `v` (or both) must be 0 or 1. Exact for dyadic parameters.
  BorderSpot spot(std::uint32_t face, double u, double v) const;
  /// Where a border point is evaluated.
  Place place(const BorderSpot& spot) const;

  std::uint32_t curve_count() const { return static_cast<std::uint32_t>(curves_.size()); }
  std::uint32_t vertex_count() const { return static_cast<std::uint32_t>(vertices_.size()); }

  /// Edges and vertices of the cage whose faces do not meet: OpenSubdiv gives them different limits there,
  /// each side keeps its own.
  std::uint32_t torn() const { return torn_; }

 private:
  friend class BorderBuilder;

  // Along half a curve the owner's parameters are linear: u = u0 + du * t, v = v0 + dv * t.
  struct Piece {
    std::uint32_t face;
    float u0, du, v0, dv;
  };
  using Curve = std::array<Piece, 2>;  // t <= 1/2, t > 1/2

  // Sides: 0: v = 0, 1: u = 1, 2: v = 1, 3: u = 0; a side's parameter s is the other coordinate, t = a + b *
  // s.
  struct Side {
    std::uint32_t curve;
    float a, b;
  };
  struct Corner {
    bool vertex;
    std::uint32_t id;
    float t;
  };
  struct FaceBorder {
    std::array<Side, 4> sides;
    std::array<Corner, 4> corners;  // (0,0) (1,0) (1,1) (0,1)
  };

  std::vector<FaceBorder> faces_;
  std::vector<Curve> curves_;
  std::vector<Place> vertices_;
  std::uint32_t torn_ = 0;
};

}  // namespace gnomon::surface
