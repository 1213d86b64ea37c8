// SPDX-License-Identifier: Apache-2.0
// One ray a sample against the stitched subpatches; the two kinds of picture differ in where the shadow comes
// from.
#include "host/render/picture.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <optional>
#include <stdexcept>
#include <string>

#include "host/mesh/subpatch_rects.hpp"
#include "host/metrics/parametric_mesh.hpp"
#include "host/metrics/progress.hpp"
#include "host/metrics/ray_scene.hpp"
#include "host/metrics/voxel_index.hpp"
#include "host/render/camera_rays.hpp"
#include "host/render/shading.hpp"

namespace gnomon::render {
namespace {

using metrics::MaskValue;

/// The surface under one sample.
struct Seen {
  std::size_t sample = 0;
  std::uint32_t object = 0, subpatch = 0, face = 0;
  double u = 0, v = 0;
  Vec3 point{0, 0, 0};   ///< on the triangle
  Vec3 normal{0, 0, 0};  ///< interpolated between limit normals
};

/// What a shadow source says about it, for one light.
struct ShadowAnswer {
  MaskValue mask;
  LightShare share;
};

ShadowAnswer answer(bool dark) {
  return {dark ? MaskValue::Shadow : MaskValue::Lit, light_share(dark ? 4 : 0)};
}

struct ObjectMesh {
  metrics::ParametricMesh mesh;           ///< points are in Embree alone once it is built
  std::vector<std::uint32_t> subpatches;  ///< of each rectangle
};

Vec3 vec(const std::array<float, 3>& a) {
  return {a[0], a[1], a[2]};
}

Box3 bounds_of(const voxel::VoxelSet& voxels) {
  const double res = voxels.grid.res;
  return {Vec3(0, 0, 0), Vec3(res, res, res)};
}

void check(const PictureOptions& options) {
  if (options.width < 1 || options.height < 1 || options.supersample < 1 || options.supersample > 16)
    throw std::invalid_argument("a picture needs a size, and 1 to 16 samples a pixel on each axis");
}

}  // namespace

struct PictureScene::Impl {
  Impl(std::span<const surface::LimitSurface> s, const voxel::VoxelSet& v)
      : surfaces(s), voxels(v), scene(bounds_of(v).center()) {
    if (voxels.subpatches.empty()) throw std::invalid_argument("a picture needs the voxelizer's subpatches");
    std::vector<mesh::SubpatchRects> rects = mesh::subpatch_rects(voxels, surfaces.size());
    objects.resize(surfaces.size());
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      objects[i].mesh = metrics::triangulate(surfaces[i], rects[i].rects, bounds_of(v).center(), true);
      objects[i].subpatches = std::move(rects[i].subpatches);
      scene.add(objects[i].mesh.points, objects[i].mesh.triangles);
      triangles += objects[i].mesh.triangles.size();
      objects[i].mesh.points = {};
    }
    scene.commit();
  }

  std::optional<Seen> look(const Vec3& eye, const Vec3& direction) const {
    const std::optional<metrics::RayHit> hit = scene.first_hit(eye, direction);
    if (!hit) return std::nullopt;
    const metrics::ParametricMesh& mesh = objects[hit->mesh].mesh;
    const auto& corners = mesh.triangles[hit->triangle];
    const std::array<double, 3> weights = {1.0 - hit->b - hit->c, hit->b, hit->c};
    Seen seen;
    seen.object = hit->mesh;
    seen.point = eye + direction * double{hit->distance};
    seen.subpatch = objects[hit->mesh].subpatches[mesh.rect_of_triangle[hit->triangle]];
    seen.face = voxels.subpatches[seen.subpatch].face;
    for (std::size_t k = 0; k < 3; ++k) {
      seen.u += weights[k] * mesh.params[corners[k]][0];
      seen.v += weights[k] * mesh.params[corners[k]][1];
      seen.normal += vec(mesh.normals[corners[k]]) * weights[k];
    }
    return seen;
  }

  ShadowAnswer from_states(const Seen& seen, const StateShadows& shadows) const {
    const voxel::Subpatch& p = voxels.subpatches[seen.subpatch];
    std::array<bool, 4> reached{}, dark{};
    for (std::size_t k = 0; k < 4; ++k) {
      reached[k] = light_reaches(shadows.light, metrics::representative(voxels.voxels[p.corner[k]]));
      dark[k] = reached[k] && shadows.states[p.corner[k]] == golden::VoxelState::Shadow;
    }
    const auto count = std::ranges::count(dark, true);
    const bool all_dark = count == std::ranges::count(reached, true);
    const bool high_u = seen.u > 0.5 * (double{p.u0} + p.u1);
    const bool high_v = seen.v > 0.5 * (double{p.v0} + p.v1);
    const std::size_t nearest = high_v ? (high_u ? 2 : 3) : (high_u ? 1 : 0);
    const bool mask = reached[nearest] ? dark[nearest] : all_dark;
    return {mask ? MaskValue::Shadow : MaskValue::Lit, light_share(all_dark ? 4 : static_cast<int>(count))};
  }

