// SPDX-License-Identifier: Apache-2.0
// Runs command words through a Verilated gnomon_core, holding its ports back at random.
#pragma once

#include <cstdint>
#include <gnomon/golden/engine.hpp>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/rtl/clocked_model.hpp"

namespace gnomon::rtl_test {

using golden::Word;

/// Chance in 256 that a port is open in a cycle.
struct Stalls {
  unsigned command_open = 256;
  unsigned result_open = 256;
};

template <class Model>
class StreamBench {
 public:
  /// `plusarg`: a seeded fault of a build that holds several, without its plus.
  explicit StreamBench(std::uint32_t seed, const std::string& plusarg = {})
      : model_(seed, plusarg), ports_(seed) {
    reset();
  }

  void reset() {
    model_->cmd_valid_i = 0;
    model_->res_ready_i = 0;
    model_.reset();
    cycles_ = 0;
  }

  /// All results of `words`, once nothing is under way. Throws if nothing moves for a million cycles.
  std::vector<Word> run(std::span<const Word> words, Stalls stalls = {}) {
    std::vector<Word> results;
    step(words, stalls, results, UINT64_MAX);
    return results;
  }

  /// At most `cycles` cycles of the same, then a reset in the middle of whatever goes on.
  void run_then_reset(std::span<const Word> words, Stalls stalls, std::uint64_t cycles) {
    std::vector<Word> results;
    step(words, stalls, results, cycles);
    reset();
  }

  std::uint64_t counter(unsigned index) {
    model_->counter_index_i = static_cast<CData>(index);
    model_->eval();
    return model_->counter_value_o;
  }

  std::uint64_t cycles() const { return cycles_; }  ///< since reset

 private:
  static constexpr std::uint64_t kHangCycles = 3'000'000;  // the largest plane is scrubbed in a third of it

  void step(std::span<const Word> words, Stalls stalls, std::vector<Word>& results, std::uint64_t limit) {
    std::size_t taken = 0;
    bool offering = false;
    std::uint64_t quiet = 0;
    for (std::uint64_t passed = 0; passed < limit; ++passed) {
      offering = taken < words.size() && (offering || ports_.open(stalls.command_open));
      model_->cmd_valid_i = offering;
      if (offering) model_->cmd_data_i = words[taken];
      model_->res_ready_i = ports_.open(stalls.result_open);
      model_.settle();
      if (taken == words.size() && model_->idle_o) return;
      ++quiet;
      if (offering && model_->cmd_ready_o) {
        ++taken;
        offering = false;
        quiet = 0;
      }
      if (model_->res_valid_o && model_->res_ready_i) {
        results.push_back(model_->res_data_o);
        quiet = 0;
      }
      if (quiet > kHangCycles) throw std::runtime_error("the hardware hangs");
      model_.rise();
      ++cycles_;
    }
  }

  ClockedModel<Model> model_;
  RandomPorts ports_;
  std::uint64_t cycles_ = 0;
};

}  // namespace gnomon::rtl_test
