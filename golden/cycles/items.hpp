// SPDX-License-Identifier: Apache-2.0
// Passes that take an item a cycle, cycle by cycle: a front end that moves as a whole, the memory, and what
// follows it (docs/cycle-model.md, "Behind the bus").
#pragma once

#include <cstdint>
#include <deque>
#include <gnomon/golden/config.hpp>
#include <gnomon/golden/cycles.hpp>
#include <span>

#include "lists.hpp"
#include "ports.hpp"
#include "run.hpp"

namespace gnomon::golden::cycles {

/// An item, as golden saw it.
struct Item {
  std::uint32_t line = 0, moved_line = 0;  ///< of the plane: of the item itself, and of its offset point
  bool updates = false;                    ///< goes to the memory ...
  bool writes = false;                     ///< ... and changes it
  bool kept = false, quiet = false;        ///< its state goes to the frame buffer, and nowhere else
};

/// Which pass, by what it does with the memory.
enum class ItemPass : std::uint8_t {
  Project,  ///< an update
  Resolve,  ///< two reads, a result
  Query,    ///< a read, a result
};

class ItemClock {
 public:
  ItemClock(ItemPass pass, const HardwareConfig& config, const HardwareTiming& timing);

  void expect(std::span<const Item> items) { items_.insert(items_.end(), items.begin(), items.end()); }
  struct Moves {
    bool taken = false;    ///< the item that was offered
    bool gives = false;    ///< a result
    bool waits = false;    ///< an item, for the memory
    bool blocked = false;  ///< a result, for the port
  };
  /// One cycle of `ports`, which is still to come; `cache`: that of the memory, or none.
  Moves cycle(bool item, const Ports& ports, CacheClock* cache);
  bool idle(Cycle now, const CacheClock* cache) const;

 private:
  bool update(Cycle now, CacheClock* cache);
  bool read(Cycle now, CacheClock* cache);
  bool read_cached(const Item& item, Cycle now, CacheClock& cache);
  void serve(Cycle now, CacheClock& cache, bool room, bool moved_room);
  bool answer(Cycle now, const Ports& ports, bool& blocked);

  ItemPass pass_;
  Cycle latency_;
  std::size_t places_;  ///< of the queues of entries
  unsigned last_;       ///< the last of the stages behind the memory
  FrontEnd front_;
  std::deque<Item> items_;                        ///< from the front end's last one on
  std::size_t under_way_ = 0;                     ///< of them, in the front end
  std::deque<Item> asked_;                        ///< their entries are on their way, or their results
  std::deque<Cycle> entries_, moved_entries_;     ///< there from then on
  bool own_asked_ = false, moved_asked_ = false;  ///< by the item at the end of the front end
  unsigned stages_ = 0;                           ///< bit 0: the first one behind the memory has an item
  Cycle busy_until_ = 0;
};

}  // namespace gnomon::golden::cycles
