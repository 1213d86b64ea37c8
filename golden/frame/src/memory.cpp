// SPDX-License-Identifier: Apache-2.0
// Bricks in cubes of 4 x 4 x 4, made where they are written.
#include <gnomon/golden/frame/memory.hpp>

namespace gnomon::golden::frame {
namespace {

constexpr int kChunkLog2 = 4;  // voxels a side

/// The brick's number in its cube.
constexpr std::size_t brick_in_chunk(const Cell& cell) {
  return (cell.z >> 2 & 3) << 4 | (cell.y >> 2 & 3) << 2 | (cell.x >> 2 & 3);
}

}  // namespace

FrameMemory::FrameMemory(const FrameConfig& config)
    : chunk_bits_(config.voxel_bits - kChunkLog2),
      chunks_(std::size_t{1} << (3 * chunk_bits_ + config.layers_log2)) {}

std::size_t FrameMemory::chunk_of(std::uint32_t layer, const Cell& cell) const {
  std::size_t index = layer;
  for (const std::uint32_t coordinate : {cell.z, cell.y, cell.x})
    index = index << chunk_bits_ | coordinate >> kChunkLog2;
  return index;
}

State FrameMemory::put(std::uint32_t layer, const Cell& cell, State state) {
  auto& chunk = chunks_[chunk_of(layer, cell)];
  if (!chunk) chunk = std::make_unique<Chunk>();
  Brick& brick = (*chunk)[brick_in_chunk(cell)];
  const std::uint32_t place = place_in_brick(cell);
  const State before = state_in(brick, place);
  brick[place / 32] ^= std::uint64_t{static_cast<State>(before ^ state)} << (2 * (place % 32));
  return before;
}

State FrameMemory::get(std::uint32_t layer, const Cell& cell) const {
  return state_in(brick(layer, cell), place_in_brick(cell));
}

Brick FrameMemory::brick(std::uint32_t layer, const Cell& cell) const {
  const auto& chunk = chunks_[chunk_of(layer, cell)];
  return chunk ? (*chunk)[brick_in_chunk(cell)] : Brick{};
}

void FrameMemory::clear() {
  for (auto& chunk : chunks_) chunk.reset();
}

}  // namespace gnomon::golden::frame
