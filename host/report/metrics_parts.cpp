// SPDX-License-Identifier: Apache-2.0
// Parts of metrics.json that stand in it more than once.
#include "host/report/metrics_parts.hpp"

namespace gnomon::report {

Json ratio(double part, double whole) {
  return whole > 0 ? Json(part / whole) : Json(nullptr);
}
Json ratio(std::uint64_t part, std::uint64_t whole) {
  return ratio(static_cast<double>(part), static_cast<double>(whole));
}
Json vector_json(const Vec3& v) {
  return Json::array({v.x, v.y, v.z});
}

std::uint64_t event(const Events& events, const std::string& name) {
  const auto found = events.find(name);
  return found == events.end() ? 0 : found->second;
}

Json plane_json(const std::optional<PlaneRecord>& plane, const Events& events) {
  if (!plane) return nullptr;
  const PlaneRecord& p = *plane;
  const std::uint64_t entries = std::uint64_t{p.side} * p.side;
  const std::uint64_t landed = event(events, "VOXELS_PROJECTED") - event(events, "PROJECT_OFF_PLANE") -
                               event(events, "PROJECT_BEHIND");
  return {{"side", p.side},
          {"pitch", p.pitch},
          {"entries", entries},
          {"entries_hit", p.entries_hit},
          {"share_hit", ratio(p.entries_hit, entries * p.views)},
          {"voxels_per_entry_hit", ratio(landed, p.entries_hit)},
          {"off_plane", event(events, "PROJECT_OFF_PLANE")},
          {"saturated", event(events, "PROJECT_SATURATED")}};
}

std::uint64_t frame_buffer_bits(const golden::HardwareConfig& hardware) {
  constexpr std::uint64_t kBrickBits = 8 + 128;  // generation, 64 states
  const int bricks_log2 = 3 * hardware.voxel_bits - 6 + hardware.frame_layers_log2;
  return hardware.en_frame_buffer ? kBrickBits << bricks_log2 : 0;
}

std::uint64_t topology_bits(const TopologyRecord& t) {
  return std::uint64_t{t.side} * t.side * t.head_bits + t.node_bits + t.record_bits;
}

Json topology_json(const std::optional<TopologyRecord>& topology, const Events& events) {
  if (!topology) return nullptr;
  const TopologyRecord& t = *topology;
  const std::uint64_t entries = std::uint64_t{t.side} * t.side;
  const std::uint64_t uncertain = event(events, "TOPOLOGY_UNCERTAIN");
  const std::uint64_t linked = event(events, "NODES_LINKED");
  return {{"side", t.side},
          {"pitch", t.pitch},
          {"entries", entries},
          {"lists", t.lists},
          {"share_hit", ratio(t.lists, entries * t.views)},
          {"longest_list", t.longest},
          {"mean_list", ratio(linked, t.lists)},
          {"quads", event(events, "QUADS_PUT")},
          {"nodes", linked},
          {"nodes_dropped", event(events, "NODES_DROPPED")},
          {"uncertain", uncertain},
          {"uncertain_share", ratio(uncertain, event(events, "TOPOLOGY_RESOLVED"))},
          {"facing_away", event(events, "TOPOLOGY_FACING_AWAY")},
          {"hits", event(events, "TOPOLOGY_HIT")},
          {"fallbacks", event(events, "TOPOLOGY_FALLBACK")},
          {"nodes_visited_per_uncertain", ratio(event(events, "NODES_VISITED"), uncertain)},
          {"quads_tested_per_uncertain", ratio(event(events, "QUADS_TESTED"), uncertain)}};
}

Json slb_json(const std::optional<SlbRecord>& slb, const Events& events) {
  if (!slb) return nullptr;
  const SlbRecord& s = *slb;
  const std::uint64_t pixels = std::uint64_t{s.side} * s.side;
  const std::uint64_t overflowed = event(events, "SLB_QUERIES_OVERFLOW");
  return {{"side", s.side},
          {"pitch", s.pitch},
          {"pixels", pixels},
          {"pixels_by_fragments", s.pixels_by_fragments},
          {"full_pixels", s.full_pixels},
          {"overflow_pixels", s.overflow_pixels},
          {"loops", event(events, "SLB_LOOPS")},
          {"vertices", event(events, "SLB_VERTICES")},
          {"crossings", event(events, "SLB_CROSSINGS")},
          {"chains_reduced", event(events, "SLB_CHAINS_REDUCED")},
          {"chains_dropped", event(events, "SLB_CHAINS_DROPPED")},
          {"groups_evicted", event(events, "SLB_GROUPS_EVICTED")},
          {"queries", event(events, "SLB_QUERIES")},
          {"queries_off_plane", event(events, "SLB_QUERIES_OFF_PLANE")},
          {"queries_overflow", overflowed},
          {"queries_overflow_share", ratio(overflowed, event(events, "SLB_QUERIES"))}};
}

Json software_json(const std::optional<SoftwareRecord>& software) {
  if (!software) return nullptr;
  const SoftwareRecord& s = *software;
  return {{"side", s.side},
          {"pitch", s.pitch},
          {"texel_bits", s.texel_bits},
          {"kernel", s.kernel},
          {"memory_bits", s.memory_bits},
          {"queries", s.queries},
          {"drawn", s.drawn},
          {"bytes_read", s.bytes_read},
          {"bytes_written", s.bytes_written},
          {"triangles", s.triangles},
          {"build_seconds", s.build_seconds},
          {"seconds", s.seconds}};
}

}  // namespace gnomon::report
