// SPDX-License-Identifier: Apache-2.0
// Puts together the faces, the ownership of their borders and the public questions.
#include "host/surface/limit_surface.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <array>
#include <cmath>

#include "host/surface/borders.hpp"
#include "host/surface/cage.hpp"
#include "host/surface/face_source.hpp"
#include "host/surface/patch_tree.hpp"

namespace gnomon::surface {
namespace {

std::vector<ParametricFace> list_faces(const Cage& cage, const FaceSource& source) {
  std::vector<ParametricFace> faces;
  for (int f = 0; f < cage.face_count(); ++f) {
    if (!source.valid(f)) continue;
    const int n = cage.sizes[static_cast<std::size_t>(f)];
    if (n == 4) {
      faces.push_back({f, -1});
    } else {
      for (int k = 0; k < n; ++k) faces.push_back({f, k});
    }
  }
  return faces;
}

Box3 bound(const Cage& cage) {
  Box3 box;
  for (const int v : cage.indices) box.extendBy(cage.positions[static_cast<std::size_t>(v)]);
  return box;
}

Vec3 vec(const Lane4& p) {
  return {p.x[0], p.x[1], p.x[2]};
}

bool on_border(double u, double v) {
  return u == 0 || u == 1 || v == 0 || v == 1;
}

}  // namespace

struct LimitSurface::Impl {
  Impl(const Cage& cage, std::unique_ptr<FaceSource> from)
      : source(std::move(from)),
        faces(list_faces(cage, *source)),
        borders(cage, *source, faces),
        bounds(bound(cage)) {}

  void fit() {
    trees.resize(faces.size());
    tbb::parallel_for(std::size_t{0}, faces.size(),
                      [&](std::size_t f) { trees[f] = PatchTree(*source, faces[f]); });
  }

  // The one definition of a limit point, before ownership.
  Vec3 position(const Place& p) const {
    const PatchTree::Hit hit = trees[p.face].find(p.u, p.v);
    if (hit.patch == nullptr) return source->position(faces[p.face], p.u, p.v);
    return vec(cubic(hit.patch->row(hit.v), hit.u));
  }

  SurfacePoint evaluate(const Place& p) const {
    const PatchTree::Hit hit = trees[p.face].find(p.u, p.v);
    if (hit.patch == nullptr) return source->evaluate(faces[p.face], p.u, p.v);
    const auto row = hit.patch->row(hit.v);
    return {vec(cubic(row, hit.u)), vec(cubic_slope(row, hit.u)) * hit.scale,
            vec(cubic(hit.patch->row_slope(hit.v), hit.u)) * hit.scale};
  }

  std::unique_ptr<FaceSource> source;
  std::vector<ParametricFace> faces;
  Borders borders;
  Box3 bounds;
  std::vector<PatchTree> trees;
};

LimitSurface::LimitSurface(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
LimitSurface::LimitSurface(LimitSurface&&) noexcept = default;
LimitSurface& LimitSurface::operator=(LimitSurface&&) noexcept = default;
LimitSurface::~LimitSurface() = default;

Result<LimitSurface> LimitSurface::build(const scene::ControlMesh& mesh, const Mat4& to_grid) {
  const auto cage = make_cage(mesh, to_grid);
  if (!cage) return tl::make_unexpected(cage.error());
  const bool bfr_can = !trips_bfr(*cage);
  auto impl = std::make_unique<Impl>(*cage, bfr_can ? make_bfr_faces(*cage) : make_far_faces(*cage));
  if (bfr_can && impl->borders.torn() > 0) {  // faces that should meet do not: ask the other one
    auto far = std::make_unique<Impl>(*cage, make_far_faces(*cage));
    if (far->borders.torn() < impl->borders.torn()) impl = std::move(far);
  }
  if (impl->faces.empty()) {
    return fail(fmt::format(
        "object '{}' has no limit surface: all its faces are holes or lie on an open boundary", mesh.name));
  }
  impl->fit();
  return LimitSurface(std::move(impl));
}

std::uint32_t LimitSurface::face_count() const {
  return static_cast<std::uint32_t>(impl_->faces.size());
}

Vec3 LimitSurface::position(std::uint32_t face, double u, double v) const {
  return impl_->position(owner(face, u, v));
}

SurfacePoint LimitSurface::evaluate(std::uint32_t face, double u, double v) const {
  SurfacePoint p = impl_->evaluate({face, u, v});
  if (on_border(u, v)) p.position = position(face, u, v);
  return p;
}

LimitSurface::UnitNormal LimitSurface::unit_normal(std::uint32_t face, double u, double v) const {
  // Sines smaller than this leave too few digits of the direction.
  constexpr double kSmallestSine = 1e-9;
  bool nudged = false;
  for (const double step : {0.0, 0x1p-20, 0x1p-14, 0x1p-8, 0x1p-4}) {
    const SurfacePoint p = impl_->evaluate({face, u + (0.5 - u) * step, v + (0.5 - v) * step});
    const Vec3 du = p.du.normalized();
    const Vec3 dv = p.dv.normalized();
    const Vec3 n = du.cross(dv);
    if (n.length() > kSmallestSine) return {n.normalized(), nudged};
    nudged = true;
  }
  return {{0, 0, 1}, true};  // the face has no area: every direction is as good
}

Vec3 LimitSurface::normal(std::uint32_t face, double u, double v) const {
  return unit_normal(face, u, v).direction;
}

Place LimitSurface::owner(std::uint32_t face, double u, double v) const {
  return on_border(u, v) ? impl_->borders.place(impl_->borders.spot(face, u, v)) : Place{face, u, v};
}

Vec3 LimitSurface::position_at(const Place& owner) const {
  return impl_->position(owner);
}

const Borders& LimitSurface::borders() const {
  return impl_->borders;
}

const PatchTree& LimitSurface::pieces(std::uint32_t face) const {
  return impl_->trees[face];
}

Box3 LimitSurface::bounds() const {
  return impl_->bounds;
}
const std::vector<std::string>& LimitSurface::warnings() const {
  return impl_->source->warnings();
}
std::uint32_t LimitSurface::torn_borders() const {
  return impl_->borders.torn();
}

}  // namespace gnomon::surface
