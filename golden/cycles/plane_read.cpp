// SPDX-License-Identifier: Apache-2.0
// Entries are asked for one a cycle and given as they come.
#include "plane_read.hpp"

#include <bit>

namespace gnomon::golden::cycles {
namespace {

constexpr int kTileLog2 = 2;
constexpr std::size_t kCachedEntries = 4;  // places for entries behind a cache
constexpr Cycle kServedStages = 2;         // from the service of a read to its entry

/// Every other bit, from bit 0 on.
std::uint32_t spread(std::uint32_t bits) {
  std::uint32_t spread = 0;
  for (int i = 0; (bits >> i) != 0; ++i) spread |= (bits >> i & 1U) << (2 * i);
  return spread;
}

}  // namespace

std::uint32_t in_turns(std::uint32_t u, std::uint32_t v) {
  return spread(u) | spread(v) << 1U;
}

std::uint32_t line_of_entry(std::uint32_t u, std::uint32_t v) {
  return in_turns(u >> kTileLog2, v >> kTileLog2);
}

PlaneRead::PlaneRead(std::uint32_t first, std::uint32_t count, int plane_log2, const HardwareTiming& timing)
    : next_(first),
      to_ask_(count),
      to_give_(count),
      plane_log2_(plane_log2),
      latency_(static_cast<Cycle>(timing.memory_latency)),
      places_(std::bit_ceil(static_cast<std::size_t>(timing.memory_latency) + 3)) {}

PlaneRead::Moves PlaneRead::cycle(const Ports& ports, CacheClock* cache) {
  const Cycle now = ports.now();
  const bool room = entries_.size() < (cache != nullptr ? kCachedEntries : places_);
  Moves moves;
  const bool there = !entries_.empty() && entries_.front() <= now;
  moves.gives = there && ports.room();
  moves.blocked = there && !moves.gives;
  if (moves.gives) {
    entries_.pop_front();
    --to_give_;
  }
  moves.asks = to_ask_ != 0 && (cache != nullptr || room) && ask(now, cache);
  if (cache != nullptr && room && cache->ready(now)) {
    entries_.push_back(now + kServedStages);
    cache->serve(now);
  }
  return moves;
}

bool PlaneRead::ask(Cycle now, CacheClock* cache) {
  if (cache == nullptr) {
    entries_.push_back(now + latency_ + 1);
  } else {
    const std::uint32_t line = line_of_entry(next_ & ((1U << plane_log2_) - 1), next_ >> plane_log2_);
    if (!cache->look_up({.line = line}, now).first) return false;
  }
  ++next_;
  --to_ask_;
  return true;
}

}  // namespace gnomon::golden::cycles
