// SPDX-License-Identifier: Apache-2.0
// A voxel from its item to its answer (docs/vpu.md, "Resolve"), in either projection.
#pragma once

#include <gnomon/golden/vpu.hpp>

#include "plane.hpp"

namespace gnomon::golden {

/// The depth in an entry and whether it has one.
struct Entry {
  bool present = false;
  std::uint32_t depth = 0;
};
inline Entry read(const Vpu& vpu, const Plane& plane, const PlanePoint& point) {
  if (!point.on_plane) return {};
  const std::size_t index = vpu.index(point);
  return plane.present(index) ? Entry{true, plane.depth(index)} : Entry{};
}

/// From the own entry on. `land_offset()` is where the offset point lands, `limit` the largest delta that the
/// margin test decides.
template <typename LandOffset>
VoxelResult look_up(const Vpu& vpu, const Plane& plane, const PlanePoint& own, const Gradient& gradient,
                    std::int64_t limit, const LandOffset& land_offset) {
  VoxelResult result;
  result.off_plane = !own.on_plane;
  const Entry own_entry = read(vpu, plane, own);
  if (!own_entry.present) return result;
  result.nearest = own_entry.depth;
  result.uncertain = own_entry.depth < own.depth;
  if (!result.uncertain) return result;

  const PlanePoint moved = land_offset();
  const Entry entry = read(vpu, plane, moved);
  result.offset_empty = !entry.present;
  if (result.offset_empty || moved.depth <= entry.depth) return result;
  result.delta = moved.depth - entry.depth;
  result.beyond_max = result.delta > limit;
  const bool shadow = result.beyond_max || vpu.exceeds_margin(result.delta, gradient);
  result.state = shadow ? VoxelState::Shadow : VoxelState::Lit;
  return result;
}

inline VoxelResult resolve_orthographic(const Vpu& vpu, const Plane& plane, const VoxelItem& item,
                                        bool two_sided) {
  const Accumulators acc = vpu.accumulate(item);
  const PlanePoint own = vpu.land(acc);
  Gradient gradient = vpu.gradient(item);
  if (two_sided && gradient.d > 0) gradient = {.u = -gradient.u, .v = -gradient.v, .d = -gradient.d};
  if (gradient.d >= 0) return {.state = VoxelState::Shadow, .facing_away = true, .off_plane = !own.on_plane};
  return look_up(vpu, plane, own, gradient, vpu.get(Register::DeltaMax),
                 [&] { return vpu.land_offset(acc, gradient); });
}

inline VoxelResult resolve_perspective(const Vpu& vpu, const Plane& plane, const VoxelItem& item,
                                       bool two_sided) {
  const perspective::Sight sight = vpu.see(item);
  if (sight.behind) return {.state = VoxelState::Shadow, .behind = true};
  const PlanePoint own = vpu.land(sight);
  if (vpu.light().outside_cone(sight))
    return {.state = VoxelState::Shadow, .off_plane = !own.on_plane, .outside_cone = true};
  perspective::Slope slope = vpu.slope(item);
  if (two_sided && slope.d > 0) slope = -slope;
  if (slope.d >= 0) return {.state = VoxelState::Shadow, .facing_away = true, .off_plane = !own.on_plane};
  return look_up(vpu, plane, own, {.u = slope.u, .v = slope.v, .d = slope.d}, vpu.delta_limit(sight),
                 [&] { return vpu.land_offset(sight, slope); });
}

}  // namespace gnomon::golden
