// SPDX-License-Identifier: Apache-2.0
// Runs command words through a Verilated gnomon_core whose planes lie in a LineMemory.
#pragma once

#include <cstdint>
#include <gnomon/golden/engine.hpp>
#include <span>
#include <stdexcept>
#include <vector>

#include "line_memory.hpp"
#include "tests/rtl/clocked_model.hpp"

namespace gnomon::rtl_test {

using golden::Word;

template <class Model>
class CoreCacheBench {
 public:
  explicit CoreCacheBench(const LineTiming& timing, std::uint32_t seed = 1)
      : memory_(timing, seed), model_(seed) {
    model_->plane_base_i = 0x81234;
    reset();
  }

  void reset() {
    model_->cmd_valid_i = 0;
    model_->res_ready_i = 1;
    model_.reset();
    memory_.reset();
    cycles_ = 0;
  }

  /// All results of `words`, once nothing is under way. Throws if nothing moves for a million cycles.
  std::vector<Word> run(std::span<const Word> words) {
    std::vector<Word> results;
    step(words, results, UINT64_MAX);
    return results;
  }
  /// At most `cycles` cycles of the same, then a reset in the middle of whatever goes on.
  void run_then_reset(std::span<const Word> words, std::uint64_t cycles) {
    std::vector<Word> results;
    step(words, results, cycles);
    reset();
  }

  /// So many cycles without a word: lines may still be on their way to memory when nothing else is under way.
  void rest(unsigned cycles) {
    model_->cmd_valid_i = 0;
    for (unsigned i = 0; i < cycles; ++i) {
      memory_.drive(*model_);
      model_.settle();
      memory_.clock(*model_);
      model_.rise();
      ++cycles_;
    }
  }

  std::uint64_t counter(unsigned index) {
    model_->counter_index_i = static_cast<CData>(index);
    model_->eval();
    return model_->counter_value_o;
  }
  std::uint64_t cycles() const { return cycles_; }  ///< since reset
  const LineMemory& memory() const { return memory_; }

 private:
  static constexpr std::uint64_t kHangCycles = 1'000'000;

  void step(std::span<const Word> words, std::vector<Word>& results, std::uint64_t limit) {
    std::size_t taken = 0;
    std::uint64_t quiet = 0;
    for (std::uint64_t passed = 0; passed < limit; ++passed) {
      model_->cmd_valid_i = taken < words.size();
      if (taken < words.size()) model_->cmd_data_i = words[taken];
      memory_.drive(*model_);
      model_.settle();
      if (taken == words.size() && model_->idle_o) return;
      ++quiet;
      if (model_->cmd_valid_i && model_->cmd_ready_o) {
        ++taken;
        quiet = 0;
      }
      if (model_->res_valid_o) {
        results.push_back(model_->res_data_o);
        quiet = 0;
      }
      if (quiet > kHangCycles) throw std::runtime_error("the hardware hangs");
      memory_.clock(*model_);
      model_.rise();
      ++cycles_;
    }
  }

  LineMemory memory_;
  ClockedModel<Model> model_;
  std::uint64_t cycles_ = 0;
};

}  // namespace gnomon::rtl_test
