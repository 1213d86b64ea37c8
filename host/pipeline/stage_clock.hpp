// SPDX-License-Identifier: Apache-2.0
// What each stage of a run takes, by the wall and by the processor.
#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "host/report/run_record.hpp"

namespace gnomon::pipeline {

/// Seconds of CPU time that this process has used in user mode, on all threads.
double user_cpu_seconds();
/// Largest resident set of this process so far, in bytes.
std::uint64_t peak_memory_bytes();

class StageClock {
 public:
  explicit StageClock(std::vector<report::StageTime> earlier) : stages_(std::move(earlier)) {}

  /// Runs `work` as the stage `name` and passes on what it returns or throws.
  template <class Work>
  auto run(std::string name, Work&& work) {
    const Stopwatch watch(*this, std::move(name));
    return std::forward<Work>(work)();
  }

  const std::vector<report::StageTime>& stages() const { return stages_; }

 private:
  class Stopwatch {
   public:
    Stopwatch(StageClock& clock, std::string name);
    ~Stopwatch();
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

   private:
    StageClock& clock_;
    std::string name_;
    std::chrono::steady_clock::time_point start_;
    double user_start_;
  };

  std::vector<report::StageTime> stages_;
};

}  // namespace gnomon::pipeline
