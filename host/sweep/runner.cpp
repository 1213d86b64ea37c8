// SPDX-License-Identifier: Apache-2.0
// The points of a sweep, measured and confirmed.
#include "host/sweep/runner.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "host/metrics/progress.hpp"
#include "host/sweep/confirm.hpp"
#include "sim/rtl_engine.hpp"

namespace gnomon::sweep {
namespace {

/// Takes tasks, many at a time within a group, and counts what became of them.
class Runner {
 public:
  /// What a task on its scene comes to: true if it counts as done. One that the scene could not be made for
  /// has the reason instead.
  using Work = std::function<bool(const Task&, SharedScene&)>;
  using Refused = std::function<void(const Task&, const std::string& why)>;

  Runner(const RunnerOptions& options, std::size_t all, Work work, Refused refused)
      : options_(options), all_(all), work_(std::move(work)), refused_(std::move(refused)) {}

  RunnerCounts run(const std::vector<Task>& tasks) {
    tbb::task_arena arena(options_.jobs > 0 ? static_cast<int>(options_.jobs) : tbb::task_arena::automatic);
    try {
      for (const auto& group : groups_of(tasks)) arena.execute([&] { run_group(group); });
    } catch (const metrics::Cancelled&) {
      counts_.interrupted = true;
    }
    return counts_;
  }

 private:
  void run_group(const std::vector<const Task*>& tasks) {
    ++counts_.scenes;
    auto scene = SharedScene::make(*tasks.front(), options_.task);
    tbb::parallel_for(std::size_t{0}, tasks.size(), [&](std::size_t i) {
      // Nobody takes up a second point while the first waits for its own parts.
      tbb::this_task_arena::isolate([&] {
        if (aborted()) throw metrics::Cancelled();
        if (!scene) refused_(*tasks[i], scene.error().message);
        count(scene && work(*tasks[i], **scene));
      });
    });
  }

  bool aborted() const { return options_.task.abort != nullptr && options_.task.abort->load(); }

  bool work(const Task& task, SharedScene& scene) const try {
    return work_(task, scene);
  } catch (const sim::Aborted&) {
    throw metrics::Cancelled();
  }

  void count(bool done) {
    const std::scoped_lock lock(count_);
    ++(done ? counts_.done : counts_.failed);
    if (options_.progress) options_.progress(counts_.done + counts_.failed, all_);
  }

  const RunnerOptions& options_;
  std::size_t all_;
  Work work_;
  Refused refused_;
  RunnerCounts counts_;
  std::mutex count_;
};

}  // namespace

RunnerCounts run_tasks(const std::vector<Task>& tasks, Store& store, const RunnerOptions& options) {
  std::mutex write;
  std::size_t flagged = 0;
  const auto put = [&](const Row& row, bool flag = false) {
    const std::scoped_lock lock(write);
    store.put(row);
    flagged += flag ? 1 : 0;
  };
  const auto refuse = [&](const Task& task, const std::string& why) {
    Row row = row_of(task);
    row.error = why;
    put(row);
  };
  const auto measure = [&](const Task& task, SharedScene& scene) {
    auto measured = scene.measure(task);
    if (!measured) {
      refuse(task, measured.error().message);
      return false;
    }
    const bool flag = is_flagged(*measured);
    Row row = row_of(task);
    row.figures = std::move(measured->figures);
    row.labels = std::move(measured->labels);
    put(row, flag);
    return true;
  };
  RunnerCounts counts = Runner(options, tasks.size(), measure, refuse).run(tasks);
  counts.flagged = flagged;
  return counts;
}

RunnerCounts confirm_tasks(const std::vector<Task>& tasks, Store& store, const RunnerOptions& options) {
  std::mutex write;
  const auto amend = [&](const Task& task, const Measurement& more) {
    const std::scoped_lock lock(write);
    store.amend(task.key, more.figures, more.labels);
  };
  const auto refuse = [&](const Task& task, const std::string& why) {
    amend(task, {{}, {{std::string(kConfirmLabel), "not run: " + why}}});
  };
  const auto confirm = [&](const Task& task, SharedScene& scene) {
    auto measured = scene.confirm(task);
    if (!measured) {
      refuse(task, measured.error().message);
      return false;
    }
    amend(task, *measured);
    return !is_flagged(*measured);
  };
  return Runner(options, tasks.size(), confirm, refuse).run(tasks);
}

}  // namespace gnomon::sweep
