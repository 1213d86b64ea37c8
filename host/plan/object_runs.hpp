// SPDX-License-Identifier: Apache-2.0
// Voxels by object: one command has one object's flags.
#pragma once

#include <cstdint>
#include <span>

#include "host/voxel/voxel_set.hpp"

namespace gnomon::plan {

/// Calls visit(numbers, object) for each run of one object's voxels among `numbers`. Voxels are sorted by
/// object, so ascending numbers make one run an object.
template <class Visit>
void for_each_object(std::span<const std::uint32_t> numbers, const voxel::VoxelSet& voxels, Visit visit) {
  for (std::size_t first = 0; first < numbers.size();) {
    const std::uint32_t object = voxels.voxels[numbers[first]].object;
    std::size_t end = first;
    while (end < numbers.size() && voxels.voxels[numbers[end]].object == object) ++end;
    visit(numbers.subspan(first, end - first), object);
    first = end;
  }
}

}  // namespace gnomon::plan
