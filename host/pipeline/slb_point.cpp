// SPDX-License-Identifier: Apache-2.0
// One configuration of the silhouette-line buffer over shared work.
#include "host/pipeline/slb_point.hpp"

#include <algorithm>
#include <gnomon/golden/stream.hpp>
#include <utility>

#include "host/pipeline/engines.hpp"
#include "host/pipeline/light_answers.hpp"
#include "host/pipeline/records.hpp"
#include "host/pipeline/slb_answers.hpp"
#include "host/plan/slb_stream.hpp"
#include "host/report/metrics_json.hpp"
#include "host/report/numbers.hpp"

namespace gnomon::pipeline {
namespace {

using golden::VoxelState;

class Measurement {
 public:
  Measurement(const RunRequest& request, SlbShared& shared, plan::SlbPlan plan)
      : request_(request),
        shared_(shared),
        light_(shared.scene().lights.front()),
        plan_(std::move(plan)),
        stages_(request, {}) {}

  Result<SlbPoint> run(const std::vector<report::StageTime>& before) {
    if (auto done = stages_.run("stream", [&] { return write(); }); !done)
      return tl::make_unexpected(done.error());
    stages_.run(report::kGoldenStage, [&] { answer(); });
    if (auto done = stages_.run("decode", [&] { return decode(); }); !done)
      return tl::make_unexpected(done.error());
    stages_.run("errors", [&] { measure(); });
    return point(before);
  }

 private:
  Result<void> write() {
    auto drawing = shared_.drawing(plan_);
    if (!drawing) return tl::make_unexpected(drawing.error());
    drawing_ = std::move(*drawing);
    questions_ = shared_.questions(plan_, *drawing_, request_.settings.order);
    golden::StreamWriter writer(plan_.config);
    plan::draw_casters(writer, plan_, drawing_->outlines, drawing_->sheets);
    work_ = writer.take();
    work_.insert(work_.end(), questions_->voxels.begin(), questions_->voxels.end());
    golden::StreamWriter end(plan_.config);
    end.fence(0, true);
    work_.insert(work_.end(), end.words().begin(), end.words().end());
    return {};
  }

  void answer() {
    const auto engine = make_predicting_engine(request_, plan_.config, work_.size());
    const auto run = [&](std::span<const golden::Word> words, std::vector<golden::Word>& results) {
      engine->submit(words);
      engine->drain([&](std::span<const golden::Word> given) {
        results.insert(results.end(), given.begin(), given.end());
      });
    };
    run(work_, answers_.results);
    answers_.counters = engine->counters();
    run(questions_->samples, sample_results_);
  }

  Result<void> decode() {
    const auto of_voxels = query_answers(answers_.results, shared_.voxels().size());
    if (!of_voxels) return tl::make_unexpected(of_voxels.error());
    const std::vector<std::uint32_t>& places = questions_->places;
    std::size_t next = 0;
    std::vector<VoxelState> by_view;
    for (std::size_t i = 0; i < shared_.voxels().size(); ++i) {
      const Receiver& r = shared_.voxels()[places.empty() ? i : places[i]];
      const bool shadow = !r.faces_light() || of_voxels->at(next++).shadow;
      by_view.push_back(shadow ? VoxelState::Shadow : VoxelState::Lit);
    }
    by_view = plan::put_back(std::move(by_view), places);
    states_ = light_states(shared_.scene(), light_, {{by_view}});
    const auto of_samples = query_answers(sample_results_, drawing_->near.size());
    if (!of_samples) return tl::make_unexpected(of_samples.error());
    std::vector<std::uint8_t> all = drawing_->answers;
    for (std::size_t i = 0; i < drawing_->near.size(); ++i)
      all[drawing_->near[i]] = of_samples->at(i).shadow ? 1 : 0;
    const auto border = all.begin() + static_cast<std::ptrdiff_t>(light_.truth.samples.size());
    samples_ = {{all.begin(), border}, {border, all.end()}};
    return {};
  }

  void measure() {
    const LitScene& scene = shared_.scene();
    const metrics::ErrorOptions options{scene.ground(), plan_.plane.pitch};
    report::LightRecord& light = lit_;
    light.errors = errors_record(light_.truth, scene.voxels, states_, samples_, std::nullopt, options);
    for (const int finer : {1, 1 << plan_.config.frac_bits})
      light.errors.shadow_maps.push_back(shared_.shadow_map(plan_, finer, options));
    light.exact = exact_record(*light_.exact, light_.truth);
    light.in_shadow = static_cast<std::uint64_t>(std::ranges::count(states_, VoxelState::Shadow));
    light.not_reached = not_reached(scene, light_);
  }

  SlbPoint point(const std::vector<report::StageTime>& before) {
    const LitScene& scene = shared_.scene();
    report::RunRecord record = request_record(request_);
    record.technique = "slb";
    record.grid = scene.voxels.grid;
    record.voxel_statistics = scene.voxels.statistics;
    record.voxels = scene.voxels.voxels.size();
    record.hardware = plan_.config;
    lit_.light = record.lights.front().light;
    record.lights.front() = lit_;
    report::ViewRecord& view = record.lights.front().views.emplace_back();
    view.casters = light_.seen.front().casters.size();
    view.receivers = light_.seen.front().receivers.size();
    view.slb = slb_record(plan_, plan_.config);
    add_totals(record);
    record.command_words = work_.size();
    record.result_words = answers_.results.size();
    record.events = answers_.counters.events;
    record.stages = before;
    record.stages.insert(record.stages.end(), stages_.times().begin(), stages_.times().end());
    return {std::move(record), std::move(work_), std::move(answers_)};
  }

  const RunRequest& request_;
  SlbShared& shared_;
  const SceneLight& light_;
  plan::SlbPlan plan_;
  Stages stages_;
  std::shared_ptr<const SlbDrawing> drawing_;
  std::shared_ptr<const SlbQuestions> questions_;
  std::vector<golden::Word> work_, sample_results_;
  EngineAnswers answers_;
  std::vector<VoxelState> states_;
  metrics::SampleAnswers samples_;
  report::LightRecord lit_;
};

}  // namespace

Result<SlbPoint> measure_slb(const RunRequest& request, SlbShared& shared,
                             const std::vector<report::StageTime>& stages) {
  auto plan = shared.plan(request.settings.slb);
  if (!plan) return tl::make_unexpected(plan.error());
  return Measurement(request, shared, std::move(*plan)).run(stages);
}

Result<RtlAnswers> run_work(const RunRequest& request, const SlbPoint& point) try {
  sim::RtlOptions options;
  options.seed = request.seed;
  options.abort = request.abort;
  options.quick_build = true;  // the work is short, and every configuration needs a model of its own
  const golden::HardwareConfig& hardware = point.record.hardware;
  const auto engine = request.make_rtl ? request.make_rtl(hardware, options)
                                       : make_engine_under_test(request, hardware, options);
  return run_compared(*engine, point.work, point.answers, request.seed,
                      report::shell_line(request.command_line));
} catch (const sim::Aborted&) {
  throw;
} catch (const std::runtime_error& error) {
  return fail(error.what());  // a model that cannot be built is the user's to cure
}

}  // namespace gnomon::pipeline
