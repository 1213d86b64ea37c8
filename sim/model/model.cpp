// SPDX-License-Identifier: Apache-2.0
// Drives one Verilated gnomon_core behind model_abi.h. The cache compiles this file together with what
// Verilator wrote.
#include <algorithm>
#include <cstring>
#include <vector>

#include "Vgnomon_core.h"
#include "model_abi.h"
#include "verilated_top.hpp"
#if GNOMON_SAVABLE
#include "verilated_save.h"
#endif
#if VM_COVERAGE
#include "verilated_cov.h"
#endif

namespace {

#if GNOMON_SAVABLE
/// Serializes into memory instead of a file.
class StateWriter final : public VerilatedSerialize {
 public:
  explicit StateWriter(std::vector<uint8_t>& bytes) : bytes_(bytes) { bytes_.clear(); }
  void flush() override {
    bytes_.insert(bytes_.end(), m_bufp, m_cp);
    m_cp = m_bufp;
  }

 private:
  std::vector<uint8_t>& bytes_;
};

class StateReader final : public VerilatedDeserialize {
 public:
  explicit StateReader(const std::vector<uint8_t>& bytes) : bytes_(bytes) { m_endp = m_bufp; }

 private:
  void fill() override {
    const size_t kept = static_cast<size_t>(m_endp - m_cp);
    std::memmove(m_bufp, m_cp, kept);
    const size_t more = std::min(bufferSize() - kept, bytes_.size() - read_);
    std::memcpy(m_bufp + kept, bytes_.data() + read_, more);
    read_ += more;
    m_cp = m_bufp;
    m_endp = m_bufp + kept + more;
  }

  const std::vector<uint8_t>& bytes_;
  size_t read_ = 0;
};
#endif

/// Whether a port is open: a function of the cycle and the seed alone.
class Gate {
 public:
  void set(const GnomonModelGate& gate, uint64_t seed) { gate_ = gate, seed_ = seed; }
  bool open(uint64_t cycle) const {
    if (gate_.open_per_256 >= 256) return true;
    uint64_t x = seed_ + (cycle >> gate_.block_log2) * 0x9E3779B97F4A7C15u;
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
    return ((x >> 40) & 255) < gate_.open_per_256;
  }

 private:
  GnomonModelGate gate_{256, 0};
  uint64_t seed_ = 0;
};

class Model : public VerilatedTop<Vgnomon_core, GNOMON_MODEL_RESET_CYCLES> {
 public:
  // A bit that starts random and is then constant would count as toggled.
  explicit Model(uint32_t seed) : VerilatedTop("gnomon_core", seed, VM_COVERAGE ? 0 : 2) { reset(); }

  void set_stalls(const GnomonModelStalls& stalls) {
    command_gate_.set(stalls.command, stalls.seed);
    result_gate_.set(stalls.result, ~stalls.seed);
  }

  void reset() {
    enter();
    offering_ = false;
    top_->cmd_valid_i = 0;
    top_->res_ready_i = 0;
    hold_reset();
    cycle_ = 0;
  }

  int run(GnomonModelRun& io) {
    enter();
    const int stop = tracing() && !probing_ ? run_loop<true>(io) : run_loop<false>(io);
    return context_.gotFinish() || context_.gotError() ? int{GNOMON_STOP_FAULT} : stop;
  }

  uint64_t counter(uint32_t index) {
    enter();
    top_->counter_index_i = static_cast<CData>(index & 255);
    top_->eval();
    return top_->counter_value_o;
  }

  bool idle() const { return top_->idle_o != 0; }

  bool write_coverage(const char* path) {
#if VM_COVERAGE
    enter();
    context_.coveragep()->write(path);
    return true;
#else
    (void)path;
    return false;
#endif
  }

  bool save() {
#if GNOMON_SAVABLE
    StateWriter writer(saved_);
    writer << *top_;
    writer.flush();
    saved_cycle_ = cycle_;
    saved_offering_ = offering_;
    probing_ = true;
    return true;
#else
    return false;
#endif
  }

  void restore() {
#if GNOMON_SAVABLE
    StateReader reader(saved_);
    reader >> *top_;
    cycle_ = saved_cycle_;
    offering_ = saved_offering_;
    probing_ = false;
#endif
  }

 private:
  template <bool kTrace>
  int run_loop(GnomonModelRun& io) {
    Vgnomon_core& top = *top_;
    const uint64_t last = io.max_cycles;
    for (uint64_t passed = 0;; ++passed) {
      const bool all_taken = io.words_taken == io.word_count;
      if (all_taken && !io.until_idle) return GNOMON_STOP_TAKEN;
      if (io.result_count == io.result_capacity) return GNOMON_STOP_RESULTS_FULL;
      if (passed == last) return GNOMON_STOP_CYCLE_LIMIT;

      // Once offered, a word stays until it is taken.
      if (!offering_ && !all_taken && command_gate_.open(cycle_)) {
        offering_ = true;
        top.cmd_data_i = io.words[io.words_taken];
      }
      top.cmd_valid_i = offering_;
      top.res_ready_i = result_gate_.open(cycle_);
      top.clk_i = 0;
      top.eval();
      if (all_taken && top.idle_o) return GNOMON_STOP_IDLE;
      dump<kTrace>(0);

      if (top.cmd_valid_i && top.cmd_ready_o) {
        ++io.words_taken;
        offering_ = false;
      }
      if (top.res_valid_o && top.res_ready_i) {
        io.results[io.result_count] = top.res_data_o;
        io.result_cycles[io.result_count] = cycle_;
        ++io.result_count;
      }
      top.clk_i = 1;
      top.eval();
      dump<kTrace>(1);
      ++cycle_;
      if (__builtin_expect(context_.gotFinish(), 0)) return GNOMON_STOP_FAULT;
    }
  }

  Gate command_gate_, result_gate_;
  bool offering_ = false;
  std::vector<uint8_t> saved_;
  bool saved_offering_ = false;
  bool probing_ = false;  // between save and restore: cycles that do not count
  uint64_t saved_cycle_ = 0;
};

Model& model_of(void* model) {
  return *static_cast<Model*>(model);
}

const GnomonModelApi kApi = {
    GNOMON_MODEL_ABI,
    [](uint32_t seed) -> void* { return new Model(seed); },
    [](void* m) { delete static_cast<Model*>(m); },
    [](void* m, const GnomonModelStalls* stalls) { model_of(m).set_stalls(*stalls); },
    [](void* m) { model_of(m).reset(); },
    [](void* m, GnomonModelRun* run) { return model_of(m).run(*run); },
    [](void* m) { return model_of(m).cycle(); },
    [](void* m, uint32_t index) { return model_of(m).counter(index); },
    [](void* m) { return model_of(m).idle() ? 1 : 0; },
    [](void* m) { return model_of(m).fault(); },
    [](void* m, const char* path, uint64_t from, uint64_t to) {
      return model_of(m).trace_open(path, from, to) ? 1 : 0;
    },
    [](void* m) { model_of(m).trace_close(); },
    [](void* m, const char* path) { return model_of(m).write_coverage(path) ? 1 : 0; },
    [](void* m) { return model_of(m).save() ? 1 : 0; },
    [](void* m) { model_of(m).restore(); },
};

}  // namespace

extern "C" __attribute__((visibility("default"))) const GnomonModelApi* gnomon_model_api(void) {
  return &kApi;
}
