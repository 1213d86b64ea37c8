// SPDX-License-Identifier: Apache-2.0
// Bits of the command and result words (docs/command-stream.md).
#include <gnomon/golden/codec.hpp>
#include <gnomon/golden/narrow.hpp>

namespace gnomon::golden {
namespace {

/// `value`, cut to `width` bits, at bit `at` of a word.
constexpr Word field(std::uint64_t value, int at, int width) {
  return low_bits(value, width) << at;
}
constexpr std::uint64_t get(Word word, int at, int width) {
  return low_bits(word >> at, width);
}
constexpr std::uint32_t get32(Word word, int at, int width) {
  return static_cast<std::uint32_t>(get(word, at, width));
}
constexpr bool get_bit(Word word, int at) {
  return get(word, at, 1) != 0;
}
constexpr Word code(ResultCode value) {
  return field(static_cast<std::uint64_t>(value), 56, 8);
}

}  // namespace

Word encode(const Header& header) {
  return field(header.op, 56, 8) | field(header.flags, 48, 8) | field(header.count, 32, 16) |
         field(header.arg, 0, 32);
}

Header decode_header(Word word) {
  return {.op = static_cast<std::uint8_t>(get(word, 56, 8)),
          .flags = static_cast<std::uint8_t>(get(word, 48, 8)),
          .count = static_cast<std::uint16_t>(get(word, 32, 16)),
          .arg = get32(word, 0, 32)};
}

Word encode(const VoxelItem& item, const HardwareConfig& config) {
  const int p = config.position_bits();
  const int n = config.normal_bits;
  Word word = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    word |= field(item.position[i], axis * p, p);
    word |= field(static_cast<std::uint64_t>(std::int64_t{item.normal[i]}), 3 * p + axis * n, n);
  }
  return word;
}

VoxelItem decode_voxel(Word word, const HardwareConfig& config) {
  const int p = config.position_bits();
  const int n = config.normal_bits;
  VoxelItem item;
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    item.position[i] = get32(word, axis * p, p);
    item.normal[i] = static_cast<std::int32_t>(sign_extend(word >> (3 * p + axis * n), n));
  }
  return item;
}

ResultCode result_code(Word word) {
  return static_cast<ResultCode>(get(word, 56, 8));
}

Word encode(const VoxelResult& result) {
  return code(ResultCode::VoxelState) | field(static_cast<std::uint64_t>(result.state), 54, 2) |
         field(result.facing_away, 53, 1) | field(result.off_plane, 52, 1) | field(result.uncertain, 51, 1) |
         field(result.offset_empty, 50, 1) | field(result.beyond_max || result.behind, 49, 1) |
         field(result.outside_cone || result.behind, 48, 1) | field(result.nearest, 24, 24) |
         field(result.delta, 0, 24);
}

VoxelResult decode_voxel_result(Word word) {
  const bool unreached = get_bit(word, 48), why = get_bit(word, 49);
  return {.state = static_cast<VoxelState>(get(word, 54, 2)),
          .facing_away = get_bit(word, 53),
          .off_plane = get_bit(word, 52),
          .uncertain = get_bit(word, 51),
          .offset_empty = get_bit(word, 50),
          .beyond_max = !unreached && why,
          .outside_cone = unreached && !why,
          .behind = unreached && why,
          .nearest = get32(word, 24, 24),
          .delta = get32(word, 0, 24)};
}

Word encode(const FenceResult& result) {
  return code(ResultCode::Fence) | field(result.sticky, 32, 24) | field(result.tag, 0, 32);
}

FenceResult decode_fence_result(Word word) {
  return {.sticky = get32(word, 32, 24), .tag = get32(word, 0, 32)};
}

Word encode(const PlaneEntryResult& result) {
  return code(ResultCode::PlaneEntry) | field(result.index, 32, 24) | field(result.present, 31, 1) |
         field(result.depth, 0, 24);
}

PlaneEntryResult decode_plane_entry_result(Word word) {
  return {.index = get32(word, 32, 24), .present = get_bit(word, 31), .depth = get32(word, 0, 24)};
}

Word encode(const ErrorResult& result) {
  return code(ResultCode::Error) | field(result.error, 48, 8) | field(result.command_index, 0, 32);
}

ErrorResult decode_error_result(Word word) {
  return {.error = static_cast<std::uint8_t>(get(word, 48, 8)), .command_index = get32(word, 0, 32)};
}

}  // namespace gnomon::golden
