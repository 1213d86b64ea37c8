// SPDX-License-Identifier: Apache-2.0
// From a point of the surface to the set voxel that answers for it.
#pragma once

#include <cstdint>
#include <vector>

#include "host/voxel/voxel_set.hpp"

namespace gnomon::metrics {

inline constexpr std::uint32_t kNoVoxel = 0xFFFFFFFF;

/// The representative point of a voxel, grid coordinates.
Vec3 representative(const voxel::Voxel& voxel);
/// Its normal.
Vec3 representative_normal(const voxel::Voxel& voxel);

/// Hash table over the voxels of a set (which must outlive it). 8 to 16 bytes a voxel.
class VoxelIndex {
 public:
  explicit VoxelIndex(const voxel::VoxelSet& voxels);
  /// The set voxel at these coordinates, or kNoVoxel.
  std::uint32_t find(int x, int y, int z) const;
  /// The set voxel that holds the point; if that cell is empty, the one of its 26 neighbours whose
  /// representative is nearest (the lower index where two are); kNoVoxel if none is set.
  std::uint32_t answering(const Vec3& point) const;

 private:
  std::size_t slot(int x, int y, int z) const;
  const voxel::VoxelSet& voxels_;
  std::vector<std::uint32_t> table_;
};

}  // namespace gnomon::metrics
