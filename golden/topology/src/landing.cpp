// SPDX-License-Identifier: Apache-2.0
// The narrowings of corners and beams.
#include <algorithm>
#include <gnomon/golden/topology/landing.hpp>

namespace gnomon::golden::topology {
namespace {

struct DepthCode {
  std::uint32_t code;
  bool saturated;
};
DepthCode saturate_depth(std::int64_t depth, const TopologyConfig& config) {
  const std::int64_t farthest = std::int64_t{config.no_depth()} - 1;
  const std::int64_t code = std::clamp<std::int64_t>(depth, 0, farthest);
  return {static_cast<std::uint32_t>(code), code != depth};
}

/// A position on the plane, saturated to two planes on either side.
std::int64_t saturate_place(std::int64_t place, const TopologyConfig& config) {
  const std::int64_t limit = config.side() << (config.sub_bits + 1);
  return std::clamp(place, -limit, limit - 1);
}

bool on_plane(const Beam& beam, const TopologyConfig& config) {
  const auto inside = [&](std::int64_t x) {
    const std::int64_t entry = x >> config.sub_bits;
    return entry >= 0 && entry < config.side();
  };
  return inside(beam.u) && inside(beam.v);
}

}  // namespace

Corner land_corner(const Projected& point, const TopologyConfig& config) {
  const int dropped = config.matrix_frac_bits - config.sub_bits;
  const auto [depth, saturated] = saturate_depth(point.d >> (config.position_bits() + 4), config);
  return {.u = saturate_place(point.u >> dropped, config),
          .v = saturate_place(point.v >> dropped, config),
          .depth = depth,
          .saturated = saturated};
}

Beam land_beam(const Projected& point, const Projected& normal, std::int64_t factor,
               const TopologyConfig& config) {
  const int dropped = config.matrix_frac_bits - config.sub_bits;
  const int p = config.position_bits();
  Beam beam;
  beam.u = (point.u + ((factor * normal.u) >> 16)) >> dropped;
  beam.v = (point.v + ((factor * normal.v) >> 16)) >> dropped;
  const std::int64_t depth = ((point.d >> p) + ((factor * (normal.d >> p)) >> 16)) >> 4;
  beam.depth = saturate_depth(depth, config).code;
  beam.on_plane = on_plane(beam, config);
  return beam;
}

Corner land_corner(const perspective::Sight& sight, const TopologyConfig& config) {
  const int dropped = perspective::kEntryFracBits - config.sub_bits;
  const auto [depth, saturated] = saturate_depth(sight.key >> perspective::kKeyFracBits, config);
  return {.u = saturate_place(sight.u_fine >> dropped, config),
          .v = saturate_place(sight.v_fine >> dropped, config),
          .depth = depth,
          .saturated = saturated};
}

Beam land_beam(const perspective::Moved& moved, const TopologyConfig& config) {
  const int dropped = perspective::kEntryFracBits - config.sub_bits;
  Beam beam{.u = moved.u >> dropped,
            .v = moved.v >> dropped,
            .depth = saturate_depth(moved.key >> perspective::kKeyFracBits, config).code};
  beam.on_plane = on_plane(beam, config);
  return beam;
}

}  // namespace gnomon::golden::topology
