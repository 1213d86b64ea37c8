// SPDX-License-Identifier: Apache-2.0
// Open addressing, at most half full.
#include "host/metrics/voxel_index.hpp"

#include <bit>
#include <cmath>
#include <limits>

namespace gnomon::metrics {

Vec3 representative(const voxel::Voxel& voxel) {
  return {double{voxel.point[0]} + voxel.x, double{voxel.point[1]} + voxel.y,
          double{voxel.point[2]} + voxel.z};
}

Vec3 representative_normal(const voxel::Voxel& voxel) {
  return {voxel.normal[0], voxel.normal[1], voxel.normal[2]};
}

VoxelIndex::VoxelIndex(const voxel::VoxelSet& voxels)
    : voxels_(voxels), table_(std::bit_ceil(2 * voxels.voxels.size() + 2), kNoVoxel) {
  for (std::uint32_t i = 0; i < voxels.voxels.size(); ++i) {
    const voxel::Voxel& v = voxels.voxels[i];
    std::size_t at = slot(v.x, v.y, v.z);
    while (table_[at] != kNoVoxel) at = (at + 1) & (table_.size() - 1);
    table_[at] = i;
  }
}

std::size_t VoxelIndex::slot(int x, int y, int z) const {
  const std::uint64_t key = (static_cast<std::uint64_t>(z) << 42) ^ (static_cast<std::uint64_t>(y) << 21) ^
                            static_cast<std::uint64_t>(x);
  return static_cast<std::size_t>((key * 0x9E3779B97F4A7C15ULL) >> 20) & (table_.size() - 1);
}

std::uint32_t VoxelIndex::find(int x, int y, int z) const {
  for (std::size_t at = slot(x, y, z); table_[at] != kNoVoxel; at = (at + 1) & (table_.size() - 1)) {
    const voxel::Voxel& v = voxels_.voxels[table_[at]];
    if (v.x == x && v.y == y && v.z == z) return table_[at];
  }
  return kNoVoxel;
}

std::uint32_t VoxelIndex::answering(const Vec3& point) const {
  const int x = static_cast<int>(std::floor(point.x));
  const int y = static_cast<int>(std::floor(point.y));
  const int z = static_cast<int>(std::floor(point.z));
  if (const std::uint32_t own = find(x, y, z); own != kNoVoxel) return own;
  std::uint32_t best = kNoVoxel;
  double best_distance = std::numeric_limits<double>::infinity();
  for (int dz = -1; dz <= 1; ++dz)
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const std::uint32_t near = find(x + dx, y + dy, z + dz);
        if (near == kNoVoxel) continue;
        const double distance = (representative(voxels_.voxels[near]) - point).length2();
        if (distance < best_distance || (distance == best_distance && near < best)) {
          best = near;
          best_distance = distance;
        }
      }
  return best;
}

}  // namespace gnomon::metrics
