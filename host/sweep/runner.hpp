// SPDX-License-Identifier: Apache-2.0
// Measures the points of a sweep, group by group, and confirms some of them. Theory: docs/sweep.md.
#pragma once

#include <functional>
#include <vector>

#include "host/sweep/shared_scene.hpp"
#include "host/sweep/store.hpp"
#include "host/sweep/task.hpp"

namespace gnomon::sweep {

struct RunnerOptions {
  unsigned jobs = 0;  ///< points at a time; 0: one a core
  TaskOptions task;
  std::function<void(std::size_t done, std::size_t all)> progress;  ///< may be empty; one thread at a time
};

struct RunnerCounts {
  std::size_t done = 0, failed = 0;
  std::size_t flagged = 0;  ///< of those done: model and hardware disagree (confirm.hpp)
  std::size_t scenes = 0;   ///< how often surfaces, voxels and exact shadows were made
  bool interrupted = false;
};

/// Every task becomes a row, done or failed, as soon as it is measured.
RunnerCounts run_tasks(const std::vector<Task>& tasks, Store& store, const RunnerOptions& options);

/// Runs points that the store holds on the rtl engine too, and adds what came out to their rows. Counted as
/// failed: points that could not be run, and those that are flagged (confirm.hpp).
RunnerCounts confirm_tasks(const std::vector<Task>& tasks, Store& store, const RunnerOptions& options);

}  // namespace gnomon::sweep
