// SPDX-License-Identifier: Apache-2.0
// Remembers the voxels of some points of one face; forgets where two fall into the same slot.
#pragma once

#include <optional>
#include <vector>

#include "host/voxel/voxel_key.hpp"

namespace gnomon::voxel {

/// What it has forgotten depends on nothing but the questions since the last start().
class PointMemo {
 public:
  PointMemo() : entries_(kSlots) {}

  /// Forgets everything: another face is begun.
  void start() {
    stamp_ = (stamp_ + 1) % (std::uint64_t{1} << kStampBits);
    if (stamp_ == 0) entries_.assign(kSlots, {});
    stamp_ += stamp_ == 0 ? 1 : 0;
  }

  /// Parameters in units of 2^-24, 0..2^24.
  std::optional<VoxelKey> find(std::uint32_t u, std::uint32_t v) const {
    const Entry& e = entries_[slot(u, v)];
    return e.tag == tag(u, v) ? std::optional(e.key) : std::nullopt;
  }
  void remember(std::uint32_t u, std::uint32_t v, VoxelKey key) { entries_[slot(u, v)] = {tag(u, v), key}; }

 private:
  static constexpr std::size_t kSlots = 4096;
  static constexpr int kStampBits = 14;
  struct Entry {
    std::uint64_t tag = 0;
    VoxelKey key = 0;
  };
  std::uint64_t tag(std::uint32_t u, std::uint32_t v) const {
    return (std::uint64_t{u} << 25 | v) << kStampBits | stamp_;
  }
  static std::size_t slot(std::uint32_t u, std::uint32_t v) {
    return static_cast<std::size_t>((std::uint64_t{u} << 25 | v) * 0x9e3779b97f4a7c15U >> 52) % kSlots;
  }

  std::uint64_t stamp_ = 1;
  std::vector<Entry> entries_;
};

}  // namespace gnomon::voxel
