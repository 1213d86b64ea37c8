// SPDX-License-Identifier: Apache-2.0
// What each part does in a cycle is decided from what the cycles before left, as in the hardware.
#include "items.hpp"

#include <algorithm>
#include <bit>

namespace gnomon::golden::cycles {
namespace {

constexpr std::size_t kPerspectiveStages = 8;
constexpr std::size_t kCachedEntries = 4;  // places for entries behind a cache
constexpr Cycle kServedStages = 2;         // from the service of a read to its entry
constexpr Cycle kWritten = 2;              // an update, until its memory is idle; and the latency
constexpr std::uint8_t kUpdate = 0, kOwn = 1, kMoved = 2;

std::size_t front_stages(ItemPass pass, const HardwareConfig& config) {
  if (pass == ItemPass::Query) return 1;
  return (pass == ItemPass::Project ? 4 : 6) + (config.en_perspective ? kPerspectiveStages : 0);
}

}  // namespace

ItemClock::ItemClock(ItemPass pass, const HardwareConfig& config, const HardwareTiming& timing)
    : pass_(pass),
      latency_(static_cast<Cycle>(timing.memory_latency)),
      places_(std::bit_ceil(static_cast<std::size_t>(timing.memory_latency) + 3)),
      last_(pass == ItemPass::Query ? 1U << 2U : 1U << 4U),
      front_(front_stages(pass, config)) {}

ItemClock::Moves ItemClock::cycle(bool item, const Ports& ports, CacheClock* cache) {
  const Cycle now = ports.now();
  const std::size_t places = cache != nullptr ? kCachedEntries : places_;
  const bool room = entries_.size() < places, moved_room = moved_entries_.size() < places;
  Moves moves;
  moves.gives = answer(now, ports, moves.blocked);
  const bool stands = front_.out() != FrontEnd::kNone;
  if (stands) {
    if (pass_ == ItemPass::Project)
      moves.waits = !update(now, cache);
    else
      moves.waits = (cache == nullptr && !room) || !read(now, cache);
  }
  if (cache != nullptr && cache->ready(now)) serve(now, *cache, room, moved_room);
  if (moves.waits) return moves;
  if (stands) {
    if (pass_ != ItemPass::Project) asked_.push_back(items_.front());
    items_.pop_front();
    --under_way_;
  }
  moves.taken = item;
  if (item) ++under_way_;
  front_.move(item ? 0 : FrontEnd::kNone);
  return moves;
}

/// The item at the end of the front end goes to the memory; returns whether it does.
bool ItemClock::update(Cycle now, CacheClock* cache) {
  const Item& item = items_.front();
  if (cache != nullptr)
    return !item.updates ||
           cache->look_up({.line = item.line, .writes = item.writes, .kind = kUpdate}, now).first;
  if (item.updates) busy_until_ = std::max(busy_until_, now + latency_ + (item.writes ? kWritten : 1));
  return true;
}

bool ItemClock::read(Cycle now, CacheClock* cache) {
  if (cache != nullptr) return read_cached(items_.front(), now, *cache);
  entries_.push_back(now + latency_ + 1);
  if (pass_ == ItemPass::Resolve) moved_entries_.push_back(now + latency_ + 1);
  return true;
}

/// Both reads together, if both hit; else one after the other.
bool ItemClock::read_cached(const Item& item, Cycle now, CacheClock& cache) {
  if (!own_asked_) {
    const auto taken = cache.look_up(
        {.line = item.line, .beside_line = item.moved_line, .beside = !moved_asked_, .kind = kOwn}, now);
    own_asked_ = taken.first;
    moved_asked_ = taken.beside;
  } else {
    moved_asked_ = cache.look_up({.line = item.moved_line, .kind = kMoved}, now).first;
  }
  if (!own_asked_ || !moved_asked_) return false;
  own_asked_ = moved_asked_ = false;
  return true;
}

void ItemClock::serve(Cycle now, CacheClock& cache, bool room, bool moved_room) {
  const CacheClock::Request& request = cache.oldest();
  const bool own = request.kind == kOwn, moved = request.kind == kMoved || request.beside;
  if ((own && !room) || (moved && !moved_room)) return;
  if (own) entries_.push_back(now + kServedStages);
  if (moved) moved_entries_.push_back(now + kServedStages);
  cache.serve(now);
}

/// The stages behind the memory move, and may give a result.
bool ItemClock::answer(Cycle now, const Ports& ports, bool& blocked) {
  if (pass_ == ItemPass::Project) return false;
  const bool offers = (stages_ & last_) != 0;
  const bool quiet = offers && asked_.front().quiet;
  blocked = offers && !quiet && !ports.room();
  if (blocked) return false;
  if (offers) {
    if (asked_.front().kept) busy_until_ = now + latency_ + kWritten;
    asked_.pop_front();
  }
  const bool there = !entries_.empty() && entries_.front() <= now &&
                     (pass_ == ItemPass::Query || (!moved_entries_.empty() && moved_entries_.front() <= now));
  if (there) {
    entries_.pop_front();
    if (pass_ == ItemPass::Resolve) moved_entries_.pop_front();
  }
  stages_ = ((stages_ << 1U) & (2 * last_ - 1)) | (there ? 1U : 0U);
  return offers && !quiet;
}

bool ItemClock::idle(Cycle now, const CacheClock* cache) const {
  return under_way_ == 0 && asked_.empty() && busy_until_ <= now && (cache == nullptr || cache->idle(now));
}

}  // namespace gnomon::golden::cycles
