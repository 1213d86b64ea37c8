// SPDX-License-Identifier: Apache-2.0
// Separating axes between a triangle and a cube, and the gaps along borders.
#include "host/voxel/completion.hpp"

#include <algorithm>
#include <cstdlib>
#include <tuple>

namespace gnomon::voxel {
namespace {

using Int3 = std::array<std::int64_t, 3>;

constexpr std::int64_t kVoxel = std::int64_t{1} << kFractionBits;

Int3 minus(const Int3& a, const Int3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Int3 cross(const Int3& a, const Int3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Doubled cube centre and half sizes keep everything integral: the cube is [-1,1]^3 voxels at twice the
// scale. Magnitudes: coordinates below 2^(8+17), edges 2^26, normals 2^53, products with normals via
// __int128.
__extension__ using Wide = __int128;

Wide dot(const Int3& a, const Int3& b) {
  return static_cast<Wide>(a[0]) * b[0] + static_cast<Wide>(a[1]) * b[1] + static_cast<Wide>(a[2]) * b[2];
}

bool separated_along(const Int3& axis, const std::array<Int3, 3>& t) {
  const Wide a = dot(axis, t[0]);
  const Wide b = dot(axis, t[1]);
  const Wide c = dot(axis, t[2]);
  const Wide reach = static_cast<Wide>(kVoxel) * (std::abs(axis[0]) + std::abs(axis[1]) + std::abs(axis[2]));
  return std::min({a, b, c}) > reach || std::max({a, b, c}) < -reach;
}

// `t` in doubled units, relative to the cube's centre.
bool touches(const std::array<Int3, 3>& t) {
  const std::array<Int3, 3> edges{minus(t[1], t[0]), minus(t[2], t[1]), minus(t[0], t[2])};
  constexpr std::array<Int3, 3> kAxes{Int3{1, 0, 0}, Int3{0, 1, 0}, Int3{0, 0, 1}};
  if (separated_along(cross(edges[0], edges[1]), t)) return false;
  for (const Int3& axis : kAxes) {
    if (separated_along(axis, t)) return false;
    for (const Int3& e : edges) {
      if (separated_along(cross(axis, e), t)) return false;
    }
  }
  return true;
}

}  // namespace

void for_each_touched(const Triangle& triangle, std::uint32_t res,
                      const std::function<void(VoxelKey)>& visit) {
  std::array<std::uint32_t, 3> low{};
  std::array<std::uint32_t, 3> high{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [a, b] = std::minmax({triangle[0][k], triangle[1][k], triangle[2][k]});
    // A point on a wall touches the voxels on both sides of it.
    low[k] = a == 0 ? 0 : (a - 1) >> kFractionBits;
    high[k] = std::min(b >> kFractionBits, res - 1);
  }
  if (low == high) return visit(pack(low[0], low[1], low[2]));
  for (std::uint32_t z = low[2]; z <= high[2]; ++z) {
    for (std::uint32_t y = low[1]; y <= high[1]; ++y) {
      for (std::uint32_t x = low[0]; x <= high[0]; ++x) {
        const Int3 centre{(2 * std::int64_t{x} + 1) * kVoxel, (2 * std::int64_t{y} + 1) * kVoxel,
                          (2 * std::int64_t{z} + 1) * kVoxel};
        std::array<Int3, 3> t{};
        for (std::size_t v = 0; v < 3; ++v) {
          for (std::size_t k = 0; k < 3; ++k) t[v][k] = 2 * std::int64_t{triangle[v][k]} - centre[k];
        }
        if (touches(t)) visit(pack(x, y, z));
      }
    }
  }
}

void for_each_gap(std::vector<BorderSide>& sides,
                  const std::function<void(const BorderSide&, const Triangle&)>& visit) {
  const auto order = [](const BorderSide& s) {
    const Voxel& r = s.representative;
    return std::tuple(s.line, s.t0, s.t1, r.object, r.face, r.v, r.u);
  };
  std::sort(sides.begin(), sides.end(),
            [&](const BorderSide& a, const BorderSide& b) { return order(a) < order(b); });
  for (std::size_t s = 0; s < sides.size(); ++s) {
    const BorderSide& whole = sides[s];
    // Sides are dyadic intervals: those that begin within this one also end within it, or contain it.
    GridPoint last = whole.p0;
    for (std::size_t i = s; i < sides.size() && sides[i].line == whole.line && sides[i].t0 < whole.t1; ++i) {
      if (sides[i].t0 == whole.t0 || sides[i].p0 == last) continue;
      if (last != whole.p0) visit(whole, {whole.p0, last, sides[i].p0});
      last = sides[i].p0;
    }
    if (last != whole.p0) visit(whole, {whole.p0, last, whole.p1});
  }
}

Voxel moved_into(VoxelKey key, Voxel voxel) {
  const std::array from{voxel.x, voxel.y, voxel.z};
  const std::array to{key_x(key), key_y(key), key_z(key)};
  for (std::size_t k = 0; k < 3; ++k) {
    const float moved = voxel.point[k] + static_cast<float>(int{from[k]} - static_cast<int>(to[k]));
    voxel.point[k] = std::clamp(moved, 0.0F, 1.0F - 0x1p-16F);
  }
  voxel.x = static_cast<std::uint16_t>(to[0]);
  voxel.y = static_cast<std::uint16_t>(to[1]);
  voxel.z = static_cast<std::uint16_t>(to[2]);
  return voxel;
}

}  // namespace gnomon::voxel
