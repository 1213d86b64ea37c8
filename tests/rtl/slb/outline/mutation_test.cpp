// SPDX-License-Identifier: Apache-2.0
// Seeded faults in the front end: the comparison with golden notices each.
#include <gtest/gtest.h>

#include <string>

#include "Voutline_faulty.h"
#include "tests/rtl/slb/outline/bench.hpp"
#include "tests/rtl/slb/outline/loops.hpp"
#include "tests/support/seeded_faults.hpp"

namespace gnomon::rtl_test::slb {
namespace {

bool agrees(const std::string& fault) {
  const SlbConfig config;
  std::vector<Loop> loops = directed_loops(config);
  for (Loop& loop : random_loops(9, 200, config)) loops.push_back(std::move(loop));
  OutlineBench<Voutline_faulty> bench(config, 1, fault);
  return same(bench.run(loops), expected(loops, config));
}

TEST(SlbOutlineMutation, EachIsNoticed) {
  EXPECT_TRUE(agrees(""));
  for (const std::string_view fault : stimulus::kSlbOutlineFaults) {
    EXPECT_FALSE(agrees(std::string(fault))) << fault << " is not noticed";
  }
}

}  // namespace
}  // namespace gnomon::rtl_test::slb
