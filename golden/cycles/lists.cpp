// SPDX-License-Identifier: Apache-2.0
// What each part does in a cycle is decided from what the cycles before left, as in the hardware.
#include "lists.hpp"

#include <algorithm>
#include <bit>
#include <gnomon/golden/topology/codec.hpp>

namespace gnomon::golden::cycles {
namespace {

constexpr std::size_t kPlacedStages = 4;  // from an item's cycle to its place on the plane
constexpr std::size_t kMovedStages = 6;   // ... to its lifted point
constexpr std::size_t kPerspectiveStages = 8;
constexpr Cycle kTestStages = 4;
constexpr std::size_t kOrderPerWalk = 4;   // voxels that wait in order
constexpr std::size_t kEnds = 4;           // ends that a node told, waiting for a gap
constexpr Cycle kWritten = 2;              // an update, until its memory is idle; and the latency
constexpr std::size_t kCachedWalks = 256;  // walks at once with lists behind caches
constexpr std::size_t kCachedEntries = 4;  // places for what such a memory gives
constexpr Cycle kServedStages = 2;         // from the service of a read until it is there

std::size_t front_stages(const HardwareConfig& config, std::size_t stages) {
  return stages + (config.en_perspective ? kPerspectiveStages : 0);
}

}  // namespace

void FrontEnd::move(std::uint32_t item) {
  if (stages_[next_] != kNone) --items_;
  if (item != kNone) ++items_;
  stages_[next_] = item;
  next_ = (next_ + 1) % stages_.size();
}

PutClock::PutClock(const HardwareConfig& config, const HardwareTiming& timing)
    : latency_(static_cast<Cycle>(timing.memory_latency)), front_(front_stages(config, kPlacedStages)) {}

bool PutClock::cycle(bool corner, Beat& beat) {
  const bool links = !queue_.empty();
  const bool leaves = whole_ && (*whole_ == 0 || queue_.size() < kQueue);
  const bool at_quad = front_.out() != FrontEnd::kNone;
  const bool moves = !at_quad || !whole_ || leaves;

  if (leaves) {
    if (*whole_ != 0) queue_.push_back(*whole_);
    whole_.reset();
  }
  if (links) {
    if (--queue_.front() == 0) queue_.pop_front();
    written_ = now_ + latency_ + kWritten;
  }
  if (moves) {
    if (at_quad && ++corners_ == static_cast<int>(topology::kWordsPerQuad)) {
      corners_ = 0;
      whole_ = expected_.front();
      expected_.pop_front();
    }
    front_.move(corner ? 0 : FrontEnd::kNone);
  }
  const bool takes = corner && moves;
  if (links || takes) beat = Beat::Busy;
  ++now_;
  return takes;
}

bool PutClock::idle() const {
  return front_.idle() && !whole_ && queue_.empty() && written_ <= now_;
}

WalkClock::WalkClock(const HardwareConfig& config, const HardwareTiming& timing, Cycle now, bool cached)
    : now_(now),
      latency_(static_cast<Cycle>(timing.memory_latency)),
      places_(std::bit_ceil(static_cast<std::size_t>(timing.memory_latency) + 3)),
      walks_(cached ? kCachedWalks : std::bit_ceil(2 * static_cast<std::size_t>(timing.memory_latency) + 48)),
      front_(front_stages(config, kMovedStages)) {}

void WalkClock::expect(const topology::ListWork& work, bool kept, bool quiet) {
  std::size_t first = all_nodes_.size();
  for (const topology::ListWork::Voxel& voxel : work.voxels) {
    voxels_.push_back(
        {.visited = voxel.visited, .first = first, .u = voxel.u, .v = voxel.v, .kept = kept, .quiet = quiet});
    first += voxel.visited;
  }
  all_nodes_.insert(all_nodes_.end(), work.nodes.begin(), work.nodes.end());
}

/// A read of this line would be taken.
bool WalkClock::takes(const Reads& reads, CacheClock* cache, std::uint32_t line) const {
  return cache != nullptr ? cache->takes({.line = line}, now_) : reads.tokens.size() < places_;
}

/// `more`: cycles from the entry until the token is wanted.
void WalkClock::ask(Reads& reads, Token token, CacheClock* cache, std::uint32_t line, Cycle more) {
  token.ready = cache != nullptr ? kNever : now_ + latency_ + 1 + more;
  if (cache != nullptr) cache->look_up({.line = line}, now_);
  reads.tokens.push_back(token);
}

/// The oldest read of a memory behind a cache is served, if there is room for what it gives.
void WalkClock::serve(Reads& reads, CacheClock* cache, Cycle more, bool room) {
  if (cache == nullptr || !room || !cache->ready(now_)) return;
  reads.tokens[reads.served++].ready = now_ + kServedStages + more;
  cache->serve(now_);
}

/// The oldest voxel's result leaves, if its walk is done; returns whether it is held back.
bool WalkClock::give_result(bool room) {
  gave_ = false;
  if (order_.empty()) return false;
  const Voxel& voxel = voxels_[order_.front()];
  if (voxel.visited != 0 && voxel.done > now_) return false;
  if (!voxel.quiet && !room) return true;
  gave_ = !voxel.quiet;
  if (voxel.visited != 0) --walking_;
  if (voxel.kept) kept_until_ = now_ + latency_ + kWritten;
  order_.pop_front();
  return false;
}

/// A test's end sends its walk on or ends it; an end that a node told comes where no test ends a walk.
void WalkClock::end_walks() {
  const bool tells = !ends_.empty();
  bool done = false;
  if (tests_.there(now_)) {
    const Token token = tests_.tokens.front();
    tests_.leave();
    done = at_last(token);
    if (done)
      voxels_[token.voxel].done = now_ + 1;
    else
      tested_queue_.push_back(token);
  }
  if (!tells || done) return;
  voxels_[ends_.front().voxel].done = now_ + 1;
  ends_.pop_front();
}

/// The node that was looked at goes on: to its test, to the end of its walk, to the next node.
bool WalkClock::leave_seen(bool ends_full, const ListMemories& memories, bool& waits) {
  if (!seen_) return true;
  const Token token = *seen_;
  if (tested(token)) {
    CacheClock* const cache = memories.cache(CachedMemory::Records);
    const std::uint32_t line = memories.record_line(node(token).quad);
    waits = cache != nullptr && !takes(tests_, cache, line);
    if (waits) return false;
    ask(tests_, token, cache, line, kTestStages);
  } else if (!at_last(token)) {
    other_queue_.push_back(token);
  } else if (!ends_full) {
    ends_.push_back(token);
  } else {
    return false;
  }
  return true;
}

/// Nodes come into a register and a spare one.
bool WalkClock::see_node(bool seen_leaves) {
  std::optional<Token> node;
  if (nodes_.there(now_) && !spare_) {
    node = nodes_.tokens.front();
    nodes_.leave();
  }
  if (seen_leaves) {
    seen_ = spare_ ? spare_ : node;
    spare_.reset();
  } else if (node) {
    spare_ = node;
  }
  return node.has_value();
}

WalkClock::Pick WalkClock::choose() const {
  if (hold_) return pick_;
  if (!tested_queue_.empty() && !(!other_queue_.empty() && pick_ == Pick::Tested)) return Pick::Tested;
  return other_queue_.empty() ? Pick::New : Pick::Other;
}

/// The next node of a walk that goes on, or the first one of a new walk.
WalkClock::Token WalkClock::next_node(Pick pick, std::uint32_t first) const {
  if (pick == Pick::New) return {first, 0, 0};
  Token token = pick == Pick::Tested ? tested_queue_.front() : other_queue_.front();
  ++token.node;
  return token;
}

void WalkClock::ask_node(Pick pick, const Token& token, const ListMemories& memories) {
  if (pick != Pick::New) (pick == Pick::Tested ? tested_queue_ : other_queue_).pop_front();
  ask(nodes_, token, memories.cache(CachedMemory::Nodes), memories.node_line(node(token).index), 0);
}

bool WalkClock::cycle(bool voxel, bool room, const ListMemories& memories, Beat& beat) {
  CacheClock* const head_cache = memories.cache(CachedMemory::Heads);
  CacheClock* const node_cache = memories.cache(CachedMemory::Nodes);
  // What the cycles before left.
  const bool order_room = order_.size() < kOrderPerWalk * walks_;
  const bool walk_free = walking_ < walks_;
  const bool head = heads_.there(now_);
  const std::uint32_t first = head ? heads_.tokens.front().voxel : 0;
  const bool walked = head && voxels_[first].visited != 0;
  const bool begins = walked && walk_free && order_room;
  const Pick pick = choose();
  const bool asks = !tested_queue_.empty() || !other_queue_.empty() || begins;
  const Token next = asks ? next_node(pick, first) : Token{};
  const bool asked = asks && takes(nodes_, node_cache, memories.node_line(node(next).index));
  const bool head_leaves = head && order_room && (!walked || (walk_free && asked && pick == Pick::New));
  const bool reads = front_.out() != FrontEnd::kNone;
  const std::uint32_t line = reads ? memories.head_line(voxels_[front_.out()].u, voxels_[front_.out()].v) : 0;
  const bool read = reads && takes(heads_, head_cache, line);
  const bool moves = !reads || read;
  const bool ends_full = ends_.size() == kEnds;
  const bool head_room = heads_.served < kCachedEntries, node_room = nodes_.served < kCachedEntries;
  bool record_waits = false;

  const bool blocked = give_result(room);
  if (asks && asked) ask_node(pick, next, memories);
  hold_ = asks && !asked;
  pick_ = pick;
  end_walks();
  const bool visits = see_node(leave_seen(ends_full, memories, record_waits));
  if (head_leaves) {
    order_.push_back(first);
    if (walked) ++walking_;
    heads_.leave();
  }
  const bool takes_voxel = voxel && moves;
  if (moves) {
    if (reads) ask(heads_, {front_.out(), 0, 0}, head_cache, line, 0);
    front_.move(takes_voxel ? static_cast<std::uint32_t>(offered_++) : FrontEnd::kNone);
  }
  serve(heads_, head_cache, 0, head_room);
  serve(nodes_, node_cache, 0, node_room);
  serve(tests_, memories.cache(CachedMemory::Records), kTestStages, true);
  if (visits || takes_voxel)
    beat = Beat::Busy;
  else if (blocked)
    beat = Beat::Blocked;
  else if ((reads && !read) || (asks && !asked) || record_waits)
    beat = Beat::MemoryWait;
  ++now_;
  return takes_voxel;
}

bool WalkClock::idle(const ListMemories& memories) const {
  return front_.idle() && heads_.tokens.empty() && order_.empty() && kept_until_ <= now_ &&
         memories.idle(now_);
}

}  // namespace gnomon::golden::cycles
