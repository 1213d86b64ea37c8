// SPDX-License-Identifier: Apache-2.0
// A sort by tile, of whole views or of one object after the other.
#include "host/plan/item_order.hpp"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "host/plan/object_runs.hpp"
#include "host/plan/representative.hpp"

namespace gnomon::plan {
namespace {

constexpr int kTileBits = 14;  // of a tile's column and row: twice as many as the largest plane needs

/// Bit i goes to bit 2 i.
std::uint32_t spread(std::uint32_t bits) {
  bits = (bits | bits << 8U) & 0x00FF00FFU;
  bits = (bits | bits << 4U) & 0x0F0F0F0FU;
  bits = (bits | bits << 2U) & 0x33333333U;
  return (bits | bits << 1U) & 0x55555555U;
}

/// Voxels behind the light have no entry: any tile will do.
std::vector<std::uint32_t> tiles_of(const Projection& projection, const voxel::VoxelSet& voxels,
                                    std::span<const std::uint32_t> numbers) {
  std::vector<std::uint32_t> tiles(numbers.size());
  std::ranges::transform(numbers, tiles.begin(), [&](std::uint32_t number) {
    const Vec3 p = representative(voxels.voxels[number]);
    return projection.behind(p) ? 0U : tile_of(projection.entry(p));
  });
  return tiles;
}

std::vector<std::uint32_t> picked(std::span<const std::uint32_t> numbers,
                                  std::span<const std::uint32_t> places) {
  std::vector<std::uint32_t> some(places.size());
  std::ranges::transform(places, some.begin(), [&](std::uint32_t i) { return numbers[i]; });
  return some;
}

}  // namespace

std::uint32_t tile_of(const Vec2& entry) {
  const auto bits = [](double at) {
    constexpr double kLast = (1U << kTileBits) - 1;
    return spread(static_cast<std::uint32_t>(std::clamp(std::floor(at / kTileSide), 0.0, kLast)));
  };
  return bits(entry.x) | bits(entry.y) << 1U;
}

std::vector<std::uint32_t> by_tile(std::span<const std::uint32_t> tiles) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> order(tiles.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = {tiles[i], i};
  tbb::parallel_sort(order.begin(), order.end());
  std::vector<std::uint32_t> items(order.size());
  std::ranges::transform(order, items.begin(), [](const auto& item) { return item.second; });
  return items;
}

SentVoxels sent_by_tile(const Projection& projection, const voxel::VoxelSet& voxels, const ViewVoxels& seen,
                        Objects objects) {
  SentVoxels sent;
  sent.voxels.casters = picked(seen.casters, by_tile(tiles_of(projection, voxels, seen.casters)));
  const auto append = [&](std::span<const std::uint32_t> numbers, std::uint32_t) {
    const auto first = static_cast<std::uint32_t>(sent.places.size());
    for (const std::uint32_t i : by_tile(tiles_of(projection, voxels, numbers)))
      sent.places.push_back(first + i);
  };
  if (objects == Objects::Together)
    append(seen.receivers, 0);
  else
    for_each_object(seen.receivers, voxels, append);
  sent.voxels.receivers = picked(seen.receivers, sent.places);
  return sent;
}

}  // namespace gnomon::plan
