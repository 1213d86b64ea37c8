// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <gnomon/golden/codec.hpp>

namespace gnomon::golden {
namespace {

TEST(Describe, Headers) {
  EXPECT_EQ(describe_header(encode(Header{0x10, 0, 300, 0})),
            "PROJECT_VOXELS flags=0x00 count=300 arg=0x00000000");
  EXPECT_EQ(describe_header(encode(Header{0x03, 1, 0, 0xAB})), "FENCE flags=0x01 count=0 arg=0x000000AB");
  EXPECT_EQ(describe_header(encode(Header{0x7F, 0, 0, 0})),
            "unknown op 0x7F flags=0x00 count=0 arg=0x00000000");
  const char* const names[] = {"NOP", "SET_REGISTERS", "CLEAR_PLANE", "FENCE", "READ_PLANE"};
  for (std::uint8_t op = 0; op < 5; ++op) {
    EXPECT_EQ(describe_header(encode(Header{op, 0, 0, 0})).find(names[op]), 0u);
  }
  EXPECT_EQ(describe_header(encode(Header{0x11, 1, 2, 0})),
            "RESOLVE_VOXELS flags=0x01 count=2 arg=0x00000000");
}

TEST(Describe, HeadersOfTheSilhouetteLineBuffer) {
  const char* const names[] = {"SLB_CLEAR", "BEGIN_OBJECT", "LOOP",  "FILL",
                               "COVER",     "END_OBJECT",   "QUERY", "READ_ENTRIES"};
  for (std::uint8_t i = 0; i < 8; ++i) {
    EXPECT_EQ(describe_header(encode(Header{static_cast<std::uint8_t>(0x20 + i), 1, 2, 3})),
              std::string(names[i]) + " flags=0x01 count=2 arg=0x00000003");
  }
  EXPECT_EQ(describe_result(encode(FenceResult{.sticky = 0x701, .tag = 5})),
            "FENCE tag=5 sticky=ERROR_SEEN|LINE_OVERFLOW|OBJECT_OVERFLOW|WINDING_SATURATED");
}

TEST(Describe, VoxelStates) {
  EXPECT_EQ(describe_result(encode(VoxelResult{})), "VOXEL_STATE lit nearest=none delta=0");
  EXPECT_EQ(describe_result(
                encode(VoxelResult{.state = VoxelState::Shadow, .facing_away = true, .off_plane = true})),
            "VOXEL_STATE shadow facing_away off_plane nearest=none delta=0");
  EXPECT_EQ(
      describe_result(encode(VoxelResult{
          .state = VoxelState::Shadow, .uncertain = true, .beyond_max = true, .nearest = 17, .delta = 99})),
      "VOXEL_STATE shadow uncertain beyond_max nearest=17 delta=99");
  EXPECT_EQ(describe_result(encode(VoxelResult{.uncertain = true, .offset_empty = true, .nearest = 3})),
            "VOXEL_STATE lit uncertain offset_empty nearest=3 delta=0");
  EXPECT_EQ(describe_result(encode(VoxelResult{.state = VoxelState::Shadow, .behind = true})),
            "VOXEL_STATE shadow behind nearest=none delta=0");
  EXPECT_EQ(describe_result(
                encode(VoxelResult{.state = VoxelState::Shadow, .off_plane = true, .outside_cone = true})),
            "VOXEL_STATE shadow off_plane outside_cone nearest=none delta=0");
}

TEST(Describe, OtherResults) {
  EXPECT_EQ(describe_result(encode(FenceResult{.sticky = 0, .tag = 5})), "FENCE tag=5 sticky=none");
  EXPECT_EQ(describe_result(encode(FenceResult{.sticky = 7, .tag = 5})),
            "FENCE tag=5 sticky=ERROR_SEEN|OFF_PLANE|DEPTH_SATURATED");
  EXPECT_EQ(describe_result(encode(FenceResult{.sticky = 0x61, .tag = 5})),
            "FENCE tag=5 sticky=ERROR_SEEN|BEHIND_LIGHT|0x000040");
  EXPECT_EQ(describe_result(encode(PlaneEntryResult{12, true, 77})), "PLANE_ENTRY index=12 depth=77");
  EXPECT_EQ(describe_result(encode(PlaneEntryResult{12, false, 0})), "PLANE_ENTRY index=12 empty");
  EXPECT_EQ(describe_result(encode(PlaneEntryResult{12, false, 9})), "PLANE_ENTRY index=12 empty depth=9");
  EXPECT_EQ(describe_result(encode(ErrorResult{4, 9})), "ERROR BAD_ARGUMENT command=9");
  EXPECT_EQ(describe_result(encode(ErrorResult{77, 9})), "ERROR unknown error 77 command=9");
  const char* const errors[] = {"UNKNOWN_OP",   "FEATURE_ABSENT", "BAD_REGISTER",
                                "BAD_ARGUMENT", "RESERVED_FLAG",  "BAD_SEQUENCE"};
  for (std::uint8_t i = 0; i < 6; ++i) {
    EXPECT_EQ(describe_result(encode(ErrorResult{static_cast<std::uint8_t>(i + 1), 0})),
              std::string("ERROR ") + errors[i] + " command=0");
  }
  EXPECT_EQ(describe_result(0x2200000000000001), "unknown result 0x2200000000000001");
}

/// Two different words never read the same, or a mismatch report would show two equal lines.
TEST(Describe, EveryBitShows) {
  const Word words[] = {encode(FenceResult{1, 2}),
                        encode(PlaneEntryResult{3, true, 4}),
                        encode(PlaneEntryResult{3, false, 0}),
                        encode(VoxelResult{.nearest = 5, .delta = 6}),
                        encode(VoxelResult{}),
                        encode(ErrorResult{1, 2})};
  for (const Word word : words) {
    for (int bit = 0; bit < 64; ++bit) {
      EXPECT_NE(describe_result(word), describe_result(word ^ (Word{1} << bit)))
          << describe_result(word) << " bit " << bit;
      EXPECT_NE(describe_header(word), describe_header(word ^ (Word{1} << bit)));
    }
  }
}

}  // namespace
}  // namespace gnomon::golden
