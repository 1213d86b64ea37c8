// SPDX-License-Identifier: Apache-2.0
// From a scene to surfaces, voxels, views, exact shadows and their picture.
#include "host/pipeline/lit_scene.hpp"

#include <algorithm>
#include <utility>

#include "host/pipeline/records.hpp"
#include "host/report/metrics_json.hpp"
#include "host/voxel/voxelizer.hpp"

namespace gnomon::pipeline {
namespace {

render::Camera camera_in_grid(const scene::Camera& from, const voxel::Grid& grid) {
  const Mat4 to_grid = scene::to_grid(grid);
  render::Camera camera{from.eye * to_grid, from.target * to_grid, {}, from.fov};
  to_grid.multDirMatrix(from.up, camera.up);
  return camera;
}

}  // namespace

Result<void> LitScene::build_surfaces(const RunRequest& request) {
  auto grid = scene::fit_grid(request.scene, request.settings.res, request.settings.adjacency);
  if (!grid) return fail(grid.error().message);
  grid_ = *grid;
  for (const scene::Object& object : request.scene.objects) {
    auto surface = surface::LimitSurface::build(object.mesh, scene::to_grid(object, grid_));
    if (!surface) return fail(surface.error().message);
    surfaces.push_back(std::move(*surface));
    roles.two_sided.push_back(object.two_sided);
    roles.casts.push_back(object.casts);
    roles.receives.push_back(object.receives);
  }
  camera = camera_in_grid(request.scene.camera, grid_);
  ground_ = ground_of(request.scene);
  image_width_ = request.settings.image_width;
  image_height_ = request.settings.image_height;
  const auto objects = static_cast<std::uint32_t>(surfaces.size());
  materials = render::default_materials(objects, ground_.value_or(objects));
  return {};
}

Result<void> LitScene::voxelize(const RunRequest& request, const Stages& stages) {
  voxel::VoxelizerOptions options;
  options.subpatches = true;
  options.threads = request.settings.threads;
  options.progress = stages.progress_of("voxelize");
  auto made = voxel::voxelize(surfaces, grid_, options);
  if (!made) return fail(made.error().message);
  voxels = std::move(*made);
  quads.emplace(surfaces, voxels, roles);
  return {};
}

Result<void> LitScene::see(const RunRequest& request) {
  const Mat4 to_grid = scene::to_grid(grid_);
  std::size_t views = 0;
  for (const Light& in_world : request.scene.lights) {
    SceneLight& light = lights.emplace_back();
    light.light = transformed(in_world, to_grid);
    for (plan::LightView& view : plan::light_views(light.light, voxels)) {
      plan::ViewVoxels seen = plan::view_voxels(view, voxels, roles);
      if (seen.receivers.empty()) continue;
      light.views.push_back(std::move(view));
      light.seen.push_back(std::move(seen));
    }
    views += light.views.size();
  }
  if (views > 0) return {};
  return fail(request.scene.source.string() +
              ": no light reaches anything: expected an object with receives = true inside a light's cone");
}

Result<void> LitScene::build(const RunRequest& request, Stages& stages) {
  if (auto done = stages.run("surface", [&] { return build_surfaces(request); }); !done) return done;
  if (auto done = stages.run("voxelize", [&] { return voxelize(request, stages); }); !done) return done;
  return stages.run("views", [&] { return see(request); });
}

void LitScene::take_truth(const Stages& stages) {
  const auto count = static_cast<double>(lights.size());
  for (std::size_t i = 0; i < lights.size(); ++i) {
    SceneLight& light = lights[i];
    if (i == 0) {
      light.exact.emplace(surfaces, metrics::ReferenceObjects{roles.two_sided, roles.casts, roles.receives},
                          light.light);
    } else {
      light.exact.emplace(lights.front().exact->relit(light.light));
    }
    metrics::TruthOptions options;
    options.progress = [&stages, count, i](double done) {
      stages.progress(report::kExactStage, (static_cast<double>(i) + done) / count);
    };
    options.cancelled = stages.cancelled();
    light.truth = metrics::shadow_truth(*light.exact, surfaces, voxels, options);
  }
}

render::PictureOptions LitScene::picture_options(const Stages& stages, std::string_view stage) const {
  render::PictureOptions options;
  options.width = image_width_;
  options.height = image_height_;
  options.cancelled = stages.cancelled();
  options.progress = stages.progress_of(stage);
  return options;
}

void LitScene::look(const RunRequest&, Stages& stages) {
  stages.run(report::kExactStage, [&] { take_truth(stages); });
  stages.run("picture scene", [&] { picture_scene.emplace(surfaces, voxels); });
  reference = stages.run("reference picture", [&] {
    std::vector<render::ExactShadows> shadows;
    for (const SceneLight& light : lights) shadows.push_back({light.light, *light.exact});
    return picture_scene->render_reference(camera, shadows, materials,
                                           picture_options(stages, "reference picture"));
  });
}

}  // namespace gnomon::pipeline
