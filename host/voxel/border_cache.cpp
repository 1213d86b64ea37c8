// SPDX-License-Identifier: Apache-2.0
// One array of slots per border curve, as fine as the recursion can be expected to go.
#include "host/voxel/border_cache.hpp"

#include <algorithm>
#include <cmath>

#include "host/surface/patch_tree.hpp"

namespace gnomon::voxel {
namespace {

// Points closer than this along a curve are not remembered.
constexpr double kStep = 0.5;
constexpr int kDeepest = 16;

int levels_of(const surface::LimitSurface& surface, std::uint32_t curve) {
  double fastest = 0;
  for (const double t : {0.25, 0.75}) {
    const surface::Place p = surface.borders().place({false, curve, t});
    const surface::Place q = surface.borders().place({false, curve, t + 0.125});
    const auto region = surface.pieces(p.face).region(0, 0, 1, 1);
    // A curve along an n-gon is as long as two sides.
    const double sides = 8 * std::max(std::abs(q.u - p.u), std::abs(q.v - p.v));
    fastest = std::max(fastest, sides * (p.u == q.u ? region.v_speed : region.u_speed));
  }
  return std::clamp(static_cast<int>(std::ceil(std::log2(std::max(fastest / kStep, 1.0)))), 0, kDeepest);
}

}  // namespace

BorderCache::BorderCache(const surface::LimitSurface& surface) : surface_(surface) {
  std::size_t total = surface.borders().vertex_count();
  for (std::uint32_t c = 0; c < surface.borders().curve_count(); ++c) {
    const int levels = levels_of(surface, c);
    curves_.push_back({total, std::ldexp(1.0, levels)});
    total += (std::size_t{1} << levels) + 1;
  }
  slots_ = std::vector<std::atomic<VoxelKey>>(total);
}

std::atomic<VoxelKey>* BorderCache::slot(const surface::BorderSpot& spot) {
  if (spot.vertex) return &slots_[spot.id];
  const Curve& curve = curves_[spot.id];
  const double step = spot.t * curve.steps;
  const auto i = static_cast<std::size_t>(step);
  return static_cast<double>(i) == step ? &slots_[curve.first + i] : nullptr;
}

BorderCache::Stretch BorderCache::stretch(std::uint32_t face, double u, double v, double du, double dv) {
  // Half a step and one step from the start: neither is a corner.
  const surface::BorderSpot half = surface_.borders().spot(face, u + du / 2, v + dv / 2);
  const surface::BorderSpot quarter = surface_.borders().spot(face, u + du / 4, v + dv / 4);
  const Curve& curve = curves_[half.id];
  const double stride = (half.t - quarter.t) * 4 * curve.steps;
  const double start = half.t * curve.steps - stride / 2;
  if (stride != std::floor(stride) || start != std::floor(start)) return {};
  // A curve has one owner, so one point tells.
  const surface::Place owner = surface_.borders().place(half);
  return {slots_.data() + curve.first + static_cast<std::ptrdiff_t>(start),
          static_cast<std::ptrdiff_t>(stride),
          owner.face == face && owner.u == u + du / 2 && owner.v == v + dv / 2};
}

BorderCache::Answer BorderCache::voxel(std::uint32_t face, double u, double v, std::uint32_t res) {
  const surface::BorderSpot spot = surface_.borders().spot(face, u, v);
  std::atomic<VoxelKey>* const remembered = slot(spot);
  if (remembered != nullptr) {
    if (const VoxelKey k = remembered->load(std::memory_order_relaxed); k != 0) return {k - 1, false};
  }
  const surface::Place place = surface_.borders().place(spot);
  const Vec3 p = surface_.position_at(place);
  const VoxelKey key =
      pack(snap(p.x, res) >> kFractionBits, snap(p.y, res) >> kFractionBits, snap(p.z, res) >> kFractionBits);
  if (remembered == nullptr) return {key, true};
  VoxelKey empty = 0;
  return {key, remembered->compare_exchange_strong(empty, key + 1, std::memory_order_relaxed)};
}

}  // namespace gnomon::voxel
