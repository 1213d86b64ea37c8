// SPDX-License-Identifier: Apache-2.0
// The meaning of OpenSubdiv's `t` statements: creases, corners, holes and the boundary rule.
#pragma once

#include <filesystem>
#include <vector>

#include "host/base/result.hpp"
#include "host/scene/control_mesh.hpp"
#include "host/scene/obj_file.hpp"

namespace gnomon::scene {

/// All of a file's tags; indices count through the file, sharpness is 0..10.
struct ObjTags {
  std::vector<ControlMesh::Crease> creases;
  std::vector<ControlMesh::Corner> corners;
  std::vector<std::int32_t> holes;  ///< sorted, each once
  Boundary boundary = Boundary::EdgeAndCorner;
};

/// Refuses tags that name vertices, edges or faces which do not exist, or values out of range ("path:line:
/// error: ...").
Result<ObjTags> interpret_tags(const std::filesystem::path& path, const ObjFile& file);

}  // namespace gnomon::scene
