// SPDX-License-Identifier: Apache-2.0
// A drain is a job.
#include "sim/system/system_engine.hpp"

#include <array>
#include <gnomon/golden/golden_engine.hpp>
#include <stdexcept>
#include <string>
#include <utility>

#include "firmware/image.hpp"
#include "sim/counters.hpp"
#include "sim/plane_reading.hpp"
#include "sim/registers/registers.hpp"

namespace gnomon::sim::system {

namespace hw = registers::hardware;

std::string_view to_string(HardwareModel model) {
  switch (model) {
    case HardwareModel::Top:
      return "top";
    case HardwareModel::Core:
      return "core";
    case HardwareModel::Golden:
      return "golden";
  }
  return "";
}

SystemEngine::SystemEngine(const SystemConfig& config, std::unique_ptr<golden::Engine> inner,
                           std::span<const std::uint8_t> firmware, EngineClock clock)
    : system_config_(config),
      hardware_(inner->config()),
      firmware_(firmware.begin(), firmware.end()),
      inner_(std::move(inner)),
      clock_(std::move(clock)) {
  power_up();
}

SystemEngine::SystemEngine(const SystemConfig& config, const golden::HardwareConfig& hardware,
                           std::shared_ptr<const TopLibrary> library, RtlOptions rtl,
                           std::span<const std::uint8_t> firmware)
    : system_config_(config),
      hardware_(hardware),
      firmware_(firmware.begin(), firmware.end()),
      library_(std::move(library)),
      rtl_(std::move(rtl)) {
  power_up();
}

void SystemEngine::power_up() {
  system_.reset();
  if (inner_) {
    system_ = std::make_unique<System>(system_config_, *inner_, firmware_, clock_);
  } else {
    model_ = std::make_unique<TopModel>(library_, rtl_.seed);
    if (rtl_.trace) model_->open_trace(rtl_.trace->file, rtl_.trace->from, rtl_.trace->to);
    system_ = std::make_unique<System>(system_config_, *model_, hardware_, firmware_);
  }
  if (event_log_) system_->set_event_log(event_log_);
}

void SystemEngine::set_event_log(std::function<void(const std::string& line)> sink) {
  event_log_ = std::move(sink);
  system_->set_event_log(event_log_);
}

HardwareModel SystemEngine::hardware() const {
  return !inner_ ? HardwareModel::Top : clock_ ? HardwareModel::Core : HardwareModel::Golden;
}

void SystemEngine::submit(std::span<const Word> words) {
  waiting_.insert(waiting_.end(), words.begin(), words.end());
}

void SystemEngine::drain(const golden::ResultSink& sink) {
  drain_timed([&](std::span<const Word> words, std::span<const std::uint64_t>) { sink(words); });
}

JobReport SystemEngine::run(std::vector<Word> commands) {
  std::array<Job, 1> jobs;
  jobs[0].commands = std::move(commands);
  JobReport report;
  try {
    report = system_->run(jobs).at(0);
  } catch (const CycleLimit&) {
    throw;
  } catch (const Aborted&) {
    throw;
  } catch (const HangError&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw RtlFault(error.what());
  }
  if (report.outcome != registers::mailbox::kOutcomeIsDone)
    throw RtlFault("the job has failed with ERROR_STATUS " + std::to_string(report.error));
  return report;
}

void SystemEngine::drain_timed(const TimedSink& sink) {
  if (waiting_.empty()) return;
  failed_ = true;
  JobReport report = run(std::exchange(waiting_, {}));
  failed_ = false;
  const std::vector<Word> results = std::exchange(report.results, {});
  const std::vector<std::uint64_t> cycles = std::exchange(report.result_cycles, {});
  jobs_.push_back(std::move(report));
  if (!inner_) note_counters();
  if (!results.empty()) sink(results, cycles);
}

void SystemEngine::poll(const TimedSink& sink) {
  if (!std::exchange(failed_, false)) return;
  const JobReport report = system_->results_so_far();
  if (!inner_) note_counters();
  if (!report.results.empty()) sink(report.results, report.result_cycles);
}

golden::Counters SystemEngine::counters() const {
  if (!inner_) return counters_;
  golden::Counters counters = inner_->counters();
  if (!clock_) counters.cycles.clear();  // what golden predicts is no measurement
  return counters;
}

std::uint64_t SystemEngine::read_counter(std::uint32_t index) {
  const std::uint64_t low = system_->read_register(hw::kCounterLowOffset + index * hw::kCounterLowStride);
  const std::uint64_t high = system_->read_register(hw::kCounterHighOffset + index * hw::kCounterHighStride);
  return low | high << 32U;
}

golden::Counters SystemEngine::read_hardware_counters() {
  system_->write_register(hw::kSnapshotOffset, hw::kSnapshotTakeMask);
  golden::Counters now = read_counters(hardware_, [&](std::uint32_t index) { return read_counter(index); });
  return std::move(now) - hidden_;
}

void SystemEngine::note_counters() {
  counters_ = read_hardware_counters();
  if ((system_->read_register(hw::kFeaturesOffset) & hw::kFeaturesCacheMask) != 0)
    cache_counters_ = read_cache_counters([&](std::uint32_t index) { return read_counter(index); });
}

std::vector<std::uint32_t> SystemEngine::read_plane() {
  if (inner_) return inner_->read_plane();
  const golden::Counters before = read_hardware_counters();
  const JobReport report = run(plane_commands(hardware_));
  const golden::Counters read = read_hardware_counters() - before;
  for (const auto& [name, count] : read.events) hidden_.events[name] += count;
  for (const auto& [name, count] : read.cycles) hidden_.cycles[name] += count;
  return plane_of(hardware_, report.results);
}

void SystemEngine::reset() {
  waiting_.clear();
  jobs_.clear();
  failed_ = false;
  counters_ = hidden_ = {};
  cache_counters_.clear();
  if (inner_) inner_->reset();
  power_up();
}

std::uint64_t SystemEngine::sticky() const {
  std::uint64_t flags = 0;
  for (const JobReport& job : jobs_) flags |= job.flags;
  return flags;
}

void SystemEngine::write_coverage(const std::filesystem::path&) {
  throw std::logic_error("coverage is counted with the rtl engine");
}

std::unique_ptr<SystemEngine> make_system_engine(const golden::HardwareConfig& config,
                                                 const SystemOptions& options, ModelCache& cache) {
  SystemConfig system = options.system;
  system.abort = options.rtl.abort;
  system.max_cycles = options.rtl.max_cycles;
  system.progress = options.rtl.progress;
  if (options.hardware == HardwareModel::Golden)
    return std::make_unique<SystemEngine>(system, golden::make_golden_engine(config), firmware::image());
  RtlOptions inner = options.rtl;
  inner.max_cycles = UINT64_MAX;
  inner.progress = {};
  if (options.hardware == HardwareModel::Top) {
    if (const auto error = config.check()) throw std::invalid_argument(*error);
    ModelSpec spec = model_spec(config, inner);
    spec.cache_log2 = options.cache_log2;
    spec.line_ids_log2 = options.line_ids_log2;
    spec.axi_data_bits = options.axi_data_bits;
    return std::make_unique<SystemEngine>(system, config, cache.load_top(spec), inner, firmware::image());
  }
  auto rtl = make_rtl_engine(config, inner, cache);
  const RtlEngine* const clock = rtl.get();
  return std::make_unique<SystemEngine>(system, std::move(rtl), firmware::image(),
                                        [clock] { return clock->cycle(); });
}

std::unique_ptr<SystemEngine> make_system_engine(const golden::HardwareConfig& config,
                                                 const SystemOptions& options) {
  ModelCache cache;
  return make_system_engine(config, options, cache);
}

}  // namespace gnomon::sim::system
