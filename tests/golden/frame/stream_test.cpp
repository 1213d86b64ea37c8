// SPDX-License-Identifier: Apache-2.0
// The frame buffer's part of the stream writer, and whose a result word is.
#include <gtest/gtest.h>

#include <gnomon/golden/stream.hpp>
#include <stdexcept>

#include "tests/golden/frame/oracle.hpp"

namespace gnomon::test {
namespace {

using golden::Keeping;
using golden::StreamWriter;
using golden::VoxelItem;

const std::vector<VoxelItem> kItems(3);

TEST(FrameStream, HeadersAreThoseOfThePage) {
  StreamWriter writer(frame_hardware(4));
  writer.clear_frame();
  writer.keep(Keeping{.layer = 2});
  writer.resolve(kItems, true);
  writer.keep(Keeping{.layer = 3, .quiet = false});
  writer.resolve_topology(kItems, false, 77, true);
  writer.look_up(kItems, 1, true);
  writer.look_up(kItems, 0, false);
  const std::vector<Word> words = writer.take();
  EXPECT_EQ(words.at(0), 0x3000'0000'0000'0000u);
  EXPECT_EQ(words.at(1), 0x11C1'0003'2000'0000u);
  EXPECT_EQ(words.at(5), 0x1442'0003'3000'004Du);
  EXPECT_EQ(words.at(9), 0x3101'0003'1000'0000u);
  EXPECT_EQ(words.at(13), 0x3100'0003'0000'0000u);
  EXPECT_EQ(words.size(), 17u);
}

TEST(FrameStream, LongListsBecomeSeveralCommands) {
  StreamWriter writer(frame_hardware(4));
  writer.look_up(std::vector<VoxelItem>(golden::kMaxItems + 1), 1, false);
  const std::vector<Word> words = writer.take();
  ASSERT_EQ(words.size(), golden::kMaxItems + 3u);
  EXPECT_EQ(words.at(golden::kMaxItems + 1), 0x3100'0001'1000'0000u);
}

TEST(FrameStream, WhatTheHardwareCannotDoIsNotWritten) {
  StreamWriter writer(frame_hardware(4));
  EXPECT_THROW(writer.look_up(kItems, 4, false), std::out_of_range);
  EXPECT_THROW(writer.keep(Keeping{.layer = 4}), std::out_of_range);
  EXPECT_THROW(writer.keep(Keeping{.layer = 9}), std::out_of_range);
  HardwareConfig without = frame_hardware(4);
  without.en_frame_buffer = false;
  StreamWriter plain(without);
  EXPECT_THROW(plain.clear_frame(), std::logic_error);
  EXPECT_THROW(plain.look_up(kItems, 0, false), std::logic_error);
  EXPECT_THROW(plain.keep(Keeping{}), std::logic_error);
  EXPECT_TRUE(writer.words().empty());
  EXPECT_TRUE(plain.words().empty());
}

TEST(FrameStream, OriginsOfResults) {
  const HardwareConfig config = frame_hardware(4);
  StreamWriter writer(config);
  writer.keep(Keeping{});
  writer.resolve(kItems, false);  // 0: no words
  writer.keep(Keeping{.layer = 0, .quiet = false});
  writer.resolve(kItems, false);                         // 1: words 0..2
  writer.look_up(std::vector<VoxelItem>(30), 0, false);  // 2: words 3, 4
  writer.look_up(kItems, 0, true);                       // 3: words 5..13
  writer.fence(0, false);                                // 4: word 14
  const std::vector<Word> words = writer.take();
  const std::vector<std::pair<std::uint32_t, std::uint32_t>> origins{{1, 0}, {1, 1}, {1, 2}, {2, 0}, {2, 1},
                                                                     {3, 0}, {3, 1}, {3, 2}, {3, 3}, {3, 4},
                                                                     {3, 5}, {3, 6}, {3, 7}, {3, 8}, {4, 0}};
  ASSERT_EQ(answer(config, words).results.size(), origins.size());
  for (std::size_t i = 0; i < origins.size(); ++i) {
    const auto origin = golden::find_result(words, i, config);
    ASSERT_TRUE(origin.has_value()) << i;
    EXPECT_EQ(origin->command.index, origins[i].first) << i;
    EXPECT_EQ(origin->result, origins[i].second) << i;
  }
  EXPECT_FALSE(golden::find_result(words, origins.size(), config).has_value());
}

}  // namespace
}  // namespace gnomon::test
