// SPDX-License-Identifier: Apache-2.0
// From a scene to its voxels.
#pragma once

#include "host/base/result.hpp"
#include "host/cli/command.hpp"
#include "host/cli/scene_input.hpp"
#include "host/voxel/voxelizer.hpp"

namespace gnomon::cli {

/// Fits the grid that the parameters ask for and voxelizes into it, with progress on a terminal. Throws
/// Interrupted.
Result<voxel::VoxelSet> voxelize_scene(Context& context, const LoadedScene& input, bool representatives);

}  // namespace gnomon::cli
