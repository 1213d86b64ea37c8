// SPDX-License-Identifier: Apache-2.0
// In which order voxels and points are sent to the hardware, and their answers put back. Theory:
// docs/planning.md, "Order of items".
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/base/vec.hpp"
#include "host/plan/light_view.hpp"
#include "host/plan/projection.hpp"
#include "host/voxel/voxel_set.hpp"

namespace gnomon::plan {

/// As the surface is walked, or by tiles of the light's plane.
enum class ItemOrder : std::uint8_t { Surface, Tile };

/// Entries or pixels a tile's side.
inline constexpr std::uint32_t kTileSide = 4;

/// The number of the tile that an entry lies in: bits of its column and row in turns. Off the plane: that of
/// the tile next to it.
std::uint32_t tile_of(const Vec2& entry);

/// Items by the numbers of their tiles, those of a tile in their own order: items[i] is sent i-th.
std::vector<std::uint32_t> by_tile(std::span<const std::uint32_t> tiles);

/// A view's voxels as they are sent.
struct SentVoxels {
  ViewVoxels voxels;                  ///< not ascending any more
  std::vector<std::uint32_t> places;  ///< of the receivers: voxels.receivers[i] is the view's places[i]-th
};

/// Which voxels of a tile follow each other.
enum class Objects : std::uint8_t {
  Apart,    ///< receivers of one object, then those of the next: a command each
  Together  ///< all voxels of a tile, then those of the next tile
};

SentVoxels sent_by_tile(const Projection& projection, const voxel::VoxelSet& voxels, const ViewVoxels& seen,
                        Objects objects);

/// What belongs to items as they were sent, in the order of the items; `places` as above, empty for items
/// that were sent in their order.
template <class T>
std::vector<T> put_back(std::vector<T> sent, std::span<const std::uint32_t> places) {
  if (places.empty()) return sent;
  std::vector<T> back(sent.size());
  for (std::size_t i = 0; i < sent.size(); ++i) back[places[i]] = sent[i];
  return back;
}

}  // namespace gnomon::plan
