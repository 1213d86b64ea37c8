// SPDX-License-Identifier: Apache-2.0
// The silhouette-line buffer behind caches in the cycle model, part by part: against the recurrences that
// hold on the chip, and against numbers worked out by hand from docs/cycle-model.md, "Entries behind caches".
#include <gtest/gtest.h>

#include <gnomon/golden/cycles.hpp>
#include <random>

#include "golden/cycles/fill.hpp"
#include "golden/cycles/outline.hpp"
#include "golden/cycles/slb_draw.hpp"
#include "golden/cycles/slb_fill.hpp"
#include "golden/cycles/slb_points.hpp"
#include "tests/support/stimulus.hpp"

namespace gnomon::golden::cycles {
namespace {

constexpr Cycle kLong = 5'000;

/// 32 x 32 pixels behind caches of 2 KiB and 1 KiB, which are empty.
class Cached : public testing::Test {
 protected:
  Cached() {
    ports_.add_cache(CachedMemory::Lanes, 11, SlbMemory::lane_lines_log2(slb_));
    ports_.add_cache(CachedMemory::Fragments, 10, SlbMemory::fragment_lines_log2(slb_));
  }
  void step() { ports_.cycle(false, false, false); }

  HardwareConfig config_{.plane_log2 = 5, .en_slb = true, .slb_plane_log2 = 5};
  slb::SlbConfig slb_ = config_.slb_config();
  Ports ports_{config_, {}};
  SlbMemory memory_{slb_};
};

using Loop = std::vector<slb::Vertex>;

/// Right of the plane, where chains end before the memory; edges short and long, level and sloping.
Loop loop_off_the_plane(std::mt19937& random, const slb::SlbConfig& config) {
  const auto pick = [&](std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(random);
  };
  const std::int64_t reach = pick(0, 1) != 0 ? config.subpixels() : 12 * config.subpixels();
  slb::Vertex at{.x = (config.side() + 16) * config.subpixels(), .y = 0};
  Loop loop;
  for (std::int64_t left = pick(1, 40); left != 0; --left) {
    at.x = std::clamp(at.x + pick(-reach, reach), std::int64_t{config.side()} << config.subpixel_bits,
                      (std::int64_t{config.side()} << (config.subpixel_bits + 1)) - 1);
    at.y += pick(-reach, reach) / 8;
    at.depth = static_cast<std::uint32_t>(pick(0, 3));
    loop.push_back(at);
  }
  return loop;
}

class CachedDraw : public Cached, public testing::WithParamInterface<int> {};

TEST_P(CachedDraw, TakesAndWalksAsTheRecurrencesSayWhereNothingIsStored) {
  const HardwareTiming timing{.slb_dividers = GetParam()};
  Outline outline(slb_, timing);
  DrawClock draw(slb_, timing);
  cycles::Run run;
  run.begin(Pass::Draw, 0);
  std::mt19937 random(7);
  std::size_t offers = 0;
  Cycle steps = 0;
  const auto offer = [&](const DrawClock::Offer& item, Cycle expected) {
    for (bool taken = false; !taken && ports_.now() < expected + kLong; step()) {
      const SlbMoves moves = draw.cycle(&item, memory_, ports_);
      taken = moves.taken;
      steps += moves.steps ? 1U : 0U;
    }
    ++offers;
    ASSERT_EQ(ports_.now() - 1, expected) << "offer " << offers;
  };
  for (int i = 0; i < 60; ++i) {
    for (const slb::Vertex& vertex : loop_off_the_plane(random, slb_))
      ASSERT_NO_FATAL_FAILURE(offer({.vertex = vertex}, outline.vertex(vertex, ports_.now(), run)));
    ASSERT_NO_FATAL_FAILURE(offer({.vertex = {}, .closes = true}, outline.close(ports_.now(), run)));
    if (i % 3 != 0) continue;
    const Cycle drained = std::max(ports_.now(), outline.drained());
    while (!draw.idle(ports_.now())) {
      steps += draw.cycle(nullptr, memory_, ports_).steps ? 1U : 0U;
      step();
    }
    ASSERT_EQ(ports_.now(), drained);
  }
  EXPECT_GT(offers, 500U);
  EXPECT_GT(steps, 1'000U);
}
INSTANTIATE_TEST_SUITE_P(Dividers, CachedDraw, testing::Values(1, 2, 3));

TEST_F(Cached, FillTakesTheStepsOfTheChip) {
  std::mt19937 random(3);
  for (const bool flat : {false, true}) {
    slb::FillSweep sweep{.first_row = 4, .last_row = 11, .lines = {}};
    for (int i = 0; i < 16; ++i) {
      std::uint32_t pixels = 0xFFFF;
      for (int draw = 0; draw < 3; ++draw) pixels &= static_cast<std::uint32_t>(random());
      sweep.lines.push_back({static_cast<std::uint16_t>(pixels), random() % 2 == 0});
    }
    sweep.lines[3] = sweep.lines[4] = {};
    FillClock fill(sweep, flat, slb_, {});
    const Cycle start = ports_.now();
    Cycle steps = 0;
    for (step(); !fill.idle() && ports_.now() < start + kLong; step())
      steps += fill.cycle(memory_, ports_).steps ? 1U : 0U;
    const FillCycles on_chip = fill_cycles(sweep, flat, slb_, {});
    EXPECT_EQ(steps, on_chip.steps);
    // An update a cycle while lines are new; the second time they are written back first.
    constexpr Cycle kMemory = 2;  // from the last update to the end, on the chip
    EXPECT_EQ(ports_.now() - start == on_chip.idle - kMemory, !flat);
    while (!memory_.idle(ports_)) {
      memory_.begin(ports_);
      memory_.serve(ports_);
      step();
    }
  }
}

/// A register, the one in front of the caches, a line that was never written (4), the service (2), three
/// stages.
TEST_F(Cached, APointIsAnsweredElevenCyclesAfterItIsTaken) {
  PointClock points;
  const SlbRequest point{.index = 100, .kind = SlbRequest::Kind::Read};
  std::vector<Cycle> answers;
  int asked = 0;
  for (; ports_.now() < 40; step()) {
    const SlbMoves moves = points.cycle(asked < 5 ? &point : nullptr, memory_, ports_);
    EXPECT_EQ(moves.taken, asked < 5);
    asked += moves.taken ? 1 : 0;
    if (moves.gives) answers.push_back(ports_.now());
  }
  EXPECT_EQ(answers, (std::vector<Cycle>{11, 12, 13, 14, 15}));
  EXPECT_TRUE(points.idle());
  EXPECT_TRUE(memory_.idle(ports_));
}

/// A header and four words each; the entry behind waits in its place.
TEST_F(Cached, EntriesAreReadAWordACycle) {
  EntryClock reader(0, 3, slb_);
  Cycle given = 0;
  for (; !reader.over() && ports_.now() < kLong; step())
    given += reader.cycle(memory_, ports_).gives ? 1U : 0U;
  EXPECT_EQ(given, 3U * 5);
  EXPECT_EQ(ports_.now(), 7U + 15) << "asked for in 0, looked up in 1, served in 5";
}

/// With lines and lists of a build that has everything.
TEST(CachedModel, SlowerMemoriesAndSmallerCachesCostCyclesInEveryUnit) {
  const HardwareConfig config{.plane_log2 = 6,
                              .en_vpu_topology = true,
                              .nodes_log2 = 12,
                              .quads_log2 = 10,
                              .en_slb = true,
                              .slb_plane_log2 = 6};
  const auto predict = [&](int cache_log2, std::uint32_t latency, int ids_log2) {
    CycleTable all;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const CycleTable table = predict_cycles(
          config,
          {.system = SystemTiming{.cache_log2 = cache_log2, .line_ids_log2 = ids_log2, .latency = latency}},
          stimulus::random_stream(config, {.seed = seed, .commands = 300, .illegal_percent = 0}));
      for (std::size_t p = 0; p < kPasses; ++p)
        for (std::size_t c = 0; c < kCauses; ++c)
          all.at(static_cast<Pass>(p), static_cast<Cause>(c)) +=
              table.at(static_cast<Pass>(p), static_cast<Cause>(c));
    }
    return all;
  };
  const CycleTable table = predict(12, 100, 3), slower = predict(12, 200, 3), larger = predict(16, 100, 3);
  for (const Pass pass : {Pass::Project, Pass::Resolve, Pass::Draw, Pass::Fill, Pass::Query}) {
    EXPECT_GT(slower.of(pass), table.of(pass)) << static_cast<int>(pass);
    EXPECT_LE(larger.of(pass), table.of(pass)) << static_cast<int>(pass);
    EXPECT_GT(table.of(pass), 300U);
  }
  EXPECT_LE(predict(12, 200, 5).total(), slower.total()) << "more lines under way";
}

TEST_F(Cached, SamplesThatDoNotCountEndInTheirRegister) {
  SampleClock samples;
  const SlbRequest sample{.index = 3, .kind = SlbRequest::Kind::Sample, .writes = false};
  EXPECT_TRUE(samples.cycle(&sample, false, memory_, ports_).taken);
  EXPECT_TRUE(samples.idle());
  step();
  EXPECT_TRUE(samples.cycle(&sample, true, memory_, ports_).taken);
  EXPECT_FALSE(samples.idle());
  step();
  samples.cycle(nullptr, false, memory_, ports_);
  EXPECT_TRUE(samples.idle());
  EXPECT_FALSE(memory_.idle(ports_));
}

}  // namespace
}  // namespace gnomon::golden::cycles
