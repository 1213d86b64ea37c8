// SPDX-License-Identifier: Apache-2.0
// Waveforms: exactly the cycles asked for, around the first difference, and complete also after Ctrl-C.
#include "sim/wave.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <gnomon/golden/codec.hpp>
#include <gnomon/golden/golden_engine.hpp>

#include "sim/interrupt.hpp"
#include "tests/sim/altered_engine.hpp"
#include "tests/sim/fst_reader.hpp"
#include "tests/sim/tiny_model.hpp"

namespace gnomon::sim::test {
namespace {

constexpr std::uint64_t kPeriod = 10;

std::uint64_t time_of(std::uint64_t cycle) {
  return (cycle + GNOMON_MODEL_RESET_CYCLES) * kPeriod;
}

class WaveTest : public testing::Test {
 protected:
  std::filesystem::path file() const { return folder_.path() / "wave.fst"; }

  TemporaryFolder folder_;
  ModelCache cache_{tiny_tools()};
};

TEST_F(WaveTest, HoldsTheCyclesOfTheWindow) {
  const Wave wave = write_window({}, {}, fences(0, 1000), {100, 149, file()}, cache_);
  EXPECT_EQ(wave.report, std::nullopt);
  const auto edges = read_signal(file(), "clk_i");
  ASSERT_TRUE(edges.has_value());
  ASSERT_EQ(edges->size(), 100u);  // two a cycle
  EXPECT_EQ(edges->front(), (Edge{time_of(100), "0"}));
  EXPECT_EQ(edges->back(), (Edge{time_of(149) + kPeriod / 2, "1"}));
}

TEST_F(WaveTest, RunEndsWithTheWindow) {
  std::uint64_t cycles = 0;
  RtlOptions options;
  options.slice = 10;
  options.progress = [&](const Progress& progress) { cycles = progress.cycles; };
  write_window({}, options, fences(0, 100'000), {0, 50, file()}, cache_);
  EXPECT_LE(cycles, 51u);
}

TEST_F(WaveTest, ShowsWhatLedToTheFirstDifference) {
  AlteredEngine reference(golden::make_golden_engine({}), flip_bit(600, 3));
  const Wave wave =
      write_first_difference(reference, {}, fences(0, 1000), file(), {.before = 20, .after = 5}, cache_);
  ASSERT_TRUE(wave.report.has_value());
  ASSERT_TRUE(wave.report->first.has_value());
  ASSERT_TRUE(wave.report->first->cycle.has_value());
  const std::uint64_t cycle = *wave.report->first->cycle;
  EXPECT_EQ(wave.window.from, cycle - 20);
  EXPECT_EQ(wave.window.to, cycle + 5);
  const auto data = read_signal(file(), "res_data_o");
  ASSERT_TRUE(data.has_value());
  bool shown = false;
  for (const Edge& edge : *data) {
    if (edge.time > time_of(cycle)) break;
    shown = std::stoull(edge.value, nullptr, 2) == *wave.report->first->actual;
  }
  EXPECT_TRUE(shown) << "the word that differs is not on the port at its cycle";
}

TEST_F(WaveTest, FindsTheFirstCommandOfAKindAndItsCycle) {
  std::vector<Word> stream{golden::encode(golden::Header{0, 0, 2, 0}), 0x0600000000000000,
                           7};  // NOP with items
  const std::vector<Word> fence = fences(0, 3);
  stream.insert(stream.end(), fence.begin(), fence.end());
  EXPECT_EQ(find_command(stream, "nop"), 0u);
  EXPECT_EQ(find_command(stream, "Fence"), 3u) << "items are no headers";
  EXPECT_EQ(find_command(stream, "QUERY"), std::nullopt);

  EXPECT_EQ(cycle_of_header({}, {}, fences(0, 100), 60, cache_), 60u) << "a word a cycle";
}

TEST_F(WaveTest, WritesNothingWhereAllIsEqual) {
  const auto reference = golden::make_golden_engine({});
  const Wave wave = write_first_difference(*reference, {}, fences(0, 100), file(), {}, cache_);
  ASSERT_TRUE(wave.report.has_value());
  EXPECT_TRUE(wave.report->passed());
  EXPECT_FALSE(std::filesystem::exists(file()));
}

TEST_F(WaveTest, ShowsAHang) {
  RtlOptions options;
  options.defines = {"TINY_HANGS"};
  options.hang_cycles = 1000;
  const auto reference = golden::make_golden_engine({});
  const Wave wave = write_first_difference(*reference, options, fences(0, 100), file(), {}, cache_);
  EXPECT_NE(wave.report->fault, "");
  const auto edges = read_signal(file(), "clk_i");
  ASSERT_TRUE(edges.has_value());
  EXPECT_EQ(edges->size(), 2 * 200u);  // up to the cycle at which the watchdog spoke
}

TEST_F(WaveTest, IsCompleteAfterAnInterrupt) {
  const InterruptFlag interrupt;
  RtlOptions options;
  options.slice = 100;
  options.abort = &interrupt.flag();
  options.progress = [](const Progress& progress) {
    if (progress.cycles == 300) std::raise(SIGINT);
  };
  EXPECT_THROW(write_window({}, options, fences(0, 1000), {0, 100'000, file()}, cache_), Aborted);
  const auto edges = read_signal(file(), "clk_i");
  ASSERT_TRUE(edges.has_value());
  EXPECT_EQ(edges->size(), 2 * 400u);
}

TEST_F(WaveTest, NamesAFileThatCannotBeWritten) {
  const TraceWindow window{0, 10, "/nowhere/wave.fst"};
  EXPECT_THROW(write_window({}, {}, fences(0, 10), window, cache_), std::runtime_error);
}

}  // namespace
}  // namespace gnomon::sim::test
