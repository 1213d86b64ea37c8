// SPDX-License-Identifier: Apache-2.0
// Winding numbers of a boundary beside all of its pieces.
#include "host/outline/sides.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace gnomon::outline {
namespace {

/// Pixels beside a piece where the winding number is asked.
constexpr double kBeside = 1e-4;
/// Longer boundaries are not looked at: the time grows with their square.
constexpr std::size_t kMostPieces = 1 << 14;
constexpr std::size_t kMostRows = 1 << 14;

/// Pieces by rows of the plane.
class Winding {
 public:
  explicit Winding(std::span<const BoundaryPiece> pieces) {
    double high = pieces.front().a.y;
    low_ = high;
    for (const BoundaryPiece& p : pieces) {
      low_ = std::min({low_, p.a.y, p.b.y});
      high = std::max({high, p.a.y, p.b.y});
    }
    height_ = std::max(1.0, (high - low_) / static_cast<double>(kMostRows - 1));
    rows_.resize(row(high) + 1);
    for (const BoundaryPiece& p : pieces)
      for (std::size_t r = row(std::min(p.a.y, p.b.y)); r <= row(std::max(p.a.y, p.b.y)); ++r)
        rows_[r].push_back(p);
  }

  int at(const Vec2& q) const {
    int turns = 0;
    for (const BoundaryPiece& p : rows_[std::min(row(q.y), rows_.size() - 1)]) {
      if ((p.a.y < q.y) == (p.b.y < q.y)) continue;
      if (p.a.x + (q.y - p.a.y) / (p.b.y - p.a.y) * (p.b.x - p.a.x) < q.x)
        turns += p.a.y < q.y ? -p.times : p.times;
    }
    return turns;
  }

 private:
  std::size_t row(double y) const { return static_cast<std::size_t>(std::max(0.0, (y - low_) / height_)); }

  double low_, height_;
  std::vector<std::vector<BoundaryPiece>> rows_;
};

}  // namespace

Sides sides_to_send(std::span<const BoundaryPiece> boundary, bool mirrored) {
  if (boundary.empty()) return Sides::Facing;
  if (boundary.size() > kMostPieces) return Sides::Both;
  const Winding winding(boundary);
  bool anticlockwise = false;
  bool clockwise = false;
  for (const BoundaryPiece& p : boundary) {
    const Vec2 along = p.b - p.a;
    const double length = along.length();
    if (!(length > kBeside)) continue;
    const Vec2 beside = Vec2(-along.y, along.x) * (kBeside / length);
    for (const double s : {0.125, 0.375, 0.625, 0.875})
      for (const double side : {-1.0, 1.0}) {
        const int turns = winding.at(p.a + along * s + beside * side);
        anticlockwise = anticlockwise || turns > 0;
        clockwise = clockwise || turns < 0;
      }
    if (anticlockwise && clockwise) return Sides::Both;
  }
  return (mirrored ? anticlockwise : clockwise) ? Sides::Averted : Sides::Facing;
}

}  // namespace gnomon::outline
