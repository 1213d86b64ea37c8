// SPDX-License-Identifier: Apache-2.0
// The last state counts; layers do not meet; quiet means quiet.
#include <gtest/gtest.h>

#include <gnomon/golden/stream.hpp>

#include "tests/golden/frame/oracle.hpp"

namespace gnomon::test {
namespace {

using golden::Keeping;
using golden::StreamWriter;
using golden::VoxelItem;

/// Registers are 0 but for the depth row: what looks up is lit, what looks down faces away.
const HardwareConfig kHardware = frame_hardware(4);
constexpr VoxelItem kLit{.position = {37, 22, 9}, .normal = {0, 0, 200}};
constexpr VoxelItem kShadow{.position = {36, 23, 8}, .normal = {0, 0, -200}};  // same voxel, other fraction
constexpr VoxelItem kNeighbour{.position = {40, 22, 9}, .normal = {0, 0, 200}};

StreamWriter light_from_above() {
  StreamWriter writer(kHardware);
  writer.set_register(golden::Register::MatrixDz, -1000);
  return writer;
}

std::vector<Word> states(std::initializer_list<golden::frame::State> all) {
  return {golden::frame::encode_states(std::vector<golden::frame::State>(all))};
}

TEST(FrameOrder, TheLastStateOfACommandCounts) {
  for (const bool lit_last : {false, true}) {
    StreamWriter writer = light_from_above();
    const std::vector<VoxelItem> items{lit_last ? kShadow : kLit, kNeighbour, lit_last ? kLit : kShadow};
    writer.keep(Keeping{});
    writer.resolve(items, false);
    writer.look_up(std::vector<VoxelItem>{kLit, kNeighbour}, 0, false);
    const Answer actual = answer(kHardware, writer.take());
    EXPECT_EQ(actual.results, lit_last ? states({1, 1}) : states({2, 1}));
    EXPECT_EQ(actual.events.at("FRAME_OVERWRITTEN"), 1u);
  }
}

TEST(FrameOrder, TheLastCommandCountsInEitherMode) {
  for (const bool lit_last : {false, true}) {
    StreamWriter writer = light_from_above();
    const std::vector<VoxelItem> first{lit_last ? kShadow : kLit}, last{lit_last ? kLit : kShadow};
    writer.keep(Keeping{});
    writer.resolve_topology(first, false, 0, false);
    writer.keep(Keeping{});
    writer.resolve(last, false);
    writer.look_up(first, 0, false);
    writer.keep(Keeping{});
    writer.resolve_topology(first, false, 0, false);
    writer.look_up(last, 0, false);
    const std::vector<Word> after = lit_last ? states({1}) : states({2}),
                            again = lit_last ? states({2}) : states({1});
    EXPECT_EQ(answer(kHardware, writer.take()).results, (std::vector<Word>{after[0], again[0]}));
  }
}

TEST(FrameOrder, LayersDoNotMeetAndAClearTakesAll) {
  StreamWriter writer = light_from_above();
  writer.keep(Keeping{.layer = 1});
  writer.resolve(std::vector<VoxelItem>{kLit}, false);
  writer.keep(Keeping{.layer = 3});
  writer.resolve(std::vector<VoxelItem>{kShadow}, false);
  std::vector<Word> expected;
  for (std::uint32_t layer = 0; layer < 4; ++layer) {
    writer.look_up(std::vector<VoxelItem>{kLit}, layer, false);
    expected.push_back(states({static_cast<golden::frame::State>(layer == 1 ? 1 : layer == 3 ? 2 : 0)})[0]);
  }
  writer.clear_frame();
  for (std::uint32_t layer = 0; layer < 4; ++layer) {
    writer.look_up(std::vector<VoxelItem>{kLit}, layer, false);
    expected.push_back(states({0})[0]);
  }
  EXPECT_EQ(answer(kHardware, writer.take()).results, expected);
}

TEST(FrameOrder, QuietWithoutKeepChangesNothingButCounters) {
  StreamWriter writer = light_from_above();
  std::vector<Word> words = writer.take();
  words.push_back(golden::encode(golden::Header{.op = 0x11, .flags = 0x80, .count = 1, .arg = 0}));
  words.push_back(golden::encode(kLit, kHardware));
  writer.look_up(std::vector<VoxelItem>{kLit}, 0, false);
  const std::vector<Word> lookup = writer.take();
  words.insert(words.end(), lookup.begin(), lookup.end());
  const Answer actual = answer(kHardware, words);
  EXPECT_EQ(actual.results, states({0}));
  EXPECT_EQ(actual.events.at("VOXELS_RESOLVED"), 1u);
  EXPECT_EQ(actual.events.at("FRAME_KEPT"), 0u);
  EXPECT_EQ(actual.events.at("FRAME_LOOKUPS_EMPTY"), 1u);
}

TEST(FrameOrder, KeepAloneGivesTheWordsToo) {
  StreamWriter plain = light_from_above(), keeps = light_from_above();
  const std::vector<VoxelItem> items{kLit, kNeighbour, kShadow};
  plain.resolve(items, false);
  keeps.keep(Keeping{.layer = 0, .quiet = false});
  keeps.resolve(items, false);
  EXPECT_EQ(answer(kHardware, keeps.take()).results, answer(kHardware, plain.take()).results);
}

}  // namespace
}  // namespace gnomon::test
