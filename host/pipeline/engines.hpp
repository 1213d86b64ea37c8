// SPDX-License-Identifier: Apache-2.0
// A command stream on the golden model, and on the rtl engine checked against it.
#pragma once

#include <gnomon/golden/engine.hpp>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "host/pipeline/run.hpp"
#include "host/report/run_record.hpp"

namespace gnomon::pipeline {

/// All that an engine gave for a stream.
struct EngineAnswers {
  std::vector<golden::Word> results;
  golden::Counters counters;
  std::uint64_t plane_entries_hit = 0;  ///< not empty after the stream
};

/// Runs `stream` from reset. `progress` takes 0..1 and may throw to end the run.
EngineAnswers run_stream(golden::Engine& engine, std::span<const golden::Word> stream,
                         const std::function<void(double)>& progress);

/// What the rtl engine did, compared with what golden gave.
struct RtlAnswers {
  report::CompareRecord compare;
  std::vector<report::PassCycles> cycles;
};

/// Runs `stream` on `rtl` from reset; every word is compared with `expected` while it comes. `reproduce` is
/// the command line that ends the text about a failure.
RtlAnswers run_compared(sim::RtlEngine& rtl, std::span<const golden::Word> stream,
                        const EngineAnswers& expected, std::uint32_t seed, const std::string& reproduce);

}  // namespace gnomon::pipeline
