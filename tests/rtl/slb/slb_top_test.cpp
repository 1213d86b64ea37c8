// SPDX-License-Identifier: Apache-2.0
// gnomon_core with the silhouette-line buffer against the golden engine: answers, every entry of the plane,
// errors, sticky flags and event counters, with and without waiting on the ports, and after a reset in the
// middle.
#include <gtest/gtest.h>

#include <gnomon/golden/codec.hpp>
#include <gnomon/golden/golden_engine.hpp>
#include <string>
#include <vector>

#include "sim/counter_names.hpp"
#include "slb_builds.hpp"
#include "slb_streams.hpp"
#include "tests/rtl/stream_bench.hpp"

namespace gnomon::rtl_test {
namespace {

template <class Model>
class SlbTop : public testing::Test {
 protected:
  void compare(const std::string& name, std::span<const Word> words, Stalls stalls, std::uint32_t seed,
               std::uint64_t reset_after = 0) {
    const auto golden = golden::make_golden_engine(SlbBuild<Model>::config());
    std::vector<Word> expected;
    golden->submit(words);
    golden->drain(
        [&](std::span<const Word> some) { expected.insert(expected.end(), some.begin(), some.end()); });

    StreamBench<Model> bench(seed);
    if (reset_after > 0) bench.run_then_reset(words, stalls, reset_after);
    const std::vector<Word> results = bench.run(words, stalls);
    ASSERT_EQ(results.size(), expected.size()) << name << " seed " << seed;
    for (std::size_t i = 0; i < expected.size(); ++i, ++compared_) {
      ASSERT_EQ(results[i], expected[i])
          << name << " seed " << seed << " result " << i << "\n  rtl    "
          << golden::describe_result(results[i]) << "\n  golden " << golden::describe_result(expected[i]);
    }
    const auto counters = golden->counters();
    for (unsigned i = 0; i < sim::kEventNames.size(); ++i) {
      expect_event(bench, i, counters.events.at(std::string(sim::kEventNames[i])), sim::kEventNames[i], seed);
    }
    for (unsigned i = 0; i < sim::kSlbEventNames.size(); ++i) {
      const std::string event(sim::kSlbEventNames[i]);
      expect_event(bench, sim::kFirstSlbCounter + i, counters.events.at(event), event, seed);
    }
    saturated_ += counters.events.at("SLB_WINDING_SATURATED");
    std::uint64_t cycles = 0;
    for (std::size_t pass = 0; pass < sim::kPassNames.size(); ++pass) {
      for (std::size_t cause = 0; cause < sim::kCauseNames.size(); ++cause) {
        cycles += bench.counter(sim::cycle_counter_index(pass, cause));
      }
    }
    EXPECT_EQ(cycles, bench.cycles()) << name;
  }

  static void expect_event(auto& bench, unsigned index, std::uint64_t expected, std::string_view event,
                           std::uint32_t seed) {
    EXPECT_EQ(bench.counter(index), expected) << event << " seed " << seed;
  }

  std::size_t compared_ = 0;
  std::uint64_t saturated_ = 0;  ///< changes of winding numbers that did not fit
};
using Builds = testing::Types<Vslb_default, Vslb_small, Vslb_wide, Vslb_published, Vslb_deep>;
TYPED_TEST_SUITE(SlbTop, Builds);

TYPED_TEST(SlbTop, AnswersRandomStreamsAsGolden) {
  constexpr Stalls kStalls[] = {{}, {40, 256}, {256, 60}, {150, 150}};
  for (std::uint32_t seed = 1; seed <= 40; ++seed) {
    this->compare("random", random_slb_stream(seed, SlbBuild<TypeParam>::config()), kStalls[seed % 4], seed);
    if (this->HasFatalFailure()) return;
  }
  EXPECT_GT(this->compared_, 10'000u);
}

TYPED_TEST(SlbTop, AnswersCrowdedPixelsAsGolden) {
  for (std::uint32_t seed = 1; seed <= 12; ++seed) {
    this->compare("crowded", crowded_slb_stream(seed, SlbBuild<TypeParam>::config()), {}, seed);
    if (this->HasFatalFailure()) return;
  }
  EXPECT_GT(this->compared_, 10'000u);
}

TYPED_TEST(SlbTop, AnswersSamplesOfEveryPixelAsGolden) {
  for (std::uint32_t seed = 1; seed <= 6; ++seed) {
    const Stalls stalls = seed % 2 == 0 ? Stalls{150, 150} : Stalls{};
    this->compare("wide", wide_slb_stream(seed, SlbBuild<TypeParam>::config()), stalls, seed);
    if (this->HasFatalFailure()) return;
  }
  EXPECT_GT(this->compared_, 1'000u);
}

TYPED_TEST(SlbTop, AnswersPointsOnLinesAsGolden) {
  this->compare("diagonal", diagonal_slb_stream(SlbBuild<TypeParam>::config()), {}, 1);
}

TYPED_TEST(SlbTop, StaysClearedWhenGenerationsComeRound) {
  this->compare("clearing", clearing_slb_stream(SlbBuild<TypeParam>::config()), {}, 1);
}

TYPED_TEST(SlbTop, SaturatesWindingNumbersAsGolden) {
  for (const std::uint32_t seed : {1u, 2u}) {
    this->compare("piled", piled_slb_stream(seed, SlbBuild<TypeParam>::config()), {}, seed);
  }
  EXPECT_GT(this->saturated_, 100u);
}

TYPED_TEST(SlbTop, RecoversFromResetInTheMiddle) {
  for (std::uint32_t seed = 1; seed <= 12; ++seed) {
    this->compare("reset", random_slb_stream(seed, SlbBuild<TypeParam>::config()), {200, 200}, seed,
                  seed * 377);
    if (this->HasFatalFailure()) return;
  }
  EXPECT_GT(this->compared_, 5'000u);
}

}  // namespace
}  // namespace gnomon::rtl_test
