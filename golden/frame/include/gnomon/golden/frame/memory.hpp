// SPDX-License-Identifier: Apache-2.0
// The states of all voxels of a grid, by layer (docs/frame-buffer.md, "What it holds").
#pragma once

#include <array>
#include <cstddef>
#include <gnomon/golden/frame/codec.hpp>
#include <memory>
#include <vector>

namespace gnomon::golden::frame {

/// 64 states of two bits; state i at bits 2i+1:2i, low word first.
using Brick = std::array<std::uint64_t, 2>;

/// Takes room only where something was written: cubes of 16 voxels a side.
class FrameMemory {
 public:
  /// `config` must be legal.
  explicit FrameMemory(const FrameConfig& config);

  /// The state that was there before. `layer` and `cell` must be inside.
  State put(std::uint32_t layer, const Cell& cell, State state);
  State get(std::uint32_t layer, const Cell& cell) const;
  /// The brick that holds `cell`.
  Brick brick(std::uint32_t layer, const Cell& cell) const;
  /// All layers.
  void clear();

 private:
  using Chunk = std::array<Brick, 64>;
  std::size_t chunk_of(std::uint32_t layer, const Cell& cell) const;

  int chunk_bits_;  ///< cubes of 16 along an axis, log2
  std::vector<std::unique_ptr<Chunk>> chunks_;
};

inline State state_in(const Brick& brick, std::size_t place) {
  return static_cast<State>(brick[place / 32] >> (2 * (place % 32)) & 3);
}

}  // namespace gnomon::golden::frame
