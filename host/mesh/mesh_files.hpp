// SPDX-License-Identifier: Apache-2.0
// Meshes as files for other programs: Wavefront OBJ and PLY.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "host/base/result.hpp"
#include "host/mesh/surface_mesh.hpp"

namespace gnomon::mesh {

/// One light's shadow: 1 or 0 for each vertex.
using VertexShadows = std::vector<std::uint8_t>;

/// The formats that a file's name can ask for.
enum class MeshFormat : std::uint8_t { Obj, Ply };
/// By the extension, .obj or .ply; fails with what was expected, naming the path.
Result<MeshFormat> mesh_format(const std::filesystem::path& path);

/// Objects by name, vertices, normals for each side of a crease, quads and triangles, to a thousandth of a
/// voxel or better. Shadows have no place in it. Fails with the reason, without naming the path; `poll` is
/// called now and then and may throw.
Result<void> write_obj(const std::filesystem::path& path, const SurfaceMesh& mesh,
                       const std::function<void()>& poll = {});

/// Binary little-endian: per vertex x y z nx ny nz (float) and one `shadow_i` (uchar, 1 in shadow) for each
/// of `lights`; per face `vertex_indices` (uchar count, int). Errors as write_obj.
Result<void> write_ply(const std::filesystem::path& path, const SurfaceMesh& mesh,
                       std::span<const VertexShadows> lights, const std::function<void()>& poll = {});

/// One of the two.
Result<void> write_mesh(MeshFormat format, const std::filesystem::path& path, const SurfaceMesh& mesh,
                        std::span<const VertexShadows> lights, const std::function<void()>& poll = {});

}  // namespace gnomon::mesh
