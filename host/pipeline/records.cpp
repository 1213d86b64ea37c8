// SPDX-License-Identifier: Apache-2.0
// What the stages found out, as the report wants it.
#include "host/pipeline/records.hpp"

#include <fmt/chrono.h>

#include <ctime>

#include "host/metrics/image_error.hpp"
#include "host/pipeline/engines.hpp"

namespace gnomon::pipeline {
namespace {

report::MislabelCounts counts(const metrics::Mislabels& m) {
  return {m.compared, m.false_shadow, m.false_lit};
}

report::ErrorPart part(const metrics::Mislabels& all, const metrics::Mislabels& unambiguous,
                       const metrics::Mislabels& steady, const metrics::Mislabels& samples,
                       const metrics::Displacement& displacement) {
  report::ErrorPart result{counts(all), counts(unambiguous), counts(steady), counts(samples), 0, {}};
  result.boundary_length = (displacement.border_cast + displacement.border_attached) / displacement.pitch;
  if (result.boundary_length > 0) result.boundary_displacement = displacement.entries();
  return result;
}

report::ErrorRecord error_record(const metrics::ShadowErrors& e) {
  return {part(e.all_voxels.total(), e.unambiguous_voxels.total(), e.steady_voxels.total(), e.samples.total(),
               e.displacement.total()),
          part(e.all_voxels.ground, e.unambiguous_voxels.ground, e.steady_voxels.ground, e.samples.ground,
               e.displacement.ground),
          part(e.all_voxels.models, e.unambiguous_voxels.models, e.steady_voxels.models, e.samples.models,
               e.displacement.models)};
}

std::string now() {
  return fmt::format("{:%FT%TZ}", fmt::gmtime(std::time(nullptr)));
}

}  // namespace

report::RunRecord request_record(const RunRequest& request) {
  report::RunRecord record;
  record.scene_name = request.scene.name;
  record.scene_source = request.scene.source.string();
  record.started = now();
  record.command_line = request.command_line;
  record.versions = request.versions;
  record.engine = to_string(request.engine);
  record.seed = request.seed;
  record.parameters = request.parameters;
  record.clock_mhz = request.settings.clock_mhz;
  for (const Light& light : request.scene.lights) record.lights.emplace_back().light = light;
  for (const scene::Object& object : request.scene.objects) {
    record.objects.push_back(
        {object.name, object.ground, object.two_sided, object.casts, object.receives, object.statistics});
  }
  record.warnings = request.scene.warnings;
  return record;
}

std::vector<report::RegisterRecord> register_records(const plan::VpuPlan& plan) {
  std::vector<report::RegisterRecord> records;
  for (int i = 0; i < golden::kRegisterCount; ++i) {
    const golden::RegisterFormat format =
        golden::register_format(static_cast<golden::Register>(i), plan.config);
    records.push_back({format.name, plan.registers.at(static_cast<std::size_t>(i)), format.width,
                       format.is_signed, format.frac_bits});
  }
  return records;
}

report::PlaneRecord plane_record(const plan::VpuPlan& plan, const PartAnswers& golden) {
  return {static_cast<std::uint32_t>(plan.config.plane_side()), golden.plane_entries_hit,
          plan.projection.pitch, 1};
}

report::ErrorsRecord errors_record(const metrics::ShadowTruth& truth, const voxel::VoxelSet& voxels,
                                   std::span<const golden::VoxelState> fixed,
                                   const metrics::SampleAnswers& samples,
                                   const std::optional<std::vector<golden::VoxelState>>& in_double,
                                   const metrics::ErrorOptions& options) {
  report::ErrorsRecord record;
  record.pitch = options.pitch;
  record.fixed = error_record(metrics::shadow_errors(truth, voxels, fixed, samples, options));
  if (!in_double) return record;
  report::DoubleRecord& exact_arithmetic = record.in_double.emplace();
  exact_arithmetic.error = error_record(metrics::shadow_errors(truth, voxels, *in_double, options));
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    if (fixed[i] == (*in_double)[i]) continue;
    ++exact_arithmetic.differing;
    exact_arithmetic.differing_unambiguous += truth.unambiguous[i];
  }
  return record;
}

report::ShadowMapRecord shadow_map_record(const metrics::ShadowTruth& truth, const voxel::VoxelSet& voxels,
                                          std::span<const golden::VoxelState> states,
                                          const metrics::SampleAnswers& samples, const LightPlane& plane,
                                          int depth_bits, const metrics::ErrorOptions& options) {
  const auto side = static_cast<std::uint64_t>(plane.side);
  return {static_cast<std::uint32_t>(side), side * side * static_cast<std::uint64_t>(depth_bits),
          error_record(metrics::shadow_errors(truth, voxels, states, samples, options))};
}

report::ExactRecord exact_record(const metrics::ExactReference& reference,
                                 const metrics::ShadowTruth& truth) {
  return {reference.triangles(), reference.sag(), reference.lift(), truth.rays};
}

report::MislabelCounts mask_record(const render::Picture& picture, const render::Picture& reference,
                                   std::size_t light) {
  const metrics::MaskError mask = metrics::mask_error(picture.mask_of(light), reference.mask_of(light));
  return {mask.receivers, mask.false_shadow, mask.false_lit};
}

report::PictureRecord picture_record(const render::Picture& picture, const render::Picture& reference) {
  const metrics::MaskError mask = metrics::mask_error(picture.mask, reference.mask);
  return {picture.image.width,
          picture.image.height,
          {mask.receivers, mask.false_shadow, mask.false_lit},
          mask.iou(),
          metrics::rmse(picture.image.rgb, reference.image.rgb)};
}

std::optional<std::uint32_t> ground_of(const scene::Scene& scene) {
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    if (scene.objects[i].ground) return static_cast<std::uint32_t>(i);
  }
  return std::nullopt;
}

}  // namespace gnomon::pipeline
