// SPDX-License-Identifier: Apache-2.0
// Second derivatives bounded by the coefficients around the rectangle's centre.
#include "host/voxel/bend.hpp"

#include <cmath>

namespace gnomon::voxel {
namespace {

using Grid4 = std::array<std::array<Vec3, 4>, 4>;

// The polynomial in x, where the old variable is centre + half * x. `of(k)` is coefficient k.
template <class Coefficient>
void recentre(Coefficient of, double centre, double half) {
  for (int first = 0; first < 3; ++first) {
    for (int k = 2; k >= first; --k) of(k) += of(k + 1) * centre;
  }
  double scale = 1;
  for (int k = 1; k < 4; ++k) of(k) *= scale *= half;
}

}  // namespace

Bend Bend::of(const surface::Patch& patch, double u0, double u1, double v0, double v1) {
  Grid4 c;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j)
      c[i][j] = Vec3(patch.c[i][j].x[0], patch.c[i][j].x[1], patch.c[i][j].x[2]);
  }
  const auto at = [&](int i, int j) -> Vec3& {
    return c[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  };
  for (int k = 0; k < 4; ++k) {
    recentre([&](int i) -> Vec3& { return at(i, k); }, (u0 + u1) / 2, (u1 - u0) / 2);
    recentre([&](int j) -> Vec3& { return at(k, j); }, (v0 + v1) / 2, (v1 - v0) / 2);
  }
  // Over [-1, 1]^2 no term is larger than its coefficient. That square's side is 2, hence the factors 4.
  Bend bend{Vec3(0), Vec3(0), Vec3(0)};
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const Vec3 size(std::abs(at(i, j).x), std::abs(at(i, j).y), std::abs(at(i, j).z));
      bend.uu += size * (4.0 * i * (i - 1));
      bend.uv += size * (4.0 * i * j);
      bend.vv += size * (4.0 * j * (j - 1));
    }
  }
  return bend;
}

}  // namespace gnomon::voxel
