// SPDX-License-Identifier: Apache-2.0
// From an OBJ file's content to one checked cage per object.
#include "host/scene/obj_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/scene/obj_file.hpp"
#include "host/scene/obj_objects.hpp"

namespace gnomon::scene {
namespace {

/// Smaller models are refused: products of their coordinates would underflow.
constexpr double kSmallestExtent = 1e-90;

double extent(const ControlMesh& mesh) {
  Box3 box;
  for (const Vec3& position : mesh.positions) box.extendBy(position);
  return std::max({box.size().x, box.size().y, box.size().z});
}

Result<void> check_extents(const std::filesystem::path& path, const ObjModel& model) {
  for (const ControlMesh& mesh : model.meshes) {
    if (extent(mesh) >= kSmallestExtent) continue;
    const std::string object = model.meshes.size() > 1 ? "object '" + mesh.name + "'" : "the model";
    return fail(
        fmt::format("{}: error: {} has zero extent (all its vertices are one point), expected a surface",
                    path.string(), object));
  }
  return {};
}

MeshStatistics measure_and_orient(ControlMesh& mesh) {
  MeshStatistics statistics = measure(mesh);
  statistics.reversed_faces = orient(mesh);
  if (statistics.inconsistent_edges > 0) statistics.unorientable_edges = measure(mesh).inconsistent_edges;
  return statistics;
}

void describe_repairs(ObjModel& model) {
  const auto note = [&](std::size_t count, std::string_view one, std::string_view many) {
    if (count > 0) model.warnings.push_back(fmt::format("{} {}", count, count == 1 ? one : many));
  };
  const MeshStatistics& total = model.total;
  note(total.reversed_faces, "face turned over to make the winding consistent and outward",
       "faces turned over to make the winding consistent and outward");
  note(total.unorientable_edges, "edge cannot be wound consistently and is treated as a border",
       "edges cannot be wound consistently and are treated as borders");
  note(total.non_manifold_edges, "edge of more than two faces is treated as a border",
       "edges of more than two faces are treated as borders");
  note(total.degenerate_faces, "face has no area", "faces have no area");
  note(total.unused_vertices, "vertex belongs to no face and is ignored",
       "vertices belong to no face and are ignored");
}

}  // namespace

Result<ObjModel> read_obj(const std::filesystem::path& path) {
  Result<ObjFile> file = parse_obj_file(path);
  if (!file) return tl::make_unexpected(file.error());
  if (file->face_sizes.empty()) {
    return fail(fmt::format("{}: error: no faces found ({} vertices), expected an OBJ control cage",
                            path.string(), file->positions.size()));
  }
  ObjModel model;
  if (file->weighted_vertices > 0) {
    model.warnings.push_back(
        fmt::format("weights of {} vertices ignored: surfaces are not rational", file->weighted_vertices));
  }
  Result<ObjObjects> objects = split_objects(path, *file);
  if (!objects) return tl::make_unexpected(objects.error());
  *file = ObjFile();
  model.meshes = std::move(objects->meshes);
  model.warnings.insert(model.warnings.end(), objects->warnings.begin(), objects->warnings.end());
  if (Result<void> sound = check_extents(path, model); !sound) return tl::make_unexpected(sound.error());

  for (ControlMesh& mesh : model.meshes) {
    model.statistics.push_back(measure_and_orient(mesh));
    model.total += model.statistics.back();
  }
  model.total.unused_vertices = objects->unused_vertices;
  describe_repairs(model);
  return model;
}

}  // namespace gnomon::scene
