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
constexpr std::size_t kOrderPerWalk = 4;  // voxels that wait in order
constexpr std::size_t kEnds = 4;          // ends that a node told, waiting for a gap
constexpr Cycle kWritten = 2;             // an update, until its memory is idle; and the latency

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

WalkClock::WalkClock(const HardwareConfig& config, const HardwareTiming& timing)
    : latency_(static_cast<Cycle>(timing.memory_latency)),
      places_(std::bit_ceil(static_cast<std::size_t>(timing.memory_latency) + 3)),
      walks_(std::bit_ceil(2 * static_cast<std::size_t>(timing.memory_latency) + 48)),
      front_(front_stages(config, kMovedStages)) {}

void WalkClock::expect(const topology::ListWork& work, bool kept, bool quiet) {
  std::size_t first = tested_.size();
  for (const std::uint32_t visited : work.voxels) {
    voxels_.push_back({visited, first, kNever, kept, quiet});
    first += visited;
  }
  tested_.insert(tested_.end(), work.tested.begin(), work.tested.end());
}

/// The oldest voxel's result leaves, if its walk is done.
void WalkClock::give_result(bool room) {
  gave_ = false;
  if (order_.empty()) return;
  const Voxel& voxel = voxels_[order_.front()];
  if (voxel.visited != 0 && voxel.done > now_) return;
  if (!voxel.quiet && !room) return;
  gave_ = !voxel.quiet;
  if (voxel.visited != 0) --walking_;
  if (voxel.kept) kept_until_ = now_ + latency_ + kWritten;
  order_.pop_front();
}

/// A test's end sends its walk on or ends it; an end that a node told comes where no test ends a walk.
void WalkClock::end_walks() {
  const bool tells = !ends_.empty();
  bool done = false;
  if (!tests_.empty() && tests_.front().ready == now_) {
    const Token token = tests_.front();
    tests_.pop_front();
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
bool WalkClock::leave_seen(bool ends_full) {
  if (!seen_) return true;
  Token token = *seen_;
  if (tested(token)) {
    token.ready = now_ + latency_ + 1 + kTestStages;
    tests_.push_back(token);
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
  if (!nodes_.empty() && nodes_.front().ready <= now_ && !spare_) {
    node = nodes_.front();
    nodes_.pop_front();
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

/// The next node of a walk that goes on, or the first one of a new walk, is asked for.
void WalkClock::ask_node(Pick pick, std::uint32_t first) {
  Token token{first, 0, 0};
  if (pick != Pick::New) {
    std::deque<Token>& queue = pick == Pick::Tested ? tested_queue_ : other_queue_;
    token = queue.front();
    queue.pop_front();
    ++token.node;
  }
  token.ready = now_ + latency_ + 1;
  nodes_.push_back(token);
}

bool WalkClock::cycle(bool voxel, bool room, Beat& beat) {
  // What the cycles before left.
  const bool order_room = order_.size() < kOrderPerWalk * walks_;
  const bool walk_free = walking_ < walks_;
  const bool head = !heads_.empty() && heads_.front().ready <= now_;
  const bool walked = head && voxels_[heads_.front().voxel].visited != 0;
  const bool begins = walked && walk_free && order_room;
  const Pick pick = choose();
  const bool asks = !tested_queue_.empty() || !other_queue_.empty() || begins;
  const bool asked = nodes_.size() < places_;
  const bool head_leaves = head && order_room && (!walked || (walk_free && asked && pick == Pick::New));
  const bool reads = front_.out() != FrontEnd::kNone;
  const bool read = heads_.size() < places_;
  const bool moves = !reads || read;
  const bool ends_full = ends_.size() == kEnds;

  give_result(room);
  if (asks && asked) ask_node(pick, head ? heads_.front().voxel : 0);
  hold_ = asks && !asked;
  pick_ = pick;
  end_walks();
  const bool visits = see_node(leave_seen(ends_full));
  if (head_leaves) {
    order_.push_back(heads_.front().voxel);
    if (walked) ++walking_;
    heads_.pop_front();
  }
  const bool takes = voxel && moves;
  if (moves) {
    if (reads) heads_.push_back({front_.out(), 0, now_ + latency_ + 1});
    front_.move(takes ? static_cast<std::uint32_t>(offered_++) : FrontEnd::kNone);
  }
  if (visits || takes)
    beat = Beat::Busy;
  else if ((reads && !read) || (asks && !asked))
    beat = Beat::MemoryWait;
  ++now_;
  return takes;
}

bool WalkClock::idle() const {
  return front_.idle() && heads_.empty() && order_.empty() && kept_until_ <= now_;
}

}  // namespace gnomon::golden::cycles
