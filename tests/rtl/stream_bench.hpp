// SPDX-License-Identifier: Apache-2.0
// Runs command words through a Verilated gnomon_core, holding its ports back at random.
#pragma once

#include <verilated.h>

#include <array>
#include <cstdint>
#include <gnomon/golden/engine.hpp>
#include <memory>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

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
  explicit StreamBench(std::uint32_t seed, const std::string& plusarg = {}) : random_(seed) {
    const std::string argument = "+" + plusarg;
    std::array<const char*, 2> arguments{"bench", argument.c_str()};
    context_.commandArgs(2, arguments.data());
    context_.randReset(2);  // registers and memories start with random contents
    context_.randSeed(static_cast<int>(seed | 1u));
    model_ = std::make_unique<Model>(&context_);
    reset();
  }
  ~StreamBench() { model_->final(); }
  StreamBench(const StreamBench&) = delete;
  StreamBench& operator=(const StreamBench&) = delete;

  void reset() {
    model_->cmd_valid_i = 0;
    model_->res_ready_i = 0;
    model_->rst_ni = 0;
    for (int i = 0; i < 3; ++i) clock();
    model_->rst_ni = 1;
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
      offering = taken < words.size() && (offering || open(stalls.command_open));
      model_->cmd_valid_i = offering;
      if (offering) model_->cmd_data_i = words[taken];
      model_->res_ready_i = open(stalls.result_open);
      model_->clk_i = 0;
      model_->eval();
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
      clock();
      ++cycles_;
    }
  }

  bool open(unsigned chance) { return chance >= 256 || (random_() & 255u) < chance; }

  void clock() {
    model_->clk_i = 0;
    model_->eval();
    model_->clk_i = 1;
    model_->eval();
  }

  VerilatedContext context_;
  std::unique_ptr<Model> model_;
  std::mt19937 random_;
  std::uint64_t cycles_ = 0;
};

}  // namespace gnomon::rtl_test
