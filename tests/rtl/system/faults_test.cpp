// SPDX-License-Identifier: Apache-2.0
// A bus that misbehaves: no hang, no wrong word, recovery each time; and seeded faults of our own, each
// noticed.
#include <gtest/gtest.h>

#include "Vsystem_cached.h"
#include "Vsystem_faulty.h"
#include "Vsystem_narrow.h"
#include "Vsystem_wide.h"
#include "campaign.hpp"
#include "tests/support/seeded_faults.hpp"

namespace gnomon::rtl_test {
namespace {

template <class Model>
void expect_clean(const golden::HardwareConfig& config, std::uint32_t seed, unsigned rounds) {
  Campaign<Model> campaign(config, seed);
  const Tally& tally = campaign.run(rounds);
  SCOPED_TRACE(tally.text());
  testing::Test::RecordProperty("tally", tally.text());
  EXPECT_TRUE(tally.clean());
  EXPECT_EQ(tally.rounds, rounds);
  EXPECT_GT(tally.stopped, rounds / 4);
  EXPECT_GT(tally.late, rounds / 20);
  EXPECT_GT(tally.words, std::size_t{rounds} * 50);
}

TEST(SystemFaults, NarrowBusRecoversFromEach) {
  expect_clean<Vsystem_narrow>(kSmall, 1, 600);
}
TEST(SystemFaults, WideBusRecoversFromEach) {
  expect_clean<Vsystem_wide>(kSmall, 2, 400);
}

TEST(SystemFaults, PlanesInMemoryRecoverFromEach) {
  expect_clean<Vsystem_cached>(kCached, 4, 400);
}

class SeededFault : public testing::TestWithParam<std::string_view> {};

/// Assertions that a fault breaks, of those that must see it by themselves.
std::string_view broken_assertion(std::string_view fault) {
  if (fault == "AXI_WITHDRAW") return "a_ar_stable";
  if (fault == "AXI_CHANGE_ADDRESS") return "a_aw_stable";
  if (fault == "AXI_LAST_EARLY") return "a_w_last";
  if (fault == "AXI_CROSS_PAGES") return "a_ar_within_page";
  if (fault == "AXI_FIXED_BURST") return "a_ar_incr";
  return "";
}

TEST_P(SeededFault, IsNoticed) {
  testing::internal::CaptureStdout();
  Campaign<Vsystem_faulty> campaign(kSmall, 3, std::string(GetParam()));
  const Tally tally = campaign.run(60, true);
  const std::string output = testing::internal::GetCapturedStdout();
  EXPECT_FALSE(tally.clean()) << tally.text();
  EXPECT_NE(output.find(broken_assertion(GetParam())), std::string::npos) << output;
}
INSTANTIATE_TEST_SUITE_P(System, SeededFault, testing::ValuesIn(stimulus::kSystemFaults),
                         [](const auto& test) { return std::string(test.param); });

TEST(SystemFaults, BuildWithSeededFaultsIsSoundWithoutOne) {
  Campaign<Vsystem_faulty> campaign(kSmall, 3);
  const Tally& tally = campaign.run(60);
  EXPECT_TRUE(tally.clean()) << tally.text();
}

}  // namespace
}  // namespace gnomon::rtl_test
