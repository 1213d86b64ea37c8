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

struct GridAndSurfaces {
  voxel::Grid grid;
  std::vector<surface::LimitSurface> surfaces;
};
Result<GridAndSurfaces> grid_and_surfaces(const LoadedScene& input) {
  const auto res = static_cast<std::uint32_t>(input.settings.integer("res"));
  const Result<voxel::Grid> grid = scene::fit_grid(input.scene, res, adjacency_of(input.settings));
  if (!grid) return tl::make_unexpected(grid.error());
  Result<std::vector<surface::LimitSurface>> surfaces = limit_surfaces(input.scene, *grid);
  if (!surfaces) return tl::make_unexpected(surfaces.error());
  return GridAndSurfaces{*grid, std::move(*surfaces)};
}

voxel::VoxelizerOptions voxelizer_options(Context& context, const LoadedScene& input, ProgressLine& line) {
  voxel::VoxelizerOptions options;
  options.threads = static_cast<unsigned>(input.settings.integer("threads"));
  options.progress = [&](double done) {
    context.interruption.check();
    line.update("voxelize", done);
  };
  return options;
}

template <class Set>
using Voxelizer = Result<Set>(std::span<const surface::LimitSurface>, const voxel::Grid&,
                              const voxel::VoxelizerOptions&);

template <class Set>
Result<Set> with_progress(Context& context, const LoadedScene& input, Voxelizer<Set>* voxelize) {
  const Result<GridAndSurfaces> made = grid_and_surfaces(input);
  if (!made) return tl::make_unexpected(made.error());
  ProgressLine line(context.show_progress);
  return voxelize(made->surfaces, made->grid, voxelizer_options(context, input, line));
}

}  // namespace

Result<voxel::VoxelSet> voxelize_scene(Context& context, const LoadedScene& input) {
  return with_progress(context, input, voxel::voxelize);
}

Result<VoxelizedScene> voxelize_with_subpatches(Context& context, const LoadedScene& input) {
  Result<GridAndSurfaces> made = grid_and_surfaces(input);
  if (!made) return tl::make_unexpected(made.error());
  ProgressLine line(context.show_progress);
  voxel::VoxelizerOptions options = voxelizer_options(context, input, line);
  options.subpatches = true;
  Result<voxel::VoxelSet> voxels = voxel::voxelize(made->surfaces, made->grid, options);
  if (!voxels) return tl::make_unexpected(voxels.error());
  return VoxelizedScene{std::move(made->surfaces), std::move(*voxels)};
}

Result<voxel::CoordinateSet> voxelize_scene_coordinates(Context& context, const LoadedScene& input) {
  return with_progress(context, input, voxel::voxelize_coordinates);
}

}  // namespace gnomon::cli
