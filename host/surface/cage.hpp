// SPDX-License-Identifier: Apache-2.0
// A control cage in canonical form: the same cage whatever order its faces were written in.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "host/base/result.hpp"
#include "host/base/vec.hpp"
#include "host/scene/control_mesh.hpp"

namespace gnomon::surface {

/// Faces start at their smallest vertex index and are sorted by their vertex lists; creases and corners are
/// sorted too. So everything computed from a Cage is identical to the bit for every order and rotation of the
/// faces.
struct Cage {
  std::vector<Vec3> positions;  ///< in grid coordinates
  std::vector<int> sizes;       ///< vertices of each face
  std::vector<int> offsets;     ///< of each face's vertices in `indices`
  std::vector<int> indices;
  std::vector<bool> hole;  ///< for each face
  std::vector<scene::ControlMesh::Crease> creases;
  std::vector<scene::ControlMesh::Corner> corners;
  scene::Boundary boundary = scene::Boundary::EdgeAndCorner;

  int face_count() const { return static_cast<int>(sizes.size()); }
  std::span<const int> face(int f) const {
    return std::span(indices).subspan(static_cast<std::size_t>(offsets[static_cast<std::size_t>(f)]),
                                      static_cast<std::size_t>(sizes[static_cast<std::size_t>(f)]));
  }
};

/// Errors: an index out of range, a face with fewer than three or with repeated vertices, a position that is
/// not finite after the transform, no face at all.
Result<Cage> make_cage(const scene::ControlMesh& mesh, const Mat4& to_grid);

}  // namespace gnomon::surface
