// SPDX-License-Identifier: Apache-2.0
// From a limit point to its voxel, and the test whether two voxels are neighbours.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "host/base/vec.hpp"
#include "host/voxel/voxel_set.hpp"

namespace gnomon::voxel {

/// Limit points are rounded to this many bits below the voxel before anything is decided, so that two
/// evaluations that differ in their last bits, or a plane that lies exactly on a voxel wall, land in one
/// voxel.
inline constexpr int kFractionBits = 16;

/// A coordinate in units of 2^-16 voxel, to nearest. All that is not within [0, res), NaN included, comes out
/// as `res` voxels or more. `res` may be up to 65535.
inline std::uint32_t snap(double x, double res) {
  // Adding 1.5 * 2^(52-16) leaves the rounded multiple of 2^-16 in the low bits of the mantissa.
  constexpr double kMagic = 0x1.8p36;
  // What is below 0 wraps around, to `res` voxels at least.
  const double clamped = std::min(std::max(res - 65536, x), res);
  return static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(clamped + kMagic));
}

/// A voxel's x, y, z in fields of 21 bits.
using VoxelKey = std::uint64_t;
inline constexpr int kFieldBits = 21;

inline constexpr VoxelKey pack(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  return VoxelKey{x} | VoxelKey{y} << kFieldBits | VoxelKey{z} << (2 * kFieldBits);
}
inline constexpr VoxelKey kOnes = pack(1, 1, 1);
inline constexpr VoxelKey kGuard = kOnes << (kFieldBits - 1);  // above all coordinates, in every field

inline std::uint32_t key_x(VoxelKey k) {
  return static_cast<std::uint32_t>(k & 0x1fffff);
}
inline std::uint32_t key_y(VoxelKey k) {
  return static_cast<std::uint32_t>(k >> kFieldBits & 0x1fffff);
}
inline std::uint32_t key_z(VoxelKey k) {
  return static_cast<std::uint32_t>(k >> (2 * kFieldBits) & 0x1fffff);
}

inline VoxelKey key_of(const Voxel& v) {
  return pack(v.x, v.y, v.z);
}

/// A voxel without a representative.
inline Voxel bare_voxel(VoxelKey k) {
  Voxel v{};
  v.x = static_cast<std::uint16_t>(key_x(k));
  v.y = static_cast<std::uint16_t>(key_y(k));
  v.z = static_cast<std::uint16_t>(key_z(k));
  return v;
}

/// Learns of many voxels whether any lies outside the grid 0..res.
class GridGuard {
 public:
  explicit GridGuard(std::uint32_t res) : lift_(kGuard - pack(res, res, res)) {}
  void add(VoxelKey key) { seen_ |= key + lift_; }
  bool crossed() const { return (seen_ & kGuard) != 0; }

 private:
  VoxelKey lift_;
  VoxelKey seen_ = 0;
};

/// Non-zero where `a` and `b` are not neighbours; several results may be or-ed before they are tested.
template <Adjacency kAdjacency>
inline std::uint64_t gap(VoxelKey a, VoxelKey b) {
  // The guard keeps borrows inside their field. Each field becomes difference + 1, which is 0, 1 or 2 between
  // neighbours.
  const std::uint64_t f = ((a | kGuard) - b + kOnes) ^ kGuard;
  std::uint64_t bad = (f | (f + kOnes)) & ~(kOnes | kOnes << 1);
  if constexpr (kAdjacency == Adjacency::N18) {
    const std::uint64_t differs = (f ^ kOnes) & kOnes;
    bad |= differs & differs >> kFieldBits & differs >> (2 * kFieldBits);
  }
  return bad;
}

}  // namespace gnomon::voxel
