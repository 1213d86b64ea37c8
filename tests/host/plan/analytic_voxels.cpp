// SPDX-License-Identifier: Apache-2.0
#include "tests/host/plan/analytic_voxels.hpp"

#include <cmath>

namespace gnomon::test {
namespace {

bool inside_cell(const Vec3& p, const Vec3& low) {
  for (int axis = 0; axis < 3; ++axis)
    if (!(p[axis] >= low[axis] && p[axis] < low[axis] + 1)) return false;
  return true;
}

voxel::Voxel make_voxel(const Vec3& low, const Vec3& point, const Vec3& normal, std::uint16_t object) {
  voxel::Voxel voxel{};
  voxel.x = static_cast<std::uint16_t>(low.x);
  voxel.y = static_cast<std::uint16_t>(low.y);
  voxel.z = static_cast<std::uint16_t>(low.z);
  voxel.object = object;
  for (int axis = 0; axis < 3; ++axis) {
    voxel.point[axis] = static_cast<float>(point[axis] - low[axis]);
    voxel.normal[axis] = static_cast<float>(normal[axis]);
  }
  return voxel;
}

}  // namespace

voxel::VoxelSet ball_on_ground(std::uint32_t res, const Ball& ball, double ground) {
  voxel::VoxelSet set;
  set.grid.res = res;
  const auto each_cell = [&](auto&& visit) {
    for (std::uint32_t z = 0; z < res; ++z)
      for (std::uint32_t y = 0; y < res; ++y)
        for (std::uint32_t x = 0; x < res; ++x) visit(Vec3(x, y, z));
  };
  each_cell([&](const Vec3& low) {
    const Vec3 out = (low + Vec3(0.5) - ball.centre).normalized();
    const Vec3 point = ball.centre + out * ball.radius;
    if (inside_cell(point, low)) set.voxels.push_back(make_voxel(low, point, out, 0));
  });
  each_cell([&](const Vec3& low) {
    const Vec3 point(low.x + 0.5, low.y + 0.5, ground);
    if (inside_cell(point, low)) set.voxels.push_back(make_voxel(low, point, Vec3(0, 0, 1), 1));
  });
  return set;
}

bool in_shadow_of(const Ball& ball, const Vec3& point, const Vec3& light) {
  const Vec3 to_centre = ball.centre - point;
  const double along = -to_centre.dot(light);
  return along > 0 && (to_centre + light * along).length() < ball.radius;
}

}  // namespace gnomon::test
