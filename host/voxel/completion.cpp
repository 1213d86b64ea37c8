// SPDX-License-Identifier: Apache-2.0
// Separating axes between a triangle and a cube, and the gaps along borders.
#include "host/voxel/completion.hpp"

#include <algorithm>
#include <tuple>

namespace gnomon::voxel {
namespace {

__extension__ using Wide = __int128;

constexpr int kDoubledBits = kFractionBits + 1;
constexpr std::uint32_t kMostVoxelsInInt64 = 8;

// Which cubes of side 1 voxel a triangle touches, by separating axes. Coordinates are doubled, so that
// centres of cubes are integers, and relative to a voxel. Over 8 voxels they stay below 2^20, normals below
// 2^41, products of the two below 3 * 2^61.
template <class Int>
class TouchTest {
 public:
  using Point = std::array<Int, 3>;

  explicit TouchTest(const std::array<Point, 3>& t)
      : triangle_(t), edges_{minus(t[1], t[0]), minus(t[2], t[1]), minus(t[0], t[2])} {}

  /// Where triangle and cubes share one layer of voxels across axis k, it is enough to look along that axis.
  void look_along(std::size_t k) {
    Point axis{};
    axis[k] = 1;
    for (const Point& edge : edges_) add(cross(axis, edge));
  }
  void look_from_everywhere() {
    add(cross(edges_[0], edges_[1]));
    for (std::size_t k = 0; k < 3; ++k) look_along(k);
  }

  /// Only for cubes that touch the triangle's box.
  bool touches(const Point& cube) const {
    const auto separates = [&](const Axis& axis) {
      const Int at = dot(axis.direction, cube);
      return at < axis.low || at > axis.high;
    };
    return std::none_of(axes_.begin(), axes_.begin() + count_, separates);
  }

 private:
  struct Axis {
    Point direction;
    Int low, high;  // of cubes' centres that it does not separate
  };

  static Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
  static Point cross(const Point& a, const Point& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  static Int dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  static Int magnitude(Int a) { return a < 0 ? -a : a; }

  void add(const Point& direction) {
    const auto [low, high] = std::minmax(
        {dot(direction, triangle_[0]), dot(direction, triangle_[1]), dot(direction, triangle_[2])});
    const Int reach = (magnitude(direction[0]) + magnitude(direction[1]) + magnitude(direction[2])) *
                      (Int{1} << kFractionBits);
    axes_[static_cast<std::size_t>(count_++)] = {direction, low - reach, high + reach};
  }

  std::array<Point, 3> triangle_;
  std::array<Point, 3> edges_;
  std::array<Axis, 10> axes_{};
  std::ptrdiff_t count_ = 0;
};

// The voxels whose closed cubes meet a triangle's box.
struct VoxelBox {
  std::array<std::uint32_t, 3> low{}, high{};

  VoxelBox(const Triangle& triangle, std::uint32_t res) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax({triangle[0][k], triangle[1][k], triangle[2][k]});
      // A point on a wall touches the voxels on both sides of it.
      low[k] = a == 0 ? 0 : (a - 1) >> kFractionBits;
      high[k] = std::min(b >> kFractionBits, res - 1);
    }
  }
  bool thin(std::size_t k) const { return low[k] == high[k]; }
  std::uint32_t size() const { return std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]}) + 1; }

  template <class Visit>
  void for_each(Visit visit) const {
    for (std::uint32_t z = low[2]; z <= high[2]; ++z) {
      for (std::uint32_t y = low[1]; y <= high[1]; ++y) {
        for (std::uint32_t x = low[0]; x <= high[0]; ++x) visit(x, y, z);
      }
    }
  }
};

template <class Int>
void visit_touched(const Triangle& triangle, const VoxelBox& box,
                   const std::function<void(VoxelKey)>& visit) {
  using Point = typename TouchTest<Int>::Point;
  std::array<Point, 3> t{};
  for (std::size_t v = 0; v < 3; ++v) {
    for (std::size_t k = 0; k < 3; ++k) {
      t[v][k] = 2 * static_cast<Int>(triangle[v][k]) - (static_cast<Int>(box.low[k]) << kDoubledBits);
    }
  }
  TouchTest<Int> test(t);
  if (box.thin(0) || box.thin(1) || box.thin(2)) {
    test.look_along(box.thin(0) ? 0 : box.thin(1) ? 1 : 2);
  } else {
    test.look_from_everywhere();
  }
  box.for_each([&](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    const auto centre = [](std::uint32_t voxel) {
      return (2 * static_cast<Int>(voxel) + 1) << kFractionBits;
    };
    if (test.touches({centre(x - box.low[0]), centre(y - box.low[1]), centre(z - box.low[2])}))
      visit(pack(x, y, z));
  });
}

}  // namespace

void for_each_touched(const Triangle& triangle, std::uint32_t res,
                      const std::function<void(VoxelKey)>& visit) {
  const VoxelBox box(triangle, res);
  const int thin = int{box.thin(0)} + int{box.thin(1)} + int{box.thin(2)};
  if (thin >= 2) {  // a row of voxels, all of which it must pass
    box.for_each([&](std::uint32_t x, std::uint32_t y, std::uint32_t z) { visit(pack(x, y, z)); });
  } else if (box.size() <= kMostVoxelsInInt64) {
    visit_touched<std::int64_t>(triangle, box, visit);
  } else {
    visit_touched<Wide>(triangle, box, visit);
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
