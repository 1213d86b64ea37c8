// SPDX-License-Identifier: Apache-2.0
// What the planners of both projections share: widths of the hardware, rounding into registers.
#pragma once

#include <cstdint>

#include "host/plan/vpu_plan.hpp"

namespace gnomon::plan {

inline constexpr int kOffsetFracBits = 16;
inline constexpr int kDeltaBits = 12;
inline constexpr int kSlopeBits = 16;
inline constexpr int kMarginBits = 24;

/// Smallest n with 2^n >= x.
int log2_ceil(double x);
/// Nearest.
std::int64_t round_fixed(double value, int frac_bits);
/// Shift that brings a magnitude below 2^bits.
int shift_for(double magnitude, int bits);

/// Widths as the settings and the grid have them; the plane is left as it is. Not checked.
golden::HardwareConfig hardware_for(const voxel::VoxelSet& voxels, const VpuSettings& settings);

/// OFFSET_FACTOR; fails where it does not fit.
Result<std::int64_t> offset_factor(const VpuSettings& settings, const golden::HardwareConfig& config);

/// The plan of a view from a light's place (docs/vpu.md, "What the host chooses").
Result<VpuPlan> plan_perspective(const voxel::VoxelSet& voxels, const LightView& view, const ViewVoxels& seen,
                                 const VpuSettings& settings);

}  // namespace gnomon::plan
