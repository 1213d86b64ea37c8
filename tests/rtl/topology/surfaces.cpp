// SPDX-License-Identifier: Apache-2.0
#include "tests/rtl/topology/surfaces.hpp"

#include <cmath>
#include <functional>
#include <numbers>

namespace gnomon::rtl_test::topology {

namespace {

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Item voxel_at(const TopologyConfig& config, const Vector& place, const Vector& normal) {
  Item item;
  const double length = std::sqrt(dot(normal, normal));
  for (std::size_t i = 0; i < 3; ++i) {
    item.position[i] = static_cast<std::uint32_t>(std::floor(place[i] * (1 << config.voxel_frac_bits)));
    item.normal[i] =
        static_cast<std::int32_t>(std::lround(normal[i] / length * ((1 << (config.normal_bits - 1)) - 1)));
  }
  return item;
}

/// Grid of (columns + 1) x (rows + 1) points.
void add_sheet(Surface& surface, int columns, int rows, const std::function<Item(int, int)>& point) {
  std::vector<Item> before, row;
  for (int j = 0; j <= rows; ++j) {
    row.clear();
    for (int i = 0; i <= columns; ++i) row.push_back(point(i, j));
    surface.voxels.insert(surface.voxels.end(), row.begin(), row.end());
    for (std::size_t i = 1; j > 0 && i < row.size(); ++i)
      surface.quads.push_back({before[i - 1], before[i], row[i], row[i - 1]});
    before = row;
  }
}

}  // namespace

Surface sphere_over_ground(const TopologyConfig& config) {
  Surface surface;
  add_sheet(surface, 60, 60, [&](int i, int j) {
    const double x = 1 + i, y = 1 + j;
    const Vector normal = {-0.5 * std::cos(0.2 * x), 0.4 * std::sin(0.2 * y), 1};
    return voxel_at(config, {x, y, 6 + 2.5 * std::sin(0.2 * x) + 2 * std::cos(0.2 * y)}, normal);
  });
  constexpr int kAround = 104, kDown = 52;
  constexpr double kRadius = 16.3;
  add_sheet(surface, kAround, kDown, [&](int i, int j) {
    const double a = 2 * std::numbers::pi * i / kAround, b = std::numbers::pi * j / kDown;
    const Vector n = {std::sin(b) * std::cos(a), std::sin(b) * std::sin(a), std::cos(b)};
    return voxel_at(config, {32 + kRadius * n[0], 32 + kRadius * n[1], 36 + kRadius * n[2]}, n);
  });
  return surface;
}

void sort_far_first(std::vector<Quad>& quads, const Vector& direction) {
  const auto far = [&](const Quad& quad) {
    double most = -1e9;
    for (const Item& corner : quad) {
      const auto& p = corner.position;
      most = std::max(most, dot({double(p[0]), double(p[1]), double(p[2])}, direction));
    }
    return most;
  };
  std::stable_sort(quads.begin(), quads.end(), [&](const Quad& a, const Quad& b) { return far(a) > far(b); });
}

}  // namespace gnomon::rtl_test::topology
