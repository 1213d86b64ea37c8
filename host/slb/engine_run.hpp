// SPDX-License-Identifier: Apache-2.0
// A command stream on golden, or on the hardware checked against golden.
#pragma once

#include <functional>
#include <gnomon/golden/engine.hpp>
#include <optional>
#include <span>
#include <vector>

#include "sim/compare.hpp"

namespace gnomon::slb {

/// What a stream came to.
struct EngineRun {
  std::vector<golden::Word> results;  ///< golden's; the hardware's, too, unless `compare` says otherwise
  golden::Counters counters;          ///< events of golden; cycles of the hardware, if it ran
  std::optional<sim::CompareReport> compare;  ///< of the hardware with golden, if it ran
  double golden_seconds = 0, rtl_seconds = 0;

  /// Every comparison holds.
  bool passed() const { return !compare || compare->passed(); }
};

/// Runs a stream from reset on an engine built for the configuration.
using Runner = std::function<EngineRun(const golden::HardwareConfig&, std::span<const golden::Word>)>;

/// `progress` takes 0..1 and may throw to end the run.
EngineRun run_golden(const golden::HardwareConfig& config, std::span<const golden::Word> stream,
                     const std::function<void(double)>& progress);
/// The same and then the hardware, compared word by word while it runs. Throws as sim::make_rtl_engine.
EngineRun run_rtl(const golden::HardwareConfig& config, std::span<const golden::Word> stream,
                  const std::function<void(double)>& progress, const sim::RtlOptions& options,
                  sim::ModelCache& cache);

}  // namespace gnomon::slb
