// SPDX-License-Identifier: Apache-2.0
// The subpatches of a voxelized scene as one indexed mesh without cracks. Theory: docs/rendering.md,
// "Meshes".
#pragma once

#include <array>
#include <cstdint>
#include <gnomon/golden/codec.hpp>
#include <span>
#include <string>
#include <vector>

#include "host/base/vec.hpp"
#include "host/surface/limit_surface.hpp"
#include "host/voxel/voxel_set.hpp"

namespace gnomon::mesh {

inline constexpr std::uint32_t kNone = 0xFFFFFFFF;

/// A quad, or a triangle with `kNone` in the last place. Runs anticlockwise around its normal.
using Corners = std::array<std::uint32_t, 4>;
constexpr std::size_t corner_count(const Corners& face) {
  return face[3] == kNone ? 3 : 4;
}

struct SurfaceMesh {
  struct Object {
    std::string name;
    std::size_t first_face = 0;  ///< its faces end where the next object's begin
  };
  std::vector<Object> objects;
  std::vector<Vec3> positions;                ///< of vertices, world coordinates: limit points
  std::vector<std::array<float, 3>> normals;  ///< unit; a vertex on a crease has one for each side
  std::vector<Corners> faces;                 ///< indices into positions
  std::vector<Corners> face_normals;          ///< the same corners, indices into normals
  std::vector<std::uint32_t> voxels;          ///< by vertex: the index of the voxel whose state is its own
  double spacing = 0;                         ///< side of a voxel, world units
};

/// Vertices are one wherever faces of the surface meet, and only there: surfaces that merely touch stay
/// apart. So a closed cage gives a closed mesh. Subpatches with four points on their outline become quads,
/// the others triangles around their middle. `voxels` needs subpatches and representatives; `names[i]` is
/// object i's. Multithreaded, the same for every number of threads. Throws std::invalid_argument where
/// subpatches or names are missing.
SurfaceMesh surface_mesh(std::span<const surface::LimitSurface> surfaces, const voxel::VoxelSet& voxels,
                         std::span<const std::string> names);

/// Of each vertex: the mean of its faces' normals there, unit length.
std::vector<std::array<float, 3>> vertex_normals(const SurfaceMesh& mesh);

/// Of each vertex: 1 where its voxel is in shadow. `states` has one entry a voxel.
std::vector<std::uint8_t> vertex_shadows(const SurfaceMesh& mesh, std::span<const golden::VoxelState> states);

}  // namespace gnomon::mesh
