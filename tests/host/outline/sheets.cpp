// SPDX-License-Identifier: Apache-2.0
// Counts triangles around a point, by rows of the plane.
#include "sheets.hpp"

#include <algorithm>
#include <cmath>

namespace gnomon::outline::test {
namespace {

constexpr int kRows = 4096;  // of pixels, from -kOffset
constexpr int kOffset = 1024;

std::size_t row_of(double y) {
  return static_cast<std::size_t>(std::clamp(static_cast<int>(std::floor(y)) + kOffset, 0, kRows - 1));
}

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool mirrored(const LightFrame& f) {
  return f.x.cross(f.y).dot(f.depth) > 0;
}

}  // namespace

std::vector<Corners> corners_of(const surface::LimitSurface& surface, int n) {
  const auto side = static_cast<std::size_t>(n) + 1;
  std::vector<Corners> out;
  for (std::uint32_t face = 0; face < surface.face_count(); ++face) {
    std::vector<Vec3> p;
    p.reserve(side * side);
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) p.push_back(surface.position(face, double(i) / n, double(j) / n));
    for (std::size_t j = 0; j + 1 < side; ++j)
      for (std::size_t i = 0; i + 1 < side; ++i) {
        const std::size_t k = j * side + i;
        out.push_back({p[k], p[k + 1], p[k + side + 1]});
        out.push_back({p[k], p[k + side + 1], p[k + side]});
      }
  }
  return out;
}

std::vector<Corners> corners_of(const scene::ControlMesh& mesh) {
  std::vector<Corners> out;
  std::size_t first = 0;
  const auto at = [&](std::size_t i) {
    return mesh.positions[static_cast<std::size_t>(mesh.face_indices[first + i])];
  };
  for (std::size_t f = 0; f < mesh.face_sizes.size(); ++f) {
    const auto n = static_cast<std::size_t>(mesh.face_sizes[f]);
    if (std::count(mesh.holes.begin(), mesh.holes.end(), static_cast<std::int32_t>(f)) == 0)
      for (std::size_t i = 1; i + 1 < n; ++i) out.push_back({at(0), at(i), at(i + 1)});
    first += n;
  }
  return out;
}

Sheets::Sheets(const std::vector<Corners>& triangles, const LightFrame& frame)
    : rows_(kRows), mirrored_(mirrored(frame)) {
  for (const auto& [a, b, c] : triangles) {
    const Seen seen{frame.pixel(a), frame.pixel(b), frame.pixel(c)};
    for (const Vec2& p : seen) bounds_.extendBy(Vec3(p.x, p.y, 0));
    const auto [low, high] = std::minmax({seen[0].y, seen[1].y, seen[2].y});
    for (std::size_t r = row_of(low); r <= row_of(high); ++r) rows_[r].push_back(seen);
  }
}

Sheets::Count Sheets::at(double x, double y) const {
  Count count;
  const Vec2 p(x, y);
  for (const auto& [a, b, c] : rows_[row_of(y)]) {
    const bool left = turn(a, b, p) > 0;
    if (left != (turn(b, c, p) > 0) || left != (turn(c, a, p) > 0)) continue;
    ++(left != mirrored_ ? count.facing : count.averted);
  }
  return count;
}

}  // namespace gnomon::outline::test
