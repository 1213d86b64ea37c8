// SPDX-License-Identifier: Apache-2.0
// Tags say where a line will be when its request is served; everything else is when.
#include "line_cache.hpp"

#include <algorithm>

namespace gnomon::golden::cycles {
namespace {

constexpr Cycle kQueueStages = 3;     // from the look-up of a request to the end of an empty queue
constexpr Cycle kTouchedStages = 3;   // from the question whether a line was ever written to its answer's use
constexpr unsigned kWriteStages = 2;  // from the service of a request until it writes
constexpr Cycle kBackStages = 2;      // ... until its victim is offered to the line port

std::size_t sets(int size_log2, int lines_log2) {
  constexpr int kTwoLinesLog2 = 7;
  return std::size_t{1} << std::min(size_log2 - kTwoLinesLog2, lines_log2 - 1);
}

}  // namespace

CacheClock::CacheClock(int size_log2, int lines_log2, std::uint32_t first, int line_ids_log2)
    : sets_(sets(size_log2, lines_log2)),
      dirty_(2 * sets_.size()),
      touched_(std::size_t{1} << lines_log2),
      first_line_(first),
      fills_(std::size_t{2} << line_ids_log2),
      victims_(std::size_t{4} << line_ids_log2) {}

int CacheClock::way_of(std::uint32_t line) const {
  const Set& set = set_of(line);
  return set.lines[0] == line ? 0 : set.lines[1] == line ? 1 : -1;
}

/// Places for a line to come and for one to go; and the line must not itself be on its way out.
bool CacheClock::room_for_miss(std::uint32_t line, Cycle now) const {
  if (missed_ - used_ >= fills_.size() || victims_[missed_ % victims_.size()].gone > now) return false;
  return std::ranges::none_of(victims_,
                              [&](const Victim& victim) { return victim.line == line && victim.gone > now; });
}

bool CacheClock::takes(const Request& request, Cycle now) const {
  if (in_ram_ >= kQueue) return false;
  return !request.line_wanted || way_of(request.line) >= 0 || room_for_miss(request.line, now);
}

CacheClock::Taken CacheClock::look_up(const Request& request, Cycle now) {
  if (!takes(request, now)) return {};
  queued_ = true;
  if (!request.line_wanted) {
    queue_.push_back({.request = request, .from = now + kQueueStages});
    return {.first = true};
  }
  const int hit = way_of(request.line);
  Waiting waiting{.request = request, .miss = hit < 0, .from = now + kQueueStages};
  const int beside = hit >= 0 && request.beside ? way_of(request.beside_line) : -1;
  waiting.request.beside = beside >= 0;
  Set& set = set_of(request.line);
  if (hit < 0) {
    miss(request, waiting, now);
  } else {
    set.next = hit == 0 ? 1 : 0;
    waiting.slot =
        static_cast<std::uint32_t>(2 * (request.line & (sets_.size() - 1))) + static_cast<std::uint32_t>(hit);
  }
  if (beside >= 0) set_of(request.beside_line).next = beside == 0 ? 1 : 0;
  queue_.push_back(waiting);
  return {true, beside >= 0};
}

void CacheClock::miss(const Request& request, Waiting& waiting, Cycle now) {
  Set& set = set_of(request.line);
  const bool second = set.lines[0] != kNoLine && (set.lines[1] == kNoLine || set.next == 1);
  const std::size_t way = second ? 1 : 0;
  Victim& victim = victims_[missed_ % victims_.size()];
  victim = {set.lines.at(way), set.lines.at(way) == kNoLine ? 0 : kNever};
  fills_[missed_ % fills_.size()] = {request.line, now, kNever};
  ++missed_;
  set.lines.at(way) = request.line;
  set.next = second ? 0 : 1;
  waiting.slot = static_cast<std::uint32_t>(2 * (request.line & (sets_.size() - 1)) + way);
}

bool CacheClock::ready(Cycle now) const {
  if (queue_.empty() || queue_.front().from > now) return false;
  const Waiting& first = queue_.front();
  if (first.miss && (fills_[used_ % fills_.size()].known > now || backs_used_ >= kBacks)) return false;
  return !(first.request.beside && (wrote_ & 1U << kWriteStages) != 0);
}

void CacheClock::serve(Cycle now) {
  const Waiting& first = queue_.front();
  if (first.miss) serve_miss(first, now);
  if (first.request.writes || first.miss) wrote_ |= 1U;
  if (first.request.writes) dirty_[first.slot] = 1;
  served_ = now;
  queue_.pop_front();
}

/// Its victim goes if it was written since it came.
void CacheClock::serve_miss(const Waiting& waiting, Cycle now) {
  Victim& victim = victims_[used_ % victims_.size()];
  ++backs_used_;
  if (victim.line != kNoLine && dirty_[waiting.slot] != 0) {
    backs_.push_back({used_ % static_cast<std::uint32_t>(victims_.size()), victim.line, now + kBackStages});
    touched_[victim.line] = 1;
    touches_ |= 1U;
  } else {
    victim.gone = now + 2;
    spares_ |= 1U;
  }
  dirty_[waiting.slot] = 0;
  ++used_;
}

void CacheClock::back_taken() {
  backs_.pop_front();
  --backs_used_;
}

/// The queue is a RAM with a few words read ahead, so that a place in it is free two cycles after a service.
void CacheClock::move_queue(Cycle now) {
  const bool reads = in_ram_ != 0 && ahead_ < kAhead;
  in_ram_ = in_ram_ + (queued_ ? 1 : 0) - (reads ? 1 : 0);
  ahead_ = ahead_ + (reads ? 1 : 0) - (served_ == now ? 1 : 0);
  queued_ = false;
}

void CacheClock::end_cycle(Cycle now) {
  move_queue(now);
  // What a service does, it does in the cycles after it.
  if ((spares_ & 2U) != 0) --backs_used_;
  const bool touches = (touches_ & 2U) != 0;
  spares_ <<= 1U;
  touches_ <<= 1U;
  wrote_ <<= 1U;
  Fill& fill = fills_[asked_ % fills_.size()];
  if (asked_ == missed_ || fill.missed >= now || touches) return;
  if (touched_[fill.line] != 0)
    fetches_.push_back({asked_ % static_cast<std::uint32_t>(fills_.size()), fill.line, now + kTouchedStages});
  else
    fill.known = now + kTouchedStages;
  ++asked_;
}

bool CacheClock::can_be_cleared(Cycle now) const {
  return idle(now) && asked_ == missed_ &&
         std::ranges::none_of(victims_, [&](const Victim& victim) { return victim.gone > now; });
}

void CacheClock::clear() {
  std::ranges::fill(sets_, Set{});
  std::ranges::fill(touched_, std::uint8_t{0});
  std::ranges::fill(dirty_, std::uint8_t{0});
}

}  // namespace gnomon::golden::cycles
