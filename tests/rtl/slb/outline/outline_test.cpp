// SPDX-License-Identifier: Apache-2.0
// The front end against golden: the same chains, crossings and counts for every loop, whatever the ports do.
#include <gtest/gtest.h>

#include "tests/rtl/slb/outline/bench.hpp"
#include "tests/rtl/slb/outline/builds.hpp"
#include "tests/rtl/slb/outline/loops.hpp"

namespace gnomon::rtl_test::slb {
namespace {

template <class Build>
class SlbOutline : public testing::Test {
 protected:
  using Bench = OutlineBench<typename Build::Model>;
  static SlbConfig config() { return Build::config(); }

  /// Records compared.
  static std::size_t check(const std::vector<Loop>& loops, Stalls stalls, std::uint32_t seed) {
    Bench bench(config(), seed);
    return compare(bench.run(loops, stalls), expected(loops, config()));
  }
};

using Builds = testing::Types<DefaultBuild, LongBuild, NarrowBuild, PublishedBuild>;
TYPED_TEST_SUITE(SlbOutline, Builds);

TYPED_TEST(SlbOutline, DirectedLoopsGiveGoldensChains) {
  EXPECT_GT(this->check(directed_loops(this->config()), {}, 1), 9000u);
}

TYPED_TEST(SlbOutline, RandomLoopsGiveGoldensChains) {
  EXPECT_GT(this->check(random_loops(7, 2000, this->config()), {}, 2), 50'000u);
}

TYPED_TEST(SlbOutline, StallsChangeNothing) {
  for (const unsigned vertices : {20u, 256u}) {
    for (const unsigned chains : {20u, 200u}) {
      for (const unsigned winds : {20u, 256u}) {
        EXPECT_GT(this->check(random_loops(vertices + chains + winds, 60, this->config()),
                              {vertices, chains, winds}, vertices * chains * winds),
                  1000u);
      }
    }
  }
}

TYPED_TEST(SlbOutline, LongestEdgesGiveGoldensChains) {
  const std::size_t side = static_cast<std::size_t>(this->config().side());
  EXPECT_GT(this->check(longest_edges(this->config()), {}, 3), 40 * side);
}

TYPED_TEST(SlbOutline, NothingIsLeftAfterAReset) {
  typename TestFixture::Bench bench(this->config(), 4);
  std::size_t compared = 0;
  for (std::uint64_t i = 0; i < 40; ++i) {
    bench.run_then_reset(random_loops(100 + i, 40, this->config()), {200, 100, 100}, 3 * i);
    const std::vector<Loop> loops = random_loops(200 + i, 4, this->config());
    compared += compare(bench.run(loops), expected(loops, this->config()));
  }
  EXPECT_GT(compared, 1500u);
}

TYPED_TEST(SlbOutline, IsIdleInTheMiddleOfALoopAndHasSentWhatGoldenHas) {
  typename TestFixture::Bench bench(this->config(), 5);
  std::vector<Loop> loops = random_loops(11, 40, this->config());
  loops.push_back(smooth_loop(this->config(), 3.3, 0.7));
  std::size_t compared = 0;
  for (const Loop& loop : loops) {
    const std::span<const Vertex> vertices = loop;
    for (std::size_t cut = 0; cut <= loop.size(); ++cut) {
      Outcome outcome;
      bench.begin(vertices.first(cut), {}, outcome);
      compared += compare(outcome, expected_so_far(vertices.first(cut), this->config()));
      bench.finish(vertices.subspan(cut), {}, outcome);
      compared += compare(outcome, expected(std::span(&loop, 1), this->config()));
    }
  }
  EXPECT_GT(compared, 10'000u);
}

}  // namespace
}  // namespace gnomon::rtl_test::slb
