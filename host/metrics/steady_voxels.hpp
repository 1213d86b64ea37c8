// SPDX-License-Identifier: Apache-2.0
// Voxels whose exact answer does not hang on where the surface is to a fraction of a voxel
// (docs/error-metrics.md, "Steady voxels").
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/metrics/exact_reference.hpp"
#include "host/voxel/voxel_set.hpp"

namespace gnomon::metrics {

/// Below this cosine between normal and light a surface is edge-on: half a degree. From one voxel to the next
/// the light's plane is then crossed by less than what the exact reference leaves open.
inline constexpr double kSteadyCosine = 1.0 / 128;
/// Voxels above the surface where a steady voxel has the same answer.
inline constexpr double kSteadyLift = 0.5;

/// By voxel: 1 for those of the `unambiguous` that are steady, too. `answers` are the exact ones at the
/// voxels. Both run as voxels.voxels; throws std::invalid_argument where they do not. Multithreaded.
std::vector<std::uint8_t> steady_voxels(const ExactReference& reference,
                                        std::span<const surface::LimitSurface> surfaces,
                                        const voxel::VoxelSet& voxels, std::span<const Exact> answers,
                                        std::span<const std::uint8_t> unambiguous);

}  // namespace gnomon::metrics
