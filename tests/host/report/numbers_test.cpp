// SPDX-License-Identifier: Apache-2.0
// Numbers as people read them.
#include "host/report/numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace gnomon::report {
namespace {

TEST(Numbers, ThousandsAreSeparated) {
  EXPECT_EQ(with_commas(0), "0");
  EXPECT_EQ(with_commas(999), "999");
  EXPECT_EQ(with_commas(1000), "1,000");
  EXPECT_EQ(with_commas(1234567), "1,234,567");
  EXPECT_EQ(with_commas(18446744073709551615u), "18,446,744,073,709,551,615");
}

TEST(Numbers, UnitsFollowTheSize) {
  EXPECT_EQ(duration(0), "0 ns");
  EXPECT_EQ(duration(1.234e-6), "1.23 µs");
  EXPECT_EQ(duration(0.0456), "45.6 ms");
  EXPECT_EQ(duration(9.999e-4), "1.00 ms");
  EXPECT_EQ(duration(12.34), "12.3 s");
  EXPECT_EQ(duration(4321), "4321 s");
  EXPECT_EQ(bits(999), "999 bit");
  EXPECT_EQ(bits(8388608), "8.39 Mbit");
  EXPECT_EQ(percent(0.00123), "0.123 %");
  EXPECT_EQ(percent(std::nan("")), "–");
}

TEST(Numbers, ShellLinesQuoteWhatAShellWouldTouch) {
  const std::vector<std::string> words{"gnomon", "run", "a b.obj", "--set", "res=64", "it's", "", "$HOME"};
  EXPECT_EQ(shell_line(words), R"(gnomon run 'a b.obj' --set res=64 'it'\''s' '' '$HOME')");
}

}  // namespace
}  // namespace gnomon::report
