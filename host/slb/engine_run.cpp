// SPDX-License-Identifier: Apache-2.0
// A command stream on golden, or on the hardware checked against golden.
#include "host/slb/engine_run.hpp"

#include <algorithm>
#include <chrono>
#include <gnomon/golden/golden_engine.hpp>

namespace gnomon::slb {
namespace {

constexpr std::size_t kChunkWords = 1U << 16;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

EngineRun run_golden(const golden::HardwareConfig& config, std::span<const golden::Word> stream,
                     const std::function<void(double)>& progress) {
  const auto start = std::chrono::steady_clock::now();
  const auto engine = golden::make_golden_engine(config);
  EngineRun run;
  for (std::size_t at = 0; at < stream.size(); at += kChunkWords) {
    engine->submit(stream.subspan(at, std::min(kChunkWords, stream.size() - at)));
    engine->drain([&](std::span<const golden::Word> words) {
      run.results.insert(run.results.end(), words.begin(), words.end());
    });
    progress(static_cast<double>(at) / static_cast<double>(stream.size()));
  }
  run.counters.events = engine->counters().events;
  run.golden_seconds = seconds_since(start);
  return run;
}

EngineRun run_rtl(const golden::HardwareConfig& config, std::span<const golden::Word> stream,
                  const std::function<void(double)>& progress, const sim::RtlOptions& options,
                  sim::ModelCache& cache) {
  EngineRun run = run_golden(config, stream, [](double) {});
  sim::RtlOptions with_progress = options;
  with_progress.progress = [&](const sim::Progress& p) {
    progress(static_cast<double>(p.words) / static_cast<double>(stream.size()));
  };
  const auto rtl = sim::make_rtl_engine(config, with_progress, cache);
  const auto start = std::chrono::steady_clock::now();
  const auto reference = golden::make_golden_engine(config);
  run.compare = sim::compare(*reference, *rtl, stream, {}, options.seed);
  run.counters.cycles = run.compare->rtl_counters.cycles;
  run.rtl_seconds = seconds_since(start);
  return run;
}

}  // namespace gnomon::slb
