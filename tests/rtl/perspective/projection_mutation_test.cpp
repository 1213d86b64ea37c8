// SPDX-License-Identifier: Apache-2.0
// Seeded faults of topology mode and of the perspective projection: the comparison with golden notices each.
#include <gtest/gtest.h>

#include <stdexcept>

#include "Vprojection_faulty.h"
#include "tests/rtl/perspective/projection_streams.hpp"
#include "tests/rtl/stream_bench.hpp"
#include "tests/support/seeded_faults.hpp"

namespace gnomon::rtl_test {
namespace {

bool agrees(const ProjectionCase& one, const std::string& fault) {
  StreamBench<Vprojection_faulty> bench(1, fault);
  try {
    if (bench.run(one.words) != one.results) return false;
  } catch (const std::runtime_error&) {  // it hangs
    return false;
  }
  const auto indices = event_indices();
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (bench.counter(indices[i].first) != one.events[i]) return false;
  }
  return true;
}

TEST(ProjectionMutation, IsNoticed) {
  const std::vector<ProjectionCase> all = projection_cases(8);
  for (const ProjectionCase& one : all) EXPECT_TRUE(agrees(one, "none")) << one.name;
  for (const std::string_view fault : stimulus::kProjectionFaults) {
    std::size_t noticed = 0;
    while (noticed < all.size() && agrees(all[noticed], std::string(fault))) ++noticed;
    EXPECT_LT(noticed, all.size()) << fault << " is not noticed";
    if (noticed < all.size()) RecordProperty(std::string(fault), all[noticed].name);
  }
}

}  // namespace
}  // namespace gnomon::rtl_test
