// SPDX-License-Identifier: Apache-2.0
// Runs programs through a Verilated topology unit as the command decoder would, holding its streams back at
// random.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <stdexcept>

#include "tests/rtl/clocked_model.hpp"
#include "tests/rtl/topology/outcome.hpp"

namespace gnomon::rtl_test::topology {

/// Chance in 256 that a port is open in a cycle.
struct Stalls {
  unsigned items = 256, results = 256;
};

template <class Model>
class TopologyBench {
 public:
  explicit TopologyBench(std::uint32_t seed) : model_(seed), ports_(seed) { reset(); }

  void reset() {
    model_->start_i = 0;
    model_->item_valid_i = 0;
    model_->register_write_i = 0;
    model_->result_ready_i = 0;
    model_.reset();
    outcome_ = {};
    last_op_ = {};
    left_ = UINT64_MAX;
  }

  /// Everything since the last reset, once nothing is under way. Throws if nothing moves for long.
  Outcome run(std::span<const Command> program, Stalls stalls = {}) {
    stalls_ = stalls;
    for (const Command& command : program) execute(command);
    drain();
    return outcome_;
  }

  /// Begins with the program and is reset in the middle of whatever goes on.
  void run_then_reset(std::span<const Command> program, Stalls stalls, std::uint64_t cycles) {
    stalls_ = stalls;
    left_ = cycles;
    for (const Command& command : program) execute(command);
    reset();
  }

  std::uint64_t cycles() const { return cycles_; }

 private:
  static constexpr std::uint64_t kHangCycles = 100'000;  // longer than any scrub here

  static bool streams(TopologyOp op) {
    return op == TopologyOp::PutQuads || op == TopologyOp::ResolveTopology;
  }

  /// A change of kind is a barrier.
  void execute(const Command& command) {
    const bool goes_on = !command.sets_registers && streams(command.op) && command.op == last_op_;
    if (!goes_on) drain();
    if (command.sets_registers) {
      set_registers(command.registers);
      last_op_ = {};
      return;
    }
    last_op_ = command.op;
    model_->start_i = 1;
    model_->word_i = Word{static_cast<std::uint8_t>(command.op)} << 56 | Word{command.flags} << 48 |
                     static_cast<Word>(command.items.size()) << 32 | command.arg;
    cycle();
    model_->start_i = 0;
    for (const Word item : command.items) send(item);
  }

  void set_registers(const ProjectionRegisters& registers) {
    model_->register_write_i = 1;
    for (unsigned i = 0; i <= 12; ++i) {
      model_->register_index_i = static_cast<CData>(i);
      model_->word_i = static_cast<Word>(i < 12 ? registers.matrix[i] : registers.offset_factor);
      cycle();
    }
    model_->register_write_i = 0;
  }

  void send(Word item) {
    while (left_ > 0 && !ports_.open(stalls_.items)) cycle();
    model_->item_valid_i = 1;
    model_->word_i = item;
    while (left_ > 0 && !cycle()) {
    }
    model_->item_valid_i = 0;
  }

  void drain() {
    model_.settle();
    while (left_ > 0 && !model_->idle_o) cycle();
  }

  /// Returns whether the item offered was taken.
  bool cycle() {
    if (left_ == 0) return false;
    if (left_ != UINT64_MAX) --left_;
    model_->result_ready_i = ports_.open(stalls_.results);
    model_.settle();
    const bool taken = model_->item_valid_i && model_->item_ready_o;
    const bool given = model_->result_valid_o && model_->result_ready_i;
    if (given) outcome_.results.push_back(model_->result_o);
    count();
    quiet_ = taken || given || model_->step_o ? 0 : quiet_ + 1;
    if (quiet_ > kHangCycles) throw std::runtime_error("the hardware hangs");
    model_.rise();
    ++cycles_;
    return taken;
  }

  /// Bits of events_o, the first counter highest.
  void count() {
    TopologyCounters& c = outcome_.counters;
    const std::array<std::uint64_t*, 15> counters = {
        &c.quads_tested, &c.nodes_visited,   &c.shadow,          &c.fallback,        &c.hit,
        &c.uncertain,    &c.off_plane,       &c.facing_away,     &c.resolved,        &c.nodes_dropped,
        &c.nodes_linked, &c.quads_saturated, &c.quads_too_large, &c.quads_off_plane, &c.quads_put};
    for (std::size_t i = 0; i < counters.size(); ++i) *counters[i] += model_->events_o >> i & 1u;
    outcome_.sticky.list_overflow |= (model_->events_o >> 9 & 1u) != 0;
    outcome_.sticky.depth_saturated |= (model_->events_o >> 11 & 1u) != 0;
    outcome_.sticky.quad_off_plane |= model_->clipped_o != 0;
  }

  ClockedModel<Model> model_;
  RandomPorts ports_;
  Stalls stalls_;
  Outcome outcome_;
  TopologyOp last_op_{};
  std::uint64_t cycles_ = 0, quiet_ = 0, left_ = UINT64_MAX;
};

}  // namespace gnomon::rtl_test::topology
