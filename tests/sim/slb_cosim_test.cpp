// SPDX-License-Identifier: Apache-2.0
// The hardware with the silhouette-line buffer gives the words that golden gives: ports held back, resets,
// power-up content, pieces; and the comparison finds its way through raw words. One model serves all of it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <gnomon/golden/golden_engine.hpp>
#include <numeric>

#include "sim/counter_names.hpp"
#include "tests/sim/altered_engine.hpp"
#include "tests/sim/cosim.hpp"
#include "tests/sim/tiny_model.hpp"

namespace gnomon::sim::test {
namespace {

const golden::HardwareConfig kSlb{.en_slb = true};

class StalledSlb : public testing::TestWithParam<int> {};

TEST_P(StalledSlb, RandomStreams) {
  const auto kind = static_cast<std::uint64_t>(GetParam());
  RtlOptions options = Cosim::checked();
  options.stalls = stall_profile(GetParam(), 31 + kind);
  Cosim cosim(kSlb, options);
  std::uint64_t words = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const stimulus::DirectedStream stream = random_case(kSlb, 100 * kind + seed, 200);
    const CompareReport report = cosim.run(stream.words);
    EXPECT_TRUE(report.passed()) << stream.name << "\n" << to_text(report);
    words += report.words_compared;
    const auto& cycles = report.rtl_counters.cycles;
    EXPECT_EQ(std::accumulate(cycles.begin(), cycles.end(), std::uint64_t{0},
                              [](std::uint64_t sum, const auto& cell) { return sum + cell.second; }),
              report.cycles);
    for (const char* pass : {"DRAW", "FILL", "COVER", "QUERY", "READ", "CLEAR"}) {
      EXPECT_GT(cycles.at(std::string("cycles.") + pass + ".BUSY"), 0u) << pass;
    }
  }
  EXPECT_GT(words, 1'000u);
}

INSTANTIATE_TEST_SUITE_P(Ports, StalledSlb, testing::Range(0, kStallProfiles));

TEST(SlbCosim, ResetInTheMiddleOfAnything) {
  RtlOptions options = Cosim::checked();
  options.stalls = stall_profile(4, 9);
  Cosim cosim(kSlb, options);
  const std::vector<Word> before = random_case(kSlb, 50, 150).words;
  const std::vector<Word> after = random_case(kSlb, 51, 60).words;
  for (std::size_t cut = 3; cut < before.size(); cut += 1 + before.size() / 12) {
    cosim.rtl().reset();
    cosim.rtl().submit(std::span(before).first(cut));  // returns with the pipelines full
    const CompareReport report = cosim.run(after);     // resets
    EXPECT_TRUE(report.passed()) << "reset after " << cut << " words\n" << to_text(report);
    EXPECT_GT(report.words_compared, 100u);
  }
}

TEST(SlbCosim, NeitherWordsNorCyclesDependOnThePowerUpContent) {
  const std::vector<Word> stream = random_case(kSlb, 60, 150).words;
  std::vector<std::uint64_t> cycles;
  for (const std::uint32_t seed : {1u, 2u, 0xFFFFFFFFu}) {
    RtlOptions options = Cosim::checked();
    options.seed = seed;
    Cosim cosim(kSlb, options);
    const CompareReport report = cosim.run(stream);
    EXPECT_TRUE(report.passed()) << to_text(report);
    cycles.push_back(report.cycles);
  }
  EXPECT_EQ(cycles, std::vector<std::uint64_t>(cycles.size(), cycles.front()));
}

TEST(SlbCosim, DrainInTheMiddleOfEveryKindOfCommand) {
  Cosim cosim(kSlb);
  const std::vector<Word> stream = random_case(kSlb, 71, 80).words;
  for (std::size_t offset = 0; offset < stream.size(); offset += 5) {
    const auto piece = std::span(stream).subspan(offset, std::min<std::size_t>(5, stream.size() - offset));
    ASSERT_EQ(run(cosim.rtl(), piece), run(cosim.golden(), piece)) << "at word " << offset;
    ASSERT_EQ(cosim.rtl().counters().events, cosim.golden().counters().events) << "at word " << offset;
  }
}

TEST(SlbCosim, CountersHaveTheNamesOfGolden) {
  const auto names = golden::slb::named({});
  ASSERT_EQ(names.size(), kSlbEventNames.size());
  for (std::size_t i = 0; i < names.size(); ++i) EXPECT_EQ(names[i].first, kSlbEventNames[i]);
}

/// An object, two points, two entries: results 0 and 1 answers, 2 and 7 entries, their raw words after them.
std::vector<Word> short_stream() {
  const std::int64_t pixel = kSlb.slb_config().subpixels();
  golden::StreamWriter writer(kSlb);
  writer.begin_object(5, 100);
  writer.loop(std::vector<golden::slb::Vertex>{
      {pixel, pixel, 0}, {9 * pixel, 2 * pixel, 0}, {4 * pixel, 8 * pixel, 0}});
  writer.fill();
  writer.end_object();
  writer.query(std::vector<golden::slb::QueryPoint>{{3 * pixel, 3 * pixel, 200}, {-7, 0, 200}}, 3);
  writer.read_entries(256 * 2 + 4, 2);
  return writer.take();
}

CompareReport with_flipped_bit(std::uint64_t result, int bit) {
  AlteredEngine reference(golden::make_golden_engine(kSlb), flip_bit(result, bit));
  const auto rtl = make_rtl_engine(kSlb, Cosim::checked());
  return compare(reference, *rtl, short_stream());
}

TEST(SlbCosim, ADifferenceInAnAnswerNamesThePoint) {
  const CompareReport report = with_flipped_bit(1, 50);
  EXPECT_EQ(report.words_compared, 12u);
  EXPECT_EQ(report.words_differing, 1u);
  ASSERT_TRUE(report.first);
  EXPECT_EQ(report.first->item_index, 1u);
  EXPECT_THAT(to_text(report),
              testing::AllOf(testing::HasSubstr("QUERY"), testing::HasSubstr("x -7 y 0 depth 200"),
                             testing::HasSubstr("off_plane=1")));
}

TEST(SlbCosim, ADifferenceInARawWordNamesTheEntryAndTheField) {
  const CompareReport report = with_flipped_bit(8, 10);  // the second entry's first raw word
  EXPECT_EQ(report.words_differing, 1u);
  ASSERT_TRUE(report.first);
  EXPECT_EQ(report.first->item_index, 1u);
  EXPECT_EQ(report.first->raw_word, 0u);
  EXPECT_THAT(to_text(report),
              testing::AllOf(testing::HasSubstr("READ_ENTRIES"), testing::HasSubstr("entry word 0"),
                             testing::HasSubstr("overflow=1"), testing::HasSubstr("overflow=0")));
}

}  // namespace
}  // namespace gnomon::sim::test
