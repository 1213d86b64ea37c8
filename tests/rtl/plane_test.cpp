// SPDX-License-Identifier: Apache-2.0
// The plane memory against a plain array: updates in order with forwarding, reads by tag, clears over more
// than one round of generations.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include "Vplane_fast.h"
#include "Vplane_slow.h"

namespace gnomon::rtl_test {
namespace {

constexpr std::uint32_t kEntries = 256;    // INDEX_BITS = 8, as in CMakeLists.txt
constexpr std::uint32_t kNone = 1u << 24;  // an empty entry: farther than any depth

template <class Model>
class Plane : public testing::Test {
 protected:
  Plane() {
    plane_.rst_ni = 0;
    clock();
    plane_.rst_ni = 1;
    wait_idle();
  }

  void settle() {
    plane_.clk_i = 0;
    plane_.eval();
  }
  void clock() {
    settle();
    plane_.clk_i = 1;
    plane_.eval();
    ++cycles_;
  }
  std::uint32_t pick(std::uint32_t below) { return static_cast<std::uint32_t>(random_()) % below; }
  void wait_idle() {
    for (settle(); !plane_.idle_o; settle()) clock();
  }

  /// Takes the update in one cycle: the port has no reason to wait.
  void update(std::uint32_t index, std::uint32_t depth) {
    plane_.update_valid_i = 1;
    plane_.update_index_i = static_cast<CData>(index);
    plane_.update_depth_i = depth;
    settle();
    ASSERT_TRUE(plane_.update_ready_o);
    clock();
    plane_.update_valid_i = 0;
    expected_[index] = std::min(expected_[index], depth);
  }

  void clear() {
    plane_.clear_valid_i = 1;
    for (settle(); !plane_.clear_ready_o; settle()) clock();
    clock();
    plane_.clear_valid_i = 0;
    wait_idle();
    expected_.assign(kEntries, kNone);
  }

  std::uint32_t entry_word(std::uint32_t index) const {
    return expected_[index] == kNone ? 0 : (1u << 24) | expected_[index];
  }
  /// The depth of an entry that is not present means nothing.
  static std::uint32_t seen(std::uint32_t entry) { return (entry >> 24) ? entry : 0; }

  /// Reads all entries through both ports, the two running in opposite directions, with random waiting.
  void expect_all() {
    std::uint32_t asked0 = 0, asked1 = 0, given0 = 0, given1 = 0;
    while (given0 < kEntries || given1 < kEntries) {
      plane_.read0_valid_i = asked0 < kEntries;
      plane_.read0_index_i = static_cast<CData>(asked0);
      plane_.read0_tag_i = asked0 + 1000;
      plane_.read1_valid_i = asked1 < kEntries;
      plane_.read1_index_i = static_cast<CData>(kEntries - 1 - asked1);
      plane_.read1_tag_i = asked1 + 2000;
      plane_.entry0_ready_i = random_() & 1;
      plane_.entry1_ready_i = (random_() & 3) != 0;
      settle();
      if (plane_.read0_valid_i && plane_.read0_ready_o) ++asked0;
      if (plane_.read1_valid_i && plane_.read1_ready_o) ++asked1;
      if (plane_.entry0_valid_o && plane_.entry0_ready_i) {
        EXPECT_EQ(plane_.entry0_tag_o, given0 + 1000);
        EXPECT_EQ(seen(plane_.entry0_o), entry_word(given0)) << "entry " << given0;
        ++given0;
      }
      if (plane_.entry1_valid_o && plane_.entry1_ready_i) {
        EXPECT_EQ(plane_.entry1_tag_o, given1 + 2000);
        EXPECT_EQ(seen(plane_.entry1_o), entry_word(kEntries - 1 - given1))
            << "entry " << kEntries - 1 - given1;
        ++given1;
      }
      clock();
    }
    plane_.read0_valid_i = plane_.read1_valid_i = 0;
  }

  Model plane_;
  std::mt19937 random_{77};
  std::vector<std::uint32_t> expected_ = std::vector<std::uint32_t>(kEntries, kNone);
  std::uint64_t cycles_ = 0;
};
using Planes = testing::Types<Vplane_fast, Vplane_slow>;
TYPED_TEST_SUITE(Plane, Planes);

TYPED_TEST(Plane, IsEmptyAfterReset) {
  this->expect_all();
}

TYPED_TEST(Plane, UpdatesOfFewEntriesSeeEachOther) {
  for (int round = 0; round < 20; ++round) {
    for (int i = 0; i < 200; ++i) {
      this->update(this->pick(3), this->pick(50));  // hits in consecutive and nearby cycles
      if (this->pick(4) == 0) this->clock();
    }
    this->update(this->pick(kEntries), 0);
    this->wait_idle();
    this->expect_all();
    if (round % 5 == 4) this->clear();
  }
}

TYPED_TEST(Plane, TakesAnUpdateACycle) {
  const std::uint64_t before = this->cycles_;
  for (std::uint32_t i = 0; i < 1000; ++i) this->update(7, 1000 - i);
  EXPECT_EQ(this->cycles_ - before, 1000u);
  this->wait_idle();
  EXPECT_LE(this->cycles_ - before, 1010u);
  this->expect_all();
}

TYPED_TEST(Plane, StaysClearedWhenGenerationsComeRound) {
  // An entry written now must not come back in 255 clears; the round does not fit a multiple of the
  // scrubbing.
  for (int round = 0; round < 3; ++round) {
    for (std::uint32_t i = 0; i < kEntries; ++i) this->update(i, i + 1);
    this->wait_idle();
    for (int clears = 0; clears < 255; ++clears) {
      this->clear();
      if (clears % 50 == 0 || clears >= 253) this->expect_all();
    }
  }
}

TYPED_TEST(Plane, ResetEmptiesIt) {
  for (std::uint32_t i = 0; i < kEntries; ++i) this->update(i, i);
  this->plane_.rst_ni = 0;
  this->clock();
  this->plane_.rst_ni = 1;
  this->expected_.assign(kEntries, kNone);
  this->wait_idle();
  this->expect_all();
}

}  // namespace
}  // namespace gnomon::rtl_test
