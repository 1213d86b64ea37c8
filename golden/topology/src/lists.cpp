// SPDX-License-Identifier: Apache-2.0
// Heads, nodes and records; lists are pushed in front.
#include <algorithm>
#include <gnomon/golden/topology/beam_test.hpp>
#include <gnomon/golden/topology/lists.hpp>
#include <stdexcept>

namespace gnomon::golden::topology {
namespace {

TopologyConfig checked(const TopologyConfig& config) {
  if (const auto error = config.check()) throw std::invalid_argument(*error);
  return config;
}

}  // namespace

std::vector<std::pair<std::string, std::uint64_t>> named(const TopologyCounters& c, bool perspective) {
  std::vector<std::pair<std::string, std::uint64_t>> counts = {{"QUADS_PUT", c.quads_put},
                                                               {"QUADS_OFF_PLANE", c.quads_off_plane},
                                                               {"QUADS_TOO_LARGE", c.quads_too_large},
                                                               {"QUADS_SATURATED", c.quads_saturated},
                                                               {"NODES_LINKED", c.nodes_linked},
                                                               {"NODES_DROPPED", c.nodes_dropped},
                                                               {"TOPOLOGY_RESOLVED", c.resolved},
                                                               {"TOPOLOGY_FACING_AWAY", c.facing_away},
                                                               {"TOPOLOGY_OFF_PLANE", c.off_plane},
                                                               {"TOPOLOGY_UNCERTAIN", c.uncertain},
                                                               {"TOPOLOGY_HIT", c.hit},
                                                               {"TOPOLOGY_FALLBACK", c.fallback},
                                                               {"TOPOLOGY_SHADOW", c.shadow},
                                                               {"NODES_VISITED", c.nodes_visited},
                                                               {"QUADS_TESTED", c.quads_tested}};
  if (perspective) {
    counts.emplace_back("QUADS_BEHIND", c.quads_behind);
    counts.emplace_back("QUADS_STRADDLING", c.quads_straddling);
    counts.emplace_back("TOPOLOGY_BEHIND", c.behind);
    counts.emplace_back("TOPOLOGY_OUTSIDE_CONE", c.outside_cone);
  }
  return counts;
}

QuadLists::QuadLists(const TopologyConfig& config)
    : config_(checked(config)), heads_(std::size_t{1} << (2 * config.plane_log2)) {}

void QuadLists::clear() {
  ++generation_;
  // The hardware scrubs a part of the heads with each clear; here it is done once in 2^32 clears.
  if (generation_ == 0) {
    std::fill(heads_.begin(), heads_.end(), Head{});
    generation_ = 1;
  }
  numbered_ = 0;
  nodes_.clear();
  records_.clear();
}

void QuadLists::reset() {
  clear();
  counters_ = {};
  sticky_ = {};
}

std::uint32_t QuadLists::next_number() {
  const std::uint32_t number = numbered_;
  numbered_ = std::min(numbered_ + 1, kNoQuad);
  return number;
}

void QuadLists::put_behind(bool all_corners) {
  next_number();
  ++counters_.quads_put;
  ++(all_corners ? counters_.quads_behind : counters_.quads_straddling);
  sticky_.behind_light = true;
  note_quad({});
}

QuadLists::Box QuadLists::box_of(const std::array<Corner, 4>& corners, int sub_bits) {
  const auto [u0, u1] = std::minmax_element(corners.begin(), corners.end(),
                                            [](const Corner& a, const Corner& b) { return a.u < b.u; });
  const auto [v0, v1] = std::minmax_element(corners.begin(), corners.end(),
                                            [](const Corner& a, const Corner& b) { return a.v < b.v; });
  return {{u0->u >> sub_bits, u1->u >> sub_bits}, {v0->v >> sub_bits, v1->v >> sub_bits}};
}

bool QuadLists::meets_plane(const std::array<Corner, 4>& corners, const Box& box, const Box& clipped) {
  ++counters_.quads_put;
  if (box != clipped) sticky_.quad_off_plane = true;
  if (clipped.u.low > clipped.u.high || clipped.v.low > clipped.v.high) {
    ++counters_.quads_off_plane;
    return false;
  }
  if (std::any_of(corners.begin(), corners.end(), [](const Corner& c) { return c.saturated; })) {
    ++counters_.quads_saturated;
    sticky_.depth_saturated = true;
  }
  return true;
}

void QuadLists::put(const std::array<Corner, 4>& corners) {
  const std::uint32_t number = next_number();
  const Box box = box_of(corners, config_.sub_bits);
  const auto clip = [&](const Range& r) {
    return Range{std::max<std::int64_t>(r.low, 0), std::min(r.high, config_.side() - 1)};
  };
  const Box clipped{clip(box.u), clip(box.v)};
  if (!meets_plane(corners, box, clipped)) return note_quad({});

  const std::int64_t span = std::int64_t{1} << config_.span_log2;
  const bool small = box.u.high - box.u.low < span && box.v.high - box.v.low < span;
  if (!small) ++counters_.quads_too_large;
  const bool storable = small && number < std::min(std::uint32_t{1} << config_.quads_log2, kNoQuad);
  const auto size = [](const Range& r) { return static_cast<std::uint32_t>(r.high - r.low + 1); };
  note_quad({.number = number,
             .u = static_cast<std::uint32_t>(clipped.u.low),
             .v = static_cast<std::uint32_t>(clipped.v.low),
             .columns = size(clipped.u),
             .rows = size(clipped.v),
             .storable = storable});
  if (storable) {
    records_.resize(number + std::size_t{1});
    for (std::size_t i = 0; i < 4; ++i) records_[number][i] = {corners[i].u, corners[i].v};
  }
  std::uint32_t far = 0;
  for (const Corner& c : corners) far = std::max(far, c.depth);
  for (std::int64_t v = clipped.v.low; v <= clipped.v.high; ++v)
    for (std::int64_t u = clipped.u.low; u <= clipped.u.high; ++u)
      link((static_cast<std::size_t>(v) << config_.plane_log2) + static_cast<std::size_t>(u), number, far,
           storable);
}

void QuadLists::link(std::size_t index, std::uint32_t quad, std::uint32_t far, bool storable) {
  Head& head = heads_[index];
  if (head.generation != generation_) head = {generation_, config_.no_depth(), kNoNode, false};
  head.near = std::min(head.near, far);
  if (!storable || nodes_.size() == std::size_t{1} << config_.nodes_log2) {
    head.dropped = true;
    ++counters_.nodes_dropped;
    sticky_.list_overflow = true;
    return;
  }
  nodes_.push_back({head.node, far, quad});
  head.node = static_cast<std::uint32_t>(nodes_.size() - 1);
  ++counters_.nodes_linked;
}

/// A place on the plane has two bits more than the plane, and is saturated to them.
void QuadLists::note_beam(const Beam& beam) {
  if (!work_) return;
  const std::int64_t most = (config_.side() << (config_.sub_bits + 1)) - 1;
  const auto entry = [&](std::int64_t place) {
    return static_cast<std::uint32_t>(std::clamp(place, -most - 1, most) >> config_.sub_bits &
                                      (config_.side() - 1));
  };
  work_->voxels.back().u = entry(beam.u);
  work_->voxels.back().v = entry(beam.v);
}

Walk QuadLists::walk(const Beam& beam, std::uint32_t clearance, bool sorted) {
  const auto index = (static_cast<std::size_t>(beam.v >> config_.sub_bits) << config_.plane_log2) +
                     static_cast<std::size_t>(beam.u >> config_.sub_bits);
  const auto nearer = [&](std::uint32_t depth) { return std::uint64_t{depth} + clearance < beam.depth; };
  const Head& head = heads_.at(index);
  Walk walk;
  if (head.generation != generation_ || !nearer(head.near)) return walk;
  walk.uncertain = true;
  for (std::uint32_t n = head.node; n != kNoNode && !walk.hit; n = nodes_[n].next) {
    const Node& node = nodes_[n];
    ++walk.visited;
    note_node(n, nearer(node.far));
    if (!nearer(node.far)) {
      if (sorted) break;
      continue;
    }
    ++walk.tested;
    std::array<Offset, 4> offsets;
    for (std::size_t i = 0; i < 4; ++i) {
      const Place& corner = records_[node.quad][i];
      offsets[i] = {corner.u - beam.u, corner.v - beam.v};
    }
    walk.hit = hits_quad(offsets);
    if (walk.hit) walk.quad = node.quad;
  }
  walk.fallback = !walk.hit && head.dropped;
  counters_.nodes_visited += walk.visited;
  counters_.quads_tested += walk.tested;
  return walk;
}

ListHead QuadLists::head(std::size_t index) const {
  const Head& head = heads_.at(index);
  if (head.generation != generation_) return {};
  return {.present = true, .linked = head.node != kNoNode, .dropped = head.dropped, .near = head.near};
}

std::vector<std::uint32_t> QuadLists::list(std::size_t index) const {
  std::vector<std::uint32_t> quads;
  const Head& head = heads_.at(index);
  if (head.generation != generation_) return quads;
  for (std::uint32_t n = head.node; n != kNoNode; n = nodes_[n].next) quads.push_back(nodes_[n].quad);
  return quads;
}

}  // namespace gnomon::golden::topology
