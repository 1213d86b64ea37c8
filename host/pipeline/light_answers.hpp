// SPDX-License-Identifier: Apache-2.0
// From the answers of a light's views to its answers.
#pragma once

#include <gnomon/golden/codec.hpp>
#include <span>
#include <vector>

#include "host/base/result.hpp"
#include "host/pipeline/lit_scene.hpp"

namespace gnomon::pipeline {

/// The results of each view, split where FENCE results are: view i ends with the fence whose tag is i. Fails
/// where a fence is missing, or words follow the last.
Result<std::vector<std::span<const golden::Word>>> results_of_views(std::span<const golden::Word> results,
                                                                    std::size_t views);

/// One state a voxel under `light`. `by_view[i]` are the states of light.seen[i].receivers. A voxel that no
/// view answers is in shadow, except on objects that do not receive: those are lit where they face the light
/// and it reaches them.
std::vector<golden::VoxelState> light_states(const LitScene& scene, const SceneLight& light,
                                             std::span<const std::vector<golden::VoxelState>> by_view);

/// Receiving voxels that the light does not reach: those outside a spot's cone.
std::uint64_t not_reached(const LitScene& scene, const SceneLight& light);

}  // namespace gnomon::pipeline
