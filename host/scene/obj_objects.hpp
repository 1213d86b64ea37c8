// SPDX-License-Identifier: Apache-2.0
// Splitting an OBJ file's faces and tags into one cage per object.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/scene/control_mesh.hpp"
#include "host/scene/obj_file.hpp"

namespace gnomon::scene {

struct ObjObjects {
  std::vector<ControlMesh>
      meshes;  ///< in order of first appearance; unused vertices dropped, indices renumbered
  std::size_t unused_vertices = 0;    ///< of no face
  std::vector<std::string> warnings;  ///< what was joined or ignored
};

/// An object is what one `o` name holds; `g` never splits. Objects that share an edge are one surface and are
/// joined, because splitting would tear it. `file` has at least one face; `path` is for messages and for the
/// name of faces before the first `o`. Fails for tags that contradict the mesh.
Result<ObjObjects> split_objects(const std::filesystem::path& path, const ObjFile& file);

}  // namespace gnomon::scene
