// SPDX-License-Identifier: Apache-2.0
// Encoding and restoring lines: bounds over all crossings, and the query's sign against the page's formula.
#include <gtest/gtest.h>

#include <algorithm>
#include <gnomon/golden/slb/line_encoder.hpp>
#include <gnomon/golden/slb/query.hpp>
#include <set>
#include <tuple>

#include "tests/golden/slb/reference.hpp"
#include "tests/golden/slb/shapes.hpp"

namespace gnomon::golden::slb::testing {
namespace {

SlbConfig encoding(int frac, int slope, Rounding rounding = Rounding::Better) {
  SlbConfig config;
  config.frac_bits = frac;
  config.slope_bits = slope;
  config.plane_log2 = 4;
  config.subpixel_bits = std::max(frac + 3, slope - frac + 4);
  config.rounding = rounding;
  return config;
}

/// Largest error of the restored line at both borders of the pixel (0, 0).
Rational error_of(const Line& line, const Rational& c0, const Rational& c1, const SlbConfig& config) {
  return std::max<Rational>(abs(restored(line, 0, config) - c0), abs(restored(line, 1, config) - c1));
}

/// Upwards from `x0` on y = 0 to `x1` on y = 1, as it crosses pixel (0, 0).
Line line_through(std::int64_t x0, std::int64_t x1, const SlbConfig& config) {
  const EdgeSetup edge = set_up_edge({x0, 0}, {x1, config.subpixels()}, config);
  const Position low = subtract(edge.ahead, edge.step, edge.den, config.unit());
  return encode_line(edge, low, edge.ahead, 0, config);
}

bool meets_pixel(std::int64_t x0, std::int64_t x1, std::int64_t one) {
  return std::abs(x1 - x0) <= one && ((x0 >= 0 && x0 <= one) || (x1 >= 0 && x1 <= one));
}

TEST(Line, AllCrossingsStayWithinTheBoundAndReachAllCodes) {
  const SlbConfig config = encoding(4, 4);
  const std::int64_t one = config.subpixels();
  const Rational bound = restored_bound(config);
  std::set<std::tuple<bool, bool, int, int>> codes;
  int compared = 0;
  for (std::int64_t x0 = -one; x0 <= 2 * one; ++x0)
    for (std::int64_t x1 = x0 - one; x1 <= x0 + one; ++x1) {
      if (!meets_pixel(x0, x1, one)) continue;
      const Line line = line_through(x0, x1, config);
      ASSERT_LE(error_of(line, Rational(x0) / one, Rational(x1) / one, config), bound) << x0 << " " << x1;
      ASSERT_LE(abs(restored(line, line.cross ? 1 : 0, config) - Rational(line.cross ? x1 : x0) / one),
                Rational(1, 2) / config.d0());
      codes.insert({line.xsign, line.cross, line.frac, line.slope});
      ++compared;
    }
  EXPECT_GT(compared, 40'000);
  // 2 signs, 2 borders, 16 x 16 codes; what is missing are second spellings of the same lines.
  EXPECT_GT(codes.size(), 950u);
}

TEST(Line, EveryPairOfWidthsStaysWithinTheBound) {
  Random random(5);
  for (int frac = 3; frac <= 8; ++frac)
    for (int slope = 3; slope <= 9; ++slope) {
      const SlbConfig config = encoding(frac, slope);
      const std::int64_t one = config.subpixels();
      const Rational bound = restored_bound(config);
      for (int i = 0; i < 300; ++i) {
        const std::int64_t x0 = random.integer(-one, 2 * one), x1 = x0 + random.integer(-one, one);
        if (!meets_pixel(x0, x1, one)) continue;
        ASSERT_LE(error_of(line_through(x0, x1, config), Rational(x0) / one, Rational(x1) / one, config),
                  bound)
            << "F=" << frac << " S=" << slope << " " << x0 << " " << x1;
      }
    }
}

TEST(Line, TheBoundIsNotLoose) {
  // The published rounding breaks it: each field on its own adds up.
  const SlbConfig config = encoding(4, 4, Rounding::Published);
  const std::int64_t one = config.subpixels();
  Rational worst = 0;
  for (std::int64_t x0 = 0; x0 <= one; ++x0)
    for (std::int64_t x1 = 0; x1 <= one; ++x1)
      worst = std::max(
          worst, error_of(line_through(x0, x1, config), Rational(x0) / one, Rational(x1) / one, config));
  EXPECT_GT(worst, restored_bound(config));
  EXPECT_LE(worst, 2 * restored_bound(config));
}

TEST(Line, PixelGridIsExact) {
  for (const Rounding rounding : {Rounding::Better, Rounding::Published})
    for (int frac = 3; frac <= 8; ++frac) {
      const SlbConfig config = encoding(frac, frac, rounding);
      const std::int64_t one = config.subpixels();
      for (const std::int64_t x0 : {std::int64_t{0}, one})
        for (const std::int64_t x1 : {std::int64_t{0}, one})
          EXPECT_EQ(error_of(line_through(x0, x1, config), Rational(x0) / one, Rational(x1) / one, config),
                    0);
    }
}

TEST(Line, WallsAreTheSameInEveryPixel) {
  for (const int slope_bits : {3, 4, 5, 9}) {
    const SlbConfig config = encoding(4, slope_bits);
    for (std::int64_t x = 0; x <= config.subpixels(); ++x) {
      const Line line = line_through(x, x, config);
      EXPECT_EQ(line.slope, 0);
      EXPECT_FALSE(line.cross);
    }
  }
}

/// The sign of the query against the rational formula, for one line at one point; false if they differ.
bool query_agrees(const Line& line, std::int64_t x, std::int64_t y, int bits, const SlbConfig& config,
                  bool flip = false) {
  const Rational one = std::int64_t{1} << bits;
  const Rational minor = (line.major ? x : y) / one, major = (line.major ? y : x) / one;
  const Rational at = restored(line, major, config);
  const bool expected = line.inner ? minor >= at : minor <= at;
  return (inside(line, {x, y, bits}, config) != flip) == expected;
}

TEST(Line, QueryAgreesWithTheFormulaForEveryCode) {
  int compared = 0;
  for (const Rounding rounding : {Rounding::Better, Rounding::Published}) {
    const SlbConfig config = encoding(4, 4, rounding);
    for (std::uint32_t bits = 0; bits < 1u << config.line_bits(); ++bits) {
      const Line line = unpack_line(bits, config);
      ASSERT_EQ(pack(line, config), bits);
      for (const auto& [x, y] : {std::pair{1, 1}, {3, 13}, {15, 7}, {0, 0}, {16, 16}, {8, 8}}) {
        ASSERT_TRUE(query_agrees(line, x, y, 4, config)) << bits << " at " << x << "," << y;
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 2 * 4096 * 6);
  const SlbConfig config = encoding(4, 4);
  EXPECT_FALSE(query_agrees(unpack_line(0x123, config), 3, 5, 4, config, true))
      << "the checker must be able to fail";
}

TEST(Line, QueryFitsItsWidth) {
  // F + S + Q + 5 bits signed at the largest operands.
  const std::int64_t d0 = 255, d1 = 511, one = std::int64_t{1} << 17;
  const std::int64_t largest = 2 * one * d0 * d1 + 2 * d1 * d0 * one;
  EXPECT_LT(largest, std::int64_t{1} << (8 + 9 + 16 + 4));
}

}  // namespace
}  // namespace gnomon::golden::slb::testing
