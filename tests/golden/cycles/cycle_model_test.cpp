// SPDX-License-Identifier: Apache-2.0
// The cycle model against the numbers of docs/cycle-model.md, worked out by hand, and what it promises
// whatever the stream. tests/sim compares it with the hardware.
#include <gtest/gtest.h>

#include <gnomon/golden/codec.hpp>
#include <gnomon/golden/command.hpp>
#include <gnomon/golden/cycles.hpp>
#include <gnomon/golden/golden_engine.hpp>
#include <gnomon/golden/slb/codec.hpp>
#include <gnomon/golden/stream.hpp>
#include <numeric>

#include "tests/support/stimulus.hpp"

namespace gnomon::golden {
namespace {

Word header(Op op, std::uint16_t count = 0, std::uint32_t arg = 0, std::uint8_t flags = 0) {
  return encode(Header{static_cast<std::uint8_t>(op), flags, count, arg});
}
Word header(slb::SlbOp op, std::uint16_t count = 0, std::uint32_t arg = 0) {
  return encode(Header{static_cast<std::uint8_t>(op), 0, count, arg});
}

/// 32 x 32 entries: 64 lines.
HardwareConfig small() {
  HardwareConfig config;
  config.plane_log2 = 5;
  return config;
}

HardwareConfig with_buffer() {
  HardwareConfig config = small();
  config.en_slb = true;
  config.slb_plane_log2 = 5;
  return config;
}

CycleTable predict(const HardwareConfig& config, const std::vector<Word>& words, int latency = 1) {
  return predict_cycles(config, {.memory_latency = latency}, words);
}

TEST(CycleModel, ControlTakesACycleAWord) {
  const CycleTable table = predict(small(), {header(Op::Nop, 2), 0, 0, header(Op::SetRegisters, 3), 1, 2, 3,
                                             header(Op::Fence), header(Op::ClearPlane, 1), 0});
  EXPECT_EQ(table.at(Pass::Control, Cause::Busy), 3u + 4u + 2u + 3u);  // the last is in error
  EXPECT_EQ(table.of(Pass::Control), 12u);
  EXPECT_EQ(table.of(Pass::Clear), 64u);  // after reset
  EXPECT_EQ(table.total(), 76u);
}

TEST(CycleModel, ClearsScrubTheirShare) {
  EXPECT_EQ(predict(small(), {header(Op::ClearPlane)}).of(Pass::Clear), 64u + 3u);
  const CycleTable buffer = predict(with_buffer(), {header(slb::SlbOp::Clear)});
  EXPECT_EQ(buffer.at(Pass::Clear, Cause::Busy), 65u + 2u);
  EXPECT_EQ(buffer.at(Pass::Clear, Cause::MemoryWait), 1u);
}

TEST(CycleModel, ReadsWaitForTheFirstAnswer) {
  const std::vector<Word> one{header(Op::ReadPlane, 0, encode(PlaneRange{0, 1}))};
  const std::vector<Word> many{header(Op::ReadPlane, 0, encode(PlaneRange{7, 200}))};
  EXPECT_EQ(predict(small(), one).of(Pass::Read), 4u);
  EXPECT_EQ(predict(small(), one).at(Pass::Read, Cause::MemoryWait), 1u);
  EXPECT_EQ(predict(small(), many).of(Pass::Read), 203u);
  EXPECT_EQ(predict(small(), many, 5).of(Pass::Read), 207u);
  EXPECT_EQ(predict(small(), many, 5).at(Pass::Read, Cause::MemoryWait), 0u);
}

TEST(CycleModel, DrainsBelongToThePassBefore) {
  StreamWriter writer(small());
  writer.resolve(std::vector<VoxelItem>(100), false);
  std::vector<Word> words = writer.take();
  const CycleTable last = predict(small(), words);
  EXPECT_EQ(last.at(Pass::Resolve, Cause::Busy), 101u);
  EXPECT_EQ(last.at(Pass::Resolve, Cause::InputStarved), 13u);
  EXPECT_EQ(last.at(Pass::Resolve, Cause::Hazard), 0u);
  words.push_back(header(Op::Fence));
  const CycleTable fenced = predict(small(), words);
  EXPECT_EQ(fenced.at(Pass::Resolve, Cause::Hazard), 13u);
  EXPECT_EQ(fenced.at(Pass::Resolve, Cause::InputStarved), 0u);
}

/// What became of the last voxel decides when the project pass is over: written, as it was, off the plane.
TEST(CycleModel, ProjectEndsWithItsLastWrite) {
  const auto project = [](std::int64_t u, int times) {
    StreamWriter writer(small());
    writer.set_register(Register::MatrixU1, u * (std::int64_t{1} << small().matrix_frac_bits));
    writer.project(std::vector<VoxelItem>(static_cast<std::size_t>(times)));
    return predict(small(), writer.take()).of(Pass::Project);
  };
  EXPECT_EQ(project(0, 1), 2u + 6u);
  EXPECT_EQ(project(0, 3), 4u + 5u);
  EXPECT_EQ(project(100, 1), 2u + 4u);
}

TEST(CycleModel, AWalkTakesACycleABorder) {
  const HardwareConfig config = with_buffer();
  const std::int64_t pixel = config.slb_config().subpixels();
  const auto draw = [&](std::int64_t size) {
    std::vector<Word> words{header(slb::SlbOp::BeginObject), header(slb::SlbOp::Loop, 3)};
    for (const auto& [x, y] : {std::pair{0, 0}, std::pair{1, 0}, std::pair{1, 1}})
      words.push_back(encode(slb::Vertex{pixel / 2 + x * size * pixel, pixel / 2 + y * size * pixel, 5},
                             config.slb_config()));
    return predict(config, words).of(Pass::Draw);
  };
  // 4 borders a step of the size; long enough for the last edge to wait for the walker.
  EXPECT_EQ(draw(25) - draw(20), 4u * 5u);
}

TEST(CycleModel, SaysWhatIsWrongWithATiming) {
  EXPECT_FALSE(HardwareTiming{}.check());
  EXPECT_EQ(HardwareTiming{.memory_latency = 65}.check(), "MEM_LATENCY = 65 is not in 1..64");
  EXPECT_EQ(HardwareTiming{.slb_dividers = 0}.check(), "SLB_DIVIDERS = 0 is not in 1..3");
  EXPECT_THROW(make_timed_golden_engine({}, {.memory_latency = 0}), std::invalid_argument);
}

/// Builds with every unit; streams with everything.
HardwareConfig everything() {
  HardwareConfig config = with_buffer();
  config.voxel_bits = 5;
  config.en_vpu_topology = true;
  config.nodes_log2 = 10;
  config.quads_log2 = 8;
  config.en_frame_buffer = true;
  return config;
}

std::vector<Word> random_words(std::uint64_t seed) {
  return stimulus::random_stream(everything(), {.seed = seed, .commands = 150});
}

TEST(TimedEngine, AnswersAsGoldenDoes) {
  const auto plain = make_golden_engine(everything());
  const auto timed = make_timed_golden_engine(everything(), {});
  const std::vector<Word> words = random_words(3);
  std::vector<Word> expected, given;
  plain->submit(words);
  plain->drain([&](std::span<const Word> some) { expected.assign(some.begin(), some.end()); });
  timed->submit(words);
  timed->drain([&](std::span<const Word> some) { given.assign(some.begin(), some.end()); });
  EXPECT_EQ(given, expected);
  EXPECT_GT(given.size(), 500u);
  EXPECT_EQ(timed->counters().events, plain->counters().events);
  EXPECT_TRUE(plain->counters().cycles.empty());
  const auto cycles = timed->counters().cycles;
  EXPECT_EQ(cycles.size(), kPasses * kCauses);
  EXPECT_EQ(cycles, predict_cycles(everything(), {}, words).named());
}

TEST(TimedEngine, PiecesDrainsAndResetsMakeNoDifference) {
  const std::vector<Word> words = random_words(4);
  const auto timed = make_timed_golden_engine(everything(), {});
  timed->submit(random_words(5));
  timed->reset();
  std::size_t pieces = 0;
  for (std::size_t at = 0; at < words.size(); at += 1 + at % 7, ++pieces) {
    timed->submit(std::span(words).subspan(at, std::min(1 + at % 7, words.size() - at)));
    timed->drain([](std::span<const Word>) {});
    if (pieces % 50 == 0) timed->counters();
  }
  EXPECT_GT(pieces, 300u);
  EXPECT_EQ(timed->counters().cycles, predict_cycles(everything(), {}, words).named());
}

TEST(TimedEngine, SlowerMemoriesAndFewerDividersCostCycles) {
  std::uint64_t fast = 0, slow = 0, three = 0, one = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const std::vector<Word> words = random_words(seed);
    fast += predict_cycles(everything(), {}, words).total();
    slow += predict_cycles(everything(), {.memory_latency = 7}, words).total();
    three += predict_cycles(everything(), {.slb_dividers = 3}, words).of(Pass::Draw);
    one += predict_cycles(everything(), {.slb_dividers = 1}, words).of(Pass::Draw);
  }
  EXPECT_GT(slow, fast);
  EXPECT_GT(one, three);
}

}  // namespace
}  // namespace gnomon::golden
