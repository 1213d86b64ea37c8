// SPDX-License-Identifier: Apache-2.0
// Seeded faults in the front end: the comparison with golden notices each.
#include <gtest/gtest.h>

#include <array>

#include "Voutline_faulty.h"
#include "tests/rtl/slb/outline/bench.hpp"
#include "tests/rtl/slb/outline/loops.hpp"

namespace gnomon::rtl_test::slb {
namespace {

constexpr std::array kFaults{
    "SLB_NO_ADJUST",    "SLB_DRIFT",         "SLB_DEPTH_DRIFT", "SLB_FORGET_KEPT",     "SLB_FORGET_ASIDE",
    "SLB_EXACT_ALWAYS", "SLB_LAST_OF_EQUAL", "SLB_NO_SPIKES",   "SLB_CORNER_BY_SIDES", "SLB_COUNT_CLOSE"};

bool agrees(const std::string& fault) {
  const SlbConfig config;
  std::vector<Loop> loops = directed_loops(config);
  for (Loop& loop : random_loops(9, 200, config)) loops.push_back(std::move(loop));
  OutlineBench<Voutline_faulty> bench(config, 1, fault);
  return same(bench.run(loops), expected(loops, config));
}

TEST(SlbOutlineMutation, EachIsNoticed) {
  EXPECT_TRUE(agrees(""));
  for (const char* fault : kFaults) EXPECT_FALSE(agrees(fault)) << fault << " is not noticed";
}

}  // namespace
}  // namespace gnomon::rtl_test::slb
