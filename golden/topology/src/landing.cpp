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

}  // namespace

Corner land_corner(const Projected& point, const TopologyConfig& config) {
  const int dropped = config.matrix_frac_bits - config.sub_bits;
  const std::int64_t limit = config.side() << (config.sub_bits + 1);
  const auto [depth, saturated] = saturate_depth(point.d >> (config.position_bits() + 4), config);
  return {.u = std::clamp(point.u >> dropped, -limit, limit - 1),
          .v = std::clamp(point.v >> dropped, -limit, limit - 1),
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
  const auto inside = [&](std::int64_t x) {
    const std::int64_t entry = x >> config.sub_bits;
    return entry >= 0 && entry < config.side();
  };
  beam.on_plane = inside(beam.u) && inside(beam.v);
  return beam;
}

}  // namespace gnomon::golden::topology
