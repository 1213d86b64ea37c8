// SPDX-License-Identifier: Apache-2.0
// Field positions against words written by hand from docs/command-stream.md; round trips for every build of
// the covering array.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <gnomon/golden/codec.hpp>
#include <gnomon/golden/command.hpp>

#include "tests/support/covering.hpp"

namespace gnomon::golden {
namespace {

TEST(Codec, HeaderFields) {
  EXPECT_EQ(encode(Header{.op = 0x12, .flags = 0x34, .count = 0x5678, .arg = 0x9ABCDEF0}),
            0x123456789ABCDEF0u);
  const Header header = decode_header(0xFEDCBA9876543210u);
  EXPECT_EQ(header.op, 0xFE);
  EXPECT_EQ(header.flags, 0xDC);
  EXPECT_EQ(header.count, 0xBA98);
  EXPECT_EQ(header.arg, 0x76543210u);
}

TEST(Codec, VoxelItemFieldsOfTheDefaultBuild) {
  const HardwareConfig config;  // P = 10, N = 9
  EXPECT_EQ(encode(VoxelItem{{1, 0, 0}, {0, 0, 0}}, config), 1u);
  EXPECT_EQ(encode(VoxelItem{{0, 1, 0}, {0, 0, 0}}, config), 1u << 10);
  EXPECT_EQ(encode(VoxelItem{{0, 0, 1}, {0, 0, 0}}, config), 1u << 20);
  EXPECT_EQ(encode(VoxelItem{{0, 0, 0}, {1, 0, 0}}, config), Word{1} << 30);
  EXPECT_EQ(encode(VoxelItem{{0, 0, 0}, {0, 1, 0}}, config), Word{1} << 39);
  EXPECT_EQ(encode(VoxelItem{{0, 0, 0}, {0, 0, 1}}, config), Word{1} << 48);
  EXPECT_EQ(encode(VoxelItem{{1023, 1023, 1023}, {-1, -1, -1}}, config), (Word{1} << 57) - 1);
  EXPECT_EQ(encode(VoxelItem{{0, 0, 0}, {-256, 255, 0}}, config), 0x100ull << 30 | 0xFFull << 39);
}

TEST(Codec, BitsAboveAVoxelItemAreIgnored) {
  const HardwareConfig config;
  EXPECT_EQ(decode_voxel(0x7Full << 57, config), (VoxelItem{}));
}

TEST(Codec, VoxelResultFields) {
  EXPECT_EQ(encode(VoxelResult{.state = VoxelState::Shadow, .nearest = 0}), 0x1180000000000000u);
  EXPECT_EQ(encode(VoxelResult{.state = VoxelState::Lit, .nearest = 0}), 0x1140000000000000u);
  EXPECT_EQ(encode(VoxelResult{.state = VoxelState::Empty, .facing_away = true, .nearest = 0}),
            0x1120000000000000u);
  EXPECT_EQ(encode(VoxelResult{.state = VoxelState::Empty, .off_plane = true, .nearest = 0}),
            0x1110000000000000u);
  EXPECT_EQ(encode(VoxelResult{.state = VoxelState::Empty, .uncertain = true, .nearest = 0}),
            0x1108000000000000u);
  EXPECT_EQ(encode(VoxelResult{.state = VoxelState::Empty, .offset_empty = true, .nearest = 0}),
            0x1104000000000000u);
  EXPECT_EQ(encode(VoxelResult{.state = VoxelState::Empty, .beyond_max = true, .nearest = 0}),
            0x1102000000000000u);
  EXPECT_EQ(encode(VoxelResult{.state = VoxelState::Empty, .outside_cone = true, .nearest = 0}),
            0x1101000000000000u);
  EXPECT_EQ(encode(VoxelResult{.state = VoxelState::Empty, .behind = true, .nearest = 0}),
            0x1103000000000000u);
  EXPECT_EQ(encode(VoxelResult{.state = VoxelState::Empty, .nearest = 0xABCDEF}), 0x1100ABCDEF000000u);
  EXPECT_EQ(encode(VoxelResult{.state = VoxelState::Empty, .nearest = 0, .delta = 0xABCDEF}),
            0x1100000000ABCDEFu);
}

TEST(Codec, OtherResultFields) {
  EXPECT_EQ(encode(FenceResult{.sticky = 0x123456, .tag = 0x89ABCDEF}), 0x0312345689ABCDEFu);
  EXPECT_EQ(encode(PlaneEntryResult{.index = 0x123456, .present = true, .depth = 0xABCDEF}),
            0x0412345680ABCDEFu);
  EXPECT_EQ(encode(PlaneEntryResult{.index = 0xFFFFFF, .present = false, .depth = 0}), 0x04FFFFFF00000000u);
  EXPECT_EQ(encode(ErrorResult{.error = 4, .command_index = 0xDEADBEEF}), 0xFF040000DEADBEEFu);
  EXPECT_EQ(encode(PlaneRange{.first = 0x123456, .count = 256}), 0xFF123456u);
  EXPECT_EQ(encode(PlaneRange{.first = 7, .count = 1}), 7u);
}

TEST(Codec, ResultCodes) {
  EXPECT_EQ(result_code(0x03ull << 56), ResultCode::Fence);
  EXPECT_EQ(result_code(0x04ull << 56), ResultCode::PlaneEntry);
  EXPECT_EQ(result_code(0x11ull << 56), ResultCode::VoxelState);
  EXPECT_EQ(result_code(0xFFull << 56), ResultCode::Error);
}

RC_GTEST_PROP(CodecProperty, VoxelItemsRoundTripInEveryBuild, (std::uint64_t bits)) {
  for (const HardwareConfig& config : stimulus::covering_array()) {
    const int used = 3 * (config.position_bits() + config.normal_bits);
    const VoxelItem item = decode_voxel(bits, config);
    RC_ASSERT(encode(item, config) == (bits & ((Word{1} << used) - 1)));
    RC_ASSERT(decode_voxel(encode(item, config), config) == item);
    const std::int32_t limit = 1 << (config.normal_bits - 1);
    for (const std::int32_t n : item.normal) RC_ASSERT(n >= -limit && n < limit);
    for (const std::uint32_t p : item.position) RC_ASSERT(p < 1u << config.position_bits());
  }
}

RC_GTEST_PROP(CodecProperty, WordsRoundTrip, (std::uint64_t bits)) {
  constexpr Word kPayload = 0x00FFFFFFFFFFFFFF;
  const Word voxel = 0x11ull << 56 | (bits & kPayload);
  const Word fence = 0x03ull << 56 | (bits & kPayload);
  const Word entry = 0x04ull << 56 | (bits & kPayload & ~(Word{0x7F} << 24));
  const Word error = 0xFFull << 56 | (bits & kPayload & ~(Word{0xFFFF} << 32));
  RC_ASSERT(encode(decode_header(bits)) == bits);
  RC_ASSERT(encode(decode_voxel_result(voxel)) == voxel);
  RC_ASSERT(encode(decode_fence_result(fence)) == fence);
  RC_ASSERT(encode(decode_plane_entry_result(entry)) == entry);
  RC_ASSERT(encode(decode_error_result(error)) == error);
  const auto arg = static_cast<std::uint32_t>(bits);
  RC_ASSERT(encode(decode_plane_range(arg)) == arg);
}

}  // namespace
}  // namespace gnomon::golden
