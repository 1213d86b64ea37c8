// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <gnomon/golden/command.hpp>
#include <gnomon/golden/stream.hpp>
#include <stdexcept>
#include <string>

#include "tests/golden/run_stream.hpp"
#include "tests/support/covering.hpp"
#include "tests/support/scene_registers.hpp"
#include "tests/support/stimulus.hpp"

namespace gnomon::golden_test {
namespace {

using golden::CommandReader;
using golden::HardwareConfig;
using golden::Register;
using golden::StreamWriter;
using golden::VoxelItem;
using golden::Word;

std::string refusal(const HardwareConfig& config, Register reg, std::int64_t value) {
  StreamWriter writer(config);
  try {
    writer.set_register(reg, value);
  } catch (const std::out_of_range& error) {
    EXPECT_TRUE(writer.words().empty()) << "a refused command left words behind";
    return error.what();
  }
  return "";
}

TEST(StreamWriter, RefusesRegisterValuesBeyondTheirWidthInEveryBuild) {
  for (HardwareConfig config : stimulus::covering_array()) {
    config.en_perspective = true;
    for (int i = 0; i < golden::kAllRegisterCount; ++i) {
      const auto reg = static_cast<Register>(i);
      const std::int64_t low = stimulus::register_min(reg, config),
                         high = stimulus::register_max(reg, config);
      EXPECT_EQ(refusal(config, reg, low), "");
      EXPECT_EQ(refusal(config, reg, high), "");
      const std::string name = golden::register_format(reg, config).name;
      EXPECT_EQ(refusal(config, reg, low - 1).rfind(name + "=" + std::to_string(low - 1), 0), 0u);
      EXPECT_EQ(refusal(config, reg, high + 1).rfind(name + "=", 0), 0u);
    }
  }
  EXPECT_EQ(refusal({}, Register::MatrixUx, 1 << 23), "MATRIX_UX=8388608 does not fit 24 signed bits");
  EXPECT_EQ(refusal({}, Register::DeltaMax, -1), "DELTA_MAX=-1 does not fit 20 unsigned bits");
}

TEST(StreamWriter, RefusesMoreRegistersThanThereAre) {
  StreamWriter writer{HardwareConfig{}};
  const std::vector<std::int64_t> three(3, 0);
  EXPECT_THROW(writer.set_registers(Register::MarginSquared, three), std::out_of_range);
  EXPECT_THROW(writer.read_plane(512 * 512 - 1, 2), std::out_of_range);
  EXPECT_TRUE(writer.words().empty());
}

/// In depth codes or in units of w, whichever projection was set last.
TEST(StreamWriter, ClearanceFitsTheProjection) {
  const HardwareConfig config{.depth_bits = 12, .en_perspective = true, .en_vpu_topology = true};
  StreamWriter writer(config);
  const std::vector<VoxelItem> one(1);
  EXPECT_THROW(writer.resolve_topology(one, false, 1 << 12, false), std::out_of_range);
  writer.set_register(Register::Projection, golden::kProjectionPerspective);
  writer.resolve_topology(one, false, (1 << 24) - 1, false);
  EXPECT_THROW(writer.resolve_topology(one, false, 1 << 24, false), std::out_of_range);
  const std::vector<std::int64_t> all(golden::kAllRegisterCount, 0);
  writer.set_registers(Register::MatrixUx, all);
  EXPECT_THROW(writer.resolve_topology(one, false, 1 << 12, false), std::out_of_range);
  writer.resolve_topology(one, false, (1 << 12) - 1, false);
}

TEST(StreamWriter, WordsOfEachCommand) {
  StreamWriter writer{HardwareConfig{}};
  writer.set_registers(Register::OffsetFactor, std::vector<std::int64_t>{7, 8});
  writer.set_register(Register::MatrixUx, -1);
  writer.clear_plane();
  writer.fence(0xABCD, true);
  writer.read_plane(300, 257);
  const VoxelItem voxel{{1, 2, 3}, {4, 5, 6}};
  writer.project({&voxel, 1});
  writer.resolve({&voxel, 1}, true);
  writer.project({});
  const Word item = golden::encode(voxel, {});
  EXPECT_EQ(writer.words(),
            (std::vector<Word>{0x010000020000000C, 7, 8, 0x0100000100000000, 0xFFFFFF, 0x0200000000000000,
                               0x030100000000ABCD, 0x04000000FF00012C, 0x040000000000022C, 0x1000000100000000,
                               item, 0x1101000100000000, item}));
  EXPECT_EQ(writer.take().size(), 13u);
  EXPECT_TRUE(writer.words().empty());
}

TEST(StreamWriter, SplitsLongLists) {
  StreamWriter writer{HardwareConfig{}};
  writer.project(std::vector<VoxelItem>(2 * 65535 + 1));
  std::vector<int> counts;
  CommandReader reader(writer.words());
  while (const auto command = reader.next()) {
    EXPECT_EQ(command->header.op, 0x10);
    counts.push_back(command->header.count);
  }
  EXPECT_EQ(counts, (std::vector<int>{65535, 65535, 1}));
}

TEST(CommandReader, WalksAndStopsAtACutCommand) {
  const auto words =
      command({0x00, 0, 2, 9}, {1, 2}) + command({0x02, 0, 0, 0}) + command({0x10, 0, 3, 0}, {5});
  CommandReader reader(words);
  const auto first = reader.next(), second = reader.next(), third = reader.next();
  ASSERT_TRUE(first && second && third);
  EXPECT_FALSE(reader.next());
  EXPECT_EQ(first->index, 0u);
  EXPECT_EQ(first->header.arg, 9u);
  EXPECT_EQ(std::vector<Word>(first->items.begin(), first->items.end()), (std::vector<Word>{1, 2}));
  EXPECT_EQ(second->offset, 3u);
  EXPECT_TRUE(second->items.empty());
  EXPECT_EQ(third->index, 2u);
  EXPECT_EQ(third->items.size(), 1u) << "the stream ends in the middle";
}

/// Every result of a stream with errors in it is traced to a command that can have given it.
TEST(FindResult, EveryResultHasItsOrigin) {
  for (const HardwareConfig& config : stimulus::covering_array()) {
    const auto words = stimulus::random_stream(config, {.seed = 5, .commands = 40, .max_items = 10});
    const auto results = run(config, words).results;
    for (std::size_t i = 0; i < results.size(); ++i) {
      const auto origin = golden::find_result(words, i, config);
      ASSERT_TRUE(origin) << "result " << i;
      if (origin->raw_word) {  // an entry as stored: it has no code, and may look like any result
        ASSERT_EQ(origin->command.header.op, golden::slb::kEntryCode);
      } else if (golden::result_code(results[i]) == golden::ResultCode::Error) {
        ASSERT_EQ(golden::decode_error_result(results[i]).command_index, origin->command.index);
      } else {
        ASSERT_EQ(static_cast<std::uint8_t>(golden::result_code(results[i])), origin->command.header.op);
      }
    }
    EXPECT_FALSE(golden::find_result(words, results.size(), config)) << "more results promised than given";
  }
}

TEST(FindResult, NamesTheItem) {
  const auto words = command({0x03, 0, 0, 1}) + command({0x11, 0, 3, 0}, {7, 8, 9});
  const auto origin = golden::find_result(words, 3, {});
  ASSERT_TRUE(origin);
  EXPECT_EQ(origin->command.index, 1u);
  EXPECT_EQ(origin->result, 2u);
  EXPECT_EQ(origin->command.items[origin->result], 9u);
}

}  // namespace
}  // namespace gnomon::golden_test
