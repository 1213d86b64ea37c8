// SPDX-License-Identifier: Apache-2.0
// Waveforms of a stretch of cycles, or of what led to the first difference.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <gnomon/golden/engine.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "sim/compare.hpp"
#include "sim/rtl_engine.hpp"

namespace gnomon::sim {

/// What was written.
struct Wave {
  TraceWindow window;
  std::optional<CompareReport> report;  ///< of the search for the first difference
};

/// Makes the engine whose waveform is wanted.
using TracedEngine = std::function<std::unique_ptr<RtlEngine>(const RtlOptions&)>;

/// Runs `stream` and writes the cycles of `window`; the run ends after the last of them. Cycle n is at (n +
/// 10) * 10 ns in the file. `options.trace` is ignored. The file is complete also when Aborted is thrown.
Wave write_window(const golden::HardwareConfig& config, RtlOptions options, std::span<const Word> stream,
                  const TraceWindow& window, ModelCache& cache);

/// The same of whatever engine.
Wave write_window(const TracedEngine& make, RtlOptions options, std::span<const Word> stream,
                  const TraceWindow& window);

/// Where the first command of that name (as in docs/command-stream.md, in any case) begins in the stream;
/// nothing if there is none.
std::optional<std::size_t> find_command(std::span<const Word> stream, std::string_view name);

/// The cycle at which the rtl engine takes the header word `at` of the stream; without a waveform.
std::uint64_t cycle_of_header(const golden::HardwareConfig& config, RtlOptions options,
                              std::span<const Word> stream, std::size_t at, ModelCache& cache);

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
