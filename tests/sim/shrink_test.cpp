// SPDX-License-Identifier: Apache-2.0
// Shrinking: what remains still fails and is as short as it can be.
#include "sim/shrink.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <gnomon/golden/stream.hpp>

#include "tests/sim/tiny_model.hpp"
#include "tests/support/stimulus.hpp"

namespace gnomon::sim::test {
namespace {

std::vector<golden::Command> commands(std::span<const Word> stream) {
  std::vector<golden::Command> list;
  golden::CommandReader reader(stream);
  while (const auto command = reader.next()) list.push_back(*command);
  return list;
}

/// Fails if item 77 of some command and, later, a fence with tag 5 are there.
bool needs_two_commands(std::span<const Word> stream) {
  bool seen = false;
  for (const golden::Command& command : commands(stream)) {
    seen |= std::find(command.items.begin(), command.items.end(), Word{77}) != command.items.end();
    if (seen && command.header.op == static_cast<std::uint8_t>(golden::Op::Fence) && command.header.arg == 5)
      return true;
  }
  return false;
}

std::vector<Word> failing_stream() {
  std::vector<Word> stream = stimulus::random_stream({}, {.seed = 3, .commands = 60});
  const std::vector<Word> fence = fences(5, 1);
  stream.push_back(
      golden::encode(golden::Header{static_cast<std::uint8_t>(golden::Op::ProjectVoxels), 0, 40, 0}));
  for (Word item = 60; item < 100; ++item) stream.push_back(item);
  const std::vector<Word> more = stimulus::random_stream({}, {.seed = 4, .commands = 60});
  stream.insert(stream.end(), more.begin(), more.end());
  stream.insert(stream.end(), fence.begin(), fence.end());
  return stream;
}

TEST(Shrink, KeepsOnlyWhatTheFaultNeeds) {
  const std::vector<Word> stream = failing_stream();
  ASSERT_TRUE(needs_two_commands(stream));
  const Shrunk shrunk = shrink(stream, needs_two_commands);
  EXPECT_TRUE(needs_two_commands(shrunk.stream));
  const auto left = commands(shrunk.stream);
  ASSERT_EQ(left.size(), 2u);
  EXPECT_EQ(left[0].items.size(), 1u);
  EXPECT_EQ(left[1].items.size(), 0u);
  EXPECT_LT(shrunk.trials, 600);
}

TEST(Shrink, StopsWhenTheTrialsRunOut) {
  const std::vector<Word> stream = failing_stream();
  const Shrunk shrunk = shrink(stream, needs_two_commands, {.max_trials = 5});
  EXPECT_LE(shrunk.trials, 5);
  EXPECT_TRUE(needs_two_commands(shrunk.stream));
}

TEST(Shrink, RefusesAStreamThatDoesNotFail) {
  EXPECT_THROW(shrink(fences(1, 3), [](std::span<const Word>) { return false; }), std::invalid_argument);
}

}  // namespace
}  // namespace gnomon::sim::test
