// SPDX-License-Identifier: Apache-2.0
// Lists of voxel items that are hard on a projection unit in one way each.
#pragma once

#include <cstddef>
#include <gnomon/golden/codec.hpp>
#include <vector>

#include "tests/support/random.hpp"
#include "tests/support/scene_registers.hpp"

namespace gnomon::stimulus {

enum class Pattern {
  Uniform,  ///< anywhere, any normal
  Columns,  ///< stacks along the light: several depths in one entry
  Burst,    ///< one position after the other in a handful of entries, in short cycles: hazards at every
            ///< distance
  Ties,     ///< the same positions again and again, other normals
  Sheet,    ///< a tilted surface, row after row, with its own normal
  Corners,  ///< positions and normals at the ends of their ranges
  Grazing,  ///< normals nearly or exactly across the light
};
inline constexpr int kPatternCount = 7;

/// `count` items of the pattern, made for these registers.
std::vector<golden::VoxelItem> voxel_pattern(Pattern pattern, std::size_t count,
                                             const RegisterValues& registers,
                                             const golden::HardwareConfig& config, Random& random);

}  // namespace gnomon::stimulus
