// SPDX-License-Identifier: Apache-2.0
// Voxel sets of shapes whose shadows are known in closed form.
#pragma once

#include "host/voxel/voxel_set.hpp"

namespace gnomon::test {

struct Ball {
  Vec3 centre;
  double radius;
};

/// Object 0: the ball. Object 1: the plane z = `ground` under it, over the whole grid. A voxel is set where
/// the point of the surface closest to its centre lies inside it; that point is its representative.
voxel::VoxelSet ball_on_ground(std::uint32_t res, const Ball& ball, double ground);

/// Is the point in the shadow of the ball? `light` is the unit direction in which the light travels.
bool in_shadow_of(const Ball& ball, const Vec3& point, const Vec3& light);

}  // namespace gnomon::test
