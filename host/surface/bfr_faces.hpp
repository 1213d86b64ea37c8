// SPDX-License-Identifier: Apache-2.0
// The limit surface of each face of a cage as OpenSubdiv's Bfr gives it, before any ownership of borders.
#pragma once

#include <opensubdiv/bfr/surface.h>

#include <cstdint>
#include <string>
#include <vector>

#include "host/surface/cage.hpp"
#include "host/surface/limit_surface.hpp"

namespace gnomon::surface {

/// A parametric face: a whole quad (sub_face -1) or the part of an n-gon that belongs to its corner
/// `sub_face`. Corner 0 at (0,0), 1 at (1,0), 2 at (1,1), 3 at (0,1); of a part of an n-gon these are the
/// vertex, the middle of the edge that leaves it, the centre, and the middle of the edge that arrives at it.
struct ParametricFace {
  int cage_face = 0;
  int sub_face = -1;
};

/// Evaluates single faces. Immutable after construction, so safe from many threads.
class BfrFaces {
 public:
  explicit BfrFaces(const Cage& cage);

  /// False where a face has no limit surface: holes, and boundary faces under Boundary::None.
  bool valid(int cage_face) const { return surfaces_[static_cast<std::size_t>(cage_face)].IsValid(); }
  /// True where the face is a single bicubic polynomial.
  bool regular(int cage_face) const { return surfaces_[static_cast<std::size_t>(cage_face)].IsRegular(); }

  Vec3 position(ParametricFace face, double u, double v) const;
  SurfacePoint evaluate(ParametricFace face, double u, double v) const;

  /// What OpenSubdiv had to say, one entry a message.
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  const double* points(int cage_face) const {
    return points_.data() + first_point_[static_cast<std::size_t>(cage_face)];
  }

  std::vector<OpenSubdiv::Bfr::Surface<double>> surfaces_;
  std::vector<std::size_t> first_point_;  // of each face in points_, counted in doubles
  std::vector<double> points_;            // patch points, x y z
  std::vector<std::string> warnings_;
};

}  // namespace gnomon::surface
