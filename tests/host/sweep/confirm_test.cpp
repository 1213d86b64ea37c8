// SPDX-License-Identifier: Apache-2.0
// Predicted cycles against the hardware's: when a point agrees, and when it is flagged.
#include "host/sweep/confirm.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/sweep/selection.hpp"

namespace gnomon::sweep {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

Measurement confirmation(const Cycles& model, const Cycles& rtl, const report::CompareRecord& compare) {
  return sweep::confirmation(model, rtl, compare, kChipBound);
}

const Cycles kModel{{"cycles.DRAW.BUSY", 900}, {"cycles.QUERY.BUSY", 100}, {"cycles.CLEAR.BUSY", 0}};

report::CompareRecord compared(std::uint64_t words, std::uint64_t differing = 0) {
  report::CompareRecord record;
  record.compared = true;
  record.words = words;
  record.differing = differing;
  return record;
}

std::string label(const Measurement& measured) {
  return measured.labels.at(std::string(kConfirmLabel));
}

TEST(CycleFigures, AreByPassWithTheirSumWithoutWhatDecidesNothing) {
  Cycles cycles = kModel;
  cycles["cycles.DRAW.HAZARD"] = 50;
  cycles["cycles.READ.BUSY"] = 7000;
  cycles["cycles.IDLE.IDLE"] = 9;
  EXPECT_EQ(cycle_figures("model", cycles),
            (std::map<std::string, double>{
                {"model.cycles", 1050}, {"model.cycles.DRAW", 950}, {"model.cycles.QUERY", 100}}));
}

TEST(Confirmation, AgreesWhereWordsAndCyclesDo) {
  const Measurement measured = confirmation(kModel, kModel, compared(12));
  EXPECT_EQ(label(measured), kAgrees);
  EXPECT_EQ(measured.figures.at("confirm.cycle_error"), 0);
  EXPECT_EQ(measured.figures.at("confirm.words"), 12);
  EXPECT_EQ(measured.figures.at("rtl.cycles"), 1000);
}

TEST(Confirmation, IsFlaggedBeyondTheBoundAlsoWherePassesCancel) {
  Cycles rtl = kModel;
  rtl["cycles.DRAW.BUSY"] += 1;
  EXPECT_EQ(label(confirmation(kModel, rtl, compared(1))), kAgrees);
  EXPECT_NEAR(confirmation(kModel, rtl, compared(1)).figures.at("confirm.cycle_error"), 1.0 / 1001, 1e-12);
  rtl["cycles.DRAW.BUSY"] = 920;
  rtl["cycles.QUERY.BUSY"] = 80;
  EXPECT_THAT(label(confirmation(kModel, rtl, compared(1))),
              StartsWith("flagged: predicted cycles are off by 4"));
}

TEST(Confirmation, OfTheSystemAllowsForTheProcessor) {
  Cycles rtl = kModel;
  for (const auto& [more, flagged] : {std::pair{9, false}, {20, true}}) {
    rtl["cycles.DRAW.BUSY"] = 900 + static_cast<std::uint64_t>(more);
    EXPECT_TRUE(is_flagged(confirmation(kModel, rtl, compared(1))));
    EXPECT_EQ(is_flagged(sweep::confirmation(kModel, rtl, compared(1), kSystemBound)), flagged);
  }
  EXPECT_FALSE(is_flagged({})) << "what has no hardware";
}

TEST(Confirmation, IsFlaggedWhereAPassIsMissingOrAWordDiffers) {
  Cycles rtl = kModel;
  rtl.erase("cycles.QUERY.BUSY");
  EXPECT_THAT(label(confirmation(kModel, rtl, compared(1))), StartsWith("flagged"));
  EXPECT_THAT(label(confirmation({}, kModel, compared(1))), StartsWith("flagged"));
  EXPECT_THAT(label(confirmation(kModel, kModel, compared(12, 1))), HasSubstr("12 words compared, 1 differ"));
  EXPECT_THAT(label(confirmation(kModel, kModel, compared(0))), HasSubstr("nothing is verified"));
}

Row point(const std::string& key, double error, double bits, bool confirmed = false) {
  Row row;
  row.key = key;
  row.scene = "cup.toml";
  row.configuration = "{}";
  row.figures = {{"errors.fixed.border_voxels", error}, {"memory.format_bits", bits}};
  if (confirmed) row.labels.emplace(kConfirmLabel, kAgrees);
  return row;
}

std::set<std::string> chosen(const std::string& text, const std::vector<Row>& rows) {
  const auto selection = Selection::parse(text);
  EXPECT_TRUE(selection) << text;
  return selection->choose(rows);
}

TEST(Selection, TakesTheFrontSomeOrAllThatAreNotConfirmed) {
  std::vector<Row> rows{point("a", 1, 1), point("b", 2, 2), point("c", 0.5, 3, true), point("d", 0.2, 9)};
  rows.push_back(point("e", 0, 0));
  rows.back().error = "failed";
  EXPECT_THAT(chosen("front", rows), ElementsAre("a", "d"));
  EXPECT_THAT(chosen("all", rows), ElementsAre("a", "b", "d"));
  EXPECT_THAT(chosen("2", rows), ElementsAre("a"));
  EXPECT_THAT(chosen("99", rows), ElementsAre("a", "b", "d"));
  EXPECT_THAT(chosen("", rows), ElementsAre());
}

TEST(Selection, RefusesOtherWords) {
  for (const char* text : {"0", "-1", "2x", "fronts", "1.5"}) {
    const auto selection = Selection::parse(text);
    ASSERT_FALSE(selection) << text;
    EXPECT_THAT(selection.error().message, HasSubstr("expected front, all, or how many"));
  }
}

}  // namespace
}  // namespace gnomon::sweep
