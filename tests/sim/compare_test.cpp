// SPDX-License-Identifier: Apache-2.0
// The comparison notices every kind of lie, and says exactly where it is.
#include "sim/compare.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <gnomon/golden/golden_engine.hpp>
#include <nlohmann/json.hpp>

#include "tests/sim/altered_engine.hpp"
#include "tests/sim/cosim.hpp"
#include "tests/sim/tiny_model.hpp"

namespace gnomon::sim::test {
namespace {

using testing::HasSubstr;

golden::HardwareConfig config() {
  golden::HardwareConfig config;
  config.plane_log2 = 6;
  return config;
}

/// NOP, SET_REGISTERS, FENCE (1 result), PROJECT, RESOLVE of 8 voxels (8 results), FENCE (1 result).
std::vector<Word> stream() {
  golden::StreamWriter writer(config());
  writer.set_register(golden::Register::MatrixUx, 5);
  writer.fence(1, false);
  std::vector<golden::VoxelItem> voxels(8);
  for (std::uint32_t i = 0; i < 8; ++i) voxels[i].position = {i, 2 * i, 3 * i};
  writer.project(voxels);
  writer.resolve(voxels, false);
  writer.fence(2, false);
  return writer.take();
}

class CompareTest : public testing::Test {
 protected:
  CompareReport run(const Alteration& alteration, const CompareOptions& options = {}) {
    AlteredEngine reference(golden::make_golden_engine(config()), alteration);
    rtl_->reset();
    return compare(reference, *rtl_, stream(), options, 42);
  }

  static Alteration honest() {
    return [](std::uint64_t, Word word) { return std::vector<Word>{word}; };
  }

