// SPDX-License-Identifier: Apache-2.0
// The voxel grid that holds a scene.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/scene/limit_bounds.hpp"
#include "host/scene/scene.hpp"

namespace gnomon::scene {
namespace {

/// Voxels left free along the longest side of the surfaces: at each end a whole one, and half of one so that
/// the box begins at a voxel's centre.
constexpr double kFreeAroundSurface = 3;
/// The voxelizer wants the control points inside as well; one voxel is what the alignment to centres may
/// need.
constexpr double kFreeAroundHull = 1;

double longest_side(const Box3& box) {
  return std::max({box.size().x, box.size().y, box.size().z});
}

/// Where along one axis the grid begins: the surfaces in the middle, moved so that they begin at a voxel's
/// centre, and the control points inside.
double axis_origin(const Box3& surface, const Box3& hull, int axis, double voxel, std::uint32_t res) {
  const double free = res - surface.size()[axis] / voxel;
  const double least = (surface.min[axis] - hull.min[axis]) / voxel;
  const double most = res - (hull.max[axis] - surface.min[axis]) / voxel;
  double before = std::floor(free / 2) + 0.5;
  if (before < least) before = std::ceil(least - 0.5) + 0.5;
  if (before > most) before = std::floor(most - 0.5) + 0.5;
  return surface.min[axis] - before * voxel;
}

}  // namespace

Result<voxel::Grid> fit_grid(const Scene& scene, std::uint32_t res, voxel::Adjacency adjacency) {
  Box3 surface, hull;
  for (const Object& object : scene.objects) {
    surface.extendBy(object.bounds);
    hull.extendBy(hull_bounds(object.mesh, object.to_world));
  }
  const double longest = longest_side(surface);
  if (!(longest > 0) || !std::isfinite(longest)) {
    return fail(fmt::format("{}: error: the scene's extent is {}, expected a finite size above zero",
                            scene.source.string(), longest));
  }
  voxel::Grid grid;
  grid.res = res;
  grid.adjacency = adjacency;
  grid.voxel_size =
      std::max(longest / (res - kFreeAroundSurface), longest_side(hull) / (res - kFreeAroundHull));
  for (int axis = 0; axis < 3; ++axis)
    grid.origin[axis] = axis_origin(surface, hull, axis, grid.voxel_size, res);
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
