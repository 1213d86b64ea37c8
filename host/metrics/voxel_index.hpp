// SPDX-License-Identifier: Apache-2.0
// From a point of the surface to the set voxel that answers for it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "host/voxel/voxel_set.hpp"

namespace gnomon::metrics {

inline constexpr std::uint32_t kNoVoxel = 0xFFFFFFFF;

/// The representative point of a voxel, grid coordinates.
Vec3 representative(const voxel::Voxel& voxel);
/// Its normal.
Vec3 representative_normal(const voxel::Voxel& voxel);

/// The voxels of a set (which must outlive it) in bricks of 4 x 4 x 4 cells, which a hash table finds: what
/// lies together is found together. 4 bytes a voxel and 48 to 96 a brick.
class VoxelIndex {
 public:
  explicit VoxelIndex(const voxel::VoxelSet& voxels);
  /// The set voxel at these coordinates, or kNoVoxel.
  std::uint32_t find(int x, int y, int z) const;
  /// The set voxel that holds the point; if that cell is empty, the one of its 26 neighbours whose
  /// representative is nearest (the lower index where two are); kNoVoxel if none is set.
  std::uint32_t answering(const Vec3& point) const;

  /// The same for points that follow each other closely: what was found for the last cell is kept. The index
  /// must outlive it; one thread uses it.
  class Walk {
   public:
    explicit Walk(const VoxelIndex& index) : index_(index) {}
    std::uint32_t answering(const Vec3& point);

   private:
    void enter(const std::array<int, 3>& cell);
    void add(std::uint32_t voxel) {
      if (voxel != kNoVoxel) around_[count_++] = voxel;
    }

    const VoxelIndex& index_;
    bool entered_ = false;
    std::array<int, 3> cell_{};
    std::array<std::uint32_t, 26> around_{};  ///< the voxel of the cell alone, or the set ones around it
    std::size_t count_ = 0;
  };

 private:
  struct Brick {
    std::uint64_t place = 0;
    std::uint64_t cells = 0;  ///< one bit for each cell that is set; none in a slot of the table that is free
    std::uint32_t first = 0;  ///< in voxel_, where its voxels stand in the order of the bits
  };
  Brick& slot(std::uint64_t place);
  const voxel::VoxelSet& voxels_;
  std::vector<std::uint32_t> voxel_;
  std::vector<Brick> table_;
};

}  // namespace gnomon::metrics
