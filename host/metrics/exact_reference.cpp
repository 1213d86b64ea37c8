// SPDX-License-Identifier: Apache-2.0
// Why the start is lifted by the surface's normal, and by how much: docs/error-metrics.md, "Exact shadows".
#include "host/metrics/exact_reference.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <limits>
#include <numbers>
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

/// -1 / length of the direction.
double towards(const Vec3& direction) {
  const double length = direction.length();
  if (!(length > 0) || !std::isfinite(length))
    throw std::invalid_argument("a light needs a finite direction that is not zero");
  return -1.0 / length;
}

void check_position(const Vec3& position) {
  if (!std::isfinite(position.x) || !std::isfinite(position.y) || !std::isfinite(position.z))
    throw std::invalid_argument("a light needs a finite position");
}

/// The way to one light, and whether it gets there; what depends on the light alone is worked out once.
class Beam {
 public:
  explicit Beam(const Light& light) : light_(light) {
    if (const auto* directional = std::get_if<DirectionalLight>(&light)) {
      to_light_ = directional->direction * towards(directional->direction);
      return;
    }
    placed_ = true;
    if (const auto* spot = std::get_if<SpotLight>(&light)) {
      position_ = spot->position;
      axis_ = spot->direction * -towards(spot->direction);
      cosine_ = std::cos(spot->half_angle * std::numbers::pi / 180);
    } else {
      position_ = std::get<PointLight>(light).position;
    }
    check_position(position_);
  }

  const Light& light() const { return light_; }
  Vec3 to_light(const Vec3& p) const { return placed_ ? (position_ - p).normalized() : to_light_; }
  /// Between here and the light, along to_light().
  double distance(const Vec3& p) const {
    return placed_ ? (position_ - p).length() : std::numeric_limits<double>::infinity();
  }
  bool reaches(const Vec3& to_light) const { return -axis_.dot(to_light) >= cosine_; }

 private:
  Light light_;
  bool placed_ = false;
  Vec3 to_light_{0, 0, 0}, position_{0, 0, 0};
  Vec3 axis_{0, 0, 0};
  double cosine_ = -1;  ///< of a cone that holds everything
};

bool flag(const std::vector<bool>& flags, std::uint32_t object, bool missing) {
  return object < flags.size() ? flags[object] : missing;
}

/// Twice the sag puts the start clear of the tessellation; the rest covers single precision in Embree.
double start_lift(double sag, const Box3& box) {
  const double extent = box.size().length();
  return 2 * sag + 4 * extent * std::numeric_limits<float>::epsilon();
}

}  // namespace

/// What all lights share.
struct ExactReference::Geometry {
  Geometry(std::span<const surface::LimitSurface> surfaces, ReferenceObjects what,
           const TessellationOptions& options)
      : objects(std::move(what)), scene(bounds_of(surfaces).center()) {
    const Box3 box = bounds_of(surfaces);
    const Tessellation cells = tessellate(surfaces, options, objects.casts);
    sag = cells.sag;
    lift = start_lift(sag, box);
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      if (cells.rects[i].empty()) continue;
      const ParametricMesh mesh = triangulate(surfaces[i], cells.rects[i], box.center());
      triangles += mesh.triangles.size();
      scene.add(mesh.points, mesh.triangles);
      object_of_mesh.push_back(static_cast<std::uint32_t>(i));
    }
    scene.commit();
  }

  ReferenceObjects objects;
  RayScene scene;
  std::vector<std::uint32_t> object_of_mesh;
  double sag = 0, lift = 0;
  std::size_t triangles = 0;
};

struct ExactReference::Impl {
  Impl(std::shared_ptr<const Geometry> shared, const Beam& of) : geometry(std::move(shared)), beam(of) {}

  /// `cosine` between normal and light, as if both sides were the outside where that is so.
  double turned(double cosine, std::uint32_t object) const {
    return flag(geometry->objects.two_sided, object, false) ? std::abs(cosine) : cosine;
  }

