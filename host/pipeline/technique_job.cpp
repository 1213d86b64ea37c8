// SPDX-License-Identifier: Apache-2.0
// One technique over a lit scene: planned, run, compared, decoded.
#include "host/pipeline/technique_job.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "host/pipeline/light_answers.hpp"
#include "host/pipeline/records.hpp"
#include "host/report/metrics_json.hpp"
#include "host/report/numbers.hpp"

namespace gnomon::pipeline {

Result<void> TechniqueJob::plan() {
  return stages_.run("plan", [&]() -> Result<void> {
    std::vector<TechniqueInput> inputs;
    for (std::size_t l = 0; l < scene_.lights.size(); ++l) {
      const SceneLight& light = scene_.lights[l];
      for (std::size_t v = 0; v < light.views.size(); ++v) {
        inputs.push_back({scene_.surfaces, scene_.roles, scene_.voxels, *scene_.quads, light.views[v],
                          light.seen[v], l, v == 0, &light.exact});
        views_.push_back({l, v, nullptr});
      }
    }
    auto made = make_techniques(name_, request_.settings, inputs);
    if (!made) return fail(made.error().message);
    hardware_ = made->front()->config();
    for (std::size_t i = 0; i < views_.size(); ++i) {
      hardware_ = joined_hardware(hardware_, (*made)[i]->config());
      views_[i].technique = std::move((*made)[i]);
    }
    return {};
  });
}

/// Samples, samples along the border, points of the picture: in this order.
std::vector<Receiver> TechniqueJob::points_of(std::size_t light) const {
  const metrics::ShadowTruth& truth = scene_.lights[light].truth;
  const std::vector<Receiver>& visible = visible_[light].points;
  std::vector<Receiver> all;
  all.reserve(truth.samples.size() + truth.border_samples.size() + visible.size());
  for (const auto* samples : {&truth.samples, &truth.border_samples})
    for (const metrics::SurfaceSample& s : *samples) all.push_back({s.x, s.y, s.z, s.facing});
  all.insert(all.end(), visible.begin(), visible.end());
  return all;
}

Result<void> TechniqueJob::write_stream() {
  if (answers_points()) {
    stages_.run("visible points", [&] {
      const auto options = scene_.picture_options(stages_, "visible points");
      for (const SceneLight& light : scene_.lights)
        visible_.push_back(scene_.picture_scene->visible_points(scene_.camera, *light.exact, options));
    });
  }
  return stages_.run("stream", [&]() -> Result<void> {
    golden::StreamWriter writer(hardware_);
    for (std::uint32_t tag = 0; tag < views_.size(); ++tag) {
      const View& view = views_[tag];
      const std::vector<Receiver> points = answers_points() ? points_of(view.light) : std::vector<Receiver>();
      if (auto done = view.technique->write(writer, hardware_, points); !done)
        return fail(done.error().message);
      if (!is_software()) writer.fence(tag, true);
      ends_.push_back(writer.words().size());
    }
    stream_ = writer.take();
    return {};
  });
}

void TechniqueJob::run_golden() {
  auto engine = request_.make_golden ? request_.make_golden(hardware_)
                                     : make_predicting_engine(request_, hardware_, stream_.size());
  golden_ = stages_.run(report::kGoldenStage, [&] {
    return run_stream(*engine, stream_, ends_, stages_.progress_of(report::kGoldenStage));
  });
  if (frames_ask()) engine_ = std::move(engine);
}

/// The first run of a configuration compiles its model; without a compiler or a cache that is the user's to
/// cure.
Result<std::unique_ptr<sim::RtlEngine>> TechniqueJob::make_rtl(const sim::RtlOptions& options) const try {
  return request_.make_rtl ? request_.make_rtl(hardware_, options)
                           : make_engine_under_test(request_, hardware_, options);
} catch (const std::runtime_error& error) {
  return fail(error.what());
}

Result<void> TechniqueJob::run_rtl() {
  sim::RtlOptions options;
  options.seed = request_.seed;
  options.abort = request_.abort;
  options.max_cycles = request_.max_cycles;
  options.trace = request_.trace;
  const std::string_view stage = report::engine_stage(to_string(request_.engine));
  options.progress = [this, stage](const sim::Progress& p) {
    if (frames_) return stages_.progress(report::kFramesStage, 0);
    stages_.progress(stage, static_cast<double>(p.words) / static_cast<double>(stream_.size()));
  };
  auto engine = stages_.run("rtl model", [&] { return make_rtl(options); });
  if (!engine) return fail(engine.error().message);
  RtlAnswers answers = stages_.run(stage, [&] {
    return run_compared(**engine, stream_, golden_, request_.seed, report::shell_line(request_.command_line),
                        true);
  });
  compare_ = std::move(answers.compare);
  cycles_ = std::move(answers.cycles);
  system_ = std::move(answers.system);
  if (interrupted()) stages_.finish();
  if (frames_ask() && !compare_.failed() && compare_.partial.empty()) rtl_ = std::move(*engine);
  return {};
}

Result<void> TechniqueJob::decode() {
  if (!is_software()) {
    auto parts = results_of_views(golden_.results, views_.size());
    if (!parts) return fail(parts.error().message);
    parts_ = std::move(*parts);
  }
  std::vector<std::vector<std::vector<golden::VoxelState>>> by_view(scene_.lights.size());
  points_.resize(scene_.lights.size());
  for (std::size_t i = 0; i < views_.size(); ++i) {
    auto answers = views_[i].technique->decode(parts_[i]);
    if (!answers) return fail(answers.error().message);
    by_view[views_[i].light].push_back(std::move(answers->voxels));
    if (!answers->points.empty()) points_[views_[i].light] = std::move(answers->points);
  }
  for (std::size_t l = 0; l < scene_.lights.size(); ++l)
    states_.push_back(light_states(scene_, scene_.lights[l], by_view[l]));
  return {};
}

/// No engine: each view's answers are worked out here.
void TechniqueJob::run_software() {
  compare_.software = true;
  golden_.parts.resize(views_.size());
  parts_.resize(views_.size());
  stages_.run(report::kSoftwareStage, [&] {
    for (const View& view : views_) view.technique->solve();
  });
  for (const View& view : views_) add_cycles(cycles_, view.technique->cycles());
}

Result<void> TechniqueJob::run_engines() {
  run_golden();
  return request_.engine == EngineKind::Golden ? Result<void>() : run_rtl();
}

Result<void> TechniqueJob::run() {
  if (auto done = write_stream(); !done) return done;
  if (is_software()) {
    run_software();
  } else if (auto done = run_engines(); !done) {
    return done;
  }
  if (auto done = stages_.run("decode", [&] { return decode(); }); !done) return done;
  measure_errors();
  return {};
}

}  // namespace gnomon::pipeline
