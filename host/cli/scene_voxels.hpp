// SPDX-License-Identifier: Apache-2.0
// From a scene to its voxels.
#pragma once

#include "host/base/result.hpp"
#include "host/cli/command.hpp"
#include "host/cli/scene_input.hpp"
#include "host/surface/limit_surface.hpp"
#include "host/voxel/voxelizer.hpp"

namespace gnomon::cli {

/// Fits the grid that the parameters ask for and voxelizes into it, with progress on a terminal. Throws
/// Interrupted.
Result<voxel::VoxelSet> voxelize_scene(Context& context, const LoadedScene& input);
/// A scene's limit surfaces in grid coordinates, and their voxels with subpatches.
struct VoxelizedScene {
  std::vector<surface::LimitSurface> surfaces;
  voxel::VoxelSet voxels;
};
Result<VoxelizedScene> voxelize_with_subpatches(Context& context, const LoadedScene& input);
/// The same voxels in another order, without representatives: faster.
Result<voxel::CoordinateSet> voxelize_scene_coordinates(Context& context, const LoadedScene& input);

}  // namespace gnomon::cli
