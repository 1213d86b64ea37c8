// SPDX-License-Identifier: Apache-2.0
// How cycles pass: on the chip in steps of whole runs, with ports to memory one by one.
#include <gnomon/golden/command.hpp>
#include <gnomon/golden/frame/codec.hpp>
#include <gnomon/golden/topology/codec.hpp>
#include <utility>

#include "cycle_model.hpp"
#include "plane_read.hpp"

namespace gnomon::golden::cycles {

namespace {

constexpr Cycle kCoverStages = 1;   // off the rows swept
constexpr Cycle kUpdateStages = 1;  // more where COVER updates the memory, and the latency
constexpr Cycle kWriteStages = 1;   // more where that writes

}  // namespace

void CycleModel::submitted(std::size_t words) {
  submitted_ += words;
  if (ports_) ports_->commands().expect(submitted_);
}

CacheClock* CycleModel::cache() {
  return ports_ && ports_->has(CachedMemory::Plane) ? &ports_->cache(CachedMemory::Plane) : nullptr;
}

/// Cycles that belong to no pass, or in which a run waits.
void CycleModel::elapse(Cycle count) {
  now_ += count;
  if (!ports_) return;
  for (Cycle i = 0; i < count; ++i) ports_->cycle(std::exchange(takes_header_, false), false, false);
}

void CycleModel::spend(Pass pass, Cycle busy, Cycle memory_wait) {
  table_.at(pass, Cause::Busy) += busy;
  table_.at(pass, Cause::MemoryWait) += memory_wait;
  elapse(busy + memory_wait);
}

/// Until the decoder sees the next word. A header that is late is waited for by nobody; the run that is open
/// waits for an item.
void CycleModel::await_word(bool header) {
  while (!ports_->word()) {
    if (run_.open())
      run_.wait(now_, 1);
    else if (!header)
      ++table_.at(Pass::Control, Cause::MemoryWait);
    ++now_;
    ports_->cycle(false, false, header && !run_.open());
  }
  takes_header_ = header;
}

/// The next cycle takes a word.
Cycle CycleModel::take_word() {
  takes_header_ = true;
  elapse(1);
  return now_ - 1;
}

/// A result of a command that does not stream.
void CycleModel::give(Pass pass) {
  if (!ports_) return spend(pass, 1);
  while (!ports_->room()) {
    ++table_.at(pass, ports_->held_back());
    elapse(1);
  }
  ++table_.at(pass, Cause::Busy);
  ++now_;
  ports_->cycle(false, true, false);
}

/// Words of a run are taken from this cycle on; returns the first one's.
Cycle CycleModel::take(std::size_t count) {
  if (!ports_) {
    run_.take(now_, count);
    return std::exchange(now_, now_ + count);
  }
  Cycle first = now_;
  for (std::size_t i = 0; i < count; ++i) {
    await_word(false);
    if (i == 0) first = now_;
    run_.take(now_, 1);
    take_word();
  }
  return first;
}

void CycleModel::end_run(bool more) {
  if (slb_run_) return end_slb();
  if (items_) return end_items();
  if (put_ || cached_put_ || walk_) return end_lists(more);
  if (!run_.open()) return;
  if (outline_ && command_.op == static_cast<std::uint8_t>(slb::SlbOp::Loop))
    run_.drained_from(outline_->drained());
  const Cycle end = run_.end(more, table_);
  elapse(end - now_);
}

/// With ports: the header, then the reader alone; the line of the last entry may be written for another
/// cycle.
void CycleModel::read_plane() {
  const PlaneRange range = decode_plane_range(command_.arg);
  spend(Pass::Read, 1);
  PlaneRead reader(range.first, range.count, config_.plane_log2, timing_);
  while (!reader.over()) {
    const PlaneRead::Moves moves = reader.cycle(*ports_, cache());
    ++table_.at(Pass::Read, moves.asks || moves.gives ? Cause::Busy
                            : moves.blocked           ? ports_->held_back()
                                                      : Cause::MemoryWait);
    ++now_;
    ports_->cycle(false, moves.gives, false);
  }
}

void CycleModel::control_items(std::size_t count) {
  if (!ports_) return spend(Pass::Control, count);
  for (std::size_t i = 0; i < count; ++i) {
    await_word(false);
    ++table_.at(Pass::Control, Cause::Busy);
    take_word();
  }
}

void CycleModel::look_up(std::size_t count) {
  const bool brick = (command_.flags & frame::kBrick) != 0;
  if (!ports_) {
    now_ = look_up_->items(count, items_left_ == 0, brick, now_, run_);
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    await_word(false);
    const bool last = items_left_ == 0 && i + 1 == count;
    elapse(look_up_->items(1, last, brick, now_, run_) - 1 - now_);
    take_word();
  }
}

/// COVER, item by item.
void CycleModel::covers(const ItemWork& work) {
  const Cycle updated = kCoverStages + kUpdateStages + latency_;
  for (std::size_t i = 0; i < work.items; ++i) {
    const Cycle taken = take(1);
    run_.drained_from(taken + kCoverStages);
    if (work.last_updating == i) run_.drained_from(taken + updated);
    if (work.last_writing == i) run_.drained_from(taken + updated + kWriteStages);
  }
}

void CycleModel::begin_items(Pass pass) {
  if (!items_) {
    await_word(true);
    items_.emplace(pass == Pass::Project   ? ItemPass::Project
                   : pass == Pass::Resolve ? ItemPass::Resolve
                                           : ItemPass::Query,
                   config_, timing_);
    items_pass_ = pass;
  }
  while (!ports_->word()) item_cycle(false, false);
  item_cycle(false, true);
}

/// One cycle of a run of PROJECT_VOXELS, RESOLVE_VOXELS or QUERY behind ports; returns whether the item is
/// taken.
bool CycleModel::item_cycle(bool item, bool header) {
  const bool word = ports_->word();
  CacheClock* const plane = items_pass_ == Pass::Query ? nullptr : cache();
  const bool quiet = !word && items_->idle(now_, plane);
  const ItemClock::Moves moves = items_->cycle(item && word, *ports_, plane);
  const Cause cause = moves.taken || header       ? Cause::Busy
                      : moves.blocked             ? ports_->held_back()
                      : moves.waits               ? Cause::MemoryWait
                      : word                      ? Cause::Hazard
                      : ports_->commands().over() ? Cause::InputStarved
                                                  : Cause::MemoryWait;
  ++table_.at(items_pass_, cause);
  ++now_;
  takes_header_ = false;
  ports_->cycle(moves.taken || header, moves.gives, quiet);
  return moves.taken;
}

void CycleModel::take_items(std::span<const Item> items) {
  items_->expect(items);
  for (std::size_t i = 0; i < items.size(); ++i)
    while (!item_cycle(true, false)) continue;
}

void CycleModel::end_items() {
  while (!items_->idle(now_, items_pass_ == Pass::Query ? nullptr : cache())) item_cycle(false, false);
  items_.reset();
}

}  // namespace gnomon::golden::cycles
