// SPDX-License-Identifier: Apache-2.0
// Constraints over parameters.
#include "host/sweep/constraint.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gnomon::sweep {
namespace {

using testing::HasSubstr;

config::Settings settings(const std::vector<config::Assignment>& assignments) {
  const std::vector<std::vector<config::Assignment>> sources{assignments};
  return *config::Settings::resolve(sources);
}

bool holds(const std::string& text, const config::Settings& settings) {
  auto constraint = Constraint::parse(text);
  if (!constraint) ADD_FAILURE() << constraint.error().message;
  return constraint && constraint->holds(settings);
}

TEST(Constraint, ComparesParameters) {
  const config::Settings some = settings({{"frac_bits", "4", "t"}, {"slope_bits", "6", "t"}});
  EXPECT_TRUE(holds("slope_bits > frac_bits", some));
  EXPECT_FALSE(holds("slope_bits <= frac_bits + 1", some));
  EXPECT_TRUE(holds("abs(slope_bits - frac_bits) == 2 && res == 256", some));
}

TEST(Constraint, ComparesWords) {
  const config::Settings slb = settings({{"technique", "slb", "t"}});
  EXPECT_TRUE(holds("technique == 'slb'", slb));
  EXPECT_FALSE(holds("technique == \"voxel-offset\"", slb));
  EXPECT_TRUE(holds("technique != 'slb+voxel' || frags == 1", slb));
}

TEST(Constraint, KnowsTheComponentsOfVectors) {
  const config::Settings grazing = settings({{"light", "1,-0.25,0", "t"}});
  EXPECT_TRUE(holds("light_y > -0.5 && light_x == 1 && light_z == 0", grazing));
}

TEST(Constraint, NotANumberDoesNotHold) {
  EXPECT_FALSE(holds("sqrt(0 - res)", settings({})));
}

TEST(Constraint, CanBeAskedAgainWithOtherValues) {
  auto constraint = Constraint::parse("frags > 2");
  ASSERT_TRUE(constraint);
  Constraint moved = std::move(*constraint);
  EXPECT_FALSE(moved.holds(settings({{"frags", "2", "t"}})));
  EXPECT_TRUE(moved.holds(settings({{"frags", "3", "t"}})));
}

TEST(Constraint, RefusesWhatItCannotRead) {
  const auto message = [](const std::string& text) { return Constraint::parse(text).error().message; };
  EXPECT_THAT(message("frac_bit < 3"), HasSubstr("did you mean 'frac_bits'?"));
  EXPECT_THAT(message("technique == 'slob'"), HasSubstr("did you mean 'slb'?"));
  EXPECT_THAT(message("technique == 'slb"), HasSubstr("quote"));
  EXPECT_FALSE(Constraint::parse("frac_bits <"));
  EXPECT_FALSE(Constraint::parse(""));
}

}  // namespace
}  // namespace gnomon::sweep
