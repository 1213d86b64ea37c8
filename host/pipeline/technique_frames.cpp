// SPDX-License-Identifier: Apache-2.0
// One technique's pictures along a camera path: what its run has left, asked again; no shadow is found anew.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "host/pipeline/technique_job.hpp"
#include "host/plan/frame_lookup.hpp"
#include "host/render/png_file.hpp"
#include "host/report/metrics_json.hpp"
#include "host/report/numbers.hpp"

namespace gnomon::pipeline {
namespace {

/// Questions about shadows that are known; every other event is work on shadows.
bool is_question(const std::string& event) {
  return event == "COMMANDS" || event == "FRAME_BRICKS" || event.starts_with("FRAME_LOOKUPS") ||
         event.starts_with("SLB_QUERIES");
}

/// What was counted between two readings, without what did not move.
std::map<std::string, std::uint64_t> counted(const golden::Counters& before, const golden::Counters& after) {
  std::map<std::string, std::uint64_t> events;
  for (const auto& [name, count] : after.events) {
    const auto old = before.events.find(name);
    const std::uint64_t since = count - (old == before.events.end() ? 0 : old->second);
    if (since > 0) events[name] = since;
  }
  return events;
}

}  // namespace

/// Where the hardware keeps what frames ask for, its engines outlive the run.
bool TechniqueJob::frames_ask() const {
  return request_.frames > 0 && !is_software() && (answers_points() || hardware_.en_frame_buffer);
}

Result<std::vector<golden::Word>> TechniqueJob::ask(std::span<const golden::Word> words) {
  if (!engine_) throw std::logic_error("a frame asks an engine that is gone");
  EngineAnswers answers;
  engine_->submit(words);
  engine_->drain([&](std::span<const golden::Word> results) {
    answers.results.insert(answers.results.end(), results.begin(), results.end());
  });
  answers.counters = engine_->counters();
  frames_->command_words += words.size();
  frames_->result_words += answers.results.size();
  if (rtl_) {
    const RtlAnswers rtl =
        run_compared(*rtl_, words, answers, request_.seed, report::shell_line(request_.command_line));
    compare_.words += rtl.compare.words;
    compare_.differing += rtl.compare.differing;
    compare_.other_faults += rtl.compare.other_faults;
    if (compare_.text.empty()) compare_.text = rtl.compare.text;
    if (compare_.first.is_null()) compare_.first = rtl.compare.first;
    cycles_ = rtl.cycles;  // since reset
    system_ = rtl.system;
    if (rtl.compare.failed()) rtl_.reset();
  }
  return std::move(answers.results);
}

/// Answers at the points that the camera sees, from the silhouettes that the buffer still holds.
Result<render::Picture> TechniqueJob::picture_of_points(const render::Camera& camera,
                                                        const render::PictureOptions& options) {
  const SceneLight& light = scene_.lights.front();
  const Technique& technique = *views_.front().technique;
  const render::VisiblePoints visible = scene_.picture_scene->visible_points(
      camera, *light.exact, {options.width, options.height, options.supersample, {}, options.cancelled});
  golden::StreamWriter writer(hardware_);
  technique.ask(writer, visible.points);
  writer.fence(0, true);
  const auto results = is_software() ? Result<std::vector<golden::Word>>() : ask(writer.words());
  if (!results) return fail(results.error().message);
  const auto shadowed = technique.answers(*results, visible.points, parts_.front());
  if (!shadowed) return fail(shadowed.error().message);
  const render::PointShadows shadows{light.light, visible, *shadowed};
  return scene_.picture_scene->render(camera, std::span(&shadows, 1), scene_.materials, options);
}

/// States of the voxels that the camera sees, looked up in the frame buffer, a layer a light.
Result<std::vector<std::vector<golden::VoxelState>>> TechniqueJob::looked_up(
    const render::Camera& camera, const render::PictureOptions& options) {
  const std::vector<std::uint32_t> visible = scene_.picture_scene->visible_voxels(
      camera, {options.width, options.height, options.supersample, {}, options.cancelled});
  const plan::FrameLookup lookup(scene_.voxels, visible, hardware_);
  golden::StreamWriter writer(hardware_);
  for (std::uint32_t layer = 0; layer < states_.size(); ++layer) lookup.write(writer, layer);
  const auto results = ask(writer.words());
  if (!results) return fail(results.error().message);
  const std::vector<const plan::FrameLookup*> lookups(states_.size(), &lookup);
  const auto found = plan::frame_states(*results, lookups);
  if (!found) return fail(found.error().message);
  std::vector<std::vector<golden::VoxelState>> states;
  for (const std::vector<golden::VoxelState>& of_visible : *found) {
    auto& all = states.emplace_back(scene_.voxels.voxels.size(), golden::VoxelState::Empty);
    // What no pass was asked about has no state in the hardware: it keeps the host's answer.
    const std::vector<golden::VoxelState>& unasked = states_[states.size() - 1];
    for (std::size_t i = 0; i < visible.size(); ++i) {
      const std::uint32_t v = visible[i];
      all[v] = of_visible[i] == golden::VoxelState::Empty ? unasked[v] : of_visible[i];
    }
  }
  return states;
}

Result<render::Picture> TechniqueJob::frame(const render::Camera& camera,
                                            const render::PictureOptions& options) {
  if (answers_points()) return picture_of_points(camera, options);
  const auto draw = [&](std::span<const std::vector<golden::VoxelState>> states) {
    std::vector<render::StateShadows> shadows;
    for (std::size_t l = 0; l < states.size(); ++l) shadows.push_back({scene_.lights[l].light, states[l]});
    return scene_.picture_scene->render(camera, shadows, scene_.materials, options);
  };
  if (!hardware_.en_frame_buffer) return draw(states_);
  const auto states = looked_up(camera, options);
  if (!states) return fail(states.error().message);
  return draw(*states);
}

Result<void> TechniqueJob::draw_frames(const std::filesystem::path& folder) {
  if (request_.frames == 0) return {};
  std::filesystem::create_directories(folder);
  const std::vector<render::Camera> cameras = render::full_turn(scene_.camera, request_.frames);
  frames_.emplace();
  const golden::Counters before = engine_ ? engine_->counters() : golden_.counters;
  auto done = stages_.run(report::kFramesStage, [&]() -> Result<void> {
    for (std::size_t i = 0; i < cameras.size(); ++i) {
      render::PictureOptions options = scene_.picture_options(stages_, report::kFramesStage);
      options.progress = [&](double share) {
        stages_.progress(report::kFramesStage,
                         (static_cast<double>(i) + share) / static_cast<double>(cameras.size()));
      };
      const auto picture = frame(cameras[i], options);
      if (!picture) return fail(picture.error().message);
      const auto file = folder / fmt::format("frame_{:04}.png", i);
      if (auto written = render::write_png(picture->image, file); !written) return written;
    }
    return {};
  });
  if (!done) return done;
  const auto events = counted(before, engine_ ? engine_->counters() : golden_.counters);
  frames_->count = cameras.size();
  frames_->seconds = stages_.times().back().wall_seconds;
  frames_->user_seconds = stages_.times().back().user_seconds;
  for (const auto& [name, count] : events)
    (is_question(name) ? frames_->questions : frames_->shadow_work)[name] = count;
  return {};
}

}  // namespace gnomon::pipeline
