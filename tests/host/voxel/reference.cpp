// SPDX-License-Identifier: Apache-2.0
// Written from docs/voxelization.md, sharing nothing with host/voxel.
#include "reference.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace gnomon::test {
namespace {

class Recursion {
 public:
  Recursion(const surface::LimitSurface& s, const voxel::Grid& grid, ReferenceVoxels& out)
      : surface_(s), grid_(grid), out_(out) {
    const int more = grid.adjacency == voxel::Adjacency::N18 ? 8 : 2;
    levels_ = std::min(24, static_cast<int>(std::ceil(std::log2(grid.res) / 0.6)) + more);
  }

  void run(std::uint32_t face) { cell(face, 0, 0, 1, 1, 0, 0); }

 private:
  Coordinates at(std::uint32_t face, double u, double v) {
    const Vec3 p = surface_.position(face, u, v);
    const auto voxel = [](double x) {
      return static_cast<int>(std::floor(std::nearbyint(x * 65536) / 65536));
    };
    const Coordinates c{voxel(p.x), voxel(p.y), voxel(p.z)};
    out_.voxels.insert(c);
    return c;
  }

  bool adjacent(const Coordinates& a, const Coordinates& b) const {
    const std::array d{std::abs(std::get<0>(a) - std::get<0>(b)), std::abs(std::get<1>(a) - std::get<1>(b)),
                       std::abs(std::get<2>(a) - std::get<2>(b))};
    const int most = std::max({d[0], d[1], d[2]});
    return most <= 1 && (grid_.adjacency != voxel::Adjacency::N18 || d[0] + d[1] + d[2] <= 2);
  }

  void cell(std::uint32_t f, double u0, double v0, double u1, double v1, int level_u, int level_v) {
    const std::array c{at(f, u0, v0), at(f, u1, v0), at(f, u1, v1), at(f, u0, v1)};
    bool split_u = !adjacent(c[0], c[1]) || !adjacent(c[3], c[2]);
    bool split_v = !adjacent(c[0], c[3]) || !adjacent(c[1], c[2]);
    if (!split_u && !split_v && !adjacent(c[0], c[2]) && !adjacent(c[1], c[3])) {
      split_u = level_u <= level_v;
      split_v = !split_u;
    }
    const bool wanted = split_u || split_v;
    split_u = split_u && level_u < levels_;
    split_v = split_v && level_v < levels_;
    if (!split_u && !split_v) {
      ++out_.leaves;
      out_.floor_hits += wanted ? 1 : 0;
      return;
    }
    const double um = (u0 + u1) / 2;
    const double vm = (v0 + v1) / 2;
    const double right = split_u ? um : u1;
    const double upper = split_v ? vm : v1;
    const int nu = level_u + (split_u ? 1 : 0);
    const int nv = level_v + (split_v ? 1 : 0);
    cell(f, u0, v0, right, upper, nu, nv);
    if (split_u) cell(f, um, v0, u1, upper, nu, nv);
    if (split_v) cell(f, u0, vm, right, v1, nu, nv);
    if (split_u && split_v) cell(f, um, vm, u1, v1, nu, nv);
  }

  const surface::LimitSurface& surface_;
  const voxel::Grid& grid_;
  ReferenceVoxels& out_;
  int levels_;
};

}  // namespace

ReferenceVoxels reference_voxels(std::span<const surface::LimitSurface> surfaces, const voxel::Grid& grid) {
  ReferenceVoxels out;
  for (const auto& s : surfaces) {
    Recursion recursion(s, grid, out);
    for (std::uint32_t f = 0; f < s.face_count(); ++f) recursion.run(f);
  }
  return out;
}

}  // namespace gnomon::test
