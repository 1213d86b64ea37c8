// SPDX-License-Identifier: Apache-2.0
// Ear clipping in the plane of a face's area vector.
#include "host/outline/ears.hpp"

#include <cmath>
#include <span>

namespace gnomon::outline {
namespace {

/// One face, flattened; `ring_` is what is left of it.
class Clipper {
 public:
  Clipper(const scene::ControlMesh& mesh, std::span<const std::int32_t> face) {
    Vec3 area(0, 0, 0);
    for (std::size_t i = 0; i < face.size(); ++i)
      area += at(mesh, face[i]).cross(at(mesh, face[(i + 1) % face.size()]));
    const auto [x, y] = axes_across(area);
    for (const std::int32_t v : face) {
      ring_.push_back(points_.size());
      points_.emplace_back(at(mesh, v).dot(x), at(mesh, v).dot(y));
      vertices_.push_back(static_cast<std::uint32_t>(v));
    }
  }

  void run(std::vector<Triangle>& out) {
    while (ring_.size() > 3) {
      std::size_t ear = 0;
      while (ear < ring_.size() && !is_ear(ear)) ++ear;
      clip(ear < ring_.size() ? ear : 0, out);
    }
    clip(1, out);
  }

 private:
  static Vec3 at(const scene::ControlMesh& mesh, std::int32_t v) {
    return mesh.positions[static_cast<std::size_t>(v)];
  }

  static std::pair<Vec3, Vec3> axes_across(const Vec3& area) {
    const Vec3 n = area.normalized();
    Vec3 axis(0, 0, 0);
    axis[std::abs(n.x) < 0.6 ? 0 : 1] = 1;
    const Vec3 x = (axis - n * n.dot(axis)).normalized();
    return {x, n.cross(x)};
  }

  std::size_t neighbour(std::size_t place, std::size_t step) const {
    return ring_[(place + step) % ring_.size()];
  }
  double turn(std::size_t a, std::size_t b, std::size_t c) const {
    const Vec2 e = points_[b] - points_[a];
    const Vec2 f = points_[c] - points_[a];
    return e.x * f.y - e.y * f.x;
  }

  /// A convex corner with no other vertex in or on its triangle.
  bool is_ear(std::size_t place) const {
    const std::size_t a = neighbour(place, ring_.size() - 1);
    const std::size_t b = ring_[place];
    const std::size_t c = neighbour(place, 1);
    if (!(turn(a, b, c) > 0)) return false;
    for (const std::size_t p : ring_) {
      if (p == a || p == b || p == c) continue;
      if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
    }
    return true;
  }

  void clip(std::size_t place, std::vector<Triangle>& out) {
    out.push_back({vertices_[neighbour(place, ring_.size() - 1)], vertices_[ring_[place]],
                   vertices_[neighbour(place, 1)]});
    ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(place));
  }

  std::vector<Vec2> points_;
  std::vector<std::uint32_t> vertices_;
  std::vector<std::size_t> ring_;
};

}  // namespace

std::vector<Triangle> triangles_of(const scene::ControlMesh& mesh) {
  std::vector<bool> hole(mesh.face_sizes.size(), false);
  for (const std::int32_t h : mesh.holes) hole[static_cast<std::size_t>(h)] = true;
  std::vector<Triangle> out;
  std::span<const std::int32_t> rest(mesh.face_indices);
  for (std::size_t f = 0; f < mesh.face_sizes.size(); ++f) {
    const auto n = static_cast<std::size_t>(mesh.face_sizes[f]);
    if (!hole[f]) Clipper(mesh, rest.first(n)).run(out);
    rest = rest.subspan(n);
  }
  return out;
}

}  // namespace gnomon::outline
