// SPDX-License-Identifier: Apache-2.0
// Control cages from Wavefront OBJ files. What is read, refused and repaired: docs/models.md.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/scene/control_mesh.hpp"
#include "host/scene/mesh_topology.hpp"

namespace gnomon::scene {

/// A file's cages, one per object, and what was found in them.
struct ObjModel {
  std::vector<ControlMesh> meshes;  ///< at least one, each with at least one face and unused vertices dropped
  std::vector<MeshStatistics> statistics;  ///< one per mesh
  MeshStatistics total;                    ///< their sum, with the file's unused vertices
  std::vector<std::string> warnings;       ///< what was ignored or repaired, one line each
};

/// Reads `path` in one streaming pass (memory grows with the mesh, not with the text). Winding is made
/// consistent and outward. Errors are one line, "path:line: error: what was found, what was expected".
Result<ObjModel> read_obj(const std::filesystem::path& path);

}  // namespace gnomon::scene
