// SPDX-License-Identifier: Apache-2.0
// A scene that many points are measured on: what they share is made once. Theory: docs/sweep.md, "Shared
// work".
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>

#include "host/base/result.hpp"
#include "host/pipeline/lit_scene.hpp"
#include "host/pipeline/slb_shared.hpp"
#include "host/sweep/confirm.hpp"
#include "host/sweep/measurement.hpp"
#include "host/sweep/task.hpp"

namespace gnomon::sweep {

/// How a task becomes a run.
struct TaskOptions {
  pipeline::EngineKind engine = pipeline::EngineKind::Golden;
  std::function<Result<scene::Scene>(const std::filesystem::path&, const config::Settings&)> load;
  std::function<pipeline::RunSettings(const config::Settings&)> settings;
  pipeline::RtlFactory make_rtl;             ///< another engine than the usual one, for tests; may be empty
  const std::atomic<bool>* abort = nullptr;  ///< not owned
};

/// Tasks given to it are of one group (groups_of). Thread-safe.
class SharedScene {
 public:
  /// Surfaces, voxels, views, exact shadows. `options` must outlive it. Errors are the user's to cure;
  /// metrics::Cancelled is thrown where `options.abort` is set meanwhile.
  static Result<std::unique_ptr<SharedScene>> make(const Task& first, const TaskOptions& options);

  /// The figures of one point; of the engines other than golden those of a run, which has failed where words
  /// differ.
  Result<Measurement> measure(const Task& task);
  /// The same point on the rtl engine: its cycles, and how its words compare with golden's. A comparison that
  /// failed is in the figures.
  Result<Measurement> confirm(const Task& task);

 private:
  SharedScene(const TaskOptions& options) : options_(options), stages_(shared_, {}) {}
  pipeline::RunRequest request_of(const Task& task, pipeline::EngineKind engine) const;
  bool takes_short_way(const pipeline::RunRequest& request) const;
  Result<pipeline::SlbShared*> slb();
  Result<Measurement> by_shared_work(const pipeline::RunRequest& request);
  Result<Measurement> by_run(const pipeline::RunRequest& request);
  Cycles cycles_of_work(const report::RunRecord& record) const;
  Result<report::RunRecord> run(const pipeline::RunRequest& request);

  const TaskOptions& options_;
  pipeline::RunRequest shared_;
  pipeline::Stages stages_;
  pipeline::LitScene lit_;
  std::mutex plan_, slb_mutex_;
  std::unique_ptr<pipeline::SlbShared> slb_;
};

}  // namespace gnomon::sweep
