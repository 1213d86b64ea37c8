// SPDX-License-Identifier: Apache-2.0
// Legal configurations, widths, and the bits of an entry; the page's table of sizes against the code.
#include <gtest/gtest.h>

#include <fstream>
#include <gnomon/golden/slb/formats.hpp>
#include <regex>

#include "tests/golden/slb/shapes.hpp"

namespace gnomon::golden::slb::testing {
namespace {

TEST(Formats, PresetsAreLegal) {
  EXPECT_EQ(slb4().check(), std::nullopt);
  EXPECT_EQ(slb7().check(), std::nullopt);
  EXPECT_EQ(slb4().frac_bits, 4);
  EXPECT_EQ(slb4().slope_bits, 4);
  EXPECT_EQ(slb7().frac_bits, 7);
  EXPECT_EQ(slb7().slope_bits, 7);
}

TEST(Formats, IllegalCombinationsNameTheParameter) {
  const auto error = [](auto change) {
    SlbConfig config;
    change(config);
    return config.check().value_or("");
  };
  EXPECT_NE(error([](SlbConfig& c) { c.frac_bits = 9; }).find("FRAC_BITS=9 is out of range 3..8"),
            std::string::npos);
  EXPECT_NE(error([](SlbConfig& c) { c.slope_bits = 2; }).find("SLOPE_BITS=2"), std::string::npos);
  EXPECT_NE(error([](SlbConfig& c) { c.frags = 5; }).find("FRAGS_PER_PIXEL=5"), std::string::npos);
  EXPECT_NE(error([](SlbConfig& c) { c.depth_bits = 25; }).find("DEPTH_BITS=25"), std::string::npos);
  EXPECT_NE(error([](SlbConfig& c) { c.plane_log2 = 2; }).find("PLANE_LOG2=2"), std::string::npos);
  EXPECT_NE(error([](SlbConfig& c) { c.subpixel_bits = 9; }).find("SUBPIXEL_BITS=9 is out of range 10..16"),
            std::string::npos);
  EXPECT_NE(error([](SlbConfig& c) { c.query_bits = 17; }).find("QUERY_BITS=17"), std::string::npos);
  EXPECT_NE(error([](SlbConfig& c) { c.plane_log2 = 12, c.query_bits = 15; }).find("more than 28 bits"),
            std::string::npos);
  EXPECT_NE(error([](SlbConfig& c) {
              c.frac_bits = 3;
              c.slope_bits = 9;
              c.subpixel_bits = 9;
            }).find("SLOPE_BITS - FRAC_BITS + 4"),
            std::string::npos);
}

TEST(Formats, EntriesFitTheirPowersOfTwo) {
  for (int frac = 3; frac <= 8; ++frac)
    for (int slope = 3; slope <= 8; ++slope)
      for (int depth = 8; depth <= 24; ++depth) {
        SlbConfig config;
        config.frac_bits = frac;
        config.slope_bits = slope;
        config.depth_bits = depth;
        config.frags = 1;
        EXPECT_LE(config.entry_bits(), 128);
        config.frags = 2;
        EXPECT_LE(config.entry_bits(), 256);
      }
}

Line random_line(Random& random, const SlbConfig& config) {
  return unpack_line(static_cast<std::uint32_t>(random.bits()) & ((1u << config.line_bits()) - 1), config);
}

TEST(Formats, EntriesKeepEveryBit) {
  Random random(4);
  int fragments = 0;
  for (int i = 0; i < 2000; ++i) {
    SlbConfig config;
    config.frac_bits = static_cast<int>(random.integer(3, 8));
    config.slope_bits = static_cast<int>(random.integer(3, 9));
    config.frags = static_cast<int>(random.integer(1, 4));
    config.depth_bits = static_cast<int>(random.integer(8, 24));
    Entry entry;
    entry.count = static_cast<std::uint8_t>(random.integer(0, config.frags));
    entry.overflow = random.integer(0, 1) != 0;
    entry.open = random.integer(0, 1) != 0;
    entry.corner = static_cast<std::int8_t>(random.integer(kCornerMin, kCornerMax));
    entry.full_depth = static_cast<std::uint32_t>(random.integer(0, config.no_depth()));
    for (int f = 0; f < entry.count; ++f) {
      Fragment& fragment = entry.fragments[static_cast<std::size_t>(f)];
      fragment.depth = static_cast<std::uint32_t>(random.integer(0, config.no_depth()));
      fragment.object = static_cast<std::uint8_t>(random.integer(0, 255));
      fragment.op = static_cast<FragmentOp>(random.integer(0, 3));
      fragment.a = random_line(random, config);
      if (fragment.op != FragmentOp::One) fragment.b = random_line(random, config);
      fragment.threshold_m1 = static_cast<std::uint8_t>(random.integer(0, 2 * config.frags - 1));
      fragment.cont = f > 0 && random.integer(0, 1) != 0;
      ++fragments;
    }
    std::vector<std::uint64_t> words = pack(entry, config);
    ASSERT_EQ(words.size() * 64, static_cast<std::size_t>(config.stored_entry_bits()));
    ASSERT_EQ(unpack_entry(words, config), entry);
    // A single flipped bit must be seen.
    const auto bit = static_cast<std::size_t>(
        random.integer(8 + config.count_bits(), 15 + config.count_bits() + config.depth_bits));
    words[bit / 64] ^= std::uint64_t{1} << (bit % 64);
    ASSERT_NE(unpack_entry(words, config), entry);
  }
  EXPECT_GT(fragments, 2000);
  EXPECT_THROW(unpack_entry({1}, SlbConfig{}), std::invalid_argument);
}

TEST(Formats, ThePagesTableOfSizesIsRight) {
  std::ifstream page(std::string(GNOMON_DOCS_DIR) + "/slb.md");
  ASSERT_TRUE(page.good());
  const std::regex row(
      R"(\| (\d), (\d)[^|]*\| (\d+) \| (\d+) / (\d+) \| (\d+) / (\d+) \| (\d+) / (\d+) \| (\d+) / (\d+) \|)");
  int rows = 0;
  for (std::string line; std::getline(page, line);) {
    std::smatch found;
    if (!std::regex_match(line, found, row)) continue;
    ++rows;
    SlbConfig config;
    config.frac_bits = std::stoi(found[1]);
    config.slope_bits = std::stoi(found[2]);
    EXPECT_EQ(std::stoi(found[3]), config.line_bits());
    for (int frags = 1; frags <= 4; ++frags) {
      config.frags = frags;
      EXPECT_EQ(std::stoi(found[static_cast<std::size_t>(2 + 2 * frags)]), config.entry_bits()) << line;
      EXPECT_EQ(std::stoi(found[static_cast<std::size_t>(3 + 2 * frags)]), config.stored_entry_bits())
          << line;
    }
  }
  EXPECT_EQ(rows, 12);
}

}  // namespace
}  // namespace gnomon::golden::slb::testing
