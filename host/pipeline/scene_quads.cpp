// SPDX-License-Identifier: Apache-2.0
// The quads that cast shadows, made once for all views.
#include "host/pipeline/scene_quads.hpp"

#include <algorithm>

namespace gnomon::pipeline {

const voxel::VoxelSet& SceneQuads::casters() {
  if (std::ranges::find(roles_.casts, false) == roles_.casts.end()) return voxels_;
  if (!some_) {
    some_ = voxels_;
    std::erase_if(some_->subpatches, [&](const voxel::Subpatch& s) { return !roles_.casts.at(s.object); });
  }
  return *some_;
}

std::span<const voxel::VoxelQuad> SceneQuads::casting() {
  if (!casting_) casting_ = voxel::casting_quads(surfaces_, casters()).quads;
  return *casting_;
}

std::span<const voxel::LimitQuad> SceneQuads::limit() {
  if (!limit_) limit_ = voxel::limit_quads(surfaces_, casters());
  return *limit_;
}

}  // namespace gnomon::pipeline
