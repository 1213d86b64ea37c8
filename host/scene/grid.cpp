// SPDX-License-Identifier: Apache-2.0
// The voxel grid that holds a scene.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/scene/scene.hpp"

namespace gnomon::scene {
namespace {

/// Voxels left free along the longest side of the surfaces: at each end a whole one, and half of one so that
/// the box begins at a voxel's centre.
constexpr double kFree = 3;

double longest_side(const Box3& box) {
  return std::max({box.size().x, box.size().y, box.size().z});
}

/// Where along one axis the grid begins: the surfaces in the middle, moved so that they begin at a voxel's
/// centre.
double axis_origin(const Box3& surface, int axis, double voxel, std::uint32_t res) {
  const double free = res - surface.size()[axis] / voxel;
  return surface.min[axis] - (std::floor(free / 2) + 0.5) * voxel;
}

}  // namespace

Result<voxel::Grid> fit_grid(const Scene& scene, std::uint32_t res, voxel::Adjacency adjacency) {
  Box3 surface;
  for (const Object& object : scene.objects) surface.extendBy(object.bounds);
  const double longest = longest_side(surface);
  if (!(longest > 0) || !std::isfinite(longest)) {
    return fail(fmt::format("{}: error: the scene's extent is {}, expected a finite size above zero",
                            scene.source.string(), longest));
  }
  voxel::Grid grid;
  grid.res = res;
  grid.adjacency = adjacency;
  grid.voxel_size = longest / (res - kFree);
  for (int axis = 0; axis < 3; ++axis) grid.origin[axis] = axis_origin(surface, axis, grid.voxel_size, res);
  return grid;
}

Mat4 to_grid(const voxel::Grid& grid) {
  Mat4 move, scale;
  move.setTranslation(-grid.origin);
  scale.setScale(Vec3(1 / grid.voxel_size));
  return move * scale;
}

Mat4 to_grid(const Object& object, const voxel::Grid& grid) {
  return object.to_world * to_grid(grid);
}

}  // namespace gnomon::scene
