// SPDX-License-Identifier: Apache-2.0
// Words of the frame buffer's commands and results (docs/frame-buffer.md, "Commands").
#pragma once

#include <array>
#include <cstdint>
#include <gnomon/golden/frame/config.hpp>
#include <span>
#include <string>
#include <vector>

namespace gnomon::golden::frame {

using Word = std::uint64_t;

enum class FrameOp : std::uint8_t { ClearFrame = 0x30, LookupFrame = 0x31 };
constexpr bool is_frame_op(std::uint8_t op) {
  return op == 0x30 || op == 0x31;
}
inline constexpr std::uint8_t kBrick = 0x01;  ///< flag of LookupFrame

/// Flags of the two resolve commands.
inline constexpr std::uint8_t kKeep = 0x40, kQuiet = 0x80;
inline constexpr std::uint8_t kResolveFlags = kKeep | kQuiet;

/// The field `layer` of arg.
constexpr std::uint32_t layer_arg(std::uint32_t layer) {
  return layer << 28;
}
constexpr std::uint32_t decode_layer(std::uint32_t arg) {
  return arg >> 28;
}

/// Flag bits with a meaning.
std::uint8_t known_flags(FrameOp op);
/// Error 4 of docs/command-stream.md.
bool bad_argument(FrameOp op, std::uint32_t arg, std::size_t count, const FrameConfig& config);
/// Of a command without an error.
std::uint32_t result_words(FrameOp op, std::uint8_t flags, std::size_t count);

/// 0 empty, 1 lit, 2 in shadow.
using State = std::uint8_t;
/// Of any state word, VOXEL_STATE or TOPOLOGY_STATE.
constexpr State state_of(Word result) {
  return static_cast<State>(result >> 54 & 3);
}

/// A voxel of the grid.
struct Cell {
  std::uint32_t x = 0, y = 0, z = 0;
  bool operator==(const Cell&) const = default;
};
/// Of a voxel item: its position without the fraction.
Cell decode_cell(Word item, const FrameConfig& config);
/// The item with that voxel and fraction 0, normal 0.
Word encode_cell(const Cell& cell, const FrameConfig& config);

inline constexpr std::uint8_t kStatesCode = 0x31;
inline constexpr std::size_t kStatesPerWord = 24;
inline constexpr std::size_t kBrickStates = 64, kBrickWords = 3;

/// One FRAME_STATES word; `states` has 1..24.
Word encode_states(std::span<const State> states);
/// Throws std::invalid_argument if the word promises more than 24.
std::vector<State> decode_states(Word word);

/// Place of a voxel in its brick: 16 (z mod 4) + 4 (y mod 4) + x mod 4.
constexpr std::uint32_t place_in_brick(const Cell& cell) {
  return (cell.z & 3) << 4 | (cell.y & 3) << 2 | (cell.x & 3);
}

/// One line naming every field of a result word, for mismatch reports.
std::string describe_states(Word word);

}  // namespace gnomon::golden::frame
