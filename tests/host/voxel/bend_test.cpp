// SPDX-License-Identifier: Apache-2.0
// The bound of how far a polynomial bends, against samples.
#include "host/voxel/bend.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace gnomon::voxel {
namespace {

surface::Patch any_patch() {
  surface::Patch patch{};
  for (auto& row : patch.c) {
    for (auto& lanes : row) {
      for (double& x : lanes.x) x = *rc::gen::inRange(-40, 41) / 8.0;
    }
  }
  return patch;
}

Vec3 at(const surface::Patch& patch, double u, double v) {
  const surface::Lane4 p = cubic(patch.row(v), u);
  return {p.x[0], p.x[1], p.x[2]};
}

TEST(Bend, BoundsTheSagOfEveryPart) {
  std::size_t parts = 0;
  EXPECT_TRUE(rc::check([&] {
    const surface::Patch patch = any_patch();
    const double u0 = *rc::gen::inRange(0, 8) / 8.0;
    const double v0 = *rc::gen::inRange(0, 8) / 8.0;
    const double width = *rc::gen::inRange(1, 9) / 8.0 * (1 - u0);
    const double height = *rc::gen::inRange(1, 9) / 8.0 * (1 - v0);
    const Bend bend = Bend::of(patch, u0, u0 + width, v0, v0 + height);
    for (const int count : {1, 2, 4}) {
      const double part = 1.0 / count;
      for (int i = 0; i < count; ++i) {
        for (int j = 0; j < count; ++j, ++parts) {
          const double s = i * part, t = j * part;
          const auto point = [&](double x, double y) {
            return at(patch, u0 + width * (s + part * x), v0 + height * (t + part * y));
          };
          const Vec3 middle = point(0.5, 0.5);
          const double limit = bend.sag(part, part) + 1e-12;
          RC_ASSERT(((point(0, 0) + point(1, 1)) / 2 - middle).length() <= limit);
          RC_ASSERT(((point(1, 0) + point(0, 1)) / 2 - middle).length() <= limit);
        }
      }
    }
  }));
  EXPECT_EQ(parts, 2100U);
}

TEST(Bend, IsExactForAParaboloid) {
  surface::Patch patch{};
  patch.c[1][0].x = {10, 0, 0, 0};
  patch.c[0][1].x = {0, 10, 0, 0};
  patch.c[2][0].x = {0, 0, 3, 0};
  patch.c[0][2].x = {0, 0, 1, 0};
  // z = 3 u^2 + v^2: a diagonal's middle lies a quarter of that above the surface.
  EXPECT_DOUBLE_EQ(Bend::of(patch, 0, 1, 0, 1).sag(1, 1), 1);
  EXPECT_DOUBLE_EQ(Bend::of(patch, 0, 1, 0, 1).sag(0.5, 0), 3.0 / 16);
  EXPECT_DOUBLE_EQ(Bend::of(patch, 0.25, 0.75, 0, 0.5).sag(1, 1), 0.25);
}

TEST(Bend, OfAPlaneIsNothing) {
  surface::Patch patch{};
  patch.c[1][0].x = {10, 2, 1, 0};
  patch.c[0][1].x = {0, 10, 5, 0};
  EXPECT_EQ(Bend::of(patch, 0.25, 1, 0, 0.5).sag(1, 1), 0);
}

}  // namespace
}  // namespace gnomon::voxel
