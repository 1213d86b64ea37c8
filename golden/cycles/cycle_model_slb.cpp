// SPDX-License-Identifier: Apache-2.0
// Commands of the silhouette-line buffer with its entries behind caches (docs/cycle-model.md, "Entries behind
// caches").
#include <gnomon/golden/slb/codec.hpp>
#include <utility>

#include "cycle_model.hpp"
#include "slb_fill.hpp"

namespace gnomon::golden::cycles {

/// A good one.
void CycleModel::slb_header(std::optional<Pass> pass, const slb::FillSweep& fill) {
  if (pass) return begin_slb(*pass);
  await_word(true);
  switch (static_cast<slb::SlbOp>(command_.op)) {
    case slb::SlbOp::Clear:
      return clear_slb();
    case slb::SlbOp::Fill:
      return fill_behind_cache(fill);
    case slb::SlbOp::ReadEntries:
      return read_entries_behind_cache();
    default:
      return slb_command(fill);
  }
}

void CycleModel::begin_slb(Pass pass) {
  if (!slb_run_) await_word(true);
  slb_run_ = pass;
  while (!ports_->word()) slb_cycle(nullptr, nullptr, false);
  slb_cycle(nullptr, nullptr, true);
  close_if_complete();
}

/// Marks are scrubbed; both caches forget when nothing of theirs is on its way out.
void CycleModel::clear_slb() {
  CacheClock& lanes = ports_->cache(CachedMemory::Lanes);
  CacheClock& fragments = ports_->cache(CachedMemory::Fragments);
  const int lines_log2 = slb_lines_log2();
  const Cycle forgotten =
      std::max(share(touched_lines_log2(lines_log2)),
               share(touched_lines_log2(SlbMemory::fragment_lines_log2(config_.slb_config()))));
  const Cycle scrubbed = now_ + 1 + share(lines_log2);
  spend(Pass::Clear, 1);
  const auto wait = [&] { now_ < scrubbed ? spend(Pass::Clear, 1) : spend(Pass::Clear, 0, 1); };
  while (!lanes.can_be_cleared(now_) || !fragments.can_be_cleared(now_)) wait();
  lanes.clear();
  fragments.clear();
  slb_memory_->clear();
  const Cycle end = std::max(scrubbed, now_ + 1 + forgotten);
  while (now_ <= end) wait();
}

void CycleModel::fill_behind_cache(const slb::FillSweep& sweep) {
  spend(Pass::Fill, 1);
  FillClock fill(sweep, flat_, config_.slb_config(), timing_);
  while (!fill.idle() || !slb_memory_->idle(*ports_)) {
    const SlbMoves moves = fill.cycle(*slb_memory_, *ports_);
    ++table_.at(Pass::Fill, moves.steps ? Cause::Busy : Cause::MemoryWait);
    elapse(1);
  }
  spend(Pass::Fill, 0, 1);
}

void CycleModel::read_entries_behind_cache() {
  const slb::EntryRange range = slb::decode_entry_range(command_.arg);
  spend(Pass::Read, 1);
  EntryClock reader(range.first, range.count, config_.slb_config());
  while (!reader.over() || !slb_memory_->idle(*ports_)) {
    const SlbMoves moves = reader.cycle(*slb_memory_, *ports_);
    ++table_.at(Pass::Read, moves.steps     ? Cause::Busy
                            : moves.blocked ? ports_->held_back()
                                            : Cause::MemoryWait);
    ++now_;
    ports_->cycle(false, moves.gives, false);
  }
  spend(Pass::Read, 0, 1);
}

void CycleModel::pixels(std::span<const Item> items) {
  for (const Item& item : items)
    while (!slb_cycle(&item, nullptr, false)) continue;
}

void CycleModel::vertex_behind_cache(const DrawClock::Offer& offer) {
  while (!slb_cycle(nullptr, &offer, false)) continue;
}

bool CycleModel::slb_idle() const {
  return draw_->idle(now_) && samples_.idle() && points_.idle() && slb_memory_->idle(*ports_);
}

SlbMoves CycleModel::slb_moves(const Item* item, const DrawClock::Offer* vertex) {
  if (slb_run_ == Pass::Draw) return draw_->cycle(vertex, *slb_memory_, *ports_);
  SlbRequest request;
  if (item != nullptr)
    request = {.index = item->line,
               .kind = slb_run_ == Pass::Cover ? SlbRequest::Kind::Sample : SlbRequest::Kind::Read,
               .writes = item->writes};
  const SlbRequest* const offered = item != nullptr ? &request : nullptr;
  if (slb_run_ == Pass::Query) return points_.cycle(offered, *slb_memory_, *ports_);
  return samples_.cycle(offered, item != nullptr && item->updates, *slb_memory_, *ports_);
}

/// One cycle of a run of LOOP, COVER or QUERY; returns whether what is offered is taken. The end of a loop is
/// no word.
bool CycleModel::slb_cycle(const Item* item, const DrawClock::Offer* vertex, bool header) {
  const bool word = ports_->word();
  const bool closes = vertex != nullptr && vertex->closes;
  const bool quiet = !word && !closes && slb_idle();
  const SlbMoves moves = slb_moves(word ? item : nullptr, word || closes ? vertex : nullptr);
  const Cause cause = moves.taken || moves.steps || header ? Cause::Busy
                      : moves.blocked                      ? ports_->held_back()
                      : moves.waits                        ? Cause::MemoryWait
                      : word                               ? Cause::Hazard
                      : ports_->commands().over()          ? Cause::InputStarved
                                                           : Cause::MemoryWait;
  ++table_.at(*slb_run_, cause);
  ++now_;
  takes_header_ = false;
  ports_->cycle((moves.taken && !closes) || header, moves.gives, quiet);
  return moves.taken;
}

void CycleModel::end_slb() {
  while (!slb_idle()) slb_cycle(nullptr, nullptr, false);
  slb_run_.reset();
}

}  // namespace gnomon::golden::cycles
