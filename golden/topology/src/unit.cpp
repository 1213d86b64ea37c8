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
  const std::uint32_t most = registers_.perspective.perspective ? (1u << perspective::kClearanceBits) - 1
                                                                : lists_.config().no_depth();
  clearance_ = arg & most;
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

perspective::View TopologyUnit::view() const {
  const TopologyConfig& config = lists_.config();
  return {{.position_bits = config.position_bits(),
           .matrix_frac_bits = config.matrix_frac_bits,
           .depth_bits = config.depth_bits,
           .plane_log2 = config.plane_log2},
          registers_.perspective};
}

void TopologyUnit::put(const std::array<Item, 4>& corners) {
  if (registers_.perspective.perspective) return put_in_perspective(corners);
  std::array<Corner, 4> landed;
  std::transform(corners.begin(), corners.end(), landed.begin(),
                 [&](const Item& item) { return land_corner(project(item), lists_.config()); });
  lists_.put(landed);
}

void TopologyUnit::put_in_perspective(const std::array<Item, 4>& corners) {
  const perspective::View light = view();
  std::array<Corner, 4> landed;
  std::size_t behind = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Projected point = project(corners[i]);
    const perspective::Sight sight = light.see(point.u, point.v, corners[i].position);
    if (sight.behind)
      ++behind;
    else
      landed[i] = land_corner(sight, lists_.config());
  }
  if (behind > 0) return lists_.put_behind(behind == corners.size());
  lists_.put(landed);
}

TopologyResult TopologyUnit::resolve(const Item& voxel, bool two_sided, std::uint32_t clearance,
                                     bool sorted) {
  lists_.note_voxel();
  const TopologyResult result = registers_.perspective.perspective
                                    ? answer_in_perspective(voxel, two_sided, clearance, sorted)
                                    : answer(voxel, two_sided, clearance, sorted);
  count(result);
  return result;
}

TopologyResult TopologyUnit::answer(const Item& voxel, bool two_sided, std::uint32_t clearance, bool sorted) {
  Projected normal = gradient(voxel);
  if (two_sided && normal.d > 0) normal = negated(normal);
  const bool away = normal.d >= 0;
  if (away && !lists_.watched()) return {.shadow = true, .facing_away = true};
  const Beam beam = land_beam(project(voxel), normal, registers_.offset_factor, lists_.config());
  lists_.note_beam(beam);
  if (away) return {.shadow = true, .facing_away = true};
  return walk(beam, clearance, sorted);
}

TopologyResult TopologyUnit::answer_in_perspective(const Item& voxel, bool two_sided, std::uint32_t clearance,
                                                   bool sorted) {
  const perspective::View light = view();
  const Projected point = project(voxel);
  const perspective::Sight sight = light.see(point.u, point.v, voxel.position);
  if (sight.behind) return {.shadow = true, .behind = true};
  const bool outside = light.outside_cone(sight);
  if (outside && !lists_.watched()) return {.shadow = true, .outside_cone = true};
  const Projected normal = gradient(voxel);
  perspective::Slope slope = light.slope(normal.u, normal.v, voxel);
  if (two_sided && slope.d > 0) slope = -slope;
  const bool away = slope.d >= 0;
  if (away && !lists_.watched()) return {.shadow = true, .facing_away = true};
  const perspective::Moved moved = light.move(sight, slope, registers_.offset_factor, clearance);
  const Beam beam = land_beam(moved, lists_.config());
  lists_.note_beam(beam);
  if (outside) return {.shadow = true, .outside_cone = true};
  if (away) return {.shadow = true, .facing_away = true};
  return walk(beam, 0, sorted);
}

TopologyResult TopologyUnit::walk(const Beam& beam, std::uint32_t clearance, bool sorted) {
  if (!beam.on_plane) return {.off_plane = true};
  const Walk walk = lists_.walk(beam, clearance, sorted);
  const auto counted = [](std::uint64_t n) {
    return static_cast<std::uint32_t>(std::min<std::uint64_t>(n, kMostCounted));
  };
  return {.shadow = walk.hit || walk.fallback,
          .uncertain = walk.uncertain,
          .hit = walk.hit,
          .fallback = walk.fallback,
          .quad = walk.quad,
          .visited = counted(walk.visited),
          .tested = counted(walk.tested)};
}

void TopologyUnit::count(const TopologyResult& result) {
  TopologyCounters& counters = lists_.counters();
  ++counters.resolved;
  counters.behind += result.behind ? 1U : 0U;
  counters.outside_cone += result.outside_cone ? 1U : 0U;
  counters.facing_away += result.facing_away ? 1U : 0U;
  counters.off_plane += result.off_plane ? 1U : 0U;
  counters.uncertain += result.uncertain ? 1U : 0U;
  counters.hit += result.hit ? 1U : 0U;
  counters.fallback += result.fallback ? 1U : 0U;
  counters.shadow += result.shadow ? 1U : 0U;
}

}  // namespace gnomon::golden::topology
