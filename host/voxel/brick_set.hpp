// SPDX-License-Identifier: Apache-2.0
// A set of voxels in bricks of 8x8x8 bits: memory and time grow with the surface, not with the volume.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

#include "host/voxel/voxel_key.hpp"

namespace gnomon::voxel {

class BrickSet {
 public:
  /// With `indexed`, members carry a number; it costs 2 KiB a brick.
  explicit BrickSet(bool indexed = false);
  // A copy would remember bricks of the original.
  BrickSet(BrickSet&&) = default;
  BrickSet& operator=(BrickSet&&) = default;

  /// Adds a voxel; true if it was not a member. Members are numbered in the order of insertion.
  bool insert(VoxelKey key);
  bool contains(VoxelKey key) const;
  /// The number of a member; only if indexed.
  std::uint32_t index(VoxelKey key) const;
  std::size_t size() const { return size_; }

  /// Adds all members of another set, which is not indexed and not needed any more.
  void merge(BrickSet&& other);

  /// Calls `visit(key)` for every member, ordered by brick (z, y, x) and within a brick by z, y, x.
  template <class Visit>
  void for_each(Visit visit) const {
    for (const auto& [corner, b] : ordered()) {
      const Brick& brick = bricks_[b];
      for (std::uint32_t z = 0; z < 8; ++z) {
        const VoxelKey layer = corner + pack(0, 0, z);
        for (std::uint64_t bits = brick[z]; bits != 0; bits &= bits - 1) {
          const auto bit = static_cast<std::uint32_t>(std::countr_zero(bits));
          visit(layer + pack(bit % 8, bit / 8, 0));
        }
      }
    }
  }

 private:
  using Brick = std::array<std::uint64_t, 8>;  // one word per z, bit y * 8 + x
  struct Spot {
    std::uint32_t word, bit;
  };
  static constexpr std::uint32_t kNone = ~0U;

  // The voxel in a brick's low corner names the brick.
  static VoxelKey brick_key(VoxelKey key) { return key & ~pack(7, 7, 7); }
  static Spot spot(VoxelKey key) { return {key_z(key) & 7, (key_y(key) & 7) * 8 + (key_x(key) & 7)}; }
  static std::size_t hash(VoxelKey key) { return static_cast<std::size_t>(key * 0x9e3779b97f4a7c15U >> 32); }

  std::uint32_t find(VoxelKey brick) const;
  std::uint32_t find_or_add(VoxelKey brick);
  struct Recent {
    VoxelKey key = ~VoxelKey{0};
    Brick* bits = nullptr;
    std::uint32_t number = kNone;
  };
  const Recent& brick_of(VoxelKey key);
  void grow();
  std::vector<std::pair<VoxelKey, std::uint32_t>> ordered() const;  // keys and numbers, by key

  bool indexed_;
  std::vector<std::uint32_t> directory_;  // open addressing: numbers of bricks
  std::vector<VoxelKey> keys_;            // of each brick
  std::deque<Brick> bricks_;              // stay where they are
  std::vector<std::array<std::uint32_t, 512>> indices_;
  std::size_t size_ = 0;
  // Most insertions go to bricks that have been asked for just before.
  std::array<Recent, 64> recent_;
};

inline const BrickSet::Recent& BrickSet::brick_of(VoxelKey key) {
  const VoxelKey brick = brick_key(key);
  // The product's highest 6 bits are x + 4 y + 16 z of the brick: bricks near each other have places of their
  // own.
  constexpr std::uint64_t kSpread =
      (std::uint64_t{1} << 55) + (std::uint64_t{1} << 36) + (std::uint64_t{1} << 17);
  Recent& recent = recent_[brick * kSpread >> 58];
  if (brick != recent.key) {
    const std::uint32_t number = find_or_add(brick);
    recent = {brick, &bricks_[number], number};
  }
  return recent;
}

inline bool BrickSet::insert(VoxelKey key) {
  const Recent& brick = brick_of(key);
  const Spot s = spot(key);
  std::uint64_t& word = (*brick.bits)[s.word];
  const std::uint64_t before = word;
  // No branch here: whether a voxel is new is hard to foresee.
  word = before | std::uint64_t{1} << s.bit;
  const bool fresh = (before >> s.bit & 1) == 0;
  if (indexed_ && fresh) indices_[brick.number][s.word * 64 + s.bit] = static_cast<std::uint32_t>(size_);
  size_ += fresh ? 1 : 0;
  return fresh;
}

}  // namespace gnomon::voxel
