// SPDX-License-Identifier: Apache-2.0
// What every stage of a run needs: its name shown, its time taken, an end if the user wants one.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/metrics/progress.hpp"
#include "host/pipeline/run.hpp"
#include "host/pipeline/stage_clock.hpp"

namespace gnomon::pipeline {

class Stages {
 public:
  /// `request` must outlive it.
  Stages(const RunRequest& request, std::vector<report::StageTime> earlier)
      : request_(request), clock_(std::move(earlier)) {}

  /// The user wants an end.
  bool requested() const { return request_.abort != nullptr && request_.abort->load(); }
  /// And there is not only the report left to be written.
  bool aborted() const { return !finishing_ && requested(); }
  void finish() { finishing_ = true; }
  /// To be called from within stages as often as one likes; throws metrics::Cancelled if the run is to end.
  void progress(std::string_view stage, double done) const {
    if (aborted()) throw metrics::Cancelled();
    if (request_.progress) request_.progress(stage, done);
  }
  std::function<void(double)> progress_of(std::string_view stage) const {
    return [this, stage](double done) { progress(stage, done); };
  }
  std::function<bool()> cancelled() const {
    return [this] { return aborted(); };
  }
  /// What `work` returns, timed, its name shown from the start.
  template <class Work>
  auto run(std::string_view name, Work&& work) {
    progress(name, 0);
    return clock_.run(std::string(name), std::forward<Work>(work));
  }
  const std::vector<report::StageTime>& times() const { return clock_.stages(); }

 private:
  const RunRequest& request_;
  StageClock clock_;
  bool finishing_ = false;
};

}  // namespace gnomon::pipeline
