// SPDX-License-Identifier: Apache-2.0
// An item holds a place of the read port's queue from its request until its last word is given.
#include "look_up.hpp"

#include <algorithm>
#include <bit>
#include <gnomon/golden/frame/codec.hpp>

namespace gnomon::golden::cycles {

LookUp::LookUp(const HardwareTiming& timing)
    : latency_(static_cast<Cycle>(timing.memory_latency)),
      left_(std::bit_ceil(static_cast<std::size_t>(timing.memory_latency) + 3)) {}

Cycle LookUp::item(bool last, bool brick, Cycle now, Run& run) {
  Cycle& place = left_[items_++ % left_.size()];
  const Cycle taken = std::max(now, items_ > left_.size() ? place + 1 : 0);
  run.wait(now, taken - now);
  run.take(taken, 1);
  const Cycle answered = std::max(taken + latency_ + 1, before_ + 1);
  std::size_t words = brick ? frame::kBrickWords : 0;
  if (!brick) {
    const bool full = ++states_ == frame::kStatesPerWord || last;
    words = full ? 1 : 0;
    if (full) states_ = 0;
  }
  before_ = place = answered + std::max<std::size_t>(words, 1) - 1;
  run.step(answered, words);
  run.drained_from(before_ + 1);
  return taken + 1;
}

Cycle LookUp::items(std::size_t count, bool ends, bool brick, Cycle now, Run& run) {
  for (std::size_t i = 0; i < count; ++i) now = item(ends && i + 1 == count, brick, now, run);
  return now;
}

}  // namespace gnomon::golden::cycles
