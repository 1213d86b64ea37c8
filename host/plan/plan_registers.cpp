// SPDX-License-Identifier: Apache-2.0
// What the planners of both projections share.
#include "host/plan/plan_registers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace gnomon::plan {
namespace {

constexpr int kAxisBits = 21;        // position and normal bits an axis: three axes fill a 64-bit word
constexpr int kUsualFracBits = 4;    // more buys nothing at 256^3 (docs/planning.md)
constexpr int kUsualNormalBits = 9;  // more buys nothing at 256^3 (docs/planning.md)
constexpr int kOffsetBits = 18;

}  // namespace

int log2_ceil(double x) {
  return static_cast<int>(std::ceil(std::log2(x)));
}

std::int64_t round_fixed(double value, int frac_bits) {
  return std::llround(std::ldexp(value, frac_bits));
}

int shift_for(double magnitude, int bits) {
  return std::max(0, log2_ceil(magnitude + 1) - bits);
}

golden::HardwareConfig hardware_for(const voxel::VoxelSet& voxels, const VpuSettings& settings) {
  golden::HardwareConfig config;
  config.voxel_bits = std::max(4, static_cast<int>(std::bit_width(voxels.grid.res - 1)));
  const int left =
      kAxisBits - config.voxel_bits - (settings.normal_bits > 0 ? settings.normal_bits : kUsualNormalBits);
  config.voxel_frac_bits =
      settings.voxel_frac_bits >= 0 ? settings.voxel_frac_bits : std::clamp(left, 0, kUsualFracBits);
  config.normal_bits = settings.normal_bits > 0
                           ? settings.normal_bits
                           : std::min(kUsualNormalBits, kAxisBits - config.position_bits());
  config.matrix_frac_bits = settings.matrix_frac_bits;
  config.depth_bits = settings.depth_bits;
  return config;
}

Result<std::int64_t> offset_factor(const VpuSettings& settings, const golden::HardwareConfig& config) {
  const double unit = std::ldexp(1.0, config.normal_bits - 1) - 1;
  const int frac = config.voxel_frac_bits;
  const std::int64_t factor = round_fixed(std::ldexp(settings.offset_factor, frac) / unit, kOffsetFracBits);
  if (factor < (std::int64_t{1} << kOffsetBits)) return factor;
  return fail(
      fmt::format("offset={} is too large for voxel_frac_bits={} and normal_bits={}: expected at most {:.3g}",
                  settings.offset_factor, frac, config.normal_bits, std::ldexp(4 * unit, -frac)));
}

}  // namespace gnomon::plan
