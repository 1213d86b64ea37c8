// SPDX-License-Identifier: Apache-2.0
// How large a limit surface is.
#include "host/scene/limit_bounds.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "host/surface/limit_surface.hpp"

namespace gnomon::scene {
namespace {

constexpr std::size_t kMostFaces = 100'000;
constexpr std::uint32_t kSamples = 200'000;  ///< for the whole surface
/// A direction: the true extreme may lie next to the best sample's face.
constexpr std::size_t kSearches = 8;

/// A parameter of the surface and how far it lies in some direction.
struct Extreme {
  double reach;
  std::uint32_t face;
  double u, v;
};

class Search {
 public:
  Search(const surface::LimitSurface& surface, int axis, double sign)
      : surface_(surface), axis_(axis), sign_(sign) {}

  Extreme at(std::uint32_t face, double u, double v) const {
    return {sign_ * surface_.position(face, u, v)[axis_], face, u, v};
  }

  /// Steps to the best of eight neighbours, and halves the step where none is better.
  Extreme climb(Extreme best, double step) const {
    while (step > 1e-6) {
      for (bool moved = true; moved;) {
        moved = false;
        for (const auto& [du, dv] : kDirections) {
          const Extreme next = at(best.face, std::clamp(best.u + du * step, 0.0, 1.0),
                                  std::clamp(best.v + dv * step, 0.0, 1.0));
          if (next.reach <= best.reach) continue;
          best = next;
          moved = true;
        }
      }
      step /= 2;
    }
    return best;
  }

 private:
  static constexpr std::array<std::array<double, 2>, 8> kDirections{
      {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}}};
  const surface::LimitSurface& surface_;
  int axis_;
  double sign_;
};

/// The most extreme sample of a face.
Extreme sample_face(const Search& search, std::uint32_t face, std::uint32_t steps) {
  Extreme best = search.at(face, 0, 0);
  for (std::uint32_t i = 0; i <= steps; ++i) {
    for (std::uint32_t j = 0; j <= steps; ++j) {
      const Extreme next = search.at(face, i / static_cast<double>(steps), j / static_cast<double>(steps));
      if (next.reach > best.reach) best = next;
    }
  }
  return best;
}

double farthest(const surface::LimitSurface& surface, int axis, double sign) {
  const Search search(surface, axis, sign);
  std::uint32_t steps = 2;
  while (steps < 16 && surface.face_count() * (2 * steps + 1) * (2 * steps + 1) <= kSamples) steps *= 2;
  std::vector<Extreme> faces;
  for (std::uint32_t face = 0; face < surface.face_count(); ++face)
    faces.push_back(sample_face(search, face, steps));
  const auto count = static_cast<std::ptrdiff_t>(std::min(kSearches, faces.size()));
  std::partial_sort(faces.begin(), faces.begin() + count, faces.end(),
                    [](const Extreme& a, const Extreme& b) { return a.reach > b.reach; });
  double reach = faces.front().reach;
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    reach = std::max(reach, search.climb(faces[static_cast<std::size_t>(i)], 0.5 / steps).reach);
  }
  return sign * reach;
}

}  // namespace

Box3 hull_bounds(const ControlMesh& mesh, const Mat4& to_world) {
  Box3 box;
  for (const Vec3& position : mesh.positions) box.extendBy(position * to_world);
  return box;
}

Result<Box3> limit_bounds(const ControlMesh& mesh, const Mat4& to_world) {
  const Box3 hull = hull_bounds(mesh, to_world);
  if (mesh.face_sizes.size() > kMostFaces) return hull;
  // In a unit box, so that sizes of 1e-30 or 1e30 meet no underflow or overflow on the way.
  const double size = std::max({hull.size().x, hull.size().y, hull.size().z});
  Mat4 move, scale;
  move.setTranslation(-hull.min);
  scale.setScale(Vec3(1 / size));
  const Result<surface::LimitSurface> surface = surface::LimitSurface::build(mesh, to_world * move * scale);
  if (!surface) return tl::make_unexpected(surface.error());
  if (surface->face_count() == 0) return hull;
  Box3 box;
  for (int axis = 0; axis < 3; ++axis) {
    box.min[axis] = hull.min[axis] + size * farthest(*surface, axis, -1);
    box.max[axis] = hull.min[axis] + size * farthest(*surface, axis, +1);
  }
  return box;
}

}  // namespace gnomon::scene
