// SPDX-License-Identifier: Apache-2.0
// Chooses plane, scale, depth key and register contents for one view from a light's place (docs/planning.md,
// "Spots and point lights").
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "host/plan/orientation.hpp"
#include "host/plan/plan_registers.hpp"
#include "host/plan/representative.hpp"

namespace gnomon::plan {
namespace {

using golden::Register;

constexpr double kNearest = 0.5;     // voxels: what is nearer to the light's plane casts no shadow
constexpr double kDepthRatio = 256;  // farthest to nearest distance that depth codes tell apart
constexpr double kFarLight = 3.9;    // largest |w| at the grid's corner that MATRIX_W1 holds
constexpr int kSmallestPlane = 4, kLargestPlane = 12;  // log2
constexpr double kSurround = 2;                        // entries beyond the outermost receiver
/// Receivers as near to the light as this share of the typical distance do not widen the plane for the reach
/// of their offset points.
constexpr double kNearShare = 0.125;
constexpr double kNearCasters = 0.02;  // share of the casters that may be nearer than `near`
constexpr double kNearestShare = 16;   // `near` is at least the typical distance by this

struct Interval {
  double lo = std::numeric_limits<double>::infinity();
  double hi = -std::numeric_limits<double>::infinity();
  void extend(double x, double by) {
    lo = std::min(lo, x - by);
    hi = std::max(hi, x + by);
  }
  double size() const { return hi - lo; }
  double middle() const { return 0.5 * (lo + hi); }
};

/// What the light sees, as tangents of angles to the axis, and at which distances.
struct Sight {
  Interval x, y, z;
  double typical = 1;   ///< median z of the receivers
  double near = 1;      ///< z of the nearest casters, but for a few
  double mean = 1;      ///< mean z of the receivers
  double farthest = 0;  ///< distance from the light to anything
};

Sight sight_of(const voxel::VoxelSet& voxels, const LightView& view, const LightAxes& axes,
               const ViewVoxels& seen, double reach) {
  Sight sight;
  const auto from_eye = [&](std::uint32_t i) { return representative(voxels.voxels[i]) - view.eye; };
  std::vector<double> distances, of_casters;
  for (const auto* numbers : {&seen.casters, &seen.receivers}) {
    for (const std::uint32_t i : *numbers) {
      const Vec3 q = from_eye(i);
      const double z = view.axes.away.dot(q);
      if (z < kNearest) continue;
      sight.z.extend(z, 0);
      sight.farthest = std::max(sight.farthest, q.length());
      (numbers == &seen.receivers ? distances : of_casters).push_back(z);
    }
  }
  if (distances.empty()) return sight;
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  double sum = 0;
  for (const double z : distances) sum += z;
  sight.mean = sum / static_cast<double>(distances.size());
  std::ranges::nth_element(distances, middle);
  sight.typical = *middle;
  sight.near = sight.typical;
  if (!of_casters.empty()) {
    const auto few = static_cast<std::ptrdiff_t>(kNearCasters * static_cast<double>(of_casters.size()));
    std::ranges::nth_element(of_casters, of_casters.begin() + few);
    sight.near = std::max(of_casters[static_cast<std::size_t>(few)], sight.typical / kNearestShare);
  }
  for (const std::uint32_t i : seen.receivers) {
    const Vec3 q = from_eye(i);
    const double z = view.axes.away.dot(q);
    if (z < kNearest) continue;
    const double by = reach / std::max(z, kNearShare * sight.typical);
    sight.x.extend(axes.right.dot(q) / z, by);
    sight.y.extend(axes.up.dot(q) / z, by);
  }
  return sight;
}

/// Entries per unit of slope: as the pitch asks for at the typical receiver and at the nearest casters.
double wanted_entries(const VpuSettings& settings, const Sight& sight) {
  const double caster_pitch = settings.caster_pitch > 0 ? settings.caster_pitch : settings.pitch;
  return std::min(sight.typical / settings.pitch, sight.near / caster_pitch);
}

/// Planes between the middle of the plane and the axis that CENTRE can say on either side: it holds two
/// planes, less an entry, from the plane's low corner.
constexpr double kFarthestAxis = 1.5;

/// What the plane must be able to hold in slopes: the box, and the axis within reach of CENTRE.
double slopes_across(const Sight& sight) {
  const double off = std::max(std::abs(sight.x.middle()), std::abs(sight.y.middle()));
  return std::max({sight.x.size(), sight.y.size(), off / kFarthestAxis});
}

/// The smallest plane that holds the box.
int side_log2_for(const VpuSettings& settings, const Sight& sight) {
  const double extent = slopes_across(sight);
  if (!(extent > 0)) return kSmallestPlane;
  const double side = wanted_entries(settings, sight) * extent + 2 * kSurround;
  return std::clamp(log2_ceil(side), kSmallestPlane, kLargestPlane);
}

void lay_plane(VpuPlan& plan, const Sight& sight) {
  const VpuSettings& settings = plan.settings;
  Projection& p = plan.projection;
  plan.config.plane_log2 = settings.plane_log2 > 0 ? settings.plane_log2 : side_log2_for(settings, sight);
  p.plane_side = plan.config.plane_side();
  p.entries_a_slope =
      std::min(wanted_entries(settings, sight), (p.plane_side - 2 * kSurround) / slopes_across(sight));
  const auto centre = [&](const Interval& range) {
    return std::round(0.5 * p.plane_side - p.entries_a_slope * range.middle());
  };
  p.centre = {centre(sight.x), centre(sight.y)};
  p.pitch = sight.mean / p.entries_a_slope;
}

void set_depth(VpuPlan& plan, const Sight& sight) {
  Projection& p = plan.projection;
  const double last = std::ldexp(1.0, plan.config.depth_bits) - 2;
  const double near = std::max(sight.z.lo, sight.z.hi / kDepthRatio);
  const double far = std::max(sight.z.hi, 1.001 * near);
  p.key_scale = last / (p.w_scale / near - p.w_scale / far);
  p.key_limit = p.key_scale * p.w_scale / near;
  const double most = std::ldexp(1.0, plan.config.depth_bits + 4) - 1;
  const double too_large = std::max({1.0, p.key_limit / most, p.key_scale / most});
  p.key_scale /= too_large;
  p.key_limit /= too_large;
}

void set_rows(VpuPlan& plan, const LightAxes& axes) {
  const golden::HardwareConfig& config = plan.config;
  Projection& p = plan.projection;
  const double scale = p.entries_a_slope / p.w_scale;
  p.u = axes.right * scale;
  p.v = axes.up * scale;
  p.u1 = -p.u.dot(p.eye);
  p.v1 = -p.v.dot(p.eye);
  const double ulp = std::ldexp(1.0, -config.voxel_frac_bits);
  const Vec3 corner = Vec3(ulp / 2) - p.eye;
  const auto row = [&](Register first, const Vec3& step, int frac_bits) {
    const auto base = static_cast<std::size_t>(first);
    for (int axis = 0; axis < 3; ++axis)
      plan.registers[base + static_cast<std::size_t>(axis)] = round_fixed(step[axis] * ulp, frac_bits);
    plan.registers[base + 3] = round_fixed(step.dot(corner), frac_bits);
  };
  row(Register::MatrixUx, p.u, config.matrix_frac_bits);
  row(Register::MatrixVx, p.v, config.matrix_frac_bits);
  row(Register::MatrixWx, axes.away / p.w_scale, config.matrix_frac_bits + config.position_bits());
}

void set_margin(VpuPlan& plan, const Sight& sight) {
  const golden::HardwareConfig& config = plan.config;
  const Projection& p = plan.projection;
  const int frac = config.voxel_frac_bits, f = config.matrix_frac_bits;
  const double unit = std::ldexp(1.0, config.normal_bits - 1) - 1;
  const double code_count = std::ldexp(1.0, config.depth_bits);
  const double entries = plan.settings.margin / plan.settings.pitch;
  const double delta_max = std::min(
      std::round(code_count * entries * plan.settings.margin_tan_max / p.entries_a_slope), code_count - 1);
  const int facing_shift = shift_for(std::ldexp(unit * sight.farthest, frac + 3), kSlopeBits);
  const int tilt_shift = shift_for(std::ldexp(unit * p.entries_a_slope / p.w_scale, f - frac), kSlopeBits);
  int delta_shift = shift_for(delta_max * p.key_limit / code_count, kDeltaBits);
  const auto squared = [&] {
    const double w_an_entry = p.w_scale / p.entries_a_slope;
    const double root = std::ldexp(entries * p.key_scale * w_an_entry * w_an_entry,
                                   2 * frac + 3 - f + tilt_shift - facing_shift - delta_shift);
    return std::round(root * root);
  };
  while (squared() >= std::ldexp(1.0, kMarginBits)) ++delta_shift;
  const auto set = [&](Register reg, double value) {
    plan.registers[static_cast<std::size_t>(reg)] = static_cast<std::int64_t>(value);
  };
  set(Register::FacingShift, facing_shift);
  set(Register::TiltShift, tilt_shift);
  set(Register::DeltaShift, delta_shift);
  set(Register::MarginSquared, squared());
  set(Register::DeltaMax, delta_max);
}

void set_light(VpuPlan& plan, const LightView& view) {
  constexpr int kLightFracBits = 3, kKeyFracBits = 4, kConeFracBits = 16;
  const golden::HardwareConfig& config = plan.config;
  const Projection& p = plan.projection;
  const auto set = [&](Register reg, std::int64_t value) {
    plan.registers[static_cast<std::size_t>(reg)] = value;
  };
  const bool cone = view.kind == LightView::Kind::Spot;
  set(Register::Projection,
      golden::kProjectionPerspective | (cone ? golden::kProjectionCone : std::int64_t{0}));
  const double near = std::floor(std::ldexp(p.z_min / p.w_scale, config.position_bits()));
  set(Register::WNear, std::max(std::int64_t{1}, static_cast<std::int64_t>(near)));
  set(Register::CentreU, static_cast<std::int64_t>(p.centre.x));
  set(Register::CentreV, static_cast<std::int64_t>(p.centre.y));
  set(Register::KeyLimit, round_fixed(p.key_limit, kKeyFracBits));
  set(Register::KeyScale, round_fixed(p.key_scale, kKeyFracBits));
  for (int axis = 0; axis < 3; ++axis)
    plan.registers[static_cast<std::size_t>(Register::LightX) + static_cast<std::size_t>(axis)] =
        round_fixed(view.eye[axis], config.voxel_frac_bits + kLightFracBits);
  const double radius = cone ? p.entries_a_slope * view.tangent : 0;
  set(Register::ConeSquared, round_fixed(radius * radius, kConeFracBits));
}

/// A light too far from the grid for the registers, which the settings do not show.
Result<void> check_registers(const VpuPlan& plan) {
  for (std::size_t i = 0; i < plan.registers.size(); ++i) {
    const auto format = golden::register_format(static_cast<Register>(i), plan.config);
    const double limit = std::ldexp(1.0, format.width - (format.is_signed ? 1 : 0));
    const auto value = static_cast<double>(plan.registers[i]);
    if (value < limit && value >= (format.is_signed ? -limit : 0.0)) continue;
    return fail(
        fmt::format("a light is too far from the scene for the hardware: {} needs more than its {} "
                    "bits; expected a light within {} voxels of the grid, or a directional one",
                    format.name, format.width, 4 << plan.config.voxel_bits));
  }
  return {};
}

}  // namespace

Result<VpuPlan> plan_perspective(const voxel::VoxelSet& voxels, const LightView& view, const ViewVoxels& seen,
                                 const VpuSettings& settings) {
  VpuPlan plan;
  plan.settings = settings;
  plan.config = hardware_for(voxels, settings);
  plan.config.en_perspective = true;
  if (settings.plane_log2 > 0) plan.config.plane_log2 = settings.plane_log2;
  if (const auto wrong = plan.config.check()) return fail(*wrong);
  const double reach = settings.offset_factor + 1;
  const ViewVoxels some = sampled(seen);
  const LightAxes axes = settings.plane_log2 > 0 ? view.axes : oriented(view.axes, [&](const LightAxes& to) {
    return side_log2_for(settings, sight_of(voxels, view, to, some, reach));
  });
  Sight sight = sight_of(voxels, view, axes, seen, reach);
  if (sight.x.size() < 0) {
    // All receivers lie at the light itself: any plane will do, all are behind.
    for (Interval* range : {&sight.x, &sight.y}) range->extend(0, 1);
    sight.z.extend(1, 0);
  }
  Projection& p = plan.projection;
  p.perspective = true;
  p.eye = view.eye;
  p.axis = view.axes.away;
  p.z_min = kNearest;
  const double at_corner = std::abs(p.axis.dot(Vec3(0.5) - view.eye)) + 1;
  p.w_scale =
      std::max({sight.z.hi + reach, std::ldexp(1.0, plan.config.voxel_bits - 1) + 1, at_corner / kFarLight});
  lay_plane(plan, sight);
  set_depth(plan, sight);
  plan.registers.assign(golden::kAllRegisterCount, 0);
  set_rows(plan, axes);
  const auto factor = offset_factor(settings, plan.config);
  if (!factor) return tl::make_unexpected(factor.error());
  plan.registers[static_cast<std::size_t>(Register::OffsetFactor)] = *factor;
  set_margin(plan, sight);
  set_light(plan, view);
  plan.settings.plane_log2 = plan.config.plane_log2;
  plan.settings.normal_bits = plan.config.normal_bits;
  plan.settings.voxel_frac_bits = plan.config.voxel_frac_bits;
  if (auto fits = check_registers(plan); !fits) return tl::make_unexpected(fits.error());
  return plan;
}

}  // namespace gnomon::plan
