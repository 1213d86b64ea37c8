// SPDX-License-Identifier: Apache-2.0
// Commands and their errors; a voxel from its item to its answer.
#include <algorithm>
#include <gnomon/golden/topology/unit.hpp>
#include <stdexcept>

namespace gnomon::golden::topology {
namespace {

Projected negated(const Projected& p) {
  return {-p.u, -p.v, -p.d};
}

}  // namespace

TopologyError TopologyUnit::check(std::uint8_t op, std::uint8_t flags, std::uint32_t arg,
                                  std::size_t count) const {
  if (!is_topology_op(op)) return TopologyError::UnknownOp;
  const auto known = static_cast<TopologyOp>(op);
  if ((flags & ~known_flags(known)) != 0) return TopologyError::ReservedFlag;
  const bool bad = bad_argument(known, arg, count, lists_.config());
  return bad ? TopologyError::BadArgument : TopologyError::None;
}

TopologyOutcome TopologyUnit::execute(std::uint8_t op, std::uint8_t flags, std::uint32_t arg,
                                      std::span<const Word> items) {
  TopologyOutcome outcome = begin(op, flags, arg, items.size());
  if (outcome.error != TopologyError::None) return outcome;
  const std::vector<Word> results = take(items);
  outcome.results.insert(outcome.results.end(), results.begin(), results.end());
  return outcome;
}

TopologyOutcome TopologyUnit::begin(std::uint8_t op, std::uint8_t flags, std::uint32_t arg,
                                    std::size_t count) {
  if (const auto error = check(op, flags, arg, count); error != TopologyError::None) return {error, {}};
  op_ = static_cast<TopologyOp>(op);
  flags_ = flags;
  clearance_ = arg & lists_.config().no_depth();
  items_left_ = count;
  corner_count_ = 0;
  TopologyOutcome outcome;
  if (op_ == TopologyOp::ClearLists) lists_.clear();
  if (op_ == TopologyOp::ReadLists) {
    const EntryRange range = decode_entry_range(arg);
    for (std::uint32_t i = range.first; i < range.first + range.count; ++i)
      outcome.results.push_back(encode(ListHeadResult{i, lists_.head(i)}));
  }
  return outcome;
}

std::vector<Word> TopologyUnit::take(std::span<const Word> items) {
  if (items.size() > items_left_) throw std::logic_error("more items than the command has");
  items_left_ -= items.size();
  std::vector<Word> results;
  if (op_ == TopologyOp::PutQuads) {
    for (const Word word : items) {
      corners_.at(corner_count_++) = decode_item(word, lists_.config());
      if (corner_count_ < kWordsPerQuad) continue;
      corner_count_ = 0;
      put(corners_);
    }
  } else if (op_ == TopologyOp::ResolveTopology) {
    results.reserve(items.size());
    for (const Word word : items)
      results.push_back(encode(resolve(decode_item(word, lists_.config()), (flags_ & kTwoSided) != 0,
                                       clearance_, (flags_ & kSorted) != 0)));
  }
  return results;
}

Projected TopologyUnit::project(const Item& item) const {
  const auto& m = registers_.matrix;
  const Projected linear = [&] {
    const auto row = [&](std::size_t first) {
      return m[first] * item.position[0] + m[first + 1] * item.position[1] + m[first + 2] * item.position[2];
    };
    return Projected{row(0), row(4), row(8)};
  }();
  return {linear.u + m[3], linear.v + m[7], linear.d + m[11]};
}

Projected TopologyUnit::gradient(const Item& item) const {
  const auto& m = registers_.matrix;
  const auto row = [&](std::size_t first) {
    return m[first] * item.normal[0] + m[first + 1] * item.normal[1] + m[first + 2] * item.normal[2];
  };
  return {row(0), row(4), row(8)};
}

void TopologyUnit::put(const std::array<Item, 4>& corners) {
  std::array<Corner, 4> landed;
  std::transform(corners.begin(), corners.end(), landed.begin(),
                 [&](const Item& item) { return land_corner(project(item), lists_.config()); });
  lists_.put(landed);
}

TopologyResult TopologyUnit::resolve(const Item& voxel, bool two_sided, std::uint32_t clearance,
                                     bool sorted) {
  TopologyCounters& counters = lists_.counters();
  ++counters.resolved;
  TopologyResult result;
  Projected normal = gradient(voxel);
  if (two_sided && normal.d > 0) normal = negated(normal);
  result.facing_away = normal.d >= 0;
  if (result.facing_away) {
    result.shadow = true;
    ++counters.facing_away;
    ++counters.shadow;
    return result;
  }
  const Beam beam = land_beam(project(voxel), normal, registers_.offset_factor, lists_.config());
  result.off_plane = !beam.on_plane;
  if (result.off_plane) {
    ++counters.off_plane;
    return result;
  }
  const Walk walk = lists_.walk(beam, clearance, sorted);
  result.uncertain = walk.uncertain;
  result.hit = walk.hit;
  result.fallback = walk.fallback;
  result.shadow = walk.hit || walk.fallback;
  result.quad = walk.quad;
  result.visited = static_cast<std::uint32_t>(std::min<std::uint64_t>(walk.visited, kMostCounted));
  result.tested = static_cast<std::uint32_t>(std::min<std::uint64_t>(walk.tested, kMostCounted));
  counters.uncertain += walk.uncertain ? 1U : 0U;
  counters.hit += walk.hit ? 1U : 0U;
  counters.fallback += walk.fallback ? 1U : 0U;
  counters.shadow += result.shadow ? 1U : 0U;
  return result;
}

}  // namespace gnomon::golden::topology
