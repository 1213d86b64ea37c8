// SPDX-License-Identifier: Apache-2.0
// Memory and cycles as the page counts them.
#include "host/slb/costs.hpp"

#include <gtest/gtest.h>

#include "tests/host/slb/shapes.hpp"

namespace gnomon::slb {
namespace {

golden::Counters some_events() {
  golden::Counters counters;
  counters.events = {{"SLB_CROSSINGS", 1000},
                     {"SLB_FILL_PIXELS", 1600},
                     {"SLB_FILL_GROUPS", 300},
                     {"SLB_FILL_COVERED", 850},
                     {"SLB_QUERIES", 5000}};
  return counters;
}

TEST(Costs, OfTheBuffer) {
  const golden::HardwareConfig config = test::hardware(test::small_plane(7));
  const Costs costs = buffer_costs(config, some_events());
  EXPECT_EQ(costs.memory_bits, 64U * 64U * (256U + 11U) + 64U * 8U);
  EXPECT_FALSE(costs.measured);
  EXPECT_EQ(costs.draw_cycles, 17 + 1000 + 100 + 300);  // 4096 entries, 1/255 of them scrubbed
  EXPECT_EQ(costs.query_cycles, 5000);
}

TEST(Costs, OfTheBufferOnHardware) {
  golden::Counters counters = some_events();
  counters.cycles = {{"cycles.CLEAR.BUSY", 20},       {"cycles.DRAW.BUSY", 1100},
                     {"cycles.DRAW.MEMORY_WAIT", 30}, {"cycles.FILL.BUSY", 410},
                     {"cycles.QUERY.BUSY", 5000},     {"cycles.QUERY.INPUT_STARVED", 7},
                     {"cycles.READ.BUSY", 9999},      {"cycles.IDLE.IDLE", 99}};
  const Costs costs = buffer_costs(test::hardware(test::small_plane(7)), counters);
  EXPECT_TRUE(costs.measured);
  EXPECT_EQ(costs.draw_cycles, 20 + 1100 + 30 + 410);
  EXPECT_EQ(costs.query_cycles, 5007);
}

TEST(Costs, OfShadowMaps) {
  const golden::HardwareConfig config = test::hardware(test::small_plane(7));
  const Costs plain = map_costs(config, some_events(), 1), fine = map_costs(config, some_events(), 128);
  EXPECT_EQ(plain.memory_bits, 64U * 64U * 32U);
  EXPECT_EQ(plain.draw_cycles, (4096 + 1000) / 16.0);
  EXPECT_EQ(plain.query_cycles, 5000);
  EXPECT_EQ(fine.memory_bits, 8192U * 8192U * 32U);
  EXPECT_EQ(fine.draw_cycles, plain.draw_cycles * 128 * 128);
}

}  // namespace
}  // namespace gnomon::slb
