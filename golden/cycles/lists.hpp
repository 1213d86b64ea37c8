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

#include "ports.hpp"
#include "run.hpp"

namespace gnomon::golden::cycles {

/// What a cycle was.
enum class Beat : std::uint8_t { Busy, MemoryWait, Blocked, Nothing };

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

/// Where heads, nodes and records lie in lines (docs/cache.md), and what holds them.
class ListMemories {
 public:
  /// `ports`: null with everything on the chip.
  ListMemories(const HardwareConfig& config, Ports* ports) : config_(&config), ports_(ports) {}

  static int head_lines_log2(const HardwareConfig& config);
  static int node_lines_log2(const HardwareConfig& config);
  static int record_lines_log2(const HardwareConfig& config);

  bool cached() const { return ports_ != nullptr; }
  CacheClock* cache(CachedMemory memory) const { return ports_ ? &ports_->cache(memory) : nullptr; }
  std::uint32_t head_line(std::uint32_t u, std::uint32_t v) const;
  std::uint32_t node_line(std::uint32_t index) const;
  std::uint32_t record_line(std::uint32_t number) const;
  /// Nothing is under way in any cache.
  bool idle(Cycle now) const;

 private:
  const HardwareConfig* config_;
  Ports* ports_;
};

/// PUT_QUADS with lists behind caches: heads are changed, then their nodes written; records beside them.
class CachedPutClock {
 public:
  explicit CachedPutClock(const HardwareConfig& config);

  void expect(const topology::ListWork::Quad& quad) { expected_.push_back(quad); }
  /// One cycle; `corner`: one is offered; `nodes`: in use, and counted on. Returns whether it is taken.
  bool cycle(bool corner, Cycle now, const ListMemories& memories, std::uint32_t& nodes, Beat& beat);
  bool idle(Cycle now, const ListMemories& memories) const;

 private:
  using Quad = topology::ListWork::Quad;
  bool node_room(std::uint32_t nodes) const;
  bool link(Cycle now, const ListMemories& memories, std::uint32_t& nodes);
  bool record(Cycle now, const ListMemories& memories);
  bool write_node(Cycle now, const ListMemories& memories);
  void serve(Cycle now, const ListMemories& memories);

  std::uint32_t most_nodes_;
  FrontEnd front_;
  std::deque<Quad> expected_;  ///< quads whose corners are still on their way
  int corners_ = 0;
  std::optional<Quad> whole_;
  std::deque<Quad> queue_;
  std::uint64_t linked_ = 0;  ///< entries of the first one
  bool recorded_ = false;     ///< it has its record, or needs none
  std::size_t nodes_under_way_ = 0;
  std::deque<std::optional<std::uint32_t>> updates_;  ///< of heads: the node that comes with each
  struct Node {
    std::uint32_t index = 0;
    Cycle there = 0;
  };
  std::deque<Node> nodes_;  ///< to be written
};

/// RESOLVE_TOPOLOGY.
class WalkClock {
 public:
  /// Its first cycle is `now`; `cached`: lists lie behind caches.
  WalkClock(const HardwareConfig& config, const HardwareTiming& timing, Cycle now, bool cached);

  /// The voxels of the next items, as golden saw them; `kept`: their states go to the frame buffer.
  void expect(const topology::ListWork& work, bool kept, bool quiet);
  /// One cycle; `voxel`: one is offered, `room`: a result would be taken. Returns whether the voxel is taken.
  bool cycle(bool voxel, bool room, const ListMemories& memories, Beat& beat);
  /// The last cycle has given a result.
  bool gave() const { return gave_; }
  bool idle(const ListMemories& memories) const;

 private:
  static constexpr Cycle kNever = UINT64_MAX;
  struct Voxel {
    std::uint32_t visited = 0;
    std::size_t first = 0;       ///< its nodes in all_nodes_
    std::uint32_t u = 0, v = 0;  ///< of its entry
    Cycle done = kNever;         ///< the result of its walk is there from then on
    bool kept = false, quiet = false;
  };
  /// A walk on its way round: at node `node` of its voxel.
  struct Token {
    std::uint32_t voxel = 0, node = 0;
    Cycle ready = 0;  ///< what it waits for is there from then on
  };
  enum class Pick : std::uint8_t { New, Tested, Other };

  /// Reads of a memory under way, in order.
  struct Reads {
    std::deque<Token> tokens;
    std::size_t served = 0;  ///< of them, those whose entries are known to come

    bool there(Cycle now) const { return !tokens.empty() && tokens.front().ready <= now; }
    void leave() {
      tokens.pop_front();
      if (served != 0) --served;
    }
  };

  using Node = topology::ListWork::Node;
  const Node& node(const Token& token) const { return all_nodes_[voxels_[token.voxel].first + token.node]; }
  bool tested(const Token& token) const { return node(token).tested; }
  bool takes(const Reads& reads, CacheClock* cache, std::uint32_t line) const;
  void ask(Reads& reads, Token token, CacheClock* cache, std::uint32_t line, Cycle more);
  void serve(Reads& reads, CacheClock* cache, Cycle more, bool room);
  bool at_last(const Token& token) const { return token.node + 1 == voxels_[token.voxel].visited; }
  bool give_result(bool room);
  void end_walks();
  bool leave_seen(bool ends_full, const ListMemories& memories, bool& waits);
  bool see_node(bool seen_leaves);
  Pick choose() const;
  Token next_node(Pick pick, std::uint32_t first) const;
  void ask_node(Pick pick, const Token& token, const ListMemories& memories);

  Cycle now_ = 0, latency_, kept_until_ = 0;
  std::size_t places_;  ///< of the read ports' queues
  std::size_t walks_;   ///< at once
  FrontEnd front_;

  std::vector<Voxel> voxels_;
  std::vector<Node> all_nodes_;
  std::size_t offered_ = 0;          ///< the voxel that is taken next
  Reads heads_;                      ///< of the lists of voxels
  std::deque<std::uint32_t> order_;  ///< voxels whose head is known
  std::size_t walking_ = 0;          ///< numbers in use
  Reads nodes_, tests_;
  std::deque<Token> tested_queue_, other_queue_;
  std::deque<Token> ends_;  ///< told by a node without a test
  std::optional<Token> seen_, spare_;
  Pick pick_ = Pick::New;
  bool hold_ = false, gave_ = false;
};

}  // namespace gnomon::golden::cycles
