// SPDX-License-Identifier: Apache-2.0
// What casts, the square that holds it, the depth range.
#include "host/plan/slb_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/plan/representative.hpp"

namespace gnomon::plan {
namespace {

constexpr double kFlat = 1e-3;       // voxels
constexpr double kPitch = 1.75;      // voxels a pixel, where the user leaves it to us
constexpr double kSurround = 1;      // voxels: surface beyond the outermost representatives
constexpr double kDepthReserve = 2;  // voxels before and behind everything
constexpr int kSmallestPlane = 3;

Vec3 normal_of(const voxel::Voxel& v) {
  return {v.normal[0], v.normal[1], v.normal[2]};
}

/// The plane of a flat object: normal.p = offset.
struct Flat {
  bool is_flat = true;
  Vec3 normal{0, 0, 0};
  double offset = 0;
};

std::vector<Flat> flat_objects(const voxel::VoxelSet& voxels, std::size_t objects) {
  std::vector<Flat> flat(objects);
  for (const voxel::Voxel& v : voxels.voxels) {
    Flat& f = flat.at(v.object);
    const Vec3 normal = normal_of(v);
    if (f.normal.length2() == 0) {
      f.normal = normal;
      f.offset = normal.dot(representative(v));
    }
    // The object is large against its distance from the grid's origin, or too small to matter.
    f.is_flat = f.is_flat && (normal - f.normal).length() < kFlat &&
                std::abs(f.normal.dot(representative(v)) - f.offset) < kFlat;
  }
  return flat;
}

/// A flat object casts nothing if all others lie on the side that the light comes from.
std::vector<bool> casting(const voxel::VoxelSet& voxels, std::size_t objects, const Vec3& away) {
  const std::vector<Flat> flat = flat_objects(voxels, objects);
  std::vector<bool> casts(objects);
  for (std::size_t i = 0; i < objects; ++i) casts[i] = !flat[i].is_flat;
  for (const voxel::Voxel& v : voxels.voxels) {
    const Vec3 p = representative(v);
    for (std::size_t i = 0; i < objects; ++i) {
      if (casts[i] || v.object == i) continue;
      const double behind =
          (flat[i].normal.dot(p) - flat[i].offset) * (flat[i].normal.dot(away) < 0 ? -1 : 1);
      if (behind > kFlat) casts[i] = true;
    }
  }
  return casts;
}

/// Grows with what it is to hold.
struct Interval : SlbExtent::Range {
  Interval() : Range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()} {}
  void extend(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
  Range widened(double by) const { return {low - by, high + by}; }
};

int plane_log2_for(double extent) {
  return std::max(kSmallestPlane, static_cast<int>(std::ceil(std::log2(extent / kPitch + 2))));
}

}  // namespace

outline::LightFrame SlbPlan::frame() const {
  outline::LightFrame frame;
  frame.x = plane.axes.right / plane.pitch;
  frame.y = plane.axes.up / plane.pitch;
  frame.depth = plane.axes.away * codes_per_voxel;
  frame.x1 = plane.x1;
  frame.y1 = plane.y1;
  frame.depth1 = -nearest * codes_per_voxel;
  return frame;
}

Result<SlbExtent> slb_extent(const voxel::VoxelSet& voxels, const std::vector<bool>& may_cast,
                             const Vec3& light) {
  if (!(light.length() > 0) || !std::isfinite(light.length()))
    return fail("light has no direction: expected three finite numbers, not all 0");
  SlbExtent extent;
  extent.axes = light_axes(light);
  extent.casts = casting(voxels, may_cast.size(), extent.axes.away);
  for (std::size_t i = 0; i < may_cast.size(); ++i) extent.casts[i] = extent.casts[i] && may_cast[i];
  Interval right, up, depth;
  for (const voxel::Voxel& v : voxels.voxels) {
    const Vec3 p = representative(v);
    depth.extend(extent.axes.away.dot(p));
    if (!extent.casts[v.object]) continue;
    right.extend(extent.axes.right.dot(p));
    up.extend(extent.axes.up.dot(p));
  }
  if (right.size() < 0)
    return fail("nothing in the scene can cast a shadow: expected at least one object that is not flat");
  extent.right = right.widened(kSurround);
  extent.up = up.widened(kSurround);
  extent.depth = depth.widened(kDepthReserve);
  return extent;
}

Result<SlbPlan> plan_slb(const SlbExtent& extent, const SlbSettings& settings) {
  SlbPlan plan;
  plan.plane.axes = extent.axes;
  plan.casts = extent.casts;
  const double widest = std::max(extent.right.size(), extent.up.size());
  plan.config = settings.hardware(settings.plane_log2 > 0 ? settings.plane_log2 : plane_log2_for(widest));
  if (const auto wrong = plan.config.check()) return fail(*wrong);
  plan.plane.side = 1 << plan.config.slb_plane_log2;
  plan.plane.pitch = widest / (plan.plane.side - 2);
  plan.plane.x1 = 0.5 * plan.plane.side - extent.right.middle() / plan.plane.pitch;
  plan.plane.y1 = 0.5 * plan.plane.side - extent.up.middle() / plan.plane.pitch;
  plan.nearest = extent.depth.low;
  plan.codes_per_voxel = (std::ldexp(1.0, plan.config.depth_bits) - 2) / extent.depth.size();
  return plan;
}

Result<SlbPlan> plan_slb(const voxel::VoxelSet& voxels, const std::vector<bool>& may_cast, const Vec3& light,
                         const SlbSettings& settings) {
  const auto extent = slb_extent(voxels, may_cast, light);
  if (!extent) return tl::make_unexpected(extent.error());
  return plan_slb(*extent, settings);
}

}  // namespace gnomon::plan
