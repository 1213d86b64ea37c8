// SPDX-License-Identifier: Apache-2.0
// Small surfaces whose limits, and shadows, are known.
#pragma once

#include <vector>

#include "host/scene/control_mesh.hpp"
#include "host/surface/limit_surface.hpp"
#include "host/voxel/voxel_set.hpp"

namespace gnomon::fixtures {

/// One quad in the plane z, from (x0, y0) to (x1, y1), normal +z; its limit is exactly the rectangle.
scene::ControlMesh rectangle(double x0, double y0, double x1, double y1, double z);
/// The same as nx x ny quads.
scene::ControlMesh sheet(double x0, double y0, double x1, double y1, double z, int nx, int ny);
/// A box with infinitely sharp edges (its limit is exactly the box), or the rounded, convex limit of the same
/// cage.
scene::ControlMesh box(const Vec3& low, const Vec3& high, bool sharp);
/// A smooth torus around the z axis through `center`; the cage is chosen so that its limit is the torus of
/// these radii, to about the fourth power of the angle between vertices.
scene::ControlMesh torus(const Vec3& center, double major, double minor, int around, int across);
/// A closed prism over a regular n-gon: faces of n and of four corners, sharp where they meet or smooth.
scene::ControlMesh prism(int n, const Vec3& center, double radius, double height, bool sharp);

/// Limit surfaces in grid coordinates; fails the running test where a cage is refused.
std::vector<surface::LimitSurface> surfaces(const std::vector<scene::ControlMesh>& meshes);
/// Voxels with representatives and subpatches.
voxel::VoxelSet voxels(const std::vector<surface::LimitSurface>& surfaces, std::uint32_t res);

}  // namespace gnomon::fixtures
