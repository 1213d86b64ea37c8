// SPDX-License-Identifier: Apache-2.0
// Whole passes of the golden engine against the exact oracle: every plane entry and every result word.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <gnomon/golden/stream.hpp>

#include "tests/golden/cases.hpp"
#include "tests/golden/exact_oracle.hpp"
#include "tests/golden/run_stream.hpp"

namespace gnomon::golden_test {
namespace {

using golden::HardwareConfig;
using golden::Register;
using golden::VoxelItem;
using golden::Word;

struct Passes {
  std::vector<Word> expected;
  Outcome golden;
  exact::Plane plane;
};

/// Projects the first two thirds of the items and resolves all, both ways.
Passes run_passes(const Case& c) {
  const exact::Unit unit(c.config, c.registers);
  const auto casters = std::span(c.items).first(c.items.size() * 2 / 3);
  golden::StreamWriter writer(c.config);
  writer.set_registers(Register::MatrixUx, c.registers);
  writer.project(casters);
  Passes passes;
  for (const VoxelItem& item : casters) exact::project(passes.plane, unit, item);
  for (const bool two_sided : {false, true}) {
    writer.resolve(c.items, two_sided);
    for (const VoxelItem& item : c.items) {
      passes.expected.push_back(golden::encode(exact::resolve(passes.plane, unit, item, two_sided)));
    }
  }
  passes.golden = run(c.config, writer.words());
  return passes;
}

void check_passes(const Case& c) {
  const Passes passes = run_passes(c);
  const Comparison comparison = compare(passes.expected, passes.golden.results);
  RC_LOG() << comparison.first;
  RC_ASSERT(comparison.compared == 2 * c.items.size());
  RC_ASSERT(comparison.differ == 0u);
  std::vector<std::uint32_t> plane(passes.golden.plane.size(), golden::kEmpty);
  for (const auto& [entry, depth] : passes.plane) {
    plane[static_cast<std::size_t>(entry.second * c.config.plane_side() + entry.first)] = depth;
  }
  RC_ASSERT(plane == passes.golden.plane);
}

RC_GTEST_PROP(Exact, ScenePassesMatch, (std::uint64_t seed)) {
  check_passes(any_case(seed, Content::Scene, 60));
}
RC_GTEST_PROP(Exact, MixedPassesMatch, (std::uint64_t seed)) {
  check_passes(any_case(seed, Content::Mixed, 40));
}
RC_GTEST_PROP(Exact, ExtremePassesMatch, (std::uint64_t seed)) {
  check_passes(any_case(seed, Content::Extreme, 30));
}

/// The comparison above can fail: any flipped bit of any result word is seen, and named.
TEST(Exact, ACorruptedResultWordIsSeen) {
  Passes passes = run_passes(any_case(3, Content::Scene, 30));
  ASSERT_EQ(compare(passes.expected, passes.golden.results).differ, 0u);
  const std::size_t at = passes.expected.size() / 2;
  for (int bit = 0; bit < 64; ++bit) {
    passes.golden.results[at] ^= Word{1} << bit;
    const Comparison comparison = compare(passes.expected, passes.golden.results);
    EXPECT_EQ(comparison.differ, 1u);
    EXPECT_EQ(comparison.first.rfind("word " + std::to_string(at) + ": expected VOXEL_STATE", 0), 0u)
        << comparison.first;
    passes.golden.results[at] ^= Word{1} << bit;
  }
  passes.golden.results.pop_back();
  EXPECT_EQ(compare(passes.expected, passes.golden.results).differ, 1u) << "a missing word";
  EXPECT_EQ(compare({}, passes.golden.results).differ, passes.golden.results.size()) << "surplus words";
}

TEST(ExactOracle, FloorOfNegativesAndIntegers) {
  using exact::Rational;
  EXPECT_EQ(exact::floor(Rational(-1, 2)), -1);
  EXPECT_EQ(exact::floor(Rational(-4, 2)), -2);
  EXPECT_EQ(exact::floor(Rational(7, 2)), 3);
  EXPECT_EQ(exact::floor_to(Rational(-1, 3), 2), Rational(-1, 2));
  EXPECT_EQ(exact::power_of_two(-3), Rational(1, 8));
}

}  // namespace
}  // namespace gnomon::golden_test
