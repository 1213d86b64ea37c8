// SPDX-License-Identifier: Apache-2.0
// States by layer and place, and where they lie in a brick.
#include <gtest/gtest.h>

#include <array>
#include <gnomon/golden/frame/memory.hpp>
#include <map>

#include "tests/support/random.hpp"

namespace gnomon::golden::frame {
namespace {

using Key = std::array<std::uint32_t, 4>;

class Memory : public ::testing::TestWithParam<int> {};

TEST_P(Memory, HoldsWhatWasPutLast) {
  const FrameConfig config{.voxel_bits = GetParam(), .voxel_frac_bits = 1, .layers_log2 = 1};
  FrameMemory memory(config);
  std::map<Key, State> expected;
  stimulus::Random random(3);
  const std::int64_t last = (std::int64_t{1} << config.voxel_bits) - 1;
  std::size_t compared = 0, overwritten = 0;
  for (int round = 0; round < 2; ++round) {
    for (int i = 0; i < 20000; ++i) {
      // Half of them crowd in one corner, so that places are hit twice.
      const std::int64_t reach = random.chance(50) ? 7 : last;
      const auto coordinate = [&] {
        const std::int64_t t = random.between(0, reach);
        return static_cast<std::uint32_t>(random.chance(50) ? t : last - t);
      };
      const Cell cell{coordinate(), coordinate(), coordinate()};
      const auto layer = static_cast<std::uint32_t>(random.between(0, 1));
      const auto state = static_cast<State>(random.between(0, 2));
      State& known = expected[{layer, cell.x, cell.y, cell.z}];
      overwritten += known != 0 ? 1U : 0U;
      EXPECT_EQ(memory.put(layer, cell, state), known);
      known = state;
      ++compared;
    }
    for (const auto& [key, state] : expected) {
      const Cell cell{key[1], key[2], key[3]};
      ASSERT_EQ(memory.get(key[0], cell), state);
      const Brick brick = memory.brick(key[0], cell);
      const std::size_t place = 16 * (cell.z % 4) + 4 * (cell.y % 4) + cell.x % 4;
      ASSERT_EQ(brick[place / 32] >> (2 * (place % 32)) & 3, state);
    }
    memory.clear();
    for (const auto& [key, state] : expected) ASSERT_EQ(memory.get(key[0], {key[1], key[2], key[3]}), 0);
    expected.clear();
  }
  EXPECT_EQ(compared, 40000u);
  EXPECT_GT(overwritten, 1000u);
}

INSTANTIATE_TEST_SUITE_P(Sizes, Memory, ::testing::Values(4, 6, 11));

TEST(Memory, EveryCellIsAPlaceOfItsOwn) {
  const FrameConfig config{.voxel_bits = 4, .voxel_frac_bits = 0, .layers_log2 = 1};
  for (const std::uint32_t lone : {0u, 1u, 16u, 255u, 256u, 4095u, 1911u}) {
    FrameMemory memory(config);
    const auto cell = [](std::uint32_t i) { return Cell{i & 15, i >> 4 & 15, i >> 8}; };
    memory.put(1, cell(lone), 2);
    std::size_t set = 0;
    for (std::uint32_t i = 0; i < 4096; ++i) {
      EXPECT_EQ(memory.get(1, cell(i)), i == lone ? 2 : 0);
      EXPECT_EQ(memory.get(0, cell(i)), 0);
      set += memory.get(1, cell(i)) != 0 ? 1U : 0U;
    }
    EXPECT_EQ(set, 1u);
  }
}

TEST(FrameConfig, LegalAndNot) {
  EXPECT_EQ((FrameConfig{.voxel_bits = 11, .layers_log2 = 0}).check(), std::nullopt);
  EXPECT_EQ((FrameConfig{.voxel_bits = 10, .layers_log2 = 3}).check(), std::nullopt);
  EXPECT_EQ((FrameConfig{.voxel_bits = 11, .layers_log2 = 1}).check(),
            "3 * VOXEL_BITS + FRAME_LAYERS_LOG2 + 1 = 35 exceeds 34: a frame buffer has 2 GiB at most");
  EXPECT_EQ((FrameConfig{.layers_log2 = 4}).check(), "FRAME_LAYERS_LOG2=4 is out of range 0..3");
  EXPECT_EQ((FrameConfig{.layers_log2 = -1}).check(), "FRAME_LAYERS_LOG2=-1 is out of range 0..3");
  EXPECT_EQ((FrameConfig{.voxel_bits = 11}).state_bits(), std::uint64_t{8} << 31);
}

}  // namespace
}  // namespace gnomon::golden::frame
