// SPDX-License-Identifier: Apache-2.0
// Jobs for gnomon_top with what golden says to them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <gnomon/golden/golden_engine.hpp>
#include <memory>
#include <vector>

#include "tests/support/stimulus.hpp"
#include "top_bench.hpp"

namespace gnomon::rtl_test {

/// Of the builds under test (CMakeLists.txt); those with a cache have a plane that does not fit it.
inline constexpr golden::HardwareConfig kSmall{.plane_log2 = 5};
inline constexpr golden::HardwareConfig kCached{.plane_log2 = 7};

/// Commands, and results of a golden engine that lives from reset to reset as the hardware does.
class Reference {
 public:
  explicit Reference(const golden::HardwareConfig& config) : config_(config) { reset(); }
  void reset() { engine_ = golden::make_golden_engine(config_); }
  std::vector<Word> run(const std::vector<Word>& words) {
    std::vector<Word> results;
    engine_->submit(words);
    engine_->drain(
        [&](std::span<const Word> some) { results.insert(results.end(), some.begin(), some.end()); });
    return results;
  }
  golden::Counters counters() const { return engine_->counters(); }

 private:
  golden::HardwareConfig config_;
  std::unique_ptr<golden::Engine> engine_;
};

inline std::vector<Word> random_job(const golden::HardwareConfig& config, std::uint64_t seed, int commands) {
  return stimulus::random_stream(config, {.seed = seed, .commands = commands, .max_items = 40});
}

inline std::uint32_t error_words(const std::vector<Word>& results) {
  return static_cast<std::uint32_t>(
      std::count_if(results.begin(), results.end(), [](Word word) { return word >> 56 == 0xFF; }));
}

}  // namespace gnomon::rtl_test
