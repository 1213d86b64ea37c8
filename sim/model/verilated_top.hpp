// SPDX-License-Identifier: Apache-2.0
// What the drivers of all Verilated tops share: context, messages, power-up, waveform. A model has one
// driver, and that includes this once.
#pragma once

#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>

#include "verilated.h"
#if VM_TRACE
#include "verilated_fst_c.h"
#endif

namespace {

thread_local std::string* t_messages = nullptr;

/// Base of a driver; `reset_cycles` are shown in a waveform before cycle 0.
template <class Top, int reset_cycles>
class VerilatedTop {
 public:
  VerilatedTop(const VerilatedTop&) = delete;
  VerilatedTop& operator=(const VerilatedTop&) = delete;

  uint64_t cycle() const { return cycle_; }
  /// What the RTL and the runtime had to say.
  const char* fault() const { return messages_.c_str(); }

  bool trace_open(const char* path, uint64_t from, uint64_t to) {
#if VM_TRACE
    enter();
    trace_close();
    trace_ = std::make_unique<VerilatedFstC>();
    top_->trace(trace_.get(), 99);
    trace_->open(path);
    trace_from_ = from;
    trace_to_ = to;
    if (!trace_->isOpen()) trace_.reset();
    return trace_ != nullptr;
#else
    (void)path, (void)from, (void)to;
    return false;
#endif
  }
  void trace_close() {
#if VM_TRACE
    if (trace_) trace_->close();
    trace_.reset();
#endif
  }

 protected:
  /// `random_reset` as VerilatedContext::randReset has it.
  VerilatedTop(const char* name, uint32_t seed, int random_reset) {
    enter();
    context_.threads(1);
    context_.fatalOnError(false);
    context_.randReset(random_reset);
    context_.randSeed(static_cast<int>(seed * 2u + 1u));  // 0 would mean a seed from the clock
#if VM_TRACE
    context_.traceEverOn(true);
#endif
    top_ = std::make_unique<Top>(&context_, name);
  }
  ~VerilatedTop() {
    enter();
    trace_close();
    top_->final();
  }

  /// Several models may live in a thread; the runtime must know whose turn it is.
  void enter() {
    t_messages = &messages_;
    Verilated::threadContextp(&context_);
  }

  void hold_reset() {
    top_->rst_ni = 0;
    for (int i = 0; i < reset_cycles; ++i) {
      top_->clk_i = 0;
      top_->eval();
      top_->clk_i = 1;
      top_->eval();
    }
    top_->rst_ni = 1;
  }

  bool tracing() const {
#if VM_TRACE
    return trace_ != nullptr;
#else
    return false;
#endif
  }

  /// The first (0) or second half (1) of the cycle, if the waveform holds it.
  template <bool kTrace>
  void dump(uint64_t half) {
#if VM_TRACE
    constexpr uint64_t kNanosecondsPerCycle = 10;
    if (kTrace && cycle_ >= trace_from_ && cycle_ <= trace_to_) {
      trace_->dump((cycle_ + reset_cycles) * kNanosecondsPerCycle + half * kNanosecondsPerCycle / 2);
    }
#else
    (void)half;
#endif
  }

 private:
  std::string messages_;

 protected:
  VerilatedContext context_;
  std::unique_ptr<Top> top_;
  uint64_t cycle_ = 0;

 private:
#if VM_TRACE
  std::unique_ptr<VerilatedFstC> trace_;
  uint64_t trace_from_ = 0, trace_to_ = 0;
#endif
};

}  // namespace

int gnomon_model_printf(const char* format, ...) {
  constexpr size_t kKept = 4096;  // the first messages say what went wrong
  char line[512];
  std::va_list arguments;
  va_start(arguments, format);
  const int length = std::vsnprintf(line, sizeof line, format, arguments);
  va_end(arguments);
  if (t_messages && t_messages->size() < kKept) *t_messages += line;
  return length;
}
