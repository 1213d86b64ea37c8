// SPDX-License-Identifier: Apache-2.0
// Which borders of parametric faces are the same curve, found from the curves alone.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "host/surface/limit_surface.hpp"

namespace gnomon::metrics {

/// The four sides of a face's parameter square, and which parameter runs along each: t = u on Low V and High
/// V, else t = v.
enum class Side : std::uint8_t { LowV = 0, HighU = 1, HighV = 2, LowU = 3 };

/// Parameters of the point at t of a side.
constexpr std::array<double, 2> on_side(Side side, double t) {
  switch (side) {
    case Side::LowV:
      return {t, 0};
    case Side::HighU:
      return {1, t};
    case Side::HighV:
      return {t, 1};
    default:
      return {0, t};
  }
}

/// A piece of one side: all of it, or one half. An n-gon's parametric faces have sides that are half of their
/// neighbour's.
struct BorderPiece {
  std::uint32_t face;
  Side side;
  float t0, t1;   ///< t0 < t1, dyadic
  bool reversed;  ///< against the group's common direction
  bool whole() const { return t1 - t0 == 1.0f; }
  /// The side's t at s in [0,1] of the group's common direction.
  double at(double s) const { return reversed ? t1 - s * (t1 - t0) : t0 + s * (t1 - t0); }
  /// The inverse of `at`, exact for dyadic t.
  double common(double t) const { return reversed ? (t1 - t) / (t1 - t0) : (t - t0) / (t1 - t0); }
};

/// Pieces that are the same curve. Relies on LimitSurface's promise that shared border points are identical
/// to the bit.
using BorderGroup = std::span<const BorderPiece>;

/// All groups of two pieces or more among the given faces. 20 bytes a piece, 12 pieces a face. Multithreaded.
class FaceBorders {
 public:
  FaceBorders(const surface::LimitSurface& surface, std::span<const std::uint32_t> faces);
  std::size_t size() const { return starts_.size() - 1; }
  BorderGroup operator[](std::size_t group) const {
    return BorderGroup(pieces_).subspan(starts_[group], starts_[group + 1] - starts_[group]);
  }

 private:
  std::vector<BorderPiece> pieces_;
  std::vector<std::size_t> starts_{0};
};

}  // namespace gnomon::metrics
