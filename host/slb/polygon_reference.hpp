// SPDX-License-Identifier: Apache-2.0
// The exact answer for polygon loops: winding numbers without rounding (docs/error-metrics.md, "Polygons").
#pragma once

#include <cstdint>
#include <vector>

#include "host/slb/loop_scene.hpp"

namespace gnomon::slb {

/// A directed edge of a caster's loop.
struct OutlineEdge {
  std::size_t caster = 0;
  Vec2 from, to;
};

/// Casters as their file gives them, not as any hardware rounds them. A point exactly on an outline may go
/// either way; everywhere else the answers are exact. Thread-safe.
class PolygonReference {
 public:
  /// `side` pixels are answered fast; other points go through every edge.
  PolygonReference(const LoopScene& scene, int side);

  /// How often the caster's loops run counter-clockwise around the point.
  int winding(std::size_t caster, const Vec2& point) const;
  /// Some caster nearer than `z` covers the point.
  bool in_shadow(const Vec2& point, double z) const;
  /// Some caster covers the point, at any depth.
  bool covered(const Vec2& point) const;

  const std::vector<OutlineEdge>& edges() const { return edges_; }
  int side() const { return side_; }

 private:
  template <class Visit>
  void visit_windings(const Vec2& point, Visit&& visit) const;

  std::vector<double> depths_;
  std::vector<OutlineEdge> edges_;                ///< by caster
  std::vector<std::vector<std::uint32_t>> rows_;  ///< edges that meet a row of pixels, by caster
  std::vector<std::uint32_t> all_;
  int side_;
};

/// Sign of the cross product (to - from) x (point - from), exact: 1 if the point lies on the left.
int exact_side(const Vec2& from, const Vec2& to, const Vec2& point);

}  // namespace gnomon::slb
