// SPDX-License-Identifier: Apache-2.0
// When the front end of the silhouette-line buffer takes vertices and walks edges (docs/cycle-model.md,
// "Draw").
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <gnomon/golden/cycles.hpp>
#include <gnomon/golden/slb/formats.hpp>
#include <optional>

#include "run.hpp"

namespace gnomon::golden::cycles {

class Outline {
 public:
  Outline(const slb::SlbConfig& config, const HardwareTiming& timing);

  /// A vertex is offered from `earliest` on; returns the cycle in which it is taken. Crossings go to `run`.
  Cycle vertex(const slb::Vertex& vertex, Cycle earliest, Run& run);
  /// The loop's end is offered from `earliest` on; returns the cycle in which it is taken.
  Cycle close(Cycle earliest, Run& run);
  /// The unit is drained from this cycle on, if nothing more comes.
  Cycle drained() const;

 private:
  static constexpr std::size_t kSlots = 32;  ///< of the ring in which edges wait for their quotients

  /// An edge on its way: the last cycle that it spends in each stage.
  struct Stages {
    Cycle loop = 0, delta = 0, product = 0, issue = 0, slot = 0, quotients = 0, place = 0;
    Cycle walked = 0;    ///< its last step
    bool joins = false;  ///< a divider is left in its last cycle at issue
  };
  /// An edge that was walked, for the chains that its crossings finish.
  struct Walked {
    slb::Vertex from, to;
    Cycle first_step = 0, last_step = 0;
    bool inside = false;  ///< the loop is still in its first pixel when the edge begins
    bool crosses = false, closes = false;
  };

  Cycle take(Cycle earliest) const { return std::max(earliest, loop_free_); }
  /// An edge stands in the first register from `cycle` on.
  void edge(const slb::Vertex& from, const slb::Vertex& to, Cycle cycle, bool last, Run& run);
  int quotients(const slb::Vertex& from, const slb::Vertex& to) const;
  Cycle issue(int wanted, bool asks_first, Cycle in_product);
  Cycle chain_drained(const Walked& edge) const;
  void forget_old();

  slb::SlbConfig config_;
  int latency_, dividers_, divider_stages_;

  // The loop being taken.
  slb::Vertex origin_, before_, last_;
  int count_ = 0;            ///< vertices, 3 and more are 3
  bool in_pixel_ = false;    ///< all of them in the first one's pixel
  bool left_pixel_ = false;  ///< an edge of the loop has crossed a border

  Cycle loop_free_ = 0;                ///< the first register takes from then on
  Stages ahead_;                       ///< the edge before
  std::array<Cycle, kSlots> slots_{};  ///< when each slot was read last
  std::size_t edges_ = 0;
  std::deque<Walked> walked_;  ///< as many as can still have chains under way
  Cycle drained_ = 0;
};

}  // namespace gnomon::golden::cycles
