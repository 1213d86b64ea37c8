// SPDX-License-Identifier: Apache-2.0
// Cycles a crossing: one, as long as the vertex stream brings an edge a cycle and the dividers keep up.
#include <gtest/gtest.h>

#include <iostream>

#include "tests/rtl/slb/outline/bench.hpp"
#include "tests/rtl/slb/outline/builds.hpp"
#include "tests/rtl/slb/outline/loops.hpp"

namespace gnomon::rtl_test::slb {
namespace {

/// Of a loop sent a few times, one behind the other, from the first beat to the end.
template <class Build>
double cycles_per_crossing(const Loop& loop) {
  OutlineBench<typename Build::Model> bench(Build::config(), 1);
  const Outcome outcome = bench.run(std::vector<Loop>(4, loop));
  EXPECT_GT(outcome.counts.crossings, 1000u);
  return static_cast<double>(bench.cycles()) / static_cast<double>(outcome.counts.crossings);
}

TEST(SlbOutlineThroughput, OneCrossingACycleOnSmoothOutlines) {
  for (const double edge : {0.9, 1.0, 1.1, 1.2, 1.3, 1.4, 2.0, 5.0, 20.0}) {
    const double cycles = cycles_per_crossing<DefaultBuild>(smooth_loop(DefaultBuild::config(), 120, edge));
    std::cout << "edges of " << edge << " px: " << cycles << " cycles a crossing\n";
    EXPECT_LE(cycles, 1.10) << "edges of " << edge << " px";
    EXPECT_GE(cycles, 1.0);
  }
}

TEST(SlbOutlineThroughput, OneVertexACycleWhereEdgesAreShort) {
  const Loop loop = smooth_loop(DefaultBuild::config(), 120, 0.3);
  OutlineBench<Voutline_default> bench(DefaultBuild::config(), 1);
  bench.run(std::vector<Loop>{loop});
  EXPECT_LE(static_cast<double>(bench.cycles()), 1.05 * static_cast<double>(loop.size()));
}

TEST(SlbOutlineThroughput, OneDividerHasTwoCyclesForAnEdge) {
  const Loop loop = smooth_loop(NarrowBuild::config(), 3.5, 0.95);
  OutlineBench<Voutline_narrow> bench(NarrowBuild::config(), 1);
  const Outcome outcome = bench.run(std::vector<Loop>(60, loop));
  const double cycles = static_cast<double>(bench.cycles()) / static_cast<double>(outcome.counts.crossings);
  EXPECT_GT(cycles, 1.4);
  EXPECT_LT(cycles, 1.7);
}

}  // namespace
}  // namespace gnomon::rtl_test::slb
