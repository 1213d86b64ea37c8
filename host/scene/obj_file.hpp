// SPDX-License-Identifier: Apache-2.0
// The content of an OBJ file as it stands there: indices count through the whole file, nothing is repaired
// yet.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/base/vec.hpp"
#include "host/scene/obj_grammar.hpp"

namespace gnomon::scene {

struct ObjFile {
  /// A run of faces that belong to one object.
  struct Run {
    std::size_t first_face;
    std::string object;  ///< empty before the first `o`
  };

  std::vector<Vec3> positions;
  std::vector<std::int32_t> face_sizes;
  std::vector<std::int32_t> face_indices;  ///< 0-based, in range, different within a face
  std::vector<Run> runs;                   ///< in order of first_face
  std::vector<ObjTag> tags;                ///< as written: their indices are not checked
  std::size_t weighted_vertices = 0;       ///< with a weight other than 1, which is ignored
};

/// Reads the text through tinyobjloader's streaming interface, which gets only statements that
/// check_statement passed. Errors are "path:line: error: ...".
Result<ObjFile> parse_obj_file(const std::filesystem::path& path);

}  // namespace gnomon::scene
