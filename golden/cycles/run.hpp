// SPDX-License-Identifier: Apache-2.0
// Commands of one op that follow each other without a barrier, and which of their cycles are BUSY
// (docs/cycle-model.md, "Terms").
#pragma once

#include <algorithm>
#include <cstdint>
#include <gnomon/golden/cycles.hpp>
#include <vector>

namespace gnomon::golden::cycles {

using Cycle = std::uint64_t;

/// Cycles [first, end).
struct Span {
  Cycle first = 0, end = 0;
};

/// Ascending spans that do not touch.
class Spans {
 public:
  /// `first` must not lie before the end of what was added last.
  void add(Cycle first, std::uint64_t count);
  void clear() { spans_.clear(); }
  const std::vector<Span>& all() const { return spans_; }
  std::uint64_t size() const;
  Cycle end() const { return spans_.empty() ? 0 : spans_.back().end; }

 private:
  std::vector<Span> spans_;
};

/// Cycles that are in both.
std::uint64_t common(const Spans& a, const Spans& b);

class Run {
 public:
  void begin(Pass pass, Cycle start);
  bool open() const { return open_; }
  /// The decoder takes a header, an item or the end of a loop in each of these.
  void take(Cycle first, std::uint64_t count) { taken_.add(first, count); }
  /// The unit does a step in each of these.
  void step(Cycle first, std::uint64_t count) { steps_.add(first, count); }
  /// A memory holds an item back in each of these; where the unit does no step.
  void wait(Cycle first, std::uint64_t count) { waits_.add(first, count); }
  void drained_from(Cycle cycle) { drained_ = std::max(drained_, cycle); }
  /// The end: all cycles go to `table`. `more`: another word waits. Returns the cycle after the last one.
  Cycle end(bool more, CycleTable& table);

 private:
  bool open_ = false;
  Pass pass_ = Pass::Control;
  Cycle start_ = 0, drained_ = 0;
  Spans taken_, steps_, waits_;
};

}  // namespace gnomon::golden::cycles
