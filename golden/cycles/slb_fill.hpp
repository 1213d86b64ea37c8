// SPDX-License-Identifier: Apache-2.0
// FILL with entries behind caches, cycle by cycle: its scratch memory is on the chip, its updates wait
// (docs/cycle-model.md, "Entries behind caches").
#pragma once

#include <cstdint>
#include <deque>
#include <gnomon/golden/cycles.hpp>
#include <gnomon/golden/slb/model.hpp>
#include <vector>

#include "ports.hpp"
#include "slb_memory.hpp"
#include "slb_points.hpp"

namespace gnomon::golden::cycles {

class FillClock {
 public:
  /// `flat`: the object has one depth.
  FillClock(const slb::FillSweep& sweep, bool flat, const slb::SlbConfig& config,
            const HardwareTiming& timing);

  SlbMoves cycle(SlbMemory& memory, Ports& ports);
  bool idle() const { return line_ == steps_.size() && !at_work_; }

 private:
  /// A line that is read, and what it brings: updates [first, end), or one cycle without any.
  struct Step {
    std::size_t first = 0, end = 0;
    bool ends_span = false;
  };
  void add_span(const slb::FillSweep& sweep, std::size_t first, std::size_t lines);
  void add_line(std::uint32_t first_pixel, const slb::FillLine& line);
  void add_plain(std::uint32_t first_pixel, const slb::FillLine& line);
  SlbMoves update(SlbMemory& memory);
  void ask(Cycle now, bool room);

  int side_;
  bool flat_;
  Cycle latency_;
  std::size_t places_;  ///< of either read port's queue
  std::vector<Step> steps_;
  std::vector<SlbRequest> updates_;
  std::size_t spans_ = 0;              ///< all of them
  std::size_t span_ = 0, asked_ = 0;   ///< spans, and lines, asked for so far
  std::size_t line_ = 0;               ///< lines taken so far
  std::deque<Cycle> spans_under_way_;  ///< there from then on
  std::deque<Cycle> lines_under_way_;
  bool at_work_ = false;
  std::size_t next_ = 0, end_ = 0;  ///< updates of the line at work
};

}  // namespace gnomon::golden::cycles