  Exact classify(const SurfaceQuery& query) {
    const Vec3 to_light = beam.to_light(query.point);
    const double cosine = query.normal.dot(to_light);
    if (!(turned(cosine, query.object) > kEdgeOn)) return Exact::Attached;
    if (!beam.reaches(to_light)) return Exact::Outside;
    if (!flag(geometry->objects.receives, query.object, true)) return Exact::Lit;
    ++rays.local();
    const Vec3 normal = cosine < 0 ? -query.normal : query.normal;
    return blocked(query.point + normal * geometry->lift) ? Exact::Cast : Exact::Lit;
  }

  bool blocked(const Vec3& start) const {
    return geometry->scene.any_hit(start, beam.to_light(start), beam.distance(start));
  }

  std::shared_ptr<const Geometry> geometry;
  Beam beam;
  tbb::enumerable_thread_specific<std::uint64_t> rays{std::uint64_t{0}};
};

ExactReference::ExactReference(std::span<const surface::LimitSurface> surfaces, ReferenceObjects objects,
                               const Light& light, const TessellationOptions& options) {
  const Beam beam(light);  // refuses before the long part
  impl_ =
      std::make_unique<Impl>(std::make_shared<const Geometry>(surfaces, std::move(objects), options), beam);
}
ExactReference::ExactReference(std::span<const surface::LimitSurface> surfaces, std::vector<bool> two_sided,
                               const Light& light, const TessellationOptions& options)
    : ExactReference(surfaces, ReferenceObjects{std::move(two_sided), {}, {}}, light, options) {}
ExactReference::ExactReference(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ExactReference ExactReference::relit(const Light& light) const {
  return ExactReference(std::make_unique<Impl>(impl_->geometry, Beam(light)));
}
ExactReference::ExactReference(ExactReference&&) noexcept = default;
ExactReference& ExactReference::operator=(ExactReference&&) noexcept = default;
ExactReference::~ExactReference() = default;

Exact ExactReference::classify(const SurfaceQuery& query) const {
  return impl_->classify(query);
}

double ExactReference::facing(const Vec3& point, const Vec3& normal, std::uint32_t object) const {
  return impl_->turned(normal.dot(impl_->beam.to_light(point)), object);
}

bool ExactReference::occluded(const Vec3& point, const Vec3& normal, std::uint32_t object) const {
  return in_shadow(classify(SurfaceQuery{point, normal, object}));
}

bool ExactReference::blocked(const Vec3& point) const {
  return impl_->blocked(point);
}

SheetsMet ExactReference::sheets(const Vec3& start, const Vec3& direction,
                                 const std::vector<bool>& of) const {
  const Geometry& geometry = *impl_->geometry;
  std::vector<std::uint32_t> hits(of.size(), 0);
  SheetsMet met;
  double at = 0;
  bool any = false;
  for (auto hit = geometry.scene.first_hit(start, direction); hit;
       hit = geometry.scene.first_hit(start + direction * at, direction)) {
    at += double{hit->distance};
    const std::uint32_t object = geometry.object_of_mesh.at(hit->mesh);
    if (flag(of, object, false)) {
      if (!any) met.nearest = at;
      any = true;
      ++hits[object];
    }
    at += geometry.lift;  // past what was met
  }
  for (std::uint32_t object = 0; object < hits.size(); ++object)
    met.count += flag(geometry.objects.two_sided, object, false) ? hits[object] : (hits[object] + 1) / 2;
  return met;
}

std::vector<Exact> ExactReference::classify(std::span<const SurfaceQuery> queries) const {
  std::vector<Exact> answers(queries.size());
  tbb::parallel_for(std::size_t{0}, queries.size(),
                    [&](std::size_t i) { answers[i] = impl_->classify(queries[i]); });
  return answers;
}

const Light& ExactReference::light() const {
  return impl_->beam.light();
}
Vec3 ExactReference::to_light(const Vec3& point) const {
  return impl_->beam.to_light(point);
}
bool ExactReference::receives(std::uint32_t object) const {
  return flag(impl_->geometry->objects.receives, object, true);
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
std::uint64_t ExactReference::memory_bytes() const {
  return impl_->geometry->scene.memory_bytes();
}
std::uint64_t ExactReference::rays() const {
  return impl_->rays.combine([](std::uint64_t a, std::uint64_t b) { return a + b; });
}

}  // namespace gnomon::metrics
