// SPDX-License-Identifier: Apache-2.0
// Loops that cast nothing are told, holes are not among them.
#include "host/slb/loop_check.hpp"

#include <gmock/gmock.h>

#include <algorithm>

namespace gnomon::slb {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

Loop square(double low, double high) {
  return {{low, low}, {high, low}, {high, high}, {low, high}};
}
Loop reversed(Loop loop) {
  std::reverse(loop.begin(), loop.end());
  return loop;
}

TEST(LoopCheck, TellsClockwiseOuterLoops) {
  const auto lines = loops_that_cast_nothing({{0, {square(1, 3), reversed(square(5, 7))}}}, 16);
  ASSERT_THAT(lines, SizeIs(1));
  EXPECT_THAT(lines[0],
              HasSubstr("object 0, loop 1 (objects[0].loops[1]): signed area -4 square pixels, clockwise"));
}

TEST(LoopCheck, KnowsHoles) {
  EXPECT_THAT(loops_that_cast_nothing({{0, {square(1, 9), reversed(square(3, 7))}}}, 16), IsEmpty());
  // Inside another object is not inside.
  EXPECT_THAT(loops_that_cast_nothing({{0, {square(1, 9)}}, {0, {reversed(square(3, 7))}}}, 16), SizeIs(1));
  // A hole where two loops overlap, and an island in a hole.
  EXPECT_THAT(
      loops_that_cast_nothing({{0, {square(1, 9), square(2, 12), reversed(square(3, 7)), square(4, 5)}}}, 16),
      IsEmpty());
}

TEST(LoopCheck, TellsLoopsWithoutAreaAndEmptyObjects) {
  const auto lines = loops_that_cast_nothing({{0, {}}, {0, {{{1, 1}, {2, 2}, {3, 3}}}}}, 16);
  ASSERT_THAT(lines, SizeIs(2));
  EXPECT_THAT(lines[0], HasSubstr("object 1, loop 0 (objects[1].loops[0]): without area"));
  EXPECT_THAT(lines[1], HasSubstr("object 0 (objects[0]): no loops"));
  EXPECT_THAT(loops_that_cast_nothing({}, 16), SizeIs(1));
}

TEST(LoopCheck, StopsAfterThreeOfAKind) {
  LoopScene scene(7, {0, {reversed(square(1, 2))}});
  const auto lines = loops_that_cast_nothing(scene, 16);
  ASSERT_THAT(lines, SizeIs(4));
  EXPECT_THAT(lines[3], HasSubstr("4 more: clockwise"));
}

TEST(SignedArea, IsPositiveCounterClockwise) {
  EXPECT_EQ(signed_area(square(2, 5)), 9);
  EXPECT_EQ(signed_area(reversed(square(2, 5))), -9);
}

}  // namespace
}  // namespace gnomon::slb
