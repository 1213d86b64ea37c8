// SPDX-License-Identifier: Apache-2.0
// Who goes on the bus: by priority, and after more than 64 grants of others whoever waits.
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "Vfair_grant.h"
#include "tests/rtl/clocked_model.hpp"

namespace gnomon::rtl_test {
namespace {

class Grants {
 public:
  Grants() { model_.reset(); }
  /// Who is granted, a bit each.
  unsigned cycle(unsigned wanted, bool take) {
    model_->valid_i = static_cast<CData>(wanted);
    model_->take_i = take;
    model_.settle();
    const unsigned granted = model_->grant_o;
    model_.rise();
    return granted;
  }

 private:
  ClockedModel<Vfair_grant> model_{1};
};

TEST(FairGrant, TheFirstOfThoseWhoWant) {
  Grants grants;
  for (unsigned wanted = 0; wanted < 8; ++wanted)
    EXPECT_EQ(grants.cycle(wanted, false), wanted & (~wanted + 1u));
}

TEST(FairGrant, NobodyWaitsForEver) {
  Grants grants;
  std::array<unsigned, 3> granted{};
  unsigned since_last = 0, longest = 0;
  for (int i = 0; i < 10'000; ++i) {
    const unsigned who = grants.cycle(7, true);
    for (unsigned user = 0; user < 3; ++user) granted.at(user) += who >> user & 1u;
    since_last = who == 4 ? 0 : since_last + 1;
    longest = std::max(longest, since_last);
  }
  EXPECT_EQ(granted[0] + granted[1] + granted[2], 10'000u);
  EXPECT_EQ(longest, 66u);  // 65 grants of others, and that of the other who waits as long
  EXPECT_NEAR(granted[1], 10'000. / 67, 2);
  EXPECT_NEAR(granted[2], 10'000. / 67, 2);
}

TEST(FairGrant, WaitingCountsGrantsNotCycles) {
  Grants grants;
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(grants.cycle(3, i % 20 == 0), 1u) << "50 grants in 1,000 cycles";
}

}  // namespace
}  // namespace gnomon::rtl_test
