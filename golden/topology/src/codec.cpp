// SPDX-License-Identifier: Apache-2.0
// The bits of the mode's words.
#include <algorithm>
#include <gnomon/golden/topology/codec.hpp>

namespace gnomon::golden::topology {
namespace {

constexpr int kCode = 56;
constexpr int kState = 54, kFacingAway = 53, kOffPlane = 52, kUncertain = 51, kHit = 50, kFallback = 49,
              kUnreached = 48;
constexpr int kQuad = 24, kVisited = 12;
constexpr int kIndex = 32, kPresent = 31, kLinked = 30, kDropped = 29;

bool bit(Word word, int position) {
  return (word >> position & 1) != 0;
}
Word flag(bool value, int position) {
  return Word{value} << position;
}
std::uint32_t field(Word word, int position, int width) {
  return static_cast<std::uint32_t>(word >> position & ((Word{1} << width) - 1));
}

std::string named(const char* name, std::uint64_t value) {
  return std::string(" ") + name + "=" + std::to_string(value);
}

}  // namespace

std::uint32_t encode(const TopologySticky& sticky) {
  return (sticky.depth_saturated ? kStickyDepthSaturated : 0) |
         (sticky.list_overflow ? kStickyListOverflow : 0) |
         (sticky.quad_off_plane ? kStickyQuadOffPlane : 0) | (sticky.behind_light ? kStickyBehindLight : 0);
}

Item decode_item(Word word, const TopologyConfig& config) {
  const int p = config.position_bits(), n = config.normal_bits;
  Item item;
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    item.position[i] = field(word, axis * p, p);
    const std::uint32_t normal = field(word, 3 * p + axis * n, n);
    const std::uint32_t sign = normal >> (n - 1) & 1;
    item.normal[i] = static_cast<std::int32_t>(normal) - static_cast<std::int32_t>(sign << n);
  }
  return item;
}

Word encode(const TopologyResult& r) {
  const Word state = r.shadow ? 2 : 1;
  return Word{kStateCode} << kCode | state << kState | flag(r.facing_away, kFacingAway) |
         flag(r.off_plane, kOffPlane) | flag(r.uncertain, kUncertain) | flag(r.hit, kHit) |
         flag(r.fallback || r.behind, kFallback) | flag(r.outside_cone || r.behind, kUnreached) |
         Word{r.quad & kNoQuad} << kQuad | Word{std::min(r.visited, kMostCounted)} << kVisited |
         std::min(r.tested, kMostCounted);
}

TopologyResult decode_topology_result(Word word) {
  const bool unreached = bit(word, kUnreached), why = bit(word, kFallback);
  return {.shadow = field(word, kState, 2) == 2,
          .facing_away = bit(word, kFacingAway),
          .off_plane = bit(word, kOffPlane),
          .uncertain = bit(word, kUncertain),
          .hit = bit(word, kHit),
          .fallback = !unreached && why,
          .outside_cone = unreached && !why,
          .behind = unreached && why,
          .quad = field(word, kQuad, 24),
          .visited = field(word, kVisited, 12),
          .tested = field(word, 0, 12)};
}

Word encode(const ListHeadResult& r) {
  return Word{kListHeadCode} << kCode | Word{r.index & 0xFFFFFF} << kIndex | flag(r.head.present, kPresent) |
         flag(r.head.linked, kLinked) | flag(r.head.dropped, kDropped) | r.head.near;
}

ListHeadResult decode_list_head(Word word) {
  return {.index = field(word, kIndex, 24),
          .head = {.present = bit(word, kPresent),
                   .linked = bit(word, kLinked),
                   .dropped = bit(word, kDropped),
                   .near = field(word, 0, 24)}};
}

std::string describe_topology_result(Word word) {
  if (word >> kCode == kListHeadCode) {
    const auto [index, head] = decode_list_head(word);
    return "LIST_HEAD" + named("entry", index) + named("present", head.present) +
           named("linked", head.linked) + named("dropped", head.dropped) + named("near", head.near);
  }
  const TopologyResult r = decode_topology_result(word);
  return "TOPOLOGY_STATE" + named("state", field(word, kState, 2)) + named("facing_away", r.facing_away) +
         named("off_plane", r.off_plane) + named("uncertain", r.uncertain) + named("hit", r.hit) +
         named("fallback", r.fallback) + (r.outside_cone ? named("outside_cone", 1) : "") +
         (r.behind ? named("behind", 1) : "") + named("quad", r.quad) + named("visited", r.visited) +
         named("tested", r.tested);
}

std::uint8_t known_flags(TopologyOp op) {
  return op == TopologyOp::ResolveTopology ? kTwoSided | kSorted : 0;
}

bool bad_argument(TopologyOp op, std::uint32_t arg, std::size_t count, const TopologyConfig& config) {
  switch (op) {
    case TopologyOp::ClearLists:
      return count != 0;
    case TopologyOp::PutQuads:
      return count % kWordsPerQuad != 0;
    case TopologyOp::ReadLists: {
      const EntryRange range = decode_entry_range(arg);
      return count != 0 || std::int64_t{range.first} + range.count > config.side() * config.side();
    }
    case TopologyOp::ResolveTopology:
      break;
  }
  return false;
}

std::uint32_t result_words(TopologyOp op, std::uint32_t arg, std::size_t count) {
  if (op == TopologyOp::ResolveTopology) return static_cast<std::uint32_t>(count);
  return op == TopologyOp::ReadLists ? decode_entry_range(arg).count : 0;
}

std::uint32_t encode(const EntryRange& range) {
  return ((range.count - 1) & 0xFF) << 24 | (range.first & 0xFFFFFF);
}

EntryRange decode_entry_range(std::uint32_t arg) {
  return {.first = arg & 0xFFFFFF, .count = (arg >> 24) + 1};
}

}  // namespace gnomon::golden::topology
