// SPDX-License-Identifier: Apache-2.0
// The quads that cast shadows, made once for all views.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "host/plan/light_view.hpp"
#include "host/surface/limit_surface.hpp"
#include "host/voxel/subpatches.hpp"

namespace gnomon::pipeline {

/// The quads between voxels, made when they are first asked for: only some techniques want them.
class SceneQuads {
 public:
  SceneQuads(std::span<const surface::LimitSurface> surfaces, const voxel::VoxelSet& voxels,
             const plan::ObjectRoles& roles)
      : surfaces_(surfaces), voxels_(voxels), roles_(roles) {}

  /// Of the objects that cast.
  std::span<const voxel::VoxelQuad> casting();
  std::span<const voxel::LimitQuad> limit();
  /// Gives the memory of limit() back.
  void drop_limit() { limit_.reset(); }

 private:
  /// The voxels with the subpatches of casting objects alone.
  const voxel::VoxelSet& casters();

  std::span<const surface::LimitSurface> surfaces_;
  const voxel::VoxelSet& voxels_;
  const plan::ObjectRoles& roles_;
  std::optional<voxel::VoxelSet> some_;
  std::optional<std::vector<voxel::VoxelQuad>> casting_;
  std::optional<std::vector<voxel::LimitQuad>> limit_;
};

}  // namespace gnomon::pipeline
