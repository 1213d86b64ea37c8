// SPDX-License-Identifier: Apache-2.0
// Seeded faults of the silhouette-line buffer's back end and of what it shares: the comparison with golden
// notices each.
#include <gtest/gtest.h>

#include <gnomon/golden/golden_engine.hpp>
#include <string>
#include <vector>

#include "sim/counter_names.hpp"
#include "slb_builds.hpp"
#include "slb_streams.hpp"
#include "tests/rtl/stream_bench.hpp"
#include "tests/support/seeded_faults.hpp"

namespace gnomon::rtl_test {
namespace {

struct Case {
  std::vector<Word> words, results;
  std::vector<std::uint64_t> events;
};

/// What golden makes of some streams of each kind.
std::vector<Case> cases() {
  const golden::HardwareConfig config = SlbBuild<Vslb_faulty>::config();
  std::vector<Case> cases{{diagonal_slb_stream(config), {}, {}}};
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    cases.push_back({random_slb_stream(seed, config), {}, {}});
    if (seed <= 6) cases.push_back({crowded_slb_stream(seed, config), {}, {}});
    if (seed <= 2) cases.push_back({piled_slb_stream(seed, config), {}, {}});
    if (seed <= 4) cases.push_back({wide_slb_stream(seed, config), {}, {}});
  }
  const auto golden = golden::make_golden_engine(config);
  for (Case& one : cases) {
    golden->reset();
    golden->submit(one.words);
    golden->drain(
        [&](std::span<const Word> some) { one.results.insert(one.results.end(), some.begin(), some.end()); });
    const auto counters = golden->counters();
    for (const auto event : sim::kSlbEventNames) {
      one.events.push_back(counters.events.at(std::string(event)));
    }
  }
  return cases;
}

bool agrees(const Case& one, const std::string& fault) {
  StreamBench<Vslb_faulty> bench(1, fault);
  try {
    if (bench.run(one.words) != one.results) return false;
  } catch (const std::runtime_error&) {  // it hangs
    return false;
  }
  for (unsigned i = 0; i < one.events.size(); ++i) {
    if (bench.counter(sim::kFirstSlbCounter + i) != one.events[i]) return false;
  }
  return true;
}

TEST(SlbMutation, IsNoticed) {
  const std::vector<Case> all = cases();
  for (const Case& one : all) EXPECT_TRUE(agrees(one, "none"));
  for (const std::string_view fault : stimulus::kSlbFaults) {
    std::size_t noticed = 0;
    while (noticed < all.size() && agrees(all[noticed], std::string(fault))) ++noticed;
    EXPECT_LT(noticed, all.size()) << fault << " is not noticed";
  }
}

}  // namespace
}  // namespace gnomon::rtl_test