  ShadowAnswer from_reference(const Seen& seen, const metrics::ExactReference& reference) const {
    const surface::LimitSurface& surface = surfaces[seen.object];
    return answer(reference.occluded(surface.position(seen.face, seen.u, seen.v),
                                     surface.normal(seen.face, seen.u, seen.v), seen.object));
  }

  Receiver receiver(const Seen& seen, const metrics::ExactReference& reference) const {
    const surface::LimitSurface& surface = surfaces[seen.object];
    const Vec3 p = surface.position(seen.face, seen.u, seen.v);
    const double facing = reference.facing(p, surface.normal(seen.face, seen.u, seen.v), seen.object);
    return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z),
            static_cast<float>(facing)};
  }

  /// Calls `visit(seen)` for every sample that sees a surface, rows of samples on several threads.
  template <class Visit>
  void for_each_seen(const Camera& camera, const PictureOptions& options, const Visit& visit) const;
  /// `shadow(seen, lights[i])` answers where lights[i].light reaches.
  template <class Shadows, class Answer>
  Picture draw(const Camera& camera, std::span<const Shadows> lights, std::span<const Material> materials,
               const PictureOptions& options, const Answer& shadow) const;

  std::span<const surface::LimitSurface> surfaces;
  const voxel::VoxelSet& voxels;
  metrics::RayScene scene;
  std::vector<ObjectMesh> objects;
  std::size_t triangles = 0;
};

template <class Visit>
void PictureScene::Impl::for_each_seen(const Camera& camera, const PictureOptions& options,
                                       const Visit& visit) const {
  check(options);
  const CameraRays rays(camera, static_cast<double>(options.width) / options.height);
  const auto super = static_cast<std::size_t>(options.supersample);
  const std::size_t width = static_cast<std::size_t>(options.width) * super;
  const std::size_t height = static_cast<std::size_t>(options.height) * super;
  metrics::Progress progress(height, options.progress, options.cancelled);
  tbb::parallel_for(std::size_t{0}, height, [&](std::size_t sy) {
    const double y = (static_cast<double>(sy) + 0.5) / static_cast<double>(height);
    for (std::size_t sx = 0; sx < width; ++sx) {
      const double x = (static_cast<double>(sx) + 0.5) / static_cast<double>(width);
      std::optional<Seen> seen = look(rays.eye(), rays.direction(x, y));
      if (!seen) continue;
      seen->sample = sy * width + sx;
      visit(*seen);
    }
    progress.step();
  });
}

template <class Shadows, class Answer>
Picture PictureScene::Impl::draw(const Camera& camera, std::span<const Shadows> lights,
                                 std::span<const Material> materials, const PictureOptions& options,
                                 const Answer& shadow) const {
  check(options);
  if (lights.empty()) throw std::invalid_argument("a picture needs a light");
  if (materials.size() < surfaces.size()) throw std::invalid_argument("every object needs a material");
  const CameraRays rays(camera, static_cast<double>(options.width) / options.height);
  const Vec3 up = camera.up.normalized();
  const auto width = static_cast<std::size_t>(options.width);
  const auto height = static_cast<std::size_t>(options.height);
  const auto super = static_cast<std::size_t>(options.supersample);
  const std::size_t samples = width * height * super * super;
  Picture picture;
  picture.image = {options.width, options.height, std::vector<std::uint8_t>(3 * width * height)};
  picture.lights = lights.size();
  picture.mask.assign(lights.size() * samples, MaskValue::Background);

  const auto sample = [&](std::size_t sx, std::size_t sy, std::span<LightTerm> terms) {
    const double x = (static_cast<double>(sx) + 0.5) / static_cast<double>(width * super);
    const double y = (static_cast<double>(sy) + 0.5) / static_cast<double>(height * super);
    const Vec3 direction = rays.direction(x, y);
    std::optional<Seen> seen = look(rays.eye(), direction);
    if (!seen) return background(y);
    seen->sample = sy * width * super + sx;
    for (std::size_t i = 0; i < lights.size(); ++i) {
      const ShadowAnswer said =
          light_reaches(lights[i].light, seen->point) ? shadow(*seen, lights[i]) : answer(true);
      picture.mask[i * samples + seen->sample] = said.mask;
      terms[i] = {-light_way(lights[i].light, seen->point), said.share};
    }
    Vec3 normal = seen->normal.normalized();
    if (normal.dot(direction) > 0) normal = -normal;
    return shade({normal, -direction, up}, materials[seen->object], terms);
  };
  metrics::Progress progress(height, options.progress, options.cancelled);
  tbb::parallel_for(std::size_t{0}, height, [&](std::size_t py) {
    std::vector<LightTerm> terms(lights.size());
    for (std::size_t px = 0; px < width; ++px) {
      std::array<double, 3> sum{};
      bool empty = true;
      for (std::size_t s = 0; s < super * super; ++s) {
        const std::size_t sx = px * super + s % super;
        const std::size_t sy = py * super + s / super;
        const Color color = sample(sx, sy, terms);
        empty = empty && picture.mask[sy * width * super + sx] == MaskValue::Background;
        // Clamped before the mean, so that a bright highlight's outline is smoothed too.
        for (std::size_t k = 0; k < 3; ++k) sum[k] += std::min(1.0, double{color[k]});
      }
      const double dither = empty ? dither_noise(px, py) : 0.0;
      for (std::size_t k = 0; k < 3; ++k)
        picture.image.rgb[3 * (py * width + px) + k] =
            to_srgb(sum[k] / static_cast<double>(super * super), dither);
    }
    progress.step();
  });
  return picture;
}

