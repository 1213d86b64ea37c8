// SPDX-License-Identifier: Apache-2.0
// Measures the points of a sweep, with what they share made once. Theory: docs/sweep.md.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/pipeline/run.hpp"
#include "host/sweep/points.hpp"
#include "host/sweep/store.hpp"

namespace gnomon::sweep {

/// A point that is to be measured.
struct Task {
  Point point;
  std::string key;
  std::filesystem::path scene;
};

struct RunnerOptions {
  unsigned jobs = 0;  ///< points at a time; 0: one a core
  pipeline::EngineKind engine = pipeline::EngineKind::Golden;
  std::function<Result<scene::Scene>(const std::filesystem::path&, const config::Settings&)> load;
  std::function<pipeline::RunSettings(const config::Settings&)> settings;
  std::function<void(std::size_t done, std::size_t all)> progress;  ///< may be empty; one thread at a time
  const std::atomic<bool>* abort = nullptr;                         ///< not owned
};

struct RunnerCounts {
  std::size_t done = 0, failed = 0;
  std::size_t scenes = 0;  ///< how often surfaces, voxels and exact shadows were made
  bool interrupted = false;
};

/// Every task becomes a row, done or failed, as soon as it is measured. Points that differ in their
/// technique's parameters alone share surfaces, voxels and exact shadows.
RunnerCounts run_tasks(const std::vector<Task>& tasks, Store& store, const RunnerOptions& options);

/// UTC, ISO 8601.
std::string now();

/// True for parameters that a technique alone looks at: what is not shared between points.
bool of_technique(std::string_view key);

}  // namespace gnomon::sweep
