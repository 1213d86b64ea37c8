// SPDX-License-Identifier: Apache-2.0
// The entries of the silhouette-line buffer behind two caches in step: when an update or a read is taken, and
// when an entry is there (docs/cycle-model.md, "Entries behind caches").
#pragma once

#include <cstdint>
#include <deque>
#include <gnomon/golden/slb/config.hpp>
#include <optional>
#include <vector>

#include "ports.hpp"
#include "run.hpp"

namespace gnomon::golden::cycles {

/// What the unit asks of its memory.
struct SlbRequest {
  enum class Kind : std::uint8_t {
    Chain,      ///< goes into its pixel's entry, or FILL finishes that
    PlainLine,  ///< FILL changes full depths of a line
    Sample,     ///< of COVER
    Read,
  };
  std::uint32_t index = 0;  ///< of the pixel, row by row
  Kind kind = Kind::Read;
  bool writes = true;  ///< the entry changes
};

/// In a cycle: `begin`, then at most one `take`, then `serve`.
class SlbMemory {
 public:
  explicit SlbMemory(const slb::SlbConfig& config);

  /// Logarithms of the lines that its memories have.
  static int lane_lines_log2(const slb::SlbConfig& config);
  static int fragment_lines_log2(const slb::SlbConfig& config);

  /// The request that was taken before is looked up, if both caches take it.
  void begin(Ports& ports);
  /// A request is taken in this cycle.
  bool free() const { return !held_; }
  void take(const SlbRequest& request);
  void serve(Ports& ports);
  /// An entry that was asked for is there.
  bool entry(Cycle now) const { return !entries_.empty() && entries_.front() <= now; }
  void leave() { entries_.pop_front(); }
  bool idle(const Ports& ports) const;
  void clear() { marks_.assign(marks_.size(), 0); }

 private:
  struct Held {
    std::uint32_t lane = 0, fragments = 0;
    bool with_fragments = false, reads = false;
    bool writes = false, writes_fragments = false;
  };

  int plane_log2_, slots_log2_, places_log2_;
  std::vector<std::uint8_t> marks_;  ///< by line of lanes, along the rows: a pixel of it has fragments
  std::optional<Held> held_;
  std::deque<Cycle> entries_;  ///< there from then on
  bool room_ = true;           ///< for one more of them
};

}  // namespace gnomon::golden::cycles
