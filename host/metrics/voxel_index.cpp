// SPDX-License-Identifier: Apache-2.0
// Open addressing over bricks, at most half full.
#include "host/metrics/voxel_index.hpp"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <bit>
#include <cmath>
#include <limits>
#include <tuple>

namespace gnomon::metrics {
namespace {

/// Coordinates from -4 on have places of their own.
std::uint64_t brick_place(int x, int y, int z) {
  const auto part = [](int c) { return static_cast<std::uint64_t>(std::int64_t{c >> 2} + 1); };
  return (part(z) << 42) | (part(y) << 21) | part(x);
}

unsigned brick_cell(int x, int y, int z) {
  return static_cast<unsigned>(((z & 3) << 4) | ((y & 3) << 2) | (x & 3));
}

std::size_t scrambled(std::uint64_t place) {
  return static_cast<std::size_t>((place * 0x9E3779B97F4A7C15ULL) >> 20);
}

}  // namespace

Vec3 representative(const voxel::Voxel& voxel) {
  return {double{voxel.point[0]} + voxel.x, double{voxel.point[1]} + voxel.y,
          double{voxel.point[2]} + voxel.z};
}

Vec3 representative_normal(const voxel::Voxel& voxel) {
  return {voxel.normal[0], voxel.normal[1], voxel.normal[2]};
}

VoxelIndex::VoxelIndex(const voxel::VoxelSet& voxels) : voxels_(voxels), voxel_(voxels.voxels.size()) {
  struct Entry {
    std::uint64_t place;
    unsigned cell;
    std::uint32_t voxel;
  };
  std::vector<Entry> entries(voxels.voxels.size());
  tbb::parallel_for(std::size_t{0}, entries.size(), [&](std::size_t i) {
    const voxel::Voxel& v = voxels.voxels[i];
    entries[i] = {brick_place(v.x, v.y, v.z), brick_cell(v.x, v.y, v.z), static_cast<std::uint32_t>(i)};
  });
  tbb::parallel_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return std::tuple(a.place, a.cell) < std::tuple(b.place, b.cell);
  });
  std::size_t bricks = 0;
  for (std::size_t i = 0; i < entries.size(); ++i)
    bricks += i == 0 || entries[i].place != entries[i - 1].place ? 1U : 0U;
  table_.resize(std::bit_ceil(2 * bricks + 2));
  for (std::size_t i = 0; i < entries.size(); ++i) {
    Brick& brick = slot(entries[i].place);
    if (brick.cells == 0) brick = {entries[i].place, 0, static_cast<std::uint32_t>(i)};
    brick.cells |= std::uint64_t{1} << entries[i].cell;
    voxel_[i] = entries[i].voxel;
  }
}

VoxelIndex::Brick& VoxelIndex::slot(std::uint64_t place) {
  std::size_t at = scrambled(place) & (table_.size() - 1);
  while (table_[at].cells != 0 && table_[at].place != place) at = (at + 1) & (table_.size() - 1);
  return table_[at];
}

std::uint32_t VoxelIndex::find(int x, int y, int z) const {
  const std::uint64_t place = brick_place(x, y, z);
  const std::uint64_t bit = std::uint64_t{1} << brick_cell(x, y, z);
  for (std::size_t at = scrambled(place) & (table_.size() - 1); table_[at].cells != 0;
       at = (at + 1) & (table_.size() - 1)) {
    const Brick& brick = table_[at];
    if (brick.place != place) continue;
    if ((brick.cells & bit) == 0) return kNoVoxel;
    return voxel_[brick.first + static_cast<std::size_t>(std::popcount(brick.cells & (bit - 1)))];
  }
  return kNoVoxel;
}

std::uint32_t VoxelIndex::answering(const Vec3& point) const {
  return Walk(*this).answering(point);
}

void VoxelIndex::Walk::enter(const std::array<int, 3>& cell) {
  entered_ = true;
  cell_ = cell;
  count_ = 0;
  add(index_.find(cell[0], cell[1], cell[2]));
  if (count_ > 0) return;
  for (int dz = -1; dz <= 1; ++dz)
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        if (dx != 0 || dy != 0 || dz != 0) add(index_.find(cell[0] + dx, cell[1] + dy, cell[2] + dz));
      }
}

std::uint32_t VoxelIndex::Walk::answering(const Vec3& point) {
  const std::array<int, 3> cell{static_cast<int>(std::floor(point.x)), static_cast<int>(std::floor(point.y)),
                                static_cast<int>(std::floor(point.z))};
  if (!entered_ || cell != cell_) enter(cell);
  if (count_ == 1) return around_[0];
  std::uint32_t best = kNoVoxel;
  double best_distance = std::numeric_limits<double>::infinity();
  for (const std::uint32_t near : std::span(around_).first(count_)) {
    const double distance = (representative(index_.voxels_.voxels[near]) - point).length2();
    if (distance < best_distance || (distance == best_distance && near < best)) {
      best = near;
      best_distance = distance;
    }
  }
  return best;
}

}  // namespace gnomon::metrics
