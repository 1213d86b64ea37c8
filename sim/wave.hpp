// SPDX-License-Identifier: Apache-2.0
// Waveforms of a stretch of cycles, or of what led to the first difference.
#pragma once

#include <cstdint>
#include <filesystem>
#include <gnomon/golden/engine.hpp>
#include <optional>
#include <span>

#include "sim/compare.hpp"
#include "sim/rtl_engine.hpp"

namespace gnomon::sim {

/// What was written.
struct Wave {
  TraceWindow window;
  std::optional<CompareReport> report;  ///< of the search for the first difference
};

/// Runs `stream` and writes the cycles of `window`; the run ends after the last of them. Cycle n is at (n +
/// 10) * 10 ns in the file. `options.trace` is ignored. The file is complete also when Aborted is thrown.
Wave write_window(const golden::HardwareConfig& config, RtlOptions options, std::span<const Word> stream,
                  const TraceWindow& window, ModelCache& cache);

/// How many cycles to show on each side of the word that differs.
struct Surroundings {
  std::uint64_t before = 200;
  std::uint64_t after = 50;
};

/// Compares with `reference` (in reset state), and writes the cycles around the first difference; where a
/// word is missing or the hardware hangs, around the cycle at which that was noticed. No file if all words
/// are equal: Wave::report says so.
Wave write_first_difference(golden::Engine& reference, RtlOptions options, std::span<const Word> stream,
                            const std::filesystem::path& file, const Surroundings& surroundings,
                            ModelCache& cache);

}  // namespace gnomon::sim
