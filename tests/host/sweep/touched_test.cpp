// SPDX-License-Identifier: Apache-2.0
// Which pixels may hold a line: all that an edge can come to.
#include <gtest/gtest.h>

#include <cmath>

#include "host/pipeline/slb_touched.hpp"

namespace gnomon::pipeline {
namespace {

constexpr int kSide = 16;

SlbTouched touched_by(outline::Loop loop) {
  outline::ObjectOutline outline;
  outline.loops = {std::move(loop)};
  return SlbTouched(std::span(&outline, 1), kSide);
}

TEST(SlbTouched, IsEveryPixelThatAnEdgeComesNear) {
  const outline::Loop triangle{{2.3, 2.6, 0}, {13.7, 4.1, 0}, {6.2, 12.9, 0}};
  const SlbTouched touched = touched_by(triangle);
  EXPECT_FALSE(touched.crowded());
  std::size_t checked = 0;
  for (std::size_t i = 0; i < triangle.size(); ++i) {
    const outline::Vertex &a = triangle[i], &b = triangle[(i + 1) % triangle.size()];
    for (int k = 0; k <= 1000; ++k) {
      // A rounded vertex moves the edge by far less than a tenth of a pixel.
      for (const double dx : {-0.1, 0.1})
        for (const double dy : {-0.1, 0.1}) {
          const double t = k / 1000.0;
          EXPECT_TRUE(touched.at({a.x + (b.x - a.x) * t + dx, a.y + (b.y - a.y) * t + dy})) << i << " " << t;
          ++checked;
        }
    }
  }
  EXPECT_EQ(checked, 3U * 1001 * 4);
  EXPECT_FALSE(touched.at({7.5, 6.5})) << "inside, far from the edges";
  EXPECT_FALSE(touched.at({5.5, 4.5})) << "beside a pixel with an edge";
  EXPECT_FALSE(touched.at({0.5, 0.5}));
  EXPECT_FALSE(touched.at({-0.5, 2.5})) << "off the plane";
  EXPECT_FALSE(touched.at({2.5, 16.5}));
}

TEST(SlbTouched, LoopsBeyondThePlaneTouchItsRimAtMost) {
  const SlbTouched touched = touched_by({{-40, -3, 0}, {-20, 30, 0}, {-30, 8, 0}});
  for (int row = 0; row < kSide; ++row) {
    for (int column = 1; column < kSide; ++column)
      EXPECT_FALSE(touched.at({column + 0.5, row + 0.5})) << column << " " << row;
  }
}

TEST(SlbTouched, IsCrowdedWhereWindingNumbersCouldSaturate) {
  outline::Loop zigzag;
  for (int i = 0; i < 140; ++i) zigzag.push_back({5.5 + 0.001 * i, i % 2 == 0 ? 4.8 : 5.2, 0});
  EXPECT_TRUE(touched_by(zigzag).crowded());
  zigzag.resize(20);
  EXPECT_FALSE(touched_by(zigzag).crowded());
}

}  // namespace
}  // namespace gnomon::pipeline
