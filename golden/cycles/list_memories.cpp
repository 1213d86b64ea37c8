// SPDX-License-Identifier: Apache-2.0
// Topology mode's memories in lines, and PUT_QUADS behind caches.
#include <algorithm>
#include <bit>
#include <gnomon/golden/topology/codec.hpp>

#include "lists.hpp"
#include "plane_read.hpp"

namespace gnomon::golden::cycles {
namespace {

constexpr int kHeadPlaceLog2 = 3;   // entries a line, as a logarithm
constexpr int kLeastLinesLog2 = 3;  // of nodes and records
constexpr std::size_t kPlacedStages = 4, kPerspectiveStages = 8, kQueue = 8;
constexpr std::size_t kNodesOnTheirWay = 64;  // entries linked whose node is not written yet
constexpr Cycle kNodeStages = 2;  // from the service of a head's update until its node can be written

/// Entries a line, as a logarithm, of so many bits each; none is smaller than 64.
int places_log2(int bits) {
  constexpr int kLineBitsLog2 = 9, kMostLog2 = 3;
  return std::min(kMostLog2,
                  kLineBitsLog2 - static_cast<int>(std::bit_width(static_cast<unsigned>(bits - 1))));
}

int node_places(const HardwareConfig& config) {
  return places_log2(2 + config.nodes_log2 + config.depth_bits + config.quads_log2);
}

int record_places(const HardwareConfig& config) {
  constexpr int kCoordinates = 8;
  return places_log2(1 + 2 * config.span_log2 + kCoordinates * (config.span_log2 + config.sub_bits));
}

}  // namespace

int ListMemories::head_lines_log2(const HardwareConfig& config) {
  return 2 * config.plane_log2 - kHeadPlaceLog2;
}

int ListMemories::node_lines_log2(const HardwareConfig& config) {
  return std::max(config.nodes_log2 - node_places(config), kLeastLinesLog2);
}

int ListMemories::record_lines_log2(const HardwareConfig& config) {
  return std::max(config.quads_log2 - record_places(config), kLeastLinesLog2);
}

std::uint32_t ListMemories::head_line(std::uint32_t u, std::uint32_t v) const {
  return in_turns(u, v) >> kHeadPlaceLog2;
}

std::uint32_t ListMemories::node_line(std::uint32_t index) const {
  return index >> node_places(*config_);
}

std::uint32_t ListMemories::record_line(std::uint32_t number) const {
  return number >> record_places(*config_);
}

bool ListMemories::idle(Cycle now) const {
  return ports_ == nullptr ||
         (ports_->cache(CachedMemory::Heads).idle(now) && ports_->cache(CachedMemory::Nodes).idle(now) &&
          ports_->cache(CachedMemory::Records).idle(now));
}

CachedPutClock::CachedPutClock(const HardwareConfig& config)
    : most_nodes_(std::uint32_t{1} << config.nodes_log2),
      front_(kPlacedStages + (config.en_perspective ? kPerspectiveStages : 0)) {}

bool CachedPutClock::cycle(bool corner, Cycle now, const ListMemories& memories, std::uint32_t& nodes,
                           Beat& beat) {
  const bool leaves = whole_ && (whole_->entries() == 0 || queue_.size() < kQueue);
  const bool at_quad = front_.out() != FrontEnd::kNone;
  const bool moves = !at_quad || !whole_ || leaves;
  const bool there = !queue_.empty();
  const bool wants = there && linked_ != queue_.front().entries() && node_room(nodes);
  const bool links = wants && link(now, memories, nodes);
  const bool record_waits = there && !recorded_ && !record(now, memories);
  const bool node_waits = !nodes_.empty() && nodes_.front().there <= now && !write_node(now, memories);
  if (there && linked_ == queue_.front().entries() && recorded_) {
    queue_.pop_front();
    linked_ = 0;
    recorded_ = false;
  }
  if (leaves) {
    if (whole_->entries() != 0) queue_.push_back(*whole_);
    whole_.reset();
  }
  if (moves) {
    if (at_quad && ++corners_ == static_cast<int>(topology::kWordsPerQuad)) {
      corners_ = 0;
      whole_ = expected_.front();
      expected_.pop_front();
    }
    front_.move(corner ? 0 : FrontEnd::kNone);
  }
  serve(now, memories);
  const bool takes = corner && moves;
  if (links || takes)
    beat = Beat::Busy;
  else if ((wants && !links) || node_waits || record_waits)
    beat = Beat::MemoryWait;
  return takes;
}

/// There is room for the node of the first quad's next entry, or none comes.
bool CachedPutClock::node_room(std::uint32_t nodes) const {
  return !queue_.front().storable || nodes == most_nodes_ || nodes_under_way_ < kNodesOnTheirWay;
}

/// The first quad to its next entry.
bool CachedPutClock::link(Cycle now, const ListMemories& memories, std::uint32_t& nodes) {
  const Quad& quad = queue_.front();
  const bool linked = quad.storable && nodes < most_nodes_;
  const auto place = static_cast<std::uint32_t>(linked_);
  const std::uint32_t line = memories.head_line(quad.u + place % quad.columns, quad.v + place / quad.columns);
  if (!memories.cache(CachedMemory::Heads)->look_up({.line = line, .writes = true}, now).first) return false;
  updates_.push_back(linked ? std::optional(nodes) : std::nullopt);
  if (linked) {
    ++nodes;
    ++nodes_under_way_;
  }
  ++linked_;
  return true;
}

bool CachedPutClock::record(Cycle now, const ListMemories& memories) {
  const Quad& quad = queue_.front();
  recorded_ =
      !quad.storable || memories.cache(CachedMemory::Records)
                            ->look_up({.line = memories.record_line(quad.number), .writes = true}, now)
                            .first;
  return recorded_;
}

bool CachedPutClock::write_node(Cycle now, const ListMemories& memories) {
  const std::uint32_t line = memories.node_line(nodes_.front().index);
  if (!memories.cache(CachedMemory::Nodes)->look_up({.line = line, .writes = true}, now).first) return false;
  nodes_.pop_front();
  --nodes_under_way_;
  return true;
}

/// A head that is changed tells the node that goes with it.
void CachedPutClock::serve(Cycle now, const ListMemories& memories) {
  for (const CachedMemory memory : {CachedMemory::Nodes, CachedMemory::Records}) {
    CacheClock& cache = *memories.cache(memory);
    if (cache.ready(now)) cache.serve(now);
  }
  CacheClock& heads = *memories.cache(CachedMemory::Heads);
  if (!heads.ready(now)) return;
  heads.serve(now);
  if (updates_.front()) nodes_.push_back({*updates_.front(), now + kNodeStages});
  updates_.pop_front();
}

bool CachedPutClock::idle(Cycle now, const ListMemories& memories) const {
  return front_.idle() && !whole_ && queue_.empty() && nodes_under_way_ == 0 && memories.idle(now);
}

}  // namespace gnomon::golden::cycles
