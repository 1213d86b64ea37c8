// SPDX-License-Identifier: Apache-2.0
// The points of a sweep, measured.
#include "host/sweep/runner.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>

#include "host/metrics/progress.hpp"
#include "host/pipeline/lit_scene.hpp"
#include "host/pipeline/technique_job.hpp"
#include "host/report/metrics_json.hpp"
#include "host/sweep/measurement.hpp"
#include "sim/rtl_engine.hpp"

namespace gnomon::sweep {
namespace {

/// What is not named here is taken for shared, so that a new parameter costs time at worst.
constexpr std::array<std::string_view, 26> kOfTechnique{
    "technique",  "plane",           "pitch",           "offset",     "margin",     "margin_tan_max",
    "depth_bits", "normal_bits",     "voxel_frac_bits", "frac_bits",  "slope_bits", "slb_preset",
    "frags",      "rounding",        "subpixel_bits",   "query_bits", "lift",       "clearance",
    "sub_bits",   "span_log2",       "nodes_log2",      "quads_log2", "clock_mhz",  "seed",
    "threads",    "matrix_frac_bits"};

/// The picture is not looked at; it is as small as it may be.
constexpr int kImage = 16;

std::string shared_signature(const Task& task) {
  std::string text = task.scene.string();
  for (const config::Parameter& parameter : config::parameters()) {
    if (of_technique(parameter.key)) continue;
    const config::Settings::Entry& entry = task.point.settings.entry(parameter.key);
    // Whether a light was asked for matters: one that was replaces the scene's own.
    text += fmt::format("\n{}={}{}", parameter.key, config::to_text(entry.value),
                        entry.origin == "default" ? "" : "!");
  }
  return text;
}

std::string configuration_json(const config::Settings& settings) {
  nlohmann::ordered_json all;
  for (const config::Parameter& parameter : config::parameters()) {
    const config::Value& value = settings.entry(parameter.key).value;
    if (const auto* integer = std::get_if<std::int64_t>(&value)) {
      all[std::string(parameter.key)] = *integer;
    } else if (const auto* number = std::get_if<double>(&value)) {
      all[std::string(parameter.key)] = *number;
    } else {
      all[std::string(parameter.key)] = config::to_text(value);
    }
  }
  return all.dump();
}

Row row_of(const Task& task) {
  Row row;
  row.key = task.key;
  row.scene = task.scene.filename().string();
  row.configuration = configuration_json(task.point.settings);
  row.flags = fmt::format("{} {}", task.scene.string(), fmt::join(task.point.settings.as_flags(), " "));
  row.finished = now();
  return row;
}

class Runner {
 public:
  Runner(Store& store, const RunnerOptions& options, std::size_t all)
      : store_(store), options_(options), all_(all) {}

  /// Tasks that share everything but their technique's parameters.
  void run_group(const std::vector<const Task*>& tasks) {
    ++counts_.scenes;
    pipeline::RunRequest request;
    Result<scene::Scene> scene = options_.load(tasks.front()->scene, tasks.front()->point.settings);
    if (!scene) return fail_all(tasks, scene.error().message);
    request.scene = std::move(*scene);
    prepare(request, tasks.front()->point.settings);
    pipeline::Stages stages(request, {});
    pipeline::LitScene lit;
    if (auto built = lit.build(request, stages); !built) return fail_all(tasks, built.error().message);
    lit.look(request, stages);
    tbb::parallel_for(std::size_t{0}, tasks.size(), [&](std::size_t i) {
      tbb::this_task_arena::isolate([&] { measure(*tasks[i], request, lit, stages); });
    });
  }

  RunnerCounts counts() const { return counts_; }
  bool aborted() const { return options_.abort != nullptr && options_.abort->load(); }

 private:
  void prepare(pipeline::RunRequest& request, const config::Settings& settings) const {
    request.settings = options_.settings(settings);
    request.settings.image_width = request.settings.image_height = kImage;
    request.engine = options_.engine;
    request.seed = static_cast<std::uint32_t>(settings.integer("seed"));
    request.abort = options_.abort;
  }

  void measure(const Task& task, const pipeline::RunRequest& shared, pipeline::LitScene& lit,
               const pipeline::Stages& stages) {
    if (aborted()) throw metrics::Cancelled();
    Row row = row_of(task);
    pipeline::RunRequest request = shared;
    prepare(request, task.point.settings);
    request.command_line = {"gnomon", "run", row.flags};
    try {
      if (const auto measured = run_technique(request, lit, stages)) {
        row.figures = measured->figures;
        row.labels = measured->labels;
      } else {
        row.error = measured.error().message;
      }
    } catch (const sim::Aborted&) {
      throw metrics::Cancelled();
    }
    put(row);
  }

  Result<Measurement> run_technique(const pipeline::RunRequest& request, pipeline::LitScene& lit,
                                    const pipeline::Stages& stages) {
    if (request.settings.techniques.size() != 1) return gnomon::fail("a point has one technique");
    pipeline::TechniqueJob job(request, lit, request.settings.techniques.front());
    if (auto done = plan(job); !done) return tl::make_unexpected(done.error());
    if (auto done = job.run(); !done) return tl::make_unexpected(done.error());
    if (job.compare().failed())
      return gnomon::fail("golden and rtl differ: " + report::verdict(job.compare()));
    return measurement_of(report::metrics_json(job.record(stages.times())));
  }

  /// Quads between voxels are made for the first who asks.
  Result<void> plan(pipeline::TechniqueJob& job) {
    const std::scoped_lock lock(plan_);
    return job.plan();
  }

  void put(const Row& row) {
    const std::scoped_lock lock(write_);
    store_.put(row);
    ++(row.failed() ? counts_.failed : counts_.done);
    if (options_.progress) options_.progress(counts_.done + counts_.failed, all_);
  }

  void fail_all(const std::vector<const Task*>& tasks, const std::string& why) {
    for (const Task* task : tasks) {
      Row row = row_of(*task);
      row.error = why;
      put(row);
    }
  }

  Store& store_;
  const RunnerOptions& options_;
  std::size_t all_;
  RunnerCounts counts_;
  std::mutex plan_, write_;
};

}  // namespace

std::string now() {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}",
                     fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())));
}

bool of_technique(std::string_view key) {
  return std::ranges::find(kOfTechnique, key) != kOfTechnique.end();
}

RunnerCounts run_tasks(const std::vector<Task>& tasks, Store& store, const RunnerOptions& options) {
  std::map<std::string, std::size_t> place;
  std::vector<std::vector<const Task*>> groups;  // in the order of their first point
  for (const Task& task : tasks) {
    const auto [at, added] = place.try_emplace(shared_signature(task), groups.size());
    if (added) groups.emplace_back();
    groups[at->second].push_back(&task);
  }
  Runner runner(store, options, tasks.size());
  tbb::task_arena arena(options.jobs > 0 ? static_cast<int>(options.jobs) : tbb::task_arena::automatic);
  try {
    for (const auto& group : groups) arena.execute([&] { runner.run_group(group); });
  } catch (const metrics::Cancelled&) {
    RunnerCounts counts = runner.counts();
    counts.interrupted = true;
    return counts;
  }
  return runner.counts();
}

}  // namespace gnomon::sweep
