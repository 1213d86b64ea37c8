// SPDX-License-Identifier: Apache-2.0
// A command stream on the golden model, and on the rtl engine checked against it.
#include "host/pipeline/engines.hpp"

#include <algorithm>
#include <gnomon/golden/cycles.hpp>
#include <gnomon/golden/golden_engine.hpp>
#include <stdexcept>
#include <string_view>

#include "host/pipeline/cycle_timing.hpp"
#include "sim/compare.hpp"
#include "sim/counter_names.hpp"

namespace gnomon::pipeline {
namespace {

constexpr std::size_t kChunkWords = std::size_t{1} << 16;  // a millisecond or so of golden

/// Gives answers that are known already: golden is timed alone and runs once.
class KnownAnswers final : public golden::Engine {
 public:
  KnownAnswers(const golden::HardwareConfig& config, const EngineAnswers& answers)
      : config_(config), answers_(answers) {}

  std::string_view name() const override { return "golden"; }
  const golden::HardwareConfig& config() const override { return config_; }
  void submit(std::span<const golden::Word>) override {}
  void drain(const golden::ResultSink& sink) override {
    if (!given_ && !answers_.results.empty()) sink(answers_.results);
    given_ = true;
  }
  golden::Counters counters() const override { return answers_.counters; }
  void reset() override { given_ = false; }
  std::vector<std::uint32_t> read_plane() override {
    throw std::logic_error("answers are known, the plane is not");
  }

 private:
  golden::HardwareConfig config_;
  const EngineAnswers& answers_;
  bool given_ = false;
};

/// "cycles.PROJECT.BUSY" -> a table of passes in the order of docs/command-stream.md.
std::vector<report::PassCycles> by_pass(const std::map<std::string, std::uint64_t>& cycles) {
  std::vector<report::PassCycles> passes;
  if (cycles.empty()) return passes;
  for (const std::string_view pass : sim::kPassNames) {
    report::PassCycles row{std::string(pass), {}};
    const std::string prefix = "cycles." + row.pass + ".";
    for (auto at = cycles.lower_bound(prefix); at != cycles.end() && at->first.starts_with(prefix); ++at) {
      row.causes[at->first.substr(prefix.size())] = at->second;
    }
    passes.push_back(std::move(row));
  }
  return passes;
}

std::uint64_t distance(std::uint64_t a, std::uint64_t b) {
  return a > b ? a - b : b - a;
}

report::CompareRecord compare_record(const sim::CompareReport& report, const std::string& reproduce) {
  report::CompareRecord record;
  record.compared = true;
  record.words = report.words_compared;
  record.differing = report.words_differing;
  record.partial = report.partial;
  const std::uint64_t missing =
      report.partial.empty() ? distance(report.expected_words, report.actual_words) : 0;
  record.other_faults = missing + report.counters.size() + (report.fault.empty() ? 0 : 1);
  if (!report.passed()) record.text = sim::to_text(report) + "reproduce with: " + reproduce + "\n";
  record.first = sim::to_json(report).value("first_difference", nlohmann::json());
  return record;
}

std::optional<report::SystemRecord> system_record(const sim::RtlEngine& engine) {
  const auto* const system = dynamic_cast<const sim::system::SystemEngine*>(&engine);
  if (system == nullptr) return std::nullopt;
  report::SystemRecord record;
  record.hardware = to_string(system->hardware());
  record.statistics = system->system().statistics();
  record.firmware_bytes = system->firmware_bytes();
  record.log = system->system().log();
  record.jobs = system->jobs();
  record.cache = system->cache_counters();
  return record;
}

std::map<std::string, std::uint64_t> since(std::map<std::string, std::uint64_t> now,
                                           const std::map<std::string, std::uint64_t>& before) {
  for (const auto& [name, count] : before) now[name] -= count;
  return now;
}

std::uint64_t entries_hit(golden::Engine& engine) {
  const std::vector<std::uint32_t> plane = engine.read_plane();
  return static_cast<std::uint64_t>(
      std::ranges::count_if(plane, [](std::uint32_t code) { return code != golden::kEmpty; }));
}

}  // namespace

std::unique_ptr<golden::Engine> make_predicting_engine(const RunRequest& request,
                                                       const golden::HardwareConfig& config,
                                                       std::size_t words) {
  const sim::system::SystemOptions& system = request.settings.system;
  const bool top = request.engine == EngineKind::System
                       ? system.hardware == sim::system::HardwareModel::Top
                       : request.engine == EngineKind::Golden && request.settings.memory_given;
  golden::HardwareTiming timing;
  if (top) {
    timing = cycle_timing(system);
    timing.system->job_words = words;
  }
  return golden::make_timed_golden_engine(config, timing);
}

EngineAnswers run_stream(golden::Engine& engine, std::span<const golden::Word> stream,
                         std::span<const std::size_t> ends, const std::function<void(double)>& progress) {
  EngineAnswers answers;
  const auto take = [&](std::span<const golden::Word> words) {
    answers.results.insert(answers.results.end(), words.begin(), words.end());
  };
  std::size_t at = 0;
  for (const std::size_t end : ends) {
    while (at < end) {
      const std::size_t words = std::min(kChunkWords, end - at);
      engine.submit(stream.subspan(at, words));
      engine.drain(take);
      progress(static_cast<double>(at) / static_cast<double>(stream.size()));
      at += words;
    }
    golden::Counters counters = engine.counters();
    answers.parts.push_back({since(counters.events, answers.counters.events), entries_hit(engine)});
    answers.counters = std::move(counters);
  }
  return answers;
}

std::string_view to_string(EngineKind engine) {
  switch (engine) {
    case EngineKind::Golden:
      return "golden";
    case EngineKind::Rtl:
      return "rtl";
    case EngineKind::System:
      return "system";
  }
  return "";
}

std::optional<EngineKind> engine_of(std::string_view word) {
  for (const EngineKind engine : {EngineKind::Golden, EngineKind::Rtl, EngineKind::System})
    if (to_string(engine) == word) return engine;
  return std::nullopt;
}

std::unique_ptr<sim::RtlEngine> make_engine_under_test(const RunRequest& request,
                                                       const golden::HardwareConfig& config,
                                                       const sim::RtlOptions& options) {
  if (request.engine != EngineKind::System) return sim::make_rtl_engine(config, options);
  sim::system::SystemOptions system = request.settings.system;
  system.rtl = options;
  auto engine = sim::system::make_system_engine(config, system);
  if (request.on_event) engine->set_event_log(request.on_event);
  return engine;
}

RtlAnswers run_compared(sim::RtlEngine& rtl, std::span<const golden::Word> stream,
                        const EngineAnswers& expected, std::uint32_t seed, const std::string& reproduce,
                        bool keep_partial) {
  KnownAnswers reference(rtl.config(), expected);
  sim::CompareOptions options;
  options.keep_partial = keep_partial;
  const sim::CompareReport report = sim::compare(reference, rtl, stream, options, seed);
  return {compare_record(report, reproduce), by_pass(report.rtl_counters.cycles), system_record(rtl)};
}

}  // namespace gnomon::pipeline
