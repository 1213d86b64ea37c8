// SPDX-License-Identifier: Apache-2.0
// From a scene to its voxels.
#include "host/cli/scene_voxels.hpp"

#include <fmt/format.h>

#include <span>
#include <vector>

#include "host/cli/progress.hpp"

namespace gnomon::cli {
namespace {

/// Every object's limit surface in grid coordinates; errors name file and object.
Result<std::vector<surface::LimitSurface>> limit_surfaces(const scene::Scene& scene,
                                                          const voxel::Grid& grid) {
  std::vector<surface::LimitSurface> surfaces;
  for (const scene::Object& object : scene.objects) {
    Result<surface::LimitSurface> surface =
        surface::LimitSurface::build(object.mesh, scene::to_grid(object, grid));
    if (!surface) {
      return fail(fmt::format("{}: error: object '{}': {}", scene.source.string(), object.name,
                              surface.error().message));
    }
    surfaces.push_back(std::move(*surface));
  }
  return surfaces;
}

template <class Set>
using Voxelizer = Result<Set>(std::span<const surface::LimitSurface>, const voxel::Grid&,
                              const voxel::VoxelizerOptions&);

template <class Set>
Result<Set> with_progress(Context& context, const LoadedScene& input, Voxelizer<Set>* voxelize) {
  const auto res = static_cast<std::uint32_t>(input.settings.integer("res"));
  const Result<voxel::Grid> grid = scene::fit_grid(input.scene, res, adjacency_of(input.settings));
  if (!grid) return tl::make_unexpected(grid.error());
  const Result<std::vector<surface::LimitSurface>> surfaces = limit_surfaces(input.scene, *grid);
  if (!surfaces) return tl::make_unexpected(surfaces.error());
  ProgressLine line(context.show_progress);
  voxel::VoxelizerOptions options;
  options.threads = static_cast<unsigned>(input.settings.integer("threads"));
  options.progress = [&](double done) {
    context.interruption.check();
    line.update("voxelize", done);
  };
  return voxelize(*surfaces, *grid, options);
}

}  // namespace

Result<voxel::VoxelSet> voxelize_scene(Context& context, const LoadedScene& input) {
  return with_progress(context, input, voxel::voxelize);
}

Result<voxel::CoordinateSet> voxelize_scene_coordinates(Context& context, const LoadedScene& input) {
  return with_progress(context, input, voxel::voxelize_coordinates);
}

}  // namespace gnomon::cli
