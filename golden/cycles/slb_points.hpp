// SPDX-License-Identifier: Apache-2.0
// COVER, QUERY and READ_ENTRIES with entries behind caches, cycle by cycle (docs/cycle-model.md, "Entries
// behind caches").
#pragma once

#include <cstdint>
#include <deque>
#include <gnomon/golden/slb/config.hpp>
#include <optional>

#include "ports.hpp"
#include "run.hpp"
#include "slb_memory.hpp"

namespace gnomon::golden::cycles {

/// What a cycle of the silhouette-line buffer came to.
struct SlbMoves {
  bool taken = false;    ///< what was offered
  bool steps = false;    ///< a step of a walk, a fill or a read
  bool gives = false;    ///< a result
  bool waits = false;    ///< something, for the memory
  bool blocked = false;  ///< a result, for the port
};

/// Samples of COVER: a register, then the memory.
class SampleClock {
 public:
  /// `item`: none is offered; a request without an update ends in the register.
  SlbMoves cycle(const SlbRequest* item, bool updates, SlbMemory& memory, Ports& ports);
  bool idle() const { return !sample_; }

 private:
  std::optional<SlbRequest> sample_;
};

/// Points of QUERY: a register, the memory, three stages that move together.
class PointClock {
 public:
  SlbMoves cycle(const SlbRequest* item, SlbMemory& memory, Ports& ports);
  bool idle() const { return !point_ && stages_ == 0; }

 private:
  std::optional<SlbRequest> point_;
  unsigned stages_ = 0;  ///< bit 0: the first one has an answer
};

/// READ_ENTRIES: entries one behind the other, each a header and its words.
class EntryClock {
 public:
  EntryClock(std::uint32_t first, std::uint32_t count, const slb::SlbConfig& config);

  SlbMoves cycle(SlbMemory& memory, Ports& ports);
  bool over() const { return to_give_ == 0; }

 private:
  std::uint32_t next_, to_ask_, to_give_;
  int words_, given_ = 0;  ///< of an entry, with its header
};

}  // namespace gnomon::golden::cycles
