// SPDX-License-Identifier: Apache-2.0
// From the answers of a light's views to its answers.
#include "host/pipeline/light_answers.hpp"

#include <fmt/format.h>

#include <gnomon/golden/stream.hpp>
#include <stdexcept>

#include "host/metrics/voxel_index.hpp"

namespace gnomon::pipeline {
namespace {

using golden::VoxelState;

VoxelState without_shadows(const LitScene& scene, const SceneLight& light, const voxel::Voxel& voxel) {
  const Vec3 p = metrics::representative(voxel);
  if (!light_reaches(light.light, p)) return VoxelState::Shadow;
  const double cosine = -metrics::representative_normal(voxel).dot(light_way(light.light, p));
  const bool faces = scene.roles.two_sided.at(voxel.object) ? cosine != 0 : cosine > 0;
  return faces ? VoxelState::Lit : VoxelState::Shadow;
}

}  // namespace

Result<std::vector<std::span<const golden::Word>>> results_of_views(std::span<const golden::Word> results,
                                                                    std::size_t views) {
  std::vector<std::span<const golden::Word>> parts;
  std::size_t start = 0;
  golden::ResultReader reader(results);
  while (const auto result = reader.next()) {
    if (golden::result_code(result->word) == golden::ResultCode::Error)
      return fail("the hardware refused a command: " + golden::describe_result(result->word));
    if (golden::result_code(result->word) != golden::ResultCode::Fence) continue;
    const std::uint32_t tag = golden::decode_fence_result(result->word).tag;
    if (tag != parts.size())
      return fail(fmt::format("the hardware returned fence {}, expected {}", tag, parts.size()));
    parts.push_back(results.subspan(start, result->offset - start));
    start = result->offset + 1;
  }
  if (parts.size() != views || start != results.size())
    return fail(fmt::format("the hardware returned {} fences, expected {}, the last word being one",
                            parts.size(), views));
  return parts;
}

std::vector<VoxelState> light_states(const LitScene& scene, const SceneLight& light,
                                     std::span<const std::vector<VoxelState>> by_view) {
  std::vector<VoxelState> states(scene.voxels.voxels.size(), VoxelState::Shadow);
  for (std::size_t v = 0; v < light.seen.size(); ++v) {
    const std::vector<std::uint32_t>& receivers = light.seen[v].receivers;
    if (by_view[v].size() != receivers.size()) throw std::invalid_argument("one state a receiver");
    for (std::size_t i = 0; i < receivers.size(); ++i) states[receivers[i]] = by_view[v][i];
  }
  for (std::size_t i = 0; i < states.size(); ++i) {
    const voxel::Voxel& voxel = scene.voxels.voxels[i];
    if (!scene.roles.receives.at(voxel.object)) states[i] = without_shadows(scene, light, voxel);
  }
  return states;
}

std::uint64_t not_reached(const LitScene& scene, const SceneLight& light) {
  std::uint64_t receiving = 0, asked = 0;
  for (const voxel::Voxel& voxel : scene.voxels.voxels)
    receiving += scene.roles.receives.at(voxel.object) ? 1U : 0U;
  for (const plan::ViewVoxels& seen : light.seen) asked += seen.receivers.size();
  return receiving - asked;
}

}  // namespace gnomon::pipeline