  std::unique_ptr<RtlEngine> rtl_ = make_rtl_engine(config(), Cosim::checked());
};

TEST_F(CompareTest, EqualEnginesPassAndAreCounted) {
  const CompareReport report = run(honest(), {.plane = true});
  EXPECT_TRUE(report.passed()) << to_text(report);
  EXPECT_EQ(report.commands, 5u);
  EXPECT_EQ(report.words_compared, 10u);
  EXPECT_EQ(report.expected_words, 10u);
  EXPECT_EQ(report.plane_entries_compared, 64u * 64u);
  EXPECT_EQ(to_text(report), "10 words compared, 0 differ\n");
}

TEST_F(CompareTest, OneWrongBitIsLocated) {
  const CompareReport report = run(flip_bit(4, 0));  // the fourth voxel: delta
  EXPECT_FALSE(report.passed());
  EXPECT_EQ(report.words_compared, 10u);
  EXPECT_EQ(report.words_differing, 1u);
  ASSERT_TRUE(report.first.has_value());
  const Difference& first = *report.first;
  EXPECT_EQ(first.result, 4u);
  EXPECT_EQ(first.command_index, 3u);
  EXPECT_EQ(first.command.op, static_cast<std::uint8_t>(golden::Op::ResolveVoxels));
  EXPECT_EQ(first.item_index, 3u);
  ASSERT_TRUE(first.item.has_value());
  EXPECT_EQ(golden::decode_voxel(*first.item, config()).position, (std::array<std::uint32_t, 3>{3, 6, 9}));
  ASSERT_TRUE(first.cycle.has_value());
  EXPECT_LT(*first.cycle, report.cycles);
  EXPECT_EQ(*first.expected ^ *first.actual, 1u);
}

TEST_F(CompareTest, EveryBitOfEveryWordCounts) {
  for (std::uint64_t word = 0; word < 10; ++word) {
    for (int bit = 0; bit < 64; ++bit) {
      const CompareReport report = run(flip_bit(word, bit), {.stop_at_first = true});
      ASSERT_FALSE(report.passed()) << "word " << word << " bit " << bit;
      ASSERT_EQ(report.first->result, word);
    }
  }
}

TEST_F(CompareTest, MissingAndSurplusWordsFail) {
  const CompareReport surplus = run(drop(9));  // the last: the hardware gives one more than expected
  EXPECT_FALSE(surplus.passed());
  EXPECT_EQ(surplus.words_differing, 0u);
  EXPECT_EQ(surplus.expected_words + 1, surplus.actual_words);
  ASSERT_TRUE(surplus.first.has_value());
  EXPECT_EQ(surplus.first->expected, std::nullopt);

  const CompareReport missing = run(repeat(9));
  EXPECT_FALSE(missing.passed());
  EXPECT_EQ(missing.words_differing, 0u);
  ASSERT_TRUE(missing.first.has_value());
  EXPECT_EQ(missing.first->actual, std::nullopt);
  EXPECT_TRUE(missing.first->after_stream);
}

TEST_F(CompareTest, EventCountersAndPlaneCount) {
  for (const auto& [event, count] : rtl_->counters().events) {
    AlteredEngine reference(golden::make_golden_engine(config()), honest());
    reference.miscount(event);
    rtl_->reset();
    const CompareReport report = compare(reference, *rtl_, stream());
    EXPECT_FALSE(report.passed()) << event;
    ASSERT_EQ(report.counters.size(), 1u);
    EXPECT_EQ(report.counters[0].name, event);
    EXPECT_EQ(report.counters[0].expected, report.counters[0].actual + 1);
  }
  AlteredEngine reference(golden::make_golden_engine(config()), honest());
  reference.misread(77);
  rtl_->reset();
  const CompareReport report = compare(reference, *rtl_, stream(), {.plane = true});
  EXPECT_FALSE(report.passed());
  EXPECT_EQ(report.plane_entries_differing, 1u);
}

TEST_F(CompareTest, NothingComparedIsNoSuccess) {
  const auto reference = golden::make_golden_engine(config());
  const CompareReport report = compare(*reference, *rtl_, std::vector<Word>{});
  EXPECT_FALSE(report.passed());
  EXPECT_TRUE(report.consistent());
  EXPECT_THAT(to_text(report), HasSubstr("no result word was compared"));
}

TEST_F(CompareTest, OtherConfigurationsAreRefused) {
  const auto reference = golden::make_golden_engine({});
  EXPECT_THROW(compare(*reference, *rtl_, stream()), std::invalid_argument);
}

TEST_F(CompareTest, ReportNamesEverything) {
  const CompareReport report = run(flip_bit(4, 54));
  const std::string text = to_text(report);
  for (const char* part : {"first difference: result word 4", "command   3", "RESOLVE_VOXELS",
                           "result    3 of the command", "position (3, 6, 9)", "cycle", "expected", "rtl",
                           "seed 42", "PLANE_LOG2=6", "10 words compared, 1 differ"}) {
    EXPECT_THAT(text, HasSubstr(part));
  }
  const nlohmann::json json = to_json(report);
  EXPECT_EQ(json.at("passed"), false);
  EXPECT_EQ(json.at("seed"), 42);
  EXPECT_EQ(json.at("words_differing"), 1);
  EXPECT_EQ(json.at("config").at("plane_log2"), 6);
  EXPECT_EQ(json.at("first_difference").at("command_index"), 3);
  EXPECT_EQ(json.at("first_difference").at("item_index"), 3);
  EXPECT_EQ(json.at("first_difference").at("cycle"), *report.first->cycle);
}

TEST(CompareFaults, AHangEndsTheComparisonAndIsReported) {
  RtlOptions options;
  options.defines = {"TINY_HANGS"};
  options.hang_cycles = 1000;
  const auto rtl = tiny_engine(options);
  const auto reference = golden::make_golden_engine({});
  const CompareReport report = compare(*reference, *rtl, fences(0, 10));
  EXPECT_FALSE(report.passed());
  EXPECT_THAT(report.fault, HasSubstr("hangs"));
  EXPECT_EQ(report.words_compared, 3u);
  ASSERT_TRUE(report.first.has_value());
  EXPECT_EQ(report.first->command_index, 3u);  // the first command without an answer
  EXPECT_EQ(to_json(report).at("fault"), report.fault);
}

TEST(CompareFaults, AFailedAssertionIsReported) {
  RtlOptions options;
  options.defines = {"TINY_ASSERTS"};
  options.assertions = true;
  const auto rtl = tiny_engine(options);
  const auto reference = golden::make_golden_engine({});
  const CompareReport report = compare(*reference, *rtl, fences(0, 10));
  EXPECT_FALSE(report.passed());
  EXPECT_THAT(report.fault, HasSubstr("tiny_never_five"));
}

}  // namespace
}  // namespace gnomon::sim::test
