// SPDX-License-Identifier: Apache-2.0
// A set of voxels in bricks of 8x8x8 bits: memory and time grow with the surface, not with the volume.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "host/voxel/voxel_key.hpp"

namespace gnomon::voxel {

class BrickSet {
 public:
  /// With `indexed`, members carry a number; it costs 2 KiB a brick.
  explicit BrickSet(bool indexed = false);

  /// Adds a voxel; true if it was not a member. Members are numbered in the order of insertion.
  bool insert(VoxelKey key);
  bool contains(VoxelKey key) const;
  /// The number of a member; only if indexed.
  std::uint32_t index(VoxelKey key) const;
  std::size_t size() const { return size_; }

  /// Calls `visit` for every member, ordered by brick (z, y, x) and within a brick by z, y, x.
  void for_each(const std::function<void(VoxelKey)>& visit) const;

 private:
  using Brick = std::array<std::uint64_t, 8>;  // one word per z, bit y * 8 + x
  struct Spot {
    std::uint32_t word, bit;
  };
  static constexpr std::uint32_t kNone = ~0U;

  static VoxelKey brick_key(VoxelKey key) { return key >> 3 & ~pack(7U << 18, 7U << 18, 7U << 18); }
  static Spot spot(VoxelKey key) { return {key_z(key) & 7, (key_y(key) & 7) * 8 + (key_x(key) & 7)}; }
  static std::size_t hash(VoxelKey key) { return static_cast<std::size_t>(key * 0x9e3779b97f4a7c15U >> 32); }

  std::uint32_t find(VoxelKey brick) const;
  std::uint32_t find_or_add(VoxelKey brick);
  void grow();

  bool indexed_;
  std::vector<std::uint32_t> directory_;  // open addressing: numbers of bricks
  std::vector<VoxelKey> keys_;            // of each brick
  std::vector<Brick> bricks_;
  std::vector<std::array<std::uint32_t, 512>> indices_;
  std::size_t size_ = 0;
  VoxelKey last_key_ = ~VoxelKey{0};  // most insertions go to the brick of the one before
  std::uint32_t last_ = kNone;
};

}  // namespace gnomon::voxel
