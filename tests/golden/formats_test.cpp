// SPDX-License-Identifier: Apache-2.0
// The tables of docs/number-formats.md against the formats of golden.
#include <gtest/gtest.h>

#include <fstream>
#include <gnomon/golden/formats.hpp>
#include <map>
#include <stdexcept>
#include <vector>

#include "tests/golden/formula.hpp"
#include "tests/support/covering.hpp"

namespace gnomon::golden_test {
namespace {

using golden::HardwareConfig;
using golden::ValueFormat;

struct PageRow {
  std::string name, sign, width, frac;
  int default_width;
};

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> result;
  std::size_t start = line.find('|');
  while (start != std::string::npos) {
    const std::size_t end = line.find('|', start + 1);
    if (end == std::string::npos) break;
    std::string cell = line.substr(start + 1, end - start - 1);
    cell.erase(0, cell.find_first_not_of(' '));
    cell.erase(cell.find_last_not_of(' ') + 1);
    result.push_back(cell);
    start = end;
  }
  return result;
}

/// The rows whose first cell is a name in backquotes.
std::vector<PageRow> page_rows() {
  std::ifstream page(std::string(GNOMON_DOCS_DIR) + "/number-formats.md");
  std::vector<PageRow> rows;
  for (std::string line; std::getline(page, line);) {
    const auto c = cells(line);
    if (c.size() < 5 || c[0].size() < 2 || c[0].front() != '`') continue;
    rows.push_back({c[0].substr(1, c[0].size() - 2), c[1], c[2], c[3], std::stoi(c[4])});
  }
  return rows;
}

std::map<char, int> symbols(const HardwareConfig& c) {
  return {{'P', c.position_bits()},  {'B', c.voxel_frac_bits}, {'N', c.normal_bits},
          {'f', c.matrix_frac_bits}, {'D', c.depth_bits},      {'p', c.plane_log2}};
}

TEST(Formats, PageListsTheSameValuesInTheSameOrder) {
  const auto rows = page_rows();
  const auto formats = golden::value_formats({});
  ASSERT_EQ(rows.size(), formats.size());
  for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(rows[i].name, formats[i].name);
}

TEST(Formats, PageFormulasGiveGoldensWidthsInEveryCornerBuild) {
  const auto rows = page_rows();
  std::size_t compared = 0;
  for (const HardwareConfig& config : stimulus::corner_configs()) {
    const auto formats = golden::value_formats(config);
    ASSERT_EQ(rows.size(), formats.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const ValueFormat page{rows[i].name, evaluate(rows[i].width, symbols(config)), rows[i].sign == "s",
                             evaluate(rows[i].frac, symbols(config))};
      ASSERT_EQ(page, formats[i]) << rows[i].name << ": " << page.width << " on the page, "
                                  << formats[i].width;
      ++compared;
    }
  }
  EXPECT_GT(compared, 30000u);
}

TEST(Formats, PageDefaultsAreThoseOfTheDefaultBuild) {
  const auto formats = golden::value_formats({});
  const auto rows = page_rows();
  ASSERT_EQ(rows.size(), formats.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    EXPECT_EQ(rows[i].default_width, formats[i].width) << rows[i].name;
}

TEST(Formula, Sums) {
  const std::map<char, int> s{{'P', 10}, {'D', 20}};
  EXPECT_EQ(evaluate("D + 2P + 6", s), 46);
  EXPECT_EQ(evaluate("P \u2212 1", s), 9);
  EXPECT_EQ(evaluate("max(P + 11, D) + 1", s), 22);
  EXPECT_EQ(evaluate("57", s), 57);
  EXPECT_THROW(evaluate("Q + 1", s), std::invalid_argument);
  EXPECT_THROW(evaluate("P + ", s), std::invalid_argument);
  EXPECT_THROW(evaluate("P 1x", s), std::invalid_argument);
  EXPECT_THROW(evaluate("max(P", s), std::invalid_argument);
}

}  // namespace
}  // namespace gnomon::golden_test
