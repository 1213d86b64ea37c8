// SPDX-License-Identifier: Apache-2.0
// Topology mode cycle by cycle, queues and walks alone: when quads are linked, and when voxels get their
// answers (docs/cycle-model.md, "Topology mode").
#pragma once

#include <cstdint>
#include <deque>
#include <gnomon/golden/cycles.hpp>
#include <gnomon/golden/topology/lists.hpp>
#include <optional>
#include <vector>

#include "run.hpp"

namespace gnomon::golden::cycles {

/// What a cycle was.
enum class Beat : std::uint8_t { Busy, MemoryWait, Nothing };

/// The projection unit's front end: all stages move together, or none does.
class FrontEnd {
 public:
  explicit FrontEnd(std::size_t stages) : stages_(stages, kNone) {}

  static constexpr std::uint32_t kNone = 0xFFFFFFFF;
  std::uint32_t out() const { return stages_[next_]; }
  bool idle() const { return items_ == 0; }
  void move(std::uint32_t item);

 private:
  std::vector<std::uint32_t> stages_;
  std::size_t next_ = 0;  ///< the last stage, which is the first one after the move
  std::size_t items_ = 0;
};

/// PUT_QUADS.
class PutClock {
 public:
  PutClock(const HardwareConfig& config, const HardwareTiming& timing);

  /// A quad whose box meets so many entries of the plane; 0 if it ends before it is linked.
  void expect(std::uint64_t entries) { expected_.push_back(entries); }
  /// One cycle; `corner`: one is offered. Returns whether it is taken.
  bool cycle(bool corner, Beat& beat);
  bool idle() const;

 private:
  static constexpr std::size_t kQueue = 8;

  Cycle now_ = 0, latency_, written_ = 0;
  FrontEnd front_;
  std::deque<std::uint64_t> expected_;  ///< quads whose corners are still on their way
  int corners_ = 0;                     ///< of the quad that is being put together
  std::optional<std::uint64_t> whole_;  ///< a quad that waits for the queue
  std::deque<std::uint64_t> queue_;     ///< entries still to be linked
};

/// RESOLVE_TOPOLOGY.
class WalkClock {
 public:
  WalkClock(const HardwareConfig& config, const HardwareTiming& timing);

  /// The voxels of the next items, as golden saw them; `kept`: their states go to the frame buffer.
  void expect(const topology::ListWork& work, bool kept, bool quiet);
  /// One cycle; `voxel`: one is offered, `room`: a result would be taken. Returns whether the voxel is taken.
  bool cycle(bool voxel, bool room, Beat& beat);
  /// The last cycle has given a result.
  bool gave() const { return gave_; }
  bool idle() const;

 private:
  static constexpr Cycle kNever = UINT64_MAX;
  struct Voxel {
    std::uint32_t visited = 0;
    std::size_t first = 0;  ///< its nodes in tested_
    Cycle done = kNever;    ///< the result of its walk is there from then on
    bool kept = false, quiet = false;
  };
  /// A walk on its way round: at node `node` of its voxel.
  struct Token {
    std::uint32_t voxel = 0, node = 0;
    Cycle ready = 0;  ///< what it waits for is there from then on
  };
  enum class Pick : std::uint8_t { New, Tested, Other };

  bool tested(const Token& token) const { return tested_[voxels_[token.voxel].first + token.node] != 0; }
  bool at_last(const Token& token) const { return token.node + 1 == voxels_[token.voxel].visited; }
  void give_result(bool room);
  void end_walks();
  bool leave_seen(bool ends_full);
  bool see_node(bool seen_leaves);
  Pick choose() const;
  void ask_node(Pick pick, std::uint32_t first);

  Cycle now_ = 0, latency_, kept_until_ = 0;
  std::size_t places_;  ///< of the read ports' queues
  std::size_t walks_;   ///< at once
  FrontEnd front_;

  std::vector<Voxel> voxels_;
  std::vector<std::uint8_t> tested_;
  std::size_t offered_ = 0;          ///< the voxel that is taken next
  std::deque<Token> heads_;          ///< asked for their list's head
  std::deque<std::uint32_t> order_;  ///< voxels whose head is known
  std::size_t walking_ = 0;          ///< numbers in use
  std::deque<Token> nodes_, tests_, tested_queue_, other_queue_;
  std::deque<Token> ends_;  ///< told by a node without a test
  std::optional<Token> seen_, spare_;
  Pick pick_ = Pick::New;
  bool hold_ = false, gave_ = false;
};

}  // namespace gnomon::golden::cycles
