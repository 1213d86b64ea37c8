// SPDX-License-Identifier: Apache-2.0
// A command stream on the golden model, and on the rtl engine checked against it.
#pragma once

#include <functional>
#include <gnomon/golden/engine.hpp>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/pipeline/run.hpp"
#include "host/report/run_record.hpp"

namespace gnomon::pipeline {

/// Golden, with the cycles that it predicts, where it can: of gnomon_top within the system where that runs,
/// or where golden runs and a memory was asked for; else of the units alone. `words`: of the stream.
std::unique_ptr<golden::Engine> make_predicting_engine(const RunRequest& request,
                                                       const golden::HardwareConfig& config,
                                                       std::size_t words);

/// What an engine did in a part of a stream.
struct PartAnswers {
  std::map<std::string, std::uint64_t> events;  ///< counted meanwhile
  std::uint64_t plane_entries_hit = 0;          ///< not empty after the part
};

/// All that an engine gave for a stream.
struct EngineAnswers {
  std::vector<golden::Word> results;
  golden::Counters counters;
  std::vector<PartAnswers> parts;
};

/// Runs `stream` from reset; `ends` are the ends of its parts, ascending, the last being the stream's.
/// `progress` takes 0..1 and may throw to end the run.
EngineAnswers run_stream(golden::Engine& engine, std::span<const golden::Word> stream,
                         std::span<const std::size_t> ends, const std::function<void(double)>& progress);

/// The rtl or system engine that a request asks for, but for request.make_rtl. Throws as
/// sim::make_rtl_engine.
std::unique_ptr<sim::RtlEngine> make_engine_under_test(const RunRequest& request,
                                                       const golden::HardwareConfig& config,
                                                       const sim::RtlOptions& options);

/// What the engine under test did, compared with what golden gave.
struct RtlAnswers {
  report::CompareRecord compare;
  std::vector<report::PassCycles> cycles;      ///< empty where the engine has none
  std::optional<report::SystemRecord> system;  ///< of the system engine
};

/// Runs `stream` on `rtl` from reset; every word is compared with `expected` while it comes. `reproduce` is
/// the command line that ends the text about a failure. Throws sim::Aborted and sim::CycleLimit unless what
/// was compared till then is asked for.
RtlAnswers run_compared(sim::RtlEngine& rtl, std::span<const golden::Word> stream,
                        const EngineAnswers& expected, std::uint32_t seed, const std::string& reproduce,
                        bool keep_partial = false);

}  // namespace gnomon::pipeline
