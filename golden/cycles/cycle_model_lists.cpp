// SPDX-License-Identifier: Apache-2.0
// Commands of topology mode, on the chip and with their lists behind caches (docs/cycle-model.md, "Topology
// mode" and "Lists behind caches").
#include <algorithm>
#include <deque>
#include <gnomon/golden/topology/codec.hpp>

#include "cycle_model.hpp"

namespace gnomon::golden::cycles {

ListMemories CycleModel::list_memories() {
  return {config_, ports_ && ports_->has(CachedMemory::Heads) ? &*ports_ : nullptr};
}

void CycleModel::begin_lists() {
  if (!put_ && !cached_put_ && !walk_) {
    if (ports_) await_word(true);
    const bool cached = list_memories().cached();
    if (command_.op != static_cast<std::uint8_t>(topology::TopologyOp::PutQuads))
      walk_.emplace(config_, timing_, now_, cached);
    else if (cached)
      cached_put_.emplace(config_);
    else
      put_.emplace(config_, timing_);
  }
  while (ports_ && !ports_->word()) list_cycle(false, false, true);
  list_cycle(false, true, true);
}

/// One cycle of a run of PUT_QUADS or RESOLVE_TOPOLOGY; returns whether the item is taken.
bool CycleModel::list_cycle(bool item, bool header, bool more) {
  Beat beat = Beat::Nothing;
  const bool word = !ports_ || ports_->word();
  const bool room = !ports_ || ports_->room();
  const bool offered = item && word;
  const bool taken = put_          ? put_->cycle(offered, beat)
                     : cached_put_ ? cached_put_->cycle(offered, now_, list_memories(), nodes_, beat)
                                   : walk_->cycle(offered, room, list_memories(), beat);
  if (header) beat = Beat::Busy;
  const bool over = ports_ ? !word && ports_->commands().over() : !more;
  const Cause cause = beat == Beat::Busy         ? Cause::Busy
                      : beat == Beat::Blocked    ? ports_->held_back()
                      : beat == Beat::MemoryWait ? Cause::MemoryWait
                      : over                     ? Cause::InputStarved
                      : word                     ? Cause::Hazard
                                                 : Cause::MemoryWait;
  ++table_.at(walk_ ? Pass::Resolve : Pass::Project, cause);
  ++now_;
  takes_header_ = false;
  if (ports_) ports_->cycle(taken || header, walk_ && walk_->gave(), false);
  return taken;
}

bool CycleModel::lists_idle() {
  if (put_) return put_->idle();
  if (cached_put_) return cached_put_->idle(now_, list_memories());
  return walk_->idle(list_memories());
}

void CycleModel::end_lists(bool more) {
  while (!lists_idle()) list_cycle(false, false, more);
  put_.reset();
  cached_put_.reset();
  walk_.reset();
}

/// Each cache forgets when nothing of its is on its way out.
void CycleModel::clear_lists() {
  struct Clear {
    CachedMemory memory;
    int lines_log2;
    bool forgotten;
  };
  std::array<Clear, 3> clears{{{CachedMemory::Heads, ListMemories::head_lines_log2(config_), false},
                               {CachedMemory::Nodes, ListMemories::node_lines_log2(config_), false},
                               {CachedMemory::Records, ListMemories::record_lines_log2(config_), false}}};
  nodes_ = 0;
  spend(Pass::Clear, 1);
  Cycle end = now_;
  while (now_ <= end) {
    bool clearing = false;
    for (Clear& clear : clears) {
      if (clear.forgotten) continue;
      clearing = true;
      end = std::max(end, now_ + 1);
      if (!ports_->cache(clear.memory).can_be_cleared(now_)) continue;
      ports_->cache(clear.memory).clear();
      clear.forgotten = true;
      end = std::max(end, now_ + 1 + share(touched_lines_log2(clear.lines_log2)));
    }
    clearing ? spend(Pass::Clear, 1) : spend(Pass::Clear, 0, 1);
  }
}

/// Entries are asked for one a cycle, as their lines are taken, and given as they come.
void CycleModel::read_lists(const topology::EntryRange& range) {
  constexpr std::size_t kEntries = 4;
  constexpr Cycle kServedStages = 2;
  const ListMemories memories = list_memories();
  CacheClock& heads = ports_->cache(CachedMemory::Heads);
  const std::uint32_t side = std::uint32_t{1} << config_.plane_log2;
  std::uint32_t asked = 0, given = 0;
  std::deque<Cycle> entries;  // there from then on
  spend(Pass::Read, 1);
  while (given != range.count || !heads.idle(now_)) {
    const bool room = entries.size() < kEntries;
    const bool there = !entries.empty() && entries.front() <= now_;
    const bool gives = there && ports_->room();
    if (gives) entries.pop_front();
    given += gives ? 1 : 0;
    const std::uint32_t index = range.first + asked;
    const bool asks = asked != range.count &&
                      heads.look_up({.line = memories.head_line(index % side, index / side)}, now_).first;
    asked += asks ? 1 : 0;
    if (room && heads.ready(now_)) {
      entries.push_back(now_ + kServedStages);
      heads.serve(now_);
    }
    ++table_.at(Pass::Read, asks || gives ? Cause::Busy : there ? ports_->held_back() : Cause::MemoryWait);
    ++now_;
    ports_->cycle(false, gives, false);
  }
  spend(Pass::Read, 0, 1);
}

}  // namespace gnomon::golden::cycles
