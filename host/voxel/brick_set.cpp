// SPDX-License-Identifier: Apache-2.0
// An open-addressing directory of bit bricks.
#include "host/voxel/brick_set.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace gnomon::voxel {

BrickSet::BrickSet(bool indexed) : indexed_(indexed), directory_(8192, kNone) {}

std::uint32_t BrickSet::find(VoxelKey brick) const {
  const std::size_t mask = directory_.size() - 1;
  for (std::size_t i = hash(brick) & mask;; i = (i + 1) & mask) {
    if (directory_[i] == kNone || keys_[directory_[i]] == brick) return directory_[i];
  }
}

void BrickSet::grow() {
  directory_.assign(directory_.size() * 2, kNone);
  const std::size_t mask = directory_.size() - 1;
  for (std::uint32_t b = 0; b < keys_.size(); ++b) {
    std::size_t i = hash(keys_[b]) & mask;
    while (directory_[i] != kNone) i = (i + 1) & mask;
    directory_[i] = b;
  }
}

std::uint32_t BrickSet::find_or_add(VoxelKey brick) {
  if (const std::uint32_t b = find(brick); b != kNone) return b;
  if (2 * (keys_.size() + 1) > directory_.size()) grow();
  const auto added = static_cast<std::uint32_t>(keys_.size());
  keys_.push_back(brick);
  bricks_.push_back({});
  if (indexed_) indices_.emplace_back();
  const std::size_t mask = directory_.size() - 1;
  std::size_t i = hash(brick) & mask;
  while (directory_[i] != kNone) i = (i + 1) & mask;
  directory_[i] = added;
  return added;
}

void BrickSet::merge(BrickSet&& other) {
  if (keys_.empty() && !indexed_) {
    *this = std::move(other);
    return;
  }
  for (std::size_t b = 0; b < other.keys_.size(); ++b) {
    Brick& mine = bricks_[find_or_add(other.keys_[b])];
    for (std::size_t z = 0; z < mine.size(); ++z) {
      const std::uint64_t fresh = other.bricks_[b][z] & ~mine[z];
      size_ += static_cast<std::size_t>(std::popcount(fresh));
      mine[z] |= fresh;
    }
  }
}

bool BrickSet::contains(VoxelKey key) const {
  const std::uint32_t b = find(brick_key(key));
  const Spot s = spot(key);
  return b != kNone && (bricks_[b][s.word] >> s.bit & 1) != 0;
}

std::uint32_t BrickSet::index(VoxelKey key) const {
  const Spot s = spot(key);
  return indices_[find(brick_key(key))][s.word * 64 + s.bit];
}

std::vector<std::pair<VoxelKey, std::uint32_t>> BrickSet::ordered() const {
  std::vector<std::pair<VoxelKey, std::uint32_t>> order;
  order.reserve(keys_.size());
  for (std::uint32_t b = 0; b < keys_.size(); ++b) order.emplace_back(keys_[b], b);
  std::sort(order.begin(), order.end());
  return order;
}

}  // namespace gnomon::voxel
