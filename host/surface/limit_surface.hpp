// SPDX-License-Identifier: Apache-2.0
// The exact limit surface of one control cage, as parametric quads. Theory: docs/limit-surface.md.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/base/vec.hpp"
#include "host/scene/control_mesh.hpp"

namespace gnomon::surface {

class Borders;
class PatchTree;

/// A parameter of a parametric face.
struct Place {
  std::uint32_t face = 0;
  double u = 0, v = 0;
};

/// Position and first derivatives at a parameter of a parametric face.
struct SurfacePoint {
  Vec3 position;
  Vec3 du, dv;
};

/// The limit surface of one object. Every n-gon of the cage is n parametric faces ("ptex faces"), a quad is
/// one; each is parametrised over [0,1]x[0,1]. A point on a border shared by two faces is identical to the
/// bit whichever face is asked (docs/limit-surface.md says how). Thread-safe for concurrent evaluation.
class LimitSurface {
 public:
  /// Coordinates are transformed by `to_grid` in double before anything else is done with them.
  static Result<LimitSurface> build(const scene::ControlMesh& mesh, const Mat4& to_grid);

  LimitSurface(LimitSurface&&) noexcept;
  LimitSurface& operator=(LimitSurface&&) noexcept;
  ~LimitSurface();

  /// Number of parametric faces (holes excluded).
  std::uint32_t face_count() const;
  /// Position only, the fast path.
  Vec3 position(std::uint32_t face, double u, double v) const;
  SurfacePoint evaluate(std::uint32_t face, double u, double v) const;
  /// Unit normal, du x dv; where that vanishes (collapsed edges, valence 2) the parameter is nudged inwards.
  Vec3 normal(std::uint32_t face, double u, double v) const;
  /// The same, and whether the parameter had to be nudged.
  struct UnitNormal {
    Vec3 direction;
    bool nudged;
  };
  UnitNormal unit_normal(std::uint32_t face, double u, double v) const;
  /// Where position() evaluates: border points belong to one of the faces that share them.
  Place owner(std::uint32_t face, double u, double v) const;
  /// The same at a place that owner() or borders() has named.
  Vec3 position_at(const Place& owner) const;
  const Borders& borders() const;
  /// The polynomials a face is made of, for those who evaluate many points of it.
  const PatchTree& pieces(std::uint32_t face) const;
  /// Box that holds the whole surface (of control points), in grid coordinates.
  Box3 bounds() const;
  /// What OpenSubdiv had to say about the cage, one entry a message.
  const std::vector<std::string>& warnings() const;
  /// Cage edges and vertices where OpenSubdiv gives the faces that meet different limits (non-manifold cages
  /// only).
  std::uint32_t torn_borders() const;

 private:
  struct Impl;
  explicit LimitSurface(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace gnomon::surface
