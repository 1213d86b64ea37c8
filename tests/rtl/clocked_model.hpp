// SPDX-License-Identifier: Apache-2.0
// What every bench here has: a Verilated module, its clock and reset, ports held back at random.
#pragma once

#include <verilated.h>

#include <array>
#include <cstdint>
#include <memory>
#include <random>
#include <string>

namespace gnomon::rtl_test {

/// A Verilated module with `clk_i` and, for reset, `rst_ni`; used like a pointer to it.
template <class Model>
class ClockedModel {
 public:
  /// Registers and memories start with random contents. `plusarg`: a seeded fault of a build that holds
  /// several, without its plus.
  explicit ClockedModel(std::uint32_t seed, const std::string& plusarg = {}) {
    std::string argument = "+";
    argument += plusarg;
    std::array<const char*, 2> arguments{"bench", argument.c_str()};
    context_.commandArgs(plusarg.empty() ? 1 : 2, arguments.data());
    context_.randReset(2);
    context_.randSeed(static_cast<int>(seed | 1u));
    model_ = std::make_unique<Model>(&context_);
  }
  ~ClockedModel() { model_->final(); }
  ClockedModel(const ClockedModel&) = delete;
  ClockedModel& operator=(const ClockedModel&) = delete;

  Model* operator->() const { return model_.get(); }
  Model& operator*() const { return *model_; }

  /// An assertion that fails is remembered, and does not end the program.
  void survive_assertions() { context_.fatalOnError(false); }
  bool asserted() const { return context_.gotError(); }

  /// Outputs follow inputs, with the clock low.
  void settle() {
    model_->clk_i = 0;
    model_->eval();
  }
  void rise() {
    model_->clk_i = 1;
    model_->eval();
  }
  void clock() {
    settle();
    rise();
  }
  /// In reset for so many cycles; whatever the inputs are meanwhile.
  void reset(int cycles = 3) {
    model_->rst_ni = 0;
    for (int i = 0; i < cycles; ++i) clock();
    model_->rst_ni = 1;
  }

 private:
  VerilatedContext context_;
  std::unique_ptr<Model> model_;
};

/// Decides in each cycle which ports are open.
class RandomPorts {
 public:
  explicit RandomPorts(std::uint32_t seed) : random_(seed) {}
  /// With so many chances in 256.
  bool open(unsigned chance) { return chance >= 256 || (random_() & 255u) < chance; }

 private:
  std::mt19937 random_;
};

}  // namespace gnomon::rtl_test
