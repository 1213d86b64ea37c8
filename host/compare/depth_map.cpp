// SPDX-License-Identifier: Apache-2.0
// One class for both maps: a plain one is a filtered one that reads a single texel.
#include "host/compare/depth_map.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace gnomon::compare {
namespace {

constexpr double kMaxSlope = 10;     ///< where the bias stops growing
constexpr double kCurvature = 0.01;  ///< voxels: of the receiver within a texel, and rounding
constexpr double kEdgeOn = 1e-9;     ///< cosines below are rounding
constexpr std::int64_t kUnit = 256;  ///< of a place on the map: fractions of a texel
constexpr std::uint64_t kClearedACycle = 16;

/// The texels of one axis that a point reads.
struct Taps {
  std::int64_t first = 0;
  std::int64_t fraction = 0;  ///< of the first texel that the box leaves out, in units

  Taps(double place, int kernel) {
    const auto at = static_cast<std::int64_t>(std::floor(place * kUnit));
    const std::int64_t from = at - (kernel - 1) * (kUnit / 2);
    first = from >= 0 ? from / kUnit : -((-from + kUnit - 1) / kUnit);
    fraction = from - first * kUnit;
  }
  std::int64_t weight(int tap, int kernel) const {
    if (kernel == 1) return 1;
    if (tap == 0) return kUnit - fraction;
    return tap == kernel - 1 ? fraction : kUnit;
  }
};

double slope_of(double facing) {
  return std::min(kMaxSlope, std::sqrt(std::max(0.0, 1 - facing * facing)) / facing);
}

double bias(const MapPlan& plan, double facing, int kernel) {
  return std::sqrt(0.5) * kernel * plan.plane.pitch * slope_of(facing) + kCurvature;
}

}  // namespace

MapPlan with_side(MapPlan plan, int side) {
  LightPlane& plane = plan.plane;
  const double times = static_cast<double>(side) / plane.side;
  plane = {plane.axes, plane.x1 * times, plane.y1 * times, plane.pitch / times, side};
  return plan;
}

int side_within(std::uint64_t bits, std::uint64_t texel_bytes) {
  const std::uint64_t texels = bits / (8 * texel_bytes);
  return std::max(1, static_cast<int>(std::floor(std::sqrt(static_cast<double>(texels)))));
}

DepthMap::DepthMap(const MapPlan& plan, const Cast& cast) : plan_(plan) {
  if (plan.plane.side < 1 || plan.depth_bits < 1 || plan.depth_bits > 31)
    throw std::invalid_argument("a depth map needs texels and 1..31 bits a depth");
  codes_.assign(plan.texels(), empty_code());
  std::vector<std::uint64_t> drawn(static_cast<std::size_t>(plan.plane.side));
  tbb::parallel_for(0, plan.plane.side,
                    [&](int y) { drawn[static_cast<std::size_t>(y)] = draw_row(y, cast); });
  drawn_ = std::accumulate(drawn.begin(), drawn.end(), std::uint64_t{0});
}

std::uint32_t DepthMap::code_of(double depth) const {
  const double code = std::floor((depth - plan_.nearest) * plan_.codes_per_voxel);
  return static_cast<std::uint32_t>(std::clamp(code, 0.0, static_cast<double>(empty_code() - 1)));
}

std::uint64_t DepthMap::draw_row(int y, const Cast& cast) {
  const LightPlane& plane = plan_.plane;
  std::uint64_t drawn = 0;
  // A voxel before the first code, so that nothing lies behind the start.
  const double before = plan_.nearest - 1;
  for (int x = 0; x < plane.side; ++x) {
    const Vec3 start = plane.axes.right * ((x + 0.5 - plane.x1) * plane.pitch) +
                       plane.axes.up * ((y + 0.5 - plane.y1) * plane.pitch) + plane.axes.away * before;
    const Sheets sheets = cast(start);
    if (sheets.count == 0) continue;
    drawn += sheets.count;
    const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(plane.side);
    codes_[at + static_cast<std::size_t>(x)] = code_of(before + sheets.nearest);
  }
  return drawn;
}

std::uint32_t DepthMap::code(int x, int y) const {
  return codes_.at(static_cast<std::size_t>(y) * static_cast<std::size_t>(plan_.plane.side) +
                   static_cast<std::size_t>(x));
}

bool DepthMap::in_shadow(const Vec3& point, double facing, int kernel) const {
  if (!(facing > kEdgeOn)) return true;
  const Vec2 place = plan_.plane.pixel(point);
  const double side = plan_.plane.side;
  if (!(place.x > -kernel && place.x < side + kernel && place.y > -kernel && place.y < side + kernel))
    return false;
  const Taps across(place.x, kernel), along(place.y, kernel);
  const std::uint32_t own = code_of(plan_.plane.axes.away.dot(point) - bias(plan_, facing, kernel));
  std::int64_t dark = 0, all = 0;
  for (int j = 0; j < kernel; ++j) {
    for (int i = 0; i < kernel; ++i) {
      const std::int64_t weight = across.weight(i, kernel) * along.weight(j, kernel);
      const std::int64_t x = across.first + i, y = along.first + j;
      all += weight;
      if (x < 0 || y < 0 || x >= plan_.plane.side || y >= plan_.plane.side) continue;
      if (code(static_cast<int>(x), static_cast<int>(y)) < own) dark += weight;
    }
  }
  return 2 * dark > all;
}

MapCosts DepthMap::costs(std::uint64_t queries, int kernel) const {
  const std::uint64_t bytes = plan_.texel_bytes();
  const std::uint64_t reads =
      queries * static_cast<std::uint64_t>(kernel) * static_cast<std::uint64_t>(kernel);
  MapCosts costs;
  costs.clear_cycles = (plan_.texels() + kClearedACycle - 1) / kClearedACycle;
  costs.draw_cycles = drawn_;
  costs.query_cycles = reads;
  costs.bytes_read = (drawn_ + reads) * bytes;
  costs.bytes_written = (plan_.texels() + drawn_) * bytes;
  return costs;
}

}  // namespace gnomon::compare
