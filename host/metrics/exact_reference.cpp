// SPDX-License-Identifier: Apache-2.0
// Why the start is lifted by the surface's normal, and by how much: docs/error-metrics.md, "Exact shadows".
#include "host/metrics/exact_reference.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "host/metrics/parametric_mesh.hpp"
#include "host/metrics/ray_scene.hpp"

namespace gnomon::metrics {
namespace {

/// Cosines below this are rounding: a surface along the light's way is not lit by it.
constexpr double kEdgeOn = 1e-9;

Box3 bounds_of(std::span<const surface::LimitSurface> surfaces) {
  Box3 box;
  for (const surface::LimitSurface& surface : surfaces) box.extendBy(surface.bounds());
  if (box.isEmpty()) box.extendBy(Vec3(0, 0, 0));
  return box;
}

Vec3 unit_towards_light(const DirectionalLight& light) {
  const double length = light.travel.length();
  if (!(length > 0) || !(length < std::numeric_limits<double>::infinity()))
    throw std::invalid_argument("a directional light needs a finite direction that is not zero");
  return light.travel * (-1.0 / length);
}

/// Twice the sag puts the start clear of the tessellation; the rest covers single precision in Embree.
double start_lift(double sag, const Box3& box) {
  const double extent = box.size().length();
  return 2 * sag + 4 * extent * std::numeric_limits<float>::epsilon();
}

}  // namespace

/// What all lights share.
struct ExactReference::Geometry {
  Geometry(std::span<const surface::LimitSurface> surfaces, std::vector<bool> two_sided_objects,
           const TessellationOptions& options)
      : two_sided(std::move(two_sided_objects)), scene(bounds_of(surfaces).center()) {
    const Box3 box = bounds_of(surfaces);
    const Tessellation cells = tessellate(surfaces, options);
    sag = cells.sag;
    lift = start_lift(sag, box);
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      const ParametricMesh mesh = triangulate(surfaces[i], cells.rects[i], box.center());
      triangles += mesh.triangles.size();
      scene.add(mesh.points, mesh.triangles);
    }
    scene.commit();
  }

  std::vector<bool> two_sided;
  RayScene scene;
  double sag = 0, lift = 0;
  std::size_t triangles = 0;
};

struct ExactReference::Impl {
  Impl(std::shared_ptr<const Geometry> shared, const DirectionalLight& light)
      : geometry(std::move(shared)), to_light(unit_towards_light(light)) {}

  double facing(const Vec3& normal, std::uint32_t object) const {
    const double cosine = normal.dot(to_light);
    const bool turned = object < geometry->two_sided.size() && geometry->two_sided[object];
    return turned ? std::abs(cosine) : cosine;
  }

  Exact classify(const SurfaceQuery& query) {
    const double cosine = facing(query.normal, query.object);
    if (!(cosine > kEdgeOn)) return Exact::Attached;
    const Vec3 normal = query.normal.dot(to_light) < 0 ? -query.normal : query.normal;
    ++rays.local();
    const Vec3 start = query.point + normal * geometry->lift;
    return geometry->scene.any_hit(start, to_light) ? Exact::Cast : Exact::Lit;
  }

  std::shared_ptr<const Geometry> geometry;
  Vec3 to_light;
  tbb::enumerable_thread_specific<std::uint64_t> rays{std::uint64_t{0}};
};

ExactReference::ExactReference(std::span<const surface::LimitSurface> surfaces, std::vector<bool> two_sided,
                               const DirectionalLight& light, const TessellationOptions& options) {
  unit_towards_light(light);  // refuse before the long part
  impl_ = std::make_unique<Impl>(std::make_shared<const Geometry>(surfaces, std::move(two_sided), options),
                                 light);
}
ExactReference::ExactReference(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ExactReference ExactReference::relit(const DirectionalLight& light) const {
  return ExactReference(std::make_unique<Impl>(impl_->geometry, light));
}
ExactReference::ExactReference(ExactReference&&) noexcept = default;
ExactReference& ExactReference::operator=(ExactReference&&) noexcept = default;
ExactReference::~ExactReference() = default;

Exact ExactReference::classify(const SurfaceQuery& query) const {
  return impl_->classify(query);
}

double ExactReference::facing(const Vec3& normal, std::uint32_t object) const {
  return impl_->facing(normal, object);
}

bool ExactReference::occluded(const Vec3& point, const Vec3& normal, std::uint32_t object) const {
  return in_shadow(classify(SurfaceQuery{point, normal, object}));
}

bool ExactReference::blocked(const Vec3& point) const {
  return impl_->geometry->scene.any_hit(point, impl_->to_light);
}

std::vector<Exact> ExactReference::classify(std::span<const SurfaceQuery> queries) const {
  std::vector<Exact> answers(queries.size());
  tbb::parallel_for(std::size_t{0}, queries.size(),
                    [&](std::size_t i) { answers[i] = impl_->classify(queries[i]); });
  return answers;
}

Vec3 ExactReference::to_light() const {
  return impl_->to_light;
}
double ExactReference::sag() const {
  return impl_->geometry->sag;
}
double ExactReference::lift() const {
  return impl_->geometry->lift;
}
std::size_t ExactReference::triangles() const {
  return impl_->geometry->triangles;
}
std::uint64_t ExactReference::rays() const {
  return impl_->rays.combine([](std::uint64_t a, std::uint64_t b) { return a + b; });
}

}  // namespace gnomon::metrics
