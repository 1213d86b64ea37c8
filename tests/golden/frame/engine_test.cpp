// SPDX-License-Identifier: Apache-2.0
// The frame buffer inside the golden engine, against the oracle: random streams of both modes, errors,
// counters.
#include <gtest/gtest.h>

#include <gnomon/golden/command.hpp>
#include <gnomon/golden/golden_engine.hpp>
#include <gnomon/golden/stream.hpp>

#include "tests/golden/frame/oracle.hpp"
#include "tests/support/frame_stream.hpp"

namespace gnomon::test {
namespace {

using golden::ErrorCode;
using golden::Header;
using golden::Keeping;
using golden::StreamWriter;
using golden::VoxelItem;

TEST(FrameEngine, RandomStreamsAgreeWithTheOracle) {
  std::size_t words = 0;
  std::map<std::string, std::uint64_t> seen;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    HardwareConfig config = frame_hardware(seed % 2 == 0 ? 4 : 5);
    config.voxel_frac_bits = static_cast<int>(seed % 3);
    config.frame_layers_log2 = static_cast<int>(seed % 4);
    const std::vector<Word> stream = stimulus::frame_stream(config, seed, 200);
    const FrameOracle expected = frame_oracle(config, stream);
    const Answer actual = answer(config, stream, seed % 5 == 0 ? 0 : seed);
    ASSERT_EQ(actual.results, expected.results) << "seed " << seed;
    for (const auto& [name, count] : expected.counters) {
      EXPECT_EQ(actual.events.at(name), count) << name << " seed " << seed;
      seen[name] += count;
    }
    words += actual.results.size();
  }
  EXPECT_GT(words, 50000u);
  for (const auto& [name, count] : seen) EXPECT_GT(count, 2000u) << name;
  EXPECT_EQ(seen.size(), 5u);
}

TEST(FrameEngine, ResolvingCountsAsEver) {
  const HardwareConfig config = frame_hardware(4);
  const std::vector<Word> stream = stimulus::frame_stream(config, 77, 100);
  HardwareConfig plain = config;
  plain.en_frame_buffer = false;
  std::vector<Word> without;
  golden::CommandReader reader(stream);
  std::uint64_t left_out = 0;
  while (const auto command = reader.next()) {
    Header header = command->header;
    if (golden::frame::is_frame_op(header.op)) {
      ++left_out;
      continue;
    }
    header.flags &= 0x3F;
    without.push_back(golden::encode(header));
    without.insert(without.end(), command->items.begin(), command->items.end());
  }
  const auto with_frame = answer(config, stream).events;
  for (const auto& [name, count] : answer(plain, without).events)
    EXPECT_EQ(with_frame.at(name), count + (name == "COMMANDS" ? left_out : 0)) << name;
}

TEST(FrameEngine, EachErrorAndNoOtherEffect) {
  const HardwareConfig config = frame_hardware(4);
  HardwareConfig no_offset = config, no_topology = config, no_frame = config;
  no_offset.en_vpu_offset = false;
  no_topology.en_vpu_topology = false;
  no_frame.en_frame_buffer = false;
  struct Case {
    Header header;
    std::optional<ErrorCode> error;
    const HardwareConfig* hardware;
  };
  const std::uint32_t last = golden::frame::layer_arg(3), beyond = golden::frame::layer_arg(4);
  const std::vector<Case> cases{
      {{0x30, 0, 0, 0xFFFFFFFF}, std::nullopt, &config},
      {{0x30, 0, 1, 0}, ErrorCode::BadArgument, &config},
      {{0x30, 1, 1, 0}, ErrorCode::ReservedFlag, &config},
      {{0x30, 0, 1, 0}, ErrorCode::FeatureAbsent, &no_frame},
      {{0x30, 2, 1, 0}, ErrorCode::ReservedFlag, &no_frame},
      {{0x31, 0, 2, last | 0x0FFFFFFF}, std::nullopt, &config},
      {{0x31, 1, 2, beyond}, ErrorCode::BadArgument, &config},
      {{0x31, 2, 2, beyond}, ErrorCode::ReservedFlag, &config},
      {{0x31, 0, 2, beyond}, ErrorCode::FeatureAbsent, &no_frame},
      {{0x11, 0xC1, 2, last}, std::nullopt, &config},
      {{0x11, 0x80, 2, beyond}, std::nullopt, &config},
      {{0x11, 0x00, 2, beyond}, std::nullopt, &config},
      {{0x11, 0x40, 2, beyond}, ErrorCode::BadArgument, &config},
      {{0x11, 0x42, 2, beyond}, ErrorCode::ReservedFlag, &config},
      {{0x11, 0x40, 2, beyond}, ErrorCode::FeatureAbsent, &no_offset},
      {{0x11, 0x80, 2, 0}, ErrorCode::FeatureAbsent, &no_frame},
      {{0x11, 0x20, 2, 0}, ErrorCode::ReservedFlag, &no_frame},
      {{0x14, 0xC3, 2, last}, std::nullopt, &config},
      {{0x14, 0x80, 2, beyond}, std::nullopt, &config},
      {{0x14, 0xC0, 2, beyond}, ErrorCode::BadArgument, &config},
      {{0x14, 0xC4, 2, beyond}, ErrorCode::ReservedFlag, &config},
      {{0x14, 0xC0, 2, beyond}, ErrorCode::FeatureAbsent, &no_topology},
      {{0x14, 0x40, 2, 0}, ErrorCode::FeatureAbsent, &no_frame},
      {{0x10, 0x40, 2, 0}, ErrorCode::ReservedFlag, &config},
      {{0x13, 0x80, 4, 0}, ErrorCode::ReservedFlag, &config},
      {{0x32, 0, 1, 0}, ErrorCode::UnknownOp, &config},
      {{0x2F, 0, 1, 0}, ErrorCode::UnknownOp, &config},
  };
  for (const auto& [header, error, hardware] : cases) {
    std::vector<Word> words{golden::encode(header)};
    words.resize(words.size() + header.count);
    const Answer actual = answer(*hardware, words);
    golden::CommandSequence sequence(*hardware);
    const std::string what = golden::describe_header(words.front());
    EXPECT_EQ(sequence.next(header), error) << what;
    EXPECT_EQ(golden::result_count(header, error, *hardware), actual.results.size()) << what;
    EXPECT_EQ(actual.events.at("ERRORS"), error ? 1u : 0u) << what;
    if (!error) continue;
    const auto code = static_cast<std::uint8_t>(*error);
    EXPECT_EQ(actual.results, std::vector<Word>{golden::encode(golden::ErrorResult{code, 0})}) << what;
    for (const char* name : {"FRAME_KEPT", "FRAME_LOOKUPS", "FRAME_BRICKS", "VOXELS_RESOLVED"})
      EXPECT_EQ(actual.events.contains(name) ? actual.events.at(name) : 0, 0u) << what;
  }
}

TEST(FrameEngine, AbsentItHasNoCounters) {
  HardwareConfig config = frame_hardware(4);
  config.en_frame_buffer = false;
  EXPECT_FALSE(golden::make_golden_engine(config)->counters().events.contains("FRAME_KEPT"));
}

TEST(FrameEngine, ResetEmptiesIt) {
  const HardwareConfig config = frame_hardware(4);
  const auto engine = golden::make_golden_engine(config);
  StreamWriter writer(config);
  writer.keep(Keeping{});
  writer.resolve(std::vector<VoxelItem>(5), false);
  engine->submit(writer.take());
  EXPECT_EQ(engine->counters().events.at("FRAME_KEPT"), 5u);
  engine->reset();
  writer.look_up(std::vector<VoxelItem>(1), 0, false);
  engine->submit(writer.take());
  std::vector<Word> results;
  engine->drain([&](std::span<const Word> some) { results.assign(some.begin(), some.end()); });
  EXPECT_EQ(results, std::vector<Word>{0x3101'0000'0000'0000u});
  EXPECT_EQ(engine->counters().events.at("FRAME_KEPT"), 0u);
}

}  // namespace
}  // namespace gnomon::test