PictureScene::PictureScene(std::span<const surface::LimitSurface> surfaces, const voxel::VoxelSet& voxels)
    : impl_(std::make_unique<Impl>(surfaces, voxels)) {}
PictureScene::PictureScene(PictureScene&&) noexcept = default;
PictureScene& PictureScene::operator=(PictureScene&&) noexcept = default;
PictureScene::~PictureScene() = default;

Picture PictureScene::render(const Camera& camera, std::span<const StateShadows> lights,
                             std::span<const Material> materials, const PictureOptions& options) const {
  for (const StateShadows& light : lights) {
    if (light.states.size() != impl_->voxels.voxels.size())
      throw std::invalid_argument(std::to_string(light.states.size()) + " voxel states given, " +
                                  std::to_string(impl_->voxels.voxels.size()) + " expected");
  }
  return impl_->draw(camera, lights, materials, options, [&](const Seen& seen, const StateShadows& shadows) {
    return impl_->from_states(seen, shadows);
  });
}

std::vector<std::uint32_t> PictureScene::visible_voxels(const Camera& camera,
                                                        const PictureOptions& options) const {
  std::vector<std::uint8_t> asked(impl_->voxels.voxels.size(), 0);
  impl_->for_each_seen(camera, options, [&](const Seen& seen) {
    for (const std::uint32_t corner : impl_->voxels.subpatches[seen.subpatch].corner)
      std::atomic_ref(asked[corner]).store(1, std::memory_order_relaxed);
  });
  std::vector<std::uint32_t> voxels;
  for (std::uint32_t i = 0; i < asked.size(); ++i)
    if (asked[i] != 0) voxels.push_back(i);
  return voxels;
}

VisiblePoints PictureScene::visible_points(const Camera& camera, const metrics::ExactReference& reference,
                                           const PictureOptions& options) const {
  check(options);
  const auto super = static_cast<std::size_t>(options.supersample);
  const std::size_t width = static_cast<std::size_t>(options.width) * super;
  const std::size_t height = static_cast<std::size_t>(options.height) * super;
  std::vector<std::vector<Receiver>> rows(height);
  VisiblePoints visible;
  visible.of_sample.assign(width * height, kNoPoint);
  impl_->for_each_seen(camera, options, [&](const Seen& seen) {
    std::vector<Receiver>& row = rows[seen.sample / width];
    visible.of_sample[seen.sample] = static_cast<std::uint32_t>(row.size());
    row.push_back(impl_->receiver(seen, reference));
  });
  for (std::size_t sy = 0; sy < height; ++sy) {
    const auto first = static_cast<std::uint32_t>(visible.points.size());
    for (std::uint32_t& index : std::span(visible.of_sample).subspan(sy * width, width))
      if (index != kNoPoint) index += first;
    visible.points.insert(visible.points.end(), rows[sy].begin(), rows[sy].end());
  }
  return visible;
}

Picture PictureScene::render(const Camera& camera, std::span<const PointShadows> lights,
                             std::span<const Material> materials, const PictureOptions& options) const {
  check(options);
  const std::size_t samples = static_cast<std::size_t>(options.width) *
                              static_cast<std::size_t>(options.height) *
                              static_cast<std::size_t>(options.supersample * options.supersample);
  for (const PointShadows& light : lights) {
    if (light.shadowed.size() != light.points.points.size() || light.points.of_sample.size() != samples)
      throw std::invalid_argument("answers, visible points and picture do not belong together");
  }
  return impl_->draw(camera, lights, materials, options, [](const Seen& seen, const PointShadows& shadows) {
    return answer(shadows.shadowed[shadows.points.of_sample[seen.sample]] != 0);
  });
}

Picture PictureScene::render_reference(const Camera& camera, std::span<const ExactShadows> lights,
                                       std::span<const Material> materials,
                                       const PictureOptions& options) const {
  return impl_->draw(camera, lights, materials, options, [&](const Seen& seen, const ExactShadows& shadows) {
    return impl_->from_reference(seen, shadows.reference);
  });
}

std::size_t PictureScene::triangles() const {
  return impl_->triangles;
}

}  // namespace gnomon::render
