// SPDX-License-Identifier: Apache-2.0
// What the rest of this folder wants from OpenSubdiv: single points of single faces.
#pragma once

#include <memory>
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

/// The limit surface of each face of a cage, before any ownership of borders. Immutable, so safe from many
/// threads.
class FaceSource {
 public:
  virtual ~FaceSource() = default;

  /// False where a face has no limit surface: holes, and boundary faces under Boundary::None.
  virtual bool valid(int cage_face) const = 0;
  /// True where the face is known to be a single bicubic polynomial.
  virtual bool regular(int cage_face) const = 0;
  virtual Vec3 position(ParametricFace face, double u, double v) const = 0;
  virtual SurfacePoint evaluate(ParametricFace face, double u, double v) const = 0;
  /// What OpenSubdiv had to say, one entry a message.
  virtual const std::vector<std::string>& warnings() const = 0;
};

/// Features are isolated this deep. The default of Bfr errs by 0.6 % of the model's size at a cube's corners,
/// level 10 by less than 3e-6. It must reach the largest finite sharpness, 10, and in Bfr the level for sharp
/// features silently caps the one for smooth features: so it is used for both.
inline constexpr int kApproximationLevel = 10;

/// Bfr sets up each face from its own neighbourhood: fast, and threaded.
std::unique_ptr<FaceSource> make_bfr_faces(const Cage& cage);

/// Far's adaptive patch table refines the cage as a whole: slower, but it bears neighbourhoods that Bfr of
/// OpenSubdiv 3.5 gets wrong or reads out of bounds on.
std::unique_ptr<FaceSource> make_far_faces(const Cage& cage);

/// True where Bfr must not be tried: an interior vertex of valence 2 makes its two faces overlap.
bool trips_bfr(const Cage& cage);

}  // namespace gnomon::surface
