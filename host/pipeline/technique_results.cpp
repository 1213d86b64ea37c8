// SPDX-License-Identifier: Apache-2.0
// One technique's errors, pictures and record.
#include <algorithm>

#include "host/metrics/shadow_map.hpp"
#include "host/pipeline/light_answers.hpp"
#include "host/pipeline/records.hpp"
#include "host/pipeline/technique_job.hpp"
#include "host/report/metrics_json.hpp"

namespace gnomon::pipeline {

using golden::VoxelState;
using States = std::vector<VoxelState>;

metrics::SampleAnswers TechniqueJob::sample_answers(std::size_t light) const {
  const metrics::ShadowTruth& truth = scene_.lights[light].truth;
  if (!answers_points()) return metrics::sample_answers(truth, states_[light]);
  const auto samples = points_[light].begin();
  const auto border = samples + static_cast<std::ptrdiff_t>(truth.samples.size());
  return {{samples, border}, {border, border + static_cast<std::ptrdiff_t>(truth.border_samples.size())}};
}

/// The mean over a light's views; 1 where it has none.
double TechniqueJob::mean_of(std::size_t light, double (Technique::*figure)() const) const {
  double sum = 0;
  int views = 0;
  for (const View& view : views_) {
    if (view.light != light) continue;
    sum += (*view.technique.*figure)();
    ++views;
  }
  return views > 0 ? sum / views : 1;
}

metrics::ErrorOptions TechniqueJob::error_options(std::size_t light) const {
  return {scene_.ground(), mean_of(light, &Technique::pitch_on_plane)};
}

report::ShadowMapRecord TechniqueJob::measure_shadow_map(std::size_t light, const LightPlane& plane) const {
  const SceneLight& of = scene_.lights[light];
  const metrics::ShadowMap map(*of.exact, plane);
  return shadow_map_record(of.truth, scene_.voxels, map.states(scene_.voxels, scene_.roles.two_sided),
                           map.answers(of.truth), plane, hardware_.depth_bits, error_options(light));
}

/// By light; nothing where the technique has no such form.
std::vector<std::optional<States>> TechniqueJob::in_double() const {
  std::vector<std::vector<States>> by_view(scene_.lights.size());
  for (const View& view : views_) {
    if (auto states = view.technique->in_double()) by_view[view.light].push_back(std::move(*states));
  }
  scene_.quads->drop_limit();
  std::vector<std::optional<States>> all(scene_.lights.size());
  for (std::size_t l = 0; l < all.size(); ++l) {
    const SceneLight& light = scene_.lights[l];
    if (by_view[l].size() == light.views.size() && !answers_points())
      all[l] = light_states(scene_, light, by_view[l]);
  }
  return all;
}

void TechniqueJob::measure_errors() {
  const auto exact_arithmetic = stages_.run(report::kDoubleStage, [&] { return in_double(); });
  lights_.resize(scene_.lights.size());
  if (!views_.front().technique->shadow_maps().empty()) {
    stages_.run(report::kShadowMapStage, [&] {
      for (const View& view : views_)
        for (const LightPlane& map : view.technique->shadow_maps())
          lights_[view.light].errors.shadow_maps.push_back(measure_shadow_map(view.light, map));
    });
  }
  stages_.run("errors", [&] {
    for (std::size_t l = 0; l < lights_.size(); ++l) {
      const SceneLight& light = scene_.lights[l];
      report::LightRecord& record = lights_[l];
      auto maps = std::move(record.errors.shadow_maps);
      record.errors = errors_record(light.truth, scene_.voxels, states_[l], sample_answers(l),
                                    exact_arithmetic[l], error_options(l));
      record.errors.pitch = mean_of(l, &Technique::pitch);
      record.errors.shadow_maps = std::move(maps);
      record.exact = exact_record(*light.exact, light.truth);
      record.in_shadow = static_cast<std::uint64_t>(std::ranges::count(states_[l], VoxelState::Shadow));
      record.not_reached = not_reached(scene_, light);
    }
  });
}

render::Picture TechniqueJob::picture() const {
  const render::PictureOptions options = scene_.picture_options(stages_, "picture");
  const std::size_t count = scene_.lights.size();
  if (!answers_points()) {
    std::vector<render::StateShadows> shadows;
    for (std::size_t l = 0; l < count; ++l) shadows.push_back({scene_.lights[l].light, states_[l]});
    return scene_.picture_scene->render(scene_.camera, shadows, scene_.materials, options);
  }
  std::vector<render::PointShadows> shadows;
  for (std::size_t l = 0; l < count; ++l)
    shadows.push_back({scene_.lights[l].light, visible_[l],
                       std::span<const std::uint8_t>(points_[l]).last(visible_[l].points.size())});
  return scene_.picture_scene->render(scene_.camera, shadows, scene_.materials, options);
}

void TechniqueJob::draw() {
  pictures_.picture = stages_.run("picture", [&] { return picture(); });
  pictures_.memory =
      stages_.run("memory picture", [&] { return views_.front().technique->memory_picture(parts_.front()); });
  pictures_.error = stages_.run("error map", [&] {
    picture_record_ = picture_record(pictures_.picture, scene_.reference);
    for (std::size_t l = 0; l < lights_.size(); ++l)
      lights_[l].mask = mask_record(pictures_.picture, scene_.reference, l);
    return render::error_map(pictures_.picture, scene_.reference);
  });
}

report::RunRecord TechniqueJob::record(const std::vector<report::StageTime>& shared) const {
  report::RunRecord record = request_record(request_);
  record.technique = name_;
  record.grid = scene_.voxels.grid;
  record.voxel_statistics = scene_.voxels.statistics;
  record.voxels = scene_.voxels.voxels.size();
  record.hardware = hardware_;
  for (std::size_t l = 0; l < lights_.size(); ++l) {
    const Light in_world = record.lights[l].light;
    record.lights[l] = lights_[l];
    record.lights[l].light = in_world;
  }
  for (std::size_t i = 0; i < views_.size(); ++i) {
    const View& view = views_[i];
    const SceneLight& light = scene_.lights[view.light];
    report::ViewRecord& row = record.lights[view.light].views.emplace_back();
    row.name = light.views[view.number].name();
    row.casters = light.seen[view.number].casters.size();
    row.receivers = light.seen[view.number].receivers.size();
    row.events = golden_.parts[i].events;
    view.technique->describe(golden_.parts[i], parts_[i], row);
  }
  add_totals(record);
  record.compare = compare_;
  record.cycles = cycles_;
  record.predicted_cycles = golden_.counters.cycles;
  record.system = system_;
  record.picture = picture_record_;
  record.frames = frames_;
  record.command_words = stream_.size();
  record.result_words = golden_.results.size();
  record.events = golden_.counters.events;
  record.stages = shared;
  record.stages.insert(record.stages.end(), stages_.times().begin(), stages_.times().end());
  record.peak_memory_bytes = peak_memory_bytes();
  return record;
}

}  // namespace gnomon::pipeline
