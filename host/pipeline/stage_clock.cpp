// SPDX-License-Identifier: Apache-2.0
// What each stage of a run takes, by the wall and by the processor.
#include "host/pipeline/stage_clock.hpp"

#include <sys/resource.h>

namespace gnomon::pipeline {
namespace {

rusage usage() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return used;
}

}  // namespace

double user_cpu_seconds() {
  const timeval time = usage().ru_utime;
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

std::uint64_t peak_memory_bytes() {
  return static_cast<std::uint64_t>(usage().ru_maxrss) * 1024;
}

StageClock::Stopwatch::Stopwatch(StageClock& clock, std::string name)
    : clock_(clock),
      name_(std::move(name)),
      start_(std::chrono::steady_clock::now()),
      user_start_(user_cpu_seconds()) {}

StageClock::Stopwatch::~Stopwatch() {
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start_;
  clock_.stages_.push_back({std::move(name_), wall.count(), user_cpu_seconds() - user_start_});
}

}  // namespace gnomon::pipeline
