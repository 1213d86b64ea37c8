// SPDX-License-Identifier: Apache-2.0
// Progress of a loop on several threads, and its early end.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <mutex>

namespace gnomon::metrics {

/// Thrown out of a computation whose `cancelled` callback returned true.
struct Cancelled {};

/// Counts finished steps; reports each hundredth of the whole once, one call at a time.
class Progress {
 public:
  Progress(std::size_t steps, const std::function<void(double)>& report,
           const std::function<bool()>& cancelled)
      : steps_(steps), report_(report), cancelled_(cancelled) {}

  /// Throws Cancelled if the work is to end. Thread-safe.
  void step() {
    if (cancelled_ && cancelled_()) throw Cancelled{};
    const std::size_t done = ++done_;
    if (!report_) return;
    const std::scoped_lock lock(mutex_);
    if (done * 100 / steps_ <= percent_) return;
    percent_ = done * 100 / steps_;
    report_(static_cast<double>(done) / static_cast<double>(steps_));
  }

 private:
  std::size_t steps_;
  const std::function<void(double)>& report_;
  const std::function<bool()>& cancelled_;
  std::atomic<std::size_t> done_{0};
  std::mutex mutex_;
  std::size_t percent_ = 0;
};

}  // namespace gnomon::metrics
