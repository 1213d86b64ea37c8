// SPDX-License-Identifier: Apache-2.0
// Whole passes of the golden engine against the exact oracle: every plane entry and every result word.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <gnomon/golden/command.hpp>
#include <gnomon/golden/stream.hpp>

#include "tests/golden/cases.hpp"
#include "tests/golden/exact_oracle.hpp"
#include "tests/golden/run_stream.hpp"
#include "tests/support/stimulus.hpp"

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

/// What the oracle answers to the voxels of a stream; commands in error are left out, other commands have no
/// such answers.
std::vector<Word> expected_voxel_states(const HardwareConfig& config, std::span<const Word> words) {
  std::vector<Word> states;
  stimulus::RegisterValues registers{};
  exact::Plane plane;
  golden::CommandReader reader(words);
  golden::CommandSequence sequence(config);
  while (const auto command = reader.next()) {
    const golden::Header& header = command->header;
    if (sequence.next(header)) continue;
    const exact::Unit unit(config, registers);
    const auto op = static_cast<golden::Op>(header.op);
    if (op == golden::Op::ClearPlane) plane.clear();
    for (std::size_t i = 0; i < command->items.size(); ++i) {
      const Word word = command->items[i];
      const VoxelItem item = golden::decode_voxel(word, config);
      if (op == golden::Op::SetRegisters)
        registers[header.arg + i] = exact::register_value(header.arg + i, word, config);
      if (op == golden::Op::ProjectVoxels) exact::project(plane, unit, item);
      if (op == golden::Op::ResolveVoxels) {
        const bool two_sided = (header.flags & golden::kResolveTwoSided) != 0;
        states.push_back(golden::encode(exact::resolve(plane, unit, item, two_sided)));
      }
    }
  }
  return states;
}

TEST(Exact, EveryVoxelOfDirectedAndRandomStreams) {
  const HardwareConfig small{.voxel_bits = 4,
                             .voxel_frac_bits = 0,
                             .normal_bits = 4,
                             .matrix_frac_bits = 12,
                             .depth_bits = 8,
                             .plane_log2 = 4};
  for (const HardwareConfig& config : {HardwareConfig{}, small}) {
    auto streams = stimulus::directed_streams(config);
    streams.push_back({"random", stimulus::random_stream(config, {.seed = 21})});
    for (const auto& [name, words] : streams) {
      auto results = run(config, words).results;
      std::erase_if(results,
                    [](Word word) { return golden::result_code(word) != golden::ResultCode::VoxelState; });
      const Comparison comparison = compare(expected_voxel_states(config, words), results);
      EXPECT_EQ(comparison.differ, 0u) << name << ": " << comparison.first;
      EXPECT_EQ(comparison.compared > 0, name != "reads") << name;
    }
  }
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
