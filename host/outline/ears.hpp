// SPDX-License-Identifier: Apache-2.0
// Faces of polygon meshes cut into triangles.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host/scene/control_mesh.hpp"

namespace gnomon::outline {

using Triangle = std::array<std::uint32_t, 3>;

/// The triangles of all faces that are not holes, wound as their faces; an n-gon gives n - 2. A face that
/// crosses itself is cut all the same.
std::vector<Triangle> triangles_of(const scene::ControlMesh& mesh);

}  // namespace gnomon::outline
