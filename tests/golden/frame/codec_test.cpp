// SPDX-License-Identifier: Apache-2.0
// The frame buffer's words, bit by bit.
#include <gtest/gtest.h>

#include <gnomon/golden/codec.hpp>
#include <gnomon/golden/frame/codec.hpp>
#include <stdexcept>

namespace gnomon::golden::frame {
namespace {

TEST(FrameCodec, StatesAreWhereThePageSays) {
  EXPECT_EQ(encode_states(std::vector<State>{2}), 0x3101'0000'0000'0002u);
  EXPECT_EQ(encode_states(std::vector<State>{1, 0, 2}), 0x3103'0000'0000'0021u);
  EXPECT_EQ(encode_states(std::vector<State>(24, 2)), 0x3118'AAAA'AAAA'AAAAu);
  EXPECT_EQ(decode_states(0x3103'0000'0000'0021u), (std::vector<State>{1, 0, 2}));
  EXPECT_EQ(decode_states(0x3118'AAAA'AAAA'AAAAu), std::vector<State>(24, 2));
  EXPECT_THROW(encode_states({}), std::invalid_argument);
  EXPECT_THROW(encode_states(std::vector<State>(25, 1)), std::invalid_argument);
  EXPECT_THROW(decode_states(0x3119'0000'0000'0000u), std::invalid_argument);
}

TEST(FrameCodec, CellsAreVoxelItemsWithoutTheFraction) {
  HardwareConfig hardware;
  hardware.voxel_bits = 5;
  hardware.voxel_frac_bits = 3;
  const FrameConfig config = hardware.frame_config();
  const VoxelItem item{.position = {0b10110'101, 0b00001'111, 0b11111'000}, .normal = {-7, 100, -256}};
  EXPECT_EQ(decode_cell(encode(item, hardware), config), (Cell{22, 1, 31}));
  const VoxelItem bare = decode_voxel(encode_cell({22, 1, 31}, config), hardware);
  EXPECT_EQ(bare, (VoxelItem{.position = {22 << 3, 1 << 3, 31 << 3}, .normal = {}}));
  for (const VoxelState state : {VoxelState::Lit, VoxelState::Shadow})
    EXPECT_EQ(state_of(encode(VoxelResult{.state = state})), static_cast<State>(state));
}

TEST(FrameCodec, NumberOfResults) {
  const auto count = [](std::uint8_t flags, std::size_t n) {
    return result_words(FrameOp::LookupFrame, flags, n);
  };
  EXPECT_EQ(count(0, 0), 0u);
  EXPECT_EQ(count(0, 1), 1u);
  EXPECT_EQ(count(0, 24), 1u);
  EXPECT_EQ(count(0, 25), 2u);
  EXPECT_EQ(count(0, 65535), 2731u);
  EXPECT_EQ(count(kBrick, 0), 0u);
  EXPECT_EQ(count(kBrick, 65535), 196605u);
  EXPECT_EQ(result_words(FrameOp::ClearFrame, 0, 0), 0u);
}

TEST(FrameCodec, WordsAsText) {
  EXPECT_EQ(describe_result(0x3103'0000'0000'0021u), "FRAME_STATES count=3 states=102000000000000000000000");
  EXPECT_EQ(describe_header(encode(Header{.op = 0x31, .flags = 1, .count = 2, .arg = layer_arg(3)})),
            "LOOKUP_FRAME flags=0x01 count=2 arg=0x30000000");
  EXPECT_EQ(describe_header(encode(Header{.op = 0x30})), "CLEAR_FRAME flags=0x00 count=0 arg=0x00000000");
}

}  // namespace
}  // namespace gnomon::golden::frame
