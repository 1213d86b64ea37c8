// SPDX-License-Identifier: Apache-2.0
// What the stages found out, as the report wants it.
#pragma once

#include <gnomon/golden/codec.hpp>
#include <optional>
#include <span>
#include <vector>

#include "host/base/light_plane.hpp"
#include "host/metrics/exact_reference.hpp"
#include "host/metrics/shadow_error.hpp"
#include "host/pipeline/engines.hpp"
#include "host/pipeline/run.hpp"
#include "host/render/picture.hpp"

namespace gnomon::pipeline {

/// The request's own part: scene, parameters, versions. Lights without results.
report::RunRecord request_record(const RunRequest& request);

std::vector<report::RegisterRecord> register_records(const plan::VpuPlan& plan);

report::PlaneRecord plane_record(const plan::VpuPlan& plan, const PartAnswers& golden);

/// The technique against the exact answers; where there is one, the method in double too, and both against
/// each other.
report::ErrorsRecord errors_record(const metrics::ShadowTruth& truth, const voxel::VoxelSet& voxels,
                                   std::span<const golden::VoxelState> fixed,
                                   const metrics::SampleAnswers& samples,
                                   const std::optional<std::vector<golden::VoxelState>>& in_double,
                                   const metrics::ErrorOptions& options);

/// A shadow map's answers; `depth_bits` a pixel.
report::ShadowMapRecord shadow_map_record(const metrics::ShadowTruth& truth, const voxel::VoxelSet& voxels,
                                          std::span<const golden::VoxelState> states,
                                          const metrics::SampleAnswers& samples, const LightPlane& plane,
                                          int depth_bits, const metrics::ErrorOptions& options);

report::ExactRecord exact_record(const metrics::ExactReference& reference, const metrics::ShadowTruth& truth);

report::PictureRecord picture_record(const render::Picture& picture, const render::Picture& reference);
/// What one light's mask says.
report::MislabelCounts mask_record(const render::Picture& picture, const render::Picture& reference,
                                   std::size_t light);

/// Fills what `record` says of all lights and views together from record.lights and record.hardware.
void add_totals(report::RunRecord& record);

/// Adds what one view's pass took to that of the others, by pass and cause.
void add_cycles(std::vector<report::PassCycles>& sum, const std::vector<report::PassCycles>& more);

/// All of a hardware's memory but the frame buffer: planes, lists and scratch, by the formulas of
/// metrics.json.
std::uint64_t hardware_memory_bits(const golden::HardwareConfig& hardware);

/// The index of the scene's ground, if it has one.
std::optional<std::uint32_t> ground_of(const scene::Scene& scene);

}  // namespace gnomon::pipeline
