// SPDX-License-Identifier: Apache-2.0
// From the numbers of a file to the unit's integers.
#include "host/slb/fixed_point.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace gnomon::slb {
namespace {

using golden::slb::SlbConfig;

/// Nothing outside the guard band.
std::optional<std::int64_t> to_lattice(double v, const SlbConfig& config) {
  const double scaled = std::floor(std::ldexp(v, config.subpixel_bits) + 0.5);
  const double side = std::ldexp(config.side(), config.subpixel_bits);
  if (!(scaled >= -side && scaled < 2 * side)) return std::nullopt;
  return static_cast<std::int64_t>(scaled);
}

Result<std::vector<golden::slb::Vertex>> to_fixed(const Loop& loop, std::uint32_t depth, std::size_t object,
                                                  std::size_t number, const SlbConfig& config) {
  std::vector<golden::slb::Vertex> vertices;
  vertices.reserve(loop.size());
  for (const Vec2& point : loop) {
    const std::optional<std::int64_t> x = to_lattice(point.x, config), y = to_lattice(point.y, config);
    if (!x || !y) {
      return fail(fmt::format(
          "{}: {}={} lies outside the guard band, expected {}..{} (the plane is {} pixels a side)",
          place_text(object, number, vertices.size()), x ? 'y' : 'x', x ? point.y : point.x, -config.side(),
          2 * config.side(), config.side()));
    }
    vertices.push_back({*x, *y, depth});
  }
  return vertices;
}

std::int64_t query_coordinate(double v, const SlbConfig& config) {
  // Off the plane is off the plane, however far.
  const double near = std::clamp(v, -1.0, static_cast<double>(config.side()));
  return static_cast<std::int64_t>(std::floor(std::ldexp(near, config.query_bits)));
}

}  // namespace

std::uint32_t caster_depth(double depth, const SlbConfig& config) {
  const double farthest = config.no_depth() - 1.0;
  return static_cast<std::uint32_t>(std::ceil(std::clamp(depth, 0.0, 1.0) * farthest));
}

std::uint32_t receiver_depth(double z, const SlbConfig& config) {
  if (z > 1) return config.no_depth();
  const double farthest = config.no_depth() - 1.0;
  return static_cast<std::uint32_t>(std::floor(std::max(z, 0.0) * farthest));
}

golden::slb::QueryPoint to_query(const Receiver& receiver, const SlbConfig& config) {
  return {query_coordinate(receiver.x, config), query_coordinate(receiver.y, config),
          receiver_depth(receiver.z, config)};
}

Result<std::vector<FixedCaster>> to_fixed(const LoopScene& scene, const SlbConfig& config) {
  std::vector<FixedCaster> casters;
  for (std::size_t object = 0; object < scene.size(); ++object) {
    FixedCaster caster{caster_depth(scene[object].depth, config), {}};
    for (std::size_t i = 0; i < scene[object].loops.size(); ++i) {
      Result<std::vector<golden::slb::Vertex>> loop =
          to_fixed(scene[object].loops[i], caster.depth, object, i, config);
      if (!loop) return tl::make_unexpected(loop.error());
      caster.loops.push_back(std::move(*loop));
    }
    casters.push_back(std::move(caster));
  }
  return casters;
}

}  // namespace gnomon::slb
