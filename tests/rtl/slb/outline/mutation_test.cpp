// SPDX-License-Identifier: Apache-2.0
// Seeded faults in the front end: the comparison with golden notices each.
#include <gtest/gtest.h>

#include "Voutline_default.h"
#include "Voutline_last_of_equal.h"
#include "Voutline_no_adjust.h"
#include "tests/rtl/slb/outline/bench.hpp"
#include "tests/rtl/slb/outline/loops.hpp"

namespace gnomon::rtl_test::slb {
namespace {

template <class Model>
bool agrees() {
  const SlbConfig config;
  OutlineBench<Model> bench(config, 1);
  const std::vector<Loop> loops = directed_loops(config);
  return same(bench.run(loops), expected(loops, config));
}

TEST(SlbOutlineMutation, NoneAgrees) {
  EXPECT_TRUE(agrees<Voutline_default>());
}

TEST(SlbOutlineMutation, CrossingsOfPixelCornersInTheWrongOrderAreNoticed) {
  EXPECT_FALSE(agrees<Voutline_no_adjust>());
}

TEST(SlbOutlineMutation, AWrongChoiceBetweenEquallyGoodLinesIsNoticed) {
  EXPECT_FALSE(agrees<Voutline_last_of_equal>());
}

}  // namespace
}  // namespace gnomon::rtl_test::slb
