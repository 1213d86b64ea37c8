// SPDX-License-Identifier: Apache-2.0
// Points on one scene: those of the silhouette-line buffer over shared work, others as a run has them.
#include "host/sweep/shared_scene.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "host/metrics/progress.hpp"
#include "host/pipeline/engines.hpp"
#include "host/pipeline/slb_answers.hpp"
#include "host/pipeline/slb_point.hpp"
#include "host/pipeline/software_technique.hpp"
#include "host/pipeline/technique_job.hpp"
#include "host/report/metrics_json.hpp"

namespace gnomon::sweep {
namespace {

/// The picture is not looked at; it is as small as it may be.
constexpr int kImage = 16;

void add(Measurement& to, const std::map<std::string, double>& figures) {
  to.figures.insert(figures.begin(), figures.end());
}

/// All of a record that does not depend on how it was measured. Entries of the silhouette-line buffer are
/// stored in powers of two; "memory.format_bits" counts what their format fills of them.
Measurement figures_of(const report::RunRecord& record) {
  Measurement measured = measurement_of(report::metrics_json(record));
  double bits = measured.figures["memory.hardware_bits"];
  if (record.slb) {
    const double pixels = static_cast<double>(record.slb->side) * record.slb->side;
    const auto filled = static_cast<double>(record.hardware.slb_config().entry_bits());
    bits -= pixels * (static_cast<double>(record.slb->entry_bits) - filled);
  }
  measured.figures.emplace("memory.format_bits", bits);
  return measured;
}

/// On what the point ran, or what was predicted: the whole system, or everything on the chip.
double bound_of(const pipeline::RunRequest& request) {
  return request.engine == pipeline::EngineKind::System ? kSystemBound : kChipBound;
}

/// Whether what ran is what was predicted: not units behind a front end of the simulation's own.
bool is_predicted(const pipeline::RunRequest& request) {
  return request.engine != pipeline::EngineKind::System ||
         request.settings.system.hardware == sim::system::HardwareModel::Top;
}

/// Of an engine under test: back from passes and causes to names.
Cycles named(const std::vector<report::PassCycles>& passes) {
  Cycles cycles;
  for (const report::PassCycles& pass : passes)
    for (const auto& [cause, count] : pass.causes) cycles["cycles." + pass.pass + "." + cause] = count;
  return cycles;
}

}  // namespace

Result<std::unique_ptr<SharedScene>> SharedScene::make(const Task& first, const TaskOptions& options) {
  std::unique_ptr<SharedScene> made(new SharedScene(options));
  Result<scene::Scene> scene = options.load(first.scene, first.point.settings);
  if (!scene) return tl::make_unexpected(scene.error());
  made->shared_.scene = std::move(*scene);
  made->shared_ = made->request_of(first, options.engine);
  if (auto built = made->lit_.build(made->shared_, made->stages_); !built)
    return tl::make_unexpected(built.error());
  made->lit_.look(made->shared_, made->stages_);
  return made;
}

pipeline::RunRequest SharedScene::request_of(const Task& task, pipeline::EngineKind engine) const {
  pipeline::RunRequest request = shared_;
  request.settings = options_.settings(task.point.settings);
  request.settings.image_width = request.settings.image_height = kImage;
  request.engine = engine;
  request.seed = static_cast<std::uint32_t>(task.point.settings.integer("seed"));
  request.abort = options_.abort;
  request.make_rtl = options_.make_rtl;
  request.command_line = {"gnomon", "run", row_of(task).flags};
  return request;
}

bool SharedScene::takes_short_way(const pipeline::RunRequest& request) const {
  return request.settings.techniques.front() == "slb" && !request.settings.frame_buffer &&
         pipeline::SlbShared::knows(lit_);
}

Result<pipeline::SlbShared*> SharedScene::slb() {
  const std::scoped_lock lock(slb_mutex_);
  if (!slb_) {
    auto made = pipeline::SlbShared::make(lit_);
    if (!made) return tl::make_unexpected(made.error());
    slb_ = std::move(*made);
  }
  return slb_.get();
}

Result<Measurement> SharedScene::measure(const Task& task) {
  const pipeline::RunRequest request = request_of(task, options_.engine);
  if (request.settings.techniques.size() != 1) return fail("a point has one technique");
  if (options_.engine == pipeline::EngineKind::Golden && takes_short_way(request))
    return by_shared_work(request);
  return by_run(request);
}

Result<Measurement> SharedScene::by_shared_work(const pipeline::RunRequest& request) {
  const auto shared = slb();
  if (!shared) return tl::make_unexpected(shared.error());
  const auto point = pipeline::measure_slb(request, **shared, stages_.times());
  if (!point) return tl::make_unexpected(point.error());
  Measurement measured = figures_of(point->record);
  drop_unasked(measured);
  const Cycles& model = point->answers.counters.cycles;
  if (!model.empty()) add(measured, cycle_figures("model", model));
  return measured;
}

Result<report::RunRecord> SharedScene::run(const pipeline::RunRequest& request) {
  pipeline::TechniqueJob job(request, lit_, request.settings.techniques.front());
  {
    // Quads between voxels are made for the first who asks.
    const std::scoped_lock lock(plan_);
    if (auto done = job.plan(); !done) return tl::make_unexpected(done.error());
  }
  if (auto done = job.run(); !done) return tl::make_unexpected(done.error());
  return job.record(stages_.times());
}

Result<Measurement> SharedScene::by_run(const pipeline::RunRequest& request) {
  const auto record = run(request);
  if (!record) return tl::make_unexpected(record.error());
  if (!record->compare.partial.empty()) throw metrics::Cancelled();
  if (record->compare.failed()) return fail("golden and rtl differ: " + report::verdict(record->compare));
  Measurement measured = figures_of(*record);
  const Cycles model = record->software ? cycles_of_work(*record) : record->predicted_cycles;
  if (!model.empty()) add(measured, cycle_figures("model", model));
  if (!record->compare.compared) return measured;
  const Cycles taken = named(record->cycles);
  if (model.empty() || !is_predicted(request)) {
    add(measured, cycle_figures("rtl", taken));
  } else {
    Measurement confirmed = confirmation(model, taken, record->compare, bound_of(request));
    add(measured, confirmed.figures);
    measured.labels.merge(confirmed.labels);
  }
  return measured;
}

/// A software technique counts its own cycles; ray casting has none. As with the silhouette-line buffer, work
/// is one question a voxel: those about samples are asked for the error's sake.
Cycles SharedScene::cycles_of_work(const report::RunRecord& record) const {
  Cycles cycles = named(record.cycles);
  const auto asking = cycles.find("cycles.QUERY.BUSY");
  if (asking == cycles.end() || record.software->queries == 0) return cycles;
  std::uint64_t questions = 0;
  for (const pipeline::SceneLight& light : lit_.lights) {
    const auto voxels = pipeline::voxel_receivers(lit_.surfaces, lit_.voxels, lit_.roles, light.views.front(),
                                                  light.seen.front());
    questions += static_cast<std::uint64_t>(std::ranges::count_if(voxels, &Receiver::faces_light));
  }
  asking->second = asking->second / record.software->queries * questions;  // the same for each
  return cycles;
}

Result<Measurement> SharedScene::confirm(const Task& task) {
  pipeline::RunRequest request = request_of(task, pipeline::EngineKind::Rtl);
  if (request.settings.memory_given)
    request.engine = pipeline::EngineKind::System;  // whose cycles were predicted
  if (request.settings.techniques.size() != 1) return fail("a point has one technique");
  if (pipeline::is_software(request.settings.techniques.front())) return Measurement{};
  if (!takes_short_way(request)) {
    const auto record = run(request);
    if (!record) return tl::make_unexpected(record.error());
    if (record->predicted_cycles.empty()) return Measurement{};  // nothing to confirm
    return confirmation(record->predicted_cycles, named(record->cycles), record->compare, bound_of(request));
  }
  const auto shared = slb();
  if (!shared) return tl::make_unexpected(shared.error());
  const auto point = pipeline::measure_slb(request, **shared, {});
  if (!point) return tl::make_unexpected(point.error());
  if (point->answers.counters.cycles.empty()) return Measurement{};
  const auto rtl = pipeline::run_work(request, *point);
  if (!rtl) return tl::make_unexpected(rtl.error());
  return confirmation(point->answers.counters.cycles, named(rtl->cycles), rtl->compare, bound_of(request));
}

}  // namespace gnomon::sweep
