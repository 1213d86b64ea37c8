// SPDX-License-Identifier: Apache-2.0
// Runs loops through a Verilated slb_outline, holding its three ports back at random.
#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "tests/rtl/clocked_model.hpp"
#include "tests/rtl/slb/outline/outcome.hpp"

namespace gnomon::rtl_test::slb {

/// Chance in 256 that a port is open in a cycle.
struct Stalls {
  unsigned vertices = 256, chains = 256, winds = 256;
};

template <class Model>
class OutlineBench {
 public:
  /// `fault` is one of mutations_pkg.sv, in a build that has them.
  OutlineBench(const SlbConfig& config, std::uint32_t seed, const std::string& fault = {})
      : config_(config), model_(seed, fault), ports_(seed) {
    reset();
  }

  void reset() {
    model_->in_valid_i = 0;
    model_->chain_ready_i = 0;
    model_->wind_ready_i = 0;
    model_.reset();
  }

  /// Everything that comes of the loops, once nothing is under way. Throws if nothing moves for long.
  Outcome run(std::span<const Loop> loops, Stalls stalls = {}) {
    Outcome outcome;
    for (const Loop& loop : loops) {
      for (const Vertex& vertex : loop) send(vertex, false, stalls, outcome);
      send({}, true, stalls, outcome);
    }
    drain(stalls, outcome);
    return outcome;
  }

  /// Vertices of a loop that goes on later; waits until nothing is under way.
  void begin(std::span<const Vertex> vertices, Stalls stalls, Outcome& outcome) {
    for (const Vertex& vertex : vertices) send(vertex, false, stalls, outcome);
    drain(stalls, outcome);
  }
  /// The rest of it.
  void finish(std::span<const Vertex> vertices, Stalls stalls, Outcome& outcome) {
    for (const Vertex& vertex : vertices) send(vertex, false, stalls, outcome);
    send({}, true, stalls, outcome);
    drain(stalls, outcome);
  }

  /// Begins with the loops and is reset in the middle of whatever goes on.
  void run_then_reset(std::span<const Loop> loops, Stalls stalls, std::uint64_t cycles) {
    Outcome dropped;
    const std::uint64_t end = cycles_ + cycles;
    for (const Loop& loop : loops) {
      for (const Vertex& vertex : loop) {
        if (cycles_ < end) send(vertex, false, stalls, dropped);
      }
      if (cycles_ < end) send({}, true, stalls, dropped);
    }
    while (cycles_ < end) cycle(stalls, dropped);
    reset();
  }

  std::uint64_t cycles() const { return cycles_; }

 private:
  static constexpr std::uint64_t kHangCycles = 300'000;  // longer than the longest edge takes

  void send(const Vertex& vertex, bool close, Stalls stalls, Outcome& outcome) {
    while (!ports_.open(stalls.vertices)) cycle(stalls, outcome);
    model_->in_valid_i = 1;
    model_->in_close_i = close;
    set(model_->in_x_i, vertex.x, config_.vertex_width());
    set(model_->in_y_i, vertex.y, config_.vertex_width());
    set(model_->in_depth_i, vertex.depth, config_.depth_bits);
    while (!cycle(stalls, outcome)) {
    }
    model_->in_valid_i = 0;
  }

  void drain(Stalls stalls, Outcome& outcome) {
    model_.settle();
    while (!model_->idle_o) cycle(stalls, outcome);
  }

  /// Returns whether the beat offered was taken.
  bool cycle(Stalls stalls, Outcome& outcome) {
    model_->chain_ready_i = ports_.open(stalls.chains);
    model_->wind_ready_i = ports_.open(stalls.winds);
    model_.settle();
    const bool taken = model_->in_valid_i && model_->in_ready_o;
    if (model_->chain_valid_o && model_->chain_ready_i) outcome.chains.push_back(chain());
    if (model_->wind_valid_o && model_->wind_ready_i) outcome.winds.push_back(wind());
    count(outcome.counts);
    quiet_ = taken || model_->event_crossing_o ? 0 : quiet_ + 1;
    if (quiet_ > kHangCycles) throw std::runtime_error("the hardware hangs");
    model_.rise();
    ++cycles_;
    return taken;
  }

  ChainRecord chain() const {
    return {.column = pixel(model_->chain_column_o),
            .row = pixel(model_->chain_row_o),
            .op = model_->chain_op_o,
            .a = model_->chain_a_o,
            .b = model_->chain_b_o,
            .corner = model_->chain_corner_o != 0,
            .depth = model_->chain_depth_o};
  }
  WindRecord wind() const {
    return {pixel(model_->wind_column_o), pixel(model_->wind_row_o), model_->wind_up_o != 0};
  }
  void count(Counts& counts) const {
    counts.vertices += model_->event_vertex_o;
    counts.repeated += model_->event_repeated_o;
    counts.loops += model_->event_loop_o;
    counts.shorts += model_->event_short_o;
    counts.tinies += model_->event_tiny_o;
    if (model_->event_tiny_o) counts.tiny_area2 += model_->event_tiny_area2_o;
    counts.crossings += model_->event_crossing_o;
  }

  /// PLANE_LOG2 + 2 bits, two's complement.
  std::int64_t pixel(std::uint32_t bits) const {
    const std::int64_t value = bits, half = std::int64_t{2} << config_.plane_log2;
    return value < half ? value : value - 2 * half;
  }
  template <class Port, class Value>
  static void set(Port& port, Value value, int bits) {
    port = static_cast<Port>(static_cast<std::uint64_t>(value) & ((std::uint64_t{1} << bits) - 1));
  }

  SlbConfig config_;
  ClockedModel<Model> model_;
  RandomPorts ports_;
  std::uint64_t cycles_ = 0, quiet_ = 0;
};

}  // namespace gnomon::rtl_test::slb
