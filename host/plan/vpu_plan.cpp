// SPDX-License-Identifier: Apache-2.0
// Chooses the plane, the depth range and the register contents for one directional light (docs/planning.md).
#include "host/plan/vpu_plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "host/base/light_plane.hpp"
#include "host/plan/orientation.hpp"
#include "host/plan/plan_registers.hpp"
#include "host/plan/representative.hpp"

namespace gnomon::plan {
namespace {

constexpr double kMinDepthRange = 16;  // voxels; keeps depth coefficients inside their register width

struct Interval {
  double lo = std::numeric_limits<double>::infinity();
  double hi = -std::numeric_limits<double>::infinity();
  void extend(double x) {
    lo = std::min(lo, x);
    hi = std::max(hi, x);
  }
  double size() const { return hi - lo; }
};

struct Extent {
  Interval u, v, d;  // voxels along right, up, away
};
Extent extent_of(const voxel::VoxelSet& voxels, const ViewVoxels& seen, const LightAxes& axes) {
  Extent extent;
  for (const auto* numbers : {&seen.casters, &seen.receivers}) {
    for (const std::uint32_t i : *numbers) {
      const Vec3 p = representative(voxels.voxels[i]);
      extent.u.extend(axes.right.dot(p));
      extent.v.extend(axes.up.dot(p));
      extent.d.extend(axes.away.dot(p));
    }
  }
  return extent;
}

Projection make_projection(const LightAxes& axes, const Extent& extent, double pitch, int plane_side,
                           int depth_bits, double reach) {
  Projection projection;
  projection.pitch = pitch;
  projection.plane_side = plane_side;
  projection.u = axes.right / pitch;
  projection.v = axes.up / pitch;
  // Whole entries only: the lattice stays aligned with the voxels where the light is parallel to an axis.
  projection.u1 = std::floor((plane_side - extent.u.size() / pitch) / 2) - std::floor(extent.u.lo / pitch);
  projection.v1 = std::floor((plane_side - extent.v.size() / pitch) / 2) - std::floor(extent.v.lo / pitch);
  const double range = std::max(extent.d.size() + 2 * reach, kMinDepthRange);
  projection.codes_per_voxel = (std::ldexp(1.0, depth_bits) - 2) / range;
  projection.d = axes.away * projection.codes_per_voxel;
  projection.d1 = -(extent.d.lo - reach) * projection.codes_per_voxel;
  return projection;
}

void set_row(std::vector<std::int64_t>& registers, golden::Register first, const Vec3& row,
             double translation, int position_frac_bits, int frac_bits) {
  const auto base = static_cast<std::size_t>(first);
  const double ulp = std::ldexp(1.0, -position_frac_bits);
  for (int axis = 0; axis < 3; ++axis)
    registers[base + static_cast<std::size_t>(axis)] = round_fixed(row[axis] * ulp, frac_bits);
  registers[base + 3] = round_fixed(translation + (row.x + row.y + row.z) * ulp / 2, frac_bits);
}

/// Margin registers: DELTA_MAX clamps, the squared margin gets as many bits as its register holds.
void set_margin(VpuPlan& plan, double facing_scale, double tilt_scale) {
  auto& registers = plan.registers;
  const auto& config = plan.config;
  const double k = plan.projection.codes_per_voxel;
  const double code_max = std::ldexp(1.0, config.depth_bits) - 1;
  const double delta_max =
      std::min(std::round(plan.settings.margin * plan.settings.margin_tan_max * k), code_max);
  const int facing_shift = shift_for(facing_scale, kSlopeBits);
  const int tilt_shift = shift_for(tilt_scale, kSlopeBits);
  int delta_shift = shift_for(delta_max, kDeltaBits);
  const auto squared = [&] {
    const int exponent =
        tilt_shift - config.matrix_frac_bits - delta_shift - facing_shift + config.position_bits() + 4;
    const double root = std::ldexp(plan.settings.margin * k * k * plan.projection.pitch, exponent);
    return std::round(root * root);
  };
  while (squared() >= std::ldexp(1.0, kMarginBits)) ++delta_shift;
  const auto set = [&](golden::Register reg, double value) {
    registers[static_cast<std::size_t>(reg)] = static_cast<std::int64_t>(value);
  };
  set(golden::Register::FacingShift, facing_shift);
  set(golden::Register::TiltShift, tilt_shift);
  set(golden::Register::DeltaShift, delta_shift);
  set(golden::Register::MarginSquared, squared());
  set(golden::Register::DeltaMax, delta_max);
}

Result<void> set_registers(VpuPlan& plan) {
  const auto& config = plan.config;
  const auto& projection = plan.projection;
  plan.registers.assign(golden::kRegisterCount, 0);
  const int frac = config.voxel_frac_bits;
  const int depth_frac = config.position_bits() + 4;
  set_row(plan.registers, golden::Register::MatrixUx, projection.u, projection.u1, frac,
          config.matrix_frac_bits);
  set_row(plan.registers, golden::Register::MatrixVx, projection.v, projection.v1, frac,
          config.matrix_frac_bits);
  set_row(plan.registers, golden::Register::MatrixDx, projection.d, projection.d1, frac, depth_frac);

  const auto factor = offset_factor(plan.settings, config);
  if (!factor) return tl::make_unexpected(factor.error());
  plan.registers[static_cast<std::size_t>(golden::Register::OffsetFactor)] = *factor;

  const double unit = std::ldexp(1.0, config.normal_bits - 1) - 1;
  const double per_ulp =
      std::ldexp(unit, -frac);  // voxels that the integer normal of a unit vector spans, in ulps
  set_margin(plan, std::ldexp(projection.codes_per_voxel * per_ulp, depth_frac),
             std::ldexp(per_ulp / projection.pitch, config.matrix_frac_bits));
  return {};
}

}  // namespace

Result<VpuPlan> plan_vpu(const voxel::VoxelSet& voxels, const Vec3& light, const VpuSettings& settings) {
  if (!(light.length() > 0) || !std::isfinite(light.length()))
    return fail("light has no direction: expected three finite numbers, not all 0");
  const LightView view = directional_view(light);
  return plan_vpu(voxels, view, all_voxels(voxels), settings);
}

Result<VpuPlan> plan_vpu(const voxel::VoxelSet& voxels, const LightView& view, const ViewVoxels& seen,
                         const VpuSettings& settings) {
  if (seen.casters.empty() && seen.receivers.empty())
    return fail("the scene has no voxels: expected at least one surface inside the grid");
  if (view.perspective()) return plan_perspective(voxels, view, seen, settings);
  // One voxel's reach beyond the outermost points on each side: offset points must find their entries.
  const double reach = settings.offset_factor + 1;
  const auto side_log2 = [&](const Extent& extent) {
    const double needed = std::max(extent.u.size(), extent.v.size()) + 2 * reach;
    return std::max(4, log2_ceil(needed / settings.pitch + 2));
  };
  const ViewVoxels some = sampled(seen);
  const LightAxes axes = settings.plane_log2 > 0 ? view.axes : oriented(view.axes, [&](const LightAxes& to) {
    return side_log2(extent_of(voxels, some, to));
  });
  const Extent extent = extent_of(voxels, seen, axes);
  const double side = std::max(extent.u.size(), extent.v.size());

  VpuPlan plan;
  plan.settings = settings;
  double pitch = settings.pitch;
  int plane_log2 = settings.plane_log2;
  const double needed = side + 2 * reach;
  if (plane_log2 == 0) {
    plane_log2 = side_log2(extent);
  } else {
    // A plane that was asked for holds the whole scene: where it is too small, its entries grow.
    pitch = std::max(pitch, needed / (std::ldexp(1.0, plane_log2) - 2));
  }
  plan.settings.pitch = pitch;

  plan.config = hardware_for(voxels, settings);
  auto& config = plan.config;
  config.plane_log2 = plane_log2;
  plan.settings.plane_log2 = plane_log2;
  plan.settings.normal_bits = config.normal_bits;
  plan.settings.voxel_frac_bits = config.voxel_frac_bits;
  if (const auto wrong = config.check()) return fail(*wrong);

  plan.projection = make_projection(axes, extent, pitch, config.plane_side(), config.depth_bits, reach);
  if (auto done = set_registers(plan); !done) return tl::make_unexpected(done.error());
  return plan;
}

golden::VoxelItem voxel_item(const voxel::Voxel& voxel, const golden::HardwareConfig& config) {
  const double scale = std::ldexp(1.0, config.voxel_frac_bits);
  const auto last = (std::uint32_t{1} << config.voxel_frac_bits) - 1;
  const double unit = std::ldexp(1.0, config.normal_bits - 1) - 1;
  const std::array<std::uint32_t, 3> cell{voxel.x, voxel.y, voxel.z};
  golden::VoxelItem item;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto inside = static_cast<std::uint32_t>(std::floor(double{voxel.point[axis]} * scale));
    item.position[axis] = (cell[axis] << config.voxel_frac_bits) + std::min(inside, last);
    item.normal[axis] = static_cast<std::int32_t>(std::lround(double{voxel.normal[axis]} * unit));
  }
  return item;
}

std::vector<golden::VoxelItem> voxel_items(const voxel::VoxelSet& voxels,
                                           const golden::HardwareConfig& config) {
  std::vector<golden::VoxelItem> items(voxels.voxels.size());
  std::transform(voxels.voxels.begin(), voxels.voxels.end(), items.begin(),
                 [&](const voxel::Voxel& voxel) { return voxel_item(voxel, config); });
  return items;
}

}  // namespace gnomon::plan
