// SPDX-License-Identifier: Apache-2.0
// Spans of cycles, and the account of a run.
#include "run.hpp"

#include <algorithm>

namespace gnomon::golden::cycles {

void Spans::add(Cycle first, std::uint64_t count) {
  if (count == 0) return;
  if (!spans_.empty() && spans_.back().end == first)
    spans_.back().end += count;
  else
    spans_.push_back({first, first + count});
}

std::uint64_t Spans::size() const {
  std::uint64_t size = 0;
  for (const Span& span : spans_) size += span.end - span.first;
  return size;
}

std::uint64_t common(const Spans& a, const Spans& b) {
  std::uint64_t size = 0;
  auto at = a.all().begin(), bt = b.all().begin();
  while (at != a.all().end() && bt != b.all().end()) {
    const Cycle first = std::max(at->first, bt->first), end = std::min(at->end, bt->end);
    if (first < end) size += end - first;
    if (at->end < bt->end)
      ++at;
    else
      ++bt;
  }
  return size;
}

void Run::begin(Pass pass, Cycle start) {
  open_ = true;
  pass_ = pass;
  start_ = drained_ = start;
  taken_.clear();
  steps_.clear();
  waits_.clear();
}

Cycle Run::end(bool more, CycleTable& table) {
  open_ = false;
  const Cycle last_taken = taken_.end();
  const Cycle end = std::max(drained_, last_taken);
  // After the last word was taken there is only what the unit still does.
  Spans tail;
  tail.add(last_taken, end - last_taken);
  const std::uint64_t tail_steps = common(tail, steps_);
  const std::uint64_t busy = taken_.size() + steps_.size() - common(taken_, steps_);
  const std::uint64_t held = waits_.size() - common(waits_, steps_);
  const std::uint64_t waiting = end - start_ - busy - held;
  const std::uint64_t tail_waiting = (end - last_taken) - tail_steps;
  table.at(pass_, Cause::Busy) += busy;
  table.at(pass_, Cause::MemoryWait) += held;
  table.at(pass_, more ? Cause::Hazard : Cause::InputStarved) += tail_waiting;
  table.at(pass_, Cause::Hazard) += waiting - tail_waiting;
  return end;
}

}  // namespace gnomon::golden::cycles
