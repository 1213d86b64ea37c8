// SPDX-License-Identifier: Apache-2.0
// Drives the plane behind its cache at random, and compares every answer with an array.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "line_memory.hpp"
#include "tests/rtl/clocked_model.hpp"

namespace gnomon::rtl_test {

/// What the random driver does; chances in 256.
struct PlaneTraffic {
  unsigned update = 0;  ///< that an update is offered
  unsigned read0 = 0;   ///< and a read
  unsigned read1 = 0;
  unsigned take = 256;                                ///< that an answer is taken
  std::function<std::uint32_t(std::mt19937&)> index;  ///< the next entry
};

/// What was compared and counted.
struct PlaneOutcome {
  std::uint64_t compared = 0;
  std::uint64_t wrong = 0;
  std::array<std::uint64_t, 6> events{};  ///< hits, hits beside, misses, fills, write-backs, waits
  std::uint64_t cycles = 0;
  bool hung = false;
};

template <class Model>
class PlaneCacheBench {
 public:
  PlaneCacheBench(std::uint32_t entries, const LineTiming& timing, std::uint32_t seed,
                  const std::string& plusarg = {})
      : memory_(timing, seed), model_(seed, plusarg), random_(seed), expected_(entries, kNone) {
    reset();
  }

  void reset() {
    model_->update_valid_i = model_->read0_valid_i = model_->read1_valid_i = model_->clear_valid_i = 0;
    model_.reset();  // the memory is not asked meanwhile
    memory_.reset();
    asked0_.clear();
    asked1_.clear();
    std::fill(expected_.begin(), expected_.end(), kNone);
  }

  /// `cycles` of random traffic, then until nothing is under way.
  void run(const PlaneTraffic& traffic, std::uint64_t cycles) {
    for (std::uint64_t i = 0; i < cycles && !outcome_.hung; ++i) {
      offer(traffic);
      step(traffic.take);
    }
    std::uint64_t quiet = 0;
    while (!outcome_.hung && !(at_rest() && model_->idle_o && asked0_.empty() && asked1_.empty())) {
      step(traffic.take);
      outcome_.hung = ++quiet > kHangCycles;
    }
  }

  void clear() {
    model_->clear_valid_i = 1;
    std::uint64_t quiet = 0;
    for (bool taken = false; !taken && !outcome_.hung;) {
      settle();
      taken = model_->clear_ready_o;
      edge();
      outcome_.hung = ++quiet > kHangCycles;
    }
    model_->clear_valid_i = 0;
    std::fill(expected_.begin(), expected_.end(), kNone);
    for (settle(); !model_->idle_o && !outcome_.hung; settle()) {
      edge();
      outcome_.hung = ++quiet > kHangCycles;
    }
  }

  const PlaneOutcome& outcome() const { return outcome_; }
  const LineMemory& memory() const { return memory_; }

 private:
  static constexpr std::uint32_t kNone = 1u << 24;  // an empty entry: farther than any depth
  static constexpr std::uint64_t kHangCycles = 20'000;
  struct Asked {
    std::uint32_t tag = 0;
    std::uint32_t depth = 0;
  };

  bool chance(unsigned in_256) { return (random_() & 255u) < in_256; }
  bool at_rest() const { return !model_->update_valid_i && !model_->read0_valid_i && !model_->read1_valid_i; }

  /// What is offered stays until it is taken.
  void offer(const PlaneTraffic& traffic) {
    if (!model_->update_valid_i && chance(traffic.update)) {
      model_->update_valid_i = 1;
      model_->update_index_i = static_cast<SData>(traffic.index(random_));
      model_->update_depth_i = static_cast<std::uint32_t>(random_()) & 0xFFFFu;
    }
    if (!model_->read0_valid_i && chance(traffic.read0)) {
      model_->read0_valid_i = 1;
      model_->read0_index_i = static_cast<SData>(traffic.index(random_));
      model_->read0_tag_i = ++tag_;
    }
    if (!model_->read1_valid_i && chance(traffic.read1)) {
      model_->read1_valid_i = 1;
      model_->read1_index_i = static_cast<SData>(traffic.index(random_));
      model_->read1_tag_i = ++tag_;
    }
  }

  /// One cycle: what is taken takes effect in order, an update before reads that are taken later.
  void step(unsigned take) {
    model_->entry0_ready_i = chance(take);
    model_->entry1_ready_i = chance(take);
    settle();
    const bool update = model_->update_valid_i && model_->update_ready_o;
    const bool read0 = model_->read0_valid_i && model_->read0_ready_o;
    const bool read1 = model_->read1_valid_i && model_->read1_ready_o;
    if (read0) asked0_.push_back({model_->read0_tag_i, expected_[model_->read0_index_i]});
    if (read1) asked1_.push_back({model_->read1_tag_i, expected_[model_->read1_index_i]});
    if (update) {
      std::uint32_t& entry = expected_[model_->update_index_i];
      entry = std::min<std::uint32_t>(entry, model_->update_depth_i);
    }
    if (model_->entry0_valid_o && model_->entry0_ready_i)
      compare(asked0_, model_->entry0_o, model_->entry0_tag_o);
    if (model_->entry1_valid_o && model_->entry1_ready_i)
      compare(asked1_, model_->entry1_o, model_->entry1_tag_o);
    edge();
    if (update) model_->update_valid_i = 0;
    if (read0) model_->read0_valid_i = 0;
    if (read1) model_->read1_valid_i = 0;
  }

  void compare(std::deque<Asked>& asked, std::uint32_t entry, std::uint32_t tag) {
    ++outcome_.compared;
    const bool present = (entry >> 24) != 0;
    const std::uint32_t depth = present ? entry & 0xFFFFFFu : kNone;
    if (asked.empty() || asked.front().tag != tag || asked.front().depth != depth) ++outcome_.wrong;
    if (!asked.empty()) asked.pop_front();
  }

  void settle() {
    memory_.drive(*model_);
    model_.settle();
  }
  void edge() {
    for (unsigned i = 0; i < outcome_.events.size(); ++i)
      outcome_.events[i] += (model_->events_o >> (5 - i)) & 1u;
    memory_.clock(*model_);
    model_.rise();
    ++outcome_.cycles;
  }

  LineMemory memory_;
  ClockedModel<Model> model_;
  std::mt19937 random_;
  std::vector<std::uint32_t> expected_;
  std::deque<Asked> asked0_, asked1_;
  std::uint32_t tag_ = 0;
  PlaneOutcome outcome_;
};

}  // namespace gnomon::rtl_test
