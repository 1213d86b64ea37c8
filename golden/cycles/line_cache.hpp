// SPDX-License-Identifier: Apache-2.0
// A cache of lines without the lines: which of them are in which slot, which have to come and which to go,
// and when (docs/cycle-model.md, "Caches").
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <gnomon/golden/cycles.hpp>
#include <vector>

#include "run.hpp"

namespace gnomon::golden::cycles {

class CacheClock {
 public:
  static constexpr Cycle kNever = UINT64_MAX;

  /// A line that the cache wants of the line port, or wants to be rid of.
  struct Wish {
    std::uint32_t number = 0;  ///< by which the cache knows it again
    std::uint32_t line = 0;
    Cycle from = 0;  ///< it is offered from this cycle on
  };
  /// What is looked up: a line, and a read beside it.
  struct Request {
    std::uint32_t line = 0, beside_line = 0;
    bool beside = false;      ///< wanted; and, when it is served, taken
    bool writes = false;      ///< changes its line
    bool line_wanted = true;  ///< else it only keeps its place among the others
    std::uint8_t kind = 0;
  };
  struct Taken {
    bool first = false, beside = false;
  };

  /// 2^size_log2 bytes over 2^lines_log2 lines, which are the memory's from line `first` on; 2^line_ids_log2
  /// of them can be under way each way.
  CacheClock(int size_log2, int lines_log2, std::uint32_t first, int line_ids_log2);

  /// A request would be taken in this cycle.
  bool takes(const Request& request, Cycle now) const;
  /// Looks up in this cycle.
  Taken look_up(const Request& request, Cycle now);
  /// The oldest request can be served in this cycle.
  bool ready(Cycle now) const;
  const Request& oldest() const { return queue_.front().request; }
  void serve(Cycle now);
  /// The end of the cycle: asks for what was missed.
  void end_cycle(Cycle now);
  void clear();
  bool idle(Cycle now) const { return queue_.empty() && now != served_ + 1; }
  bool can_be_cleared(Cycle now) const;

  // The line port's side.
  const std::deque<Wish>& fetches() const { return fetches_; }
  const std::deque<Wish>& backs() const { return backs_; }
  std::uint32_t first_line() const { return first_line_; }
  void fetch_taken() { fetches_.pop_front(); }
  void back_taken();
  void came(std::uint32_t number, Cycle now) { fills_[number].known = now + 1; }
  void written(std::uint32_t number, Cycle now) { victims_[number].gone = now + 2; }

 private:
  static constexpr std::uint32_t kNoLine = 0xFFFFFFFF;
  static constexpr std::size_t kQueue = 256, kAhead = 4, kBacks = 4;
  struct Set {
    std::array<std::uint32_t, 2> lines{kNoLine, kNoLine};
    std::uint8_t next = 0;
  };
  struct Waiting {
    Request request;
    std::uint32_t slot = 0;
    bool miss = false;
    Cycle from = 0;
  };
  struct Fill {
    std::uint32_t line = 0;
    Cycle missed = 0, known = 0;
  };
  struct Victim {
    std::uint32_t line = kNoLine;
    Cycle gone = 0;  ///< it is not on its way any more from then on
  };

  Set& set_of(std::uint32_t line) { return sets_[line & (sets_.size() - 1)]; }
  const Set& set_of(std::uint32_t line) const { return sets_[line & (sets_.size() - 1)]; }
  int way_of(std::uint32_t line) const;
  bool room_for_miss(std::uint32_t line, Cycle now) const;
  void move_queue(Cycle now);
  void miss(const Request& request, Waiting& waiting, Cycle now);
  void serve_miss(const Waiting& waiting, Cycle now);

  std::vector<Set> sets_;
  std::vector<std::uint8_t> dirty_;    ///< by slot, 2 set + way
  std::vector<std::uint8_t> touched_;  ///< by line
  std::uint32_t first_line_;
  std::deque<Waiting> queue_;
  std::size_t in_ram_ = 0, ahead_ = 0;               ///< of the queue
  bool queued_ = false;                              ///< in this cycle
  std::vector<Fill> fills_;                          ///< twice as many as can be under way
  std::vector<Victim> victims_;                      ///< twice as many again
  std::uint32_t missed_ = 0, asked_ = 0, used_ = 0;  ///< misses so far: looked up, asked for, served
  std::deque<Wish> fetches_, backs_;
  std::size_t backs_used_ = 0;  ///< places of their queue, also those that may still be needed
  Cycle served_ = kNever;
  // Bit n: a service n cycles ago spared a place for a write-back; sent one; wrote its line.
  unsigned spares_ = 0, touches_ = 0, wrote_ = 0;
};

}  // namespace gnomon::golden::cycles
