// SPDX-License-Identifier: Apache-2.0
// The front end of the silhouette-line buffer cycle by cycle, where its memory may hold it up: the stages of
// docs/cycle-model.md, "Draw", and the chains behind the walk ("Entries behind caches").
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <gnomon/golden/cycles.hpp>
#include <gnomon/golden/slb/edge_walker.hpp>
#include <gnomon/golden/slb/formats.hpp>
#include <optional>

#include "ports.hpp"
#include "slb_memory.hpp"
#include "slb_points.hpp"

namespace gnomon::golden::cycles {

class DrawClock {
 public:
  DrawClock(const slb::SlbConfig& config, const HardwareTiming& timing);

  /// A vertex, or the end of the loop.
  struct Offer {
    slb::Vertex vertex = {};
    bool closes = false;
  };
  SlbMoves cycle(const Offer* offer, SlbMemory& memory, Ports& ports);
  /// Also in the middle of a loop.
  bool idle(Cycle now) const;

 private:
  struct Edge {
    slb::Vertex from, to;
    int quotients = 0;
    std::uint64_t crossings = 0;
    bool first = false, last = false;  ///< of its loop
    Cycle from_cycle = 0;              ///< it can leave where it is from then on
  };
  struct Chain {
    Cycle there = 0;
    std::optional<std::uint32_t> index;  ///< of its pixel, if it is on the plane
  };
  /// The stages from the first register to the walker.
  enum Stage : std::uint8_t { Loop, Differences, Product, Issue, Quotients, Place, kStages };

  Edge edge(const slb::Vertex& from, const slb::Vertex& to, bool last, Cycle cycle) const;
  void move_chains(SlbMemory& memory, Cycle now, SlbMoves& moves);
  bool walk(Cycle now, SlbMoves& moves);
  void cross(Cycle now);
  void begin_walk(const Edge& edge);
  void move_stages(bool walker_free, Cycle now);
  bool pass_on(Stage stage, Cycle now);
  Cycle issue(const Edge& edge, Cycle now);
  void leave_loop(bool slot, Cycle now);
  bool take(const Offer& offer, Cycle now);
  void take_vertex(const slb::Vertex& vertex, Cycle now);
  std::optional<std::uint32_t> pixel_on_plane(std::int64_t column, std::int64_t row) const;

  slb::SlbConfig config_;
  Cycle latency_;
  int dividers_;
  Cycle divider_stages_;

  // The loop being taken.
  slb::Vertex origin_, last_;
  int count_ = 0;          ///< vertices, 3 and more are 3
  bool in_pixel_ = false;  ///< all of them in the first one's pixel
  bool fresh_ = false;     ///< none of its edges has left the first register for the second

  std::array<std::optional<Edge>, kStages> stages_;
  std::optional<Edge> second_;  ///< waits for the first register
  std::deque<Edge> ring_;       ///< wait for their quotients
  std::size_t slots_ = 0;       ///< of the ring, in use or soon to be
  Cycle issued_ = 0;            ///< the last cycle at issue of the edge before
  bool joins_ = false;          ///< a divider was left in it

  // The walk.
  std::optional<slb::EdgeWalker> walker_;
  Edge walked_;                ///< the edge in it
  std::uint64_t steps_ = 0;    ///< still to be made
  bool entered_ = false;       ///< the chain that is open has a beginning
  std::size_t under_way_ = 0;  ///< crossings whose chains have not left the queue
  std::deque<Chain> chains_;
  std::optional<std::uint32_t> chain_;  ///< in front of the memory
  Cycle drained_ = 0;
};

}  // namespace gnomon::golden::cycles
