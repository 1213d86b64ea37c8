// SPDX-License-Identifier: Apache-2.0
// READ_PLANE behind ports, cycle by cycle; and which line of a plane in memory holds an entry.
#pragma once

#include <cstdint>
#include <deque>
#include <gnomon/golden/cycles.hpp>

#include "ports.hpp"

namespace gnomon::golden::cycles {

/// Bits of u and v in turns, u's lowest.
std::uint32_t in_turns(std::uint32_t u, std::uint32_t v);
/// A line is a tile of 4 x 4 entries, tiles lie in Morton order (docs/cache.md).
std::uint32_t line_of_entry(std::uint32_t u, std::uint32_t v);

class PlaneRead {
 public:
  PlaneRead(std::uint32_t first, std::uint32_t count, int plane_log2, const HardwareTiming& timing);

  struct Moves {
    bool asks = false, gives = false;
    bool blocked = false;  ///< an entry that is there
  };
  /// One cycle of `ports`, which is still to come; `cache`: the plane's, or none.
  Moves cycle(const Ports& ports, CacheClock* cache);
  bool over() const { return to_give_ == 0; }

 private:
  bool ask(Cycle now, CacheClock* cache);

  std::uint32_t next_, to_ask_, to_give_;
  int plane_log2_;
  Cycle latency_;
  std::size_t places_;
  std::deque<Cycle> entries_;  ///< there from then on
};

}  // namespace gnomon::golden::cycles
