// SPDX-License-Identifier: Apache-2.0
// A drain is a job.
#include "sim/system/system_engine.hpp"

#include <array>
#include <stdexcept>
#include <string>
#include <utility>

#include "sim/registers/registers.hpp"

namespace gnomon::sim::system {

SystemEngine::SystemEngine(const SystemConfig& config, std::unique_ptr<golden::Engine> inner,
                           std::span<const std::uint8_t> firmware, EngineClock clock)
    : inner_(std::move(inner)), system_(config, *inner_, firmware, std::move(clock)) {}

void SystemEngine::submit(std::span<const golden::Word> words) {
  waiting_.insert(waiting_.end(), words.begin(), words.end());
}

void SystemEngine::drain(const golden::ResultSink& sink) {
  if (waiting_.empty()) return;
  std::array<Job, 1> jobs;
  jobs[0].commands = std::exchange(waiting_, {});
  const JobReport report = system_.run(jobs).at(0);
  if (report.outcome != registers::mailbox::kOutcomeIsDone)
    throw std::runtime_error("the job has failed with ERROR_STATUS " + std::to_string(report.error));
  if (!report.results.empty()) sink(report.results);
}

void SystemEngine::reset() {
  waiting_.clear();
  inner_->reset();
}

}  // namespace gnomon::sim::system
