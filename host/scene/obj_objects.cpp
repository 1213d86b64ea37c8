// SPDX-License-Identifier: Apache-2.0
// Splitting an OBJ file's faces and tags into one cage per object.
#include "host/scene/obj_objects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <span>
#include <unordered_map>

#include "host/scene/obj_tags.hpp"

namespace gnomon::scene {
namespace {

/// Sets of objects that turned out to be one surface; the earliest object stands for its set.
class Joined {
 public:
  explicit Joined(std::size_t objects) : parent_(objects) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t find(std::size_t object) {
    while (parent_[object] != object) object = parent_[object] = parent_[parent_[object]];
    return object;
  }
  void join(std::size_t a, std::size_t b) {
    const std::size_t first = find(a), second = find(b);
    parent_[std::max(first, second)] = std::min(first, second);
  }

 private:
  std::vector<std::size_t> parent_;
};

struct Objects {
  std::vector<std::string> names;    ///< in order of first appearance
  std::vector<std::size_t> of_face;  ///< index into names
};

Objects number_objects(const ObjFile& file, const std::string& unnamed) {
  Objects objects;
  objects.of_face.resize(file.face_sizes.size());
  std::unordered_map<std::string, std::size_t> known;
  const auto assign = [&](std::size_t from, std::size_t to, const std::string& name) {
    if (from == to) return;
    const auto [entry, fresh] = known.try_emplace(name, objects.names.size());
    if (fresh) objects.names.push_back(name.empty() ? unnamed : name);
    std::fill(objects.of_face.begin() + static_cast<std::ptrdiff_t>(from),
              objects.of_face.begin() + static_cast<std::ptrdiff_t>(to), entry->second);
  };
  const std::size_t faces = file.face_sizes.size();
  assign(0, file.runs.empty() ? faces : file.runs.front().first_face, "");
  for (std::size_t i = 0; i < file.runs.size(); ++i) {
    assign(file.runs[i].first_face, i + 1 < file.runs.size() ? file.runs[i + 1].first_face : faces,
           file.runs[i].object);
  }
  return objects;
}

std::uint64_t edge_key(std::int32_t a, std::int32_t b) {
  const auto [low, high] = std::minmax(a, b);
  return (static_cast<std::uint64_t>(low) << 32U) | static_cast<std::uint32_t>(high);
}

/// Calls visit(face, corners) for every face.
template <class Visit>
void for_each_face(const ObjFile& file, Visit visit) {
  std::span<const std::int32_t> rest(file.face_indices);
  for (std::size_t face = 0; face < file.face_sizes.size(); ++face) {
    const auto size = static_cast<std::size_t>(file.face_sizes[face]);
    visit(face, rest.first(size));
    rest = rest.subspan(size);
  }
}

/// Vertices that faces of more than one object use: almost always none.
std::vector<bool> shared_vertices(const ObjFile& file, const Objects& objects) {
  constexpr auto kNone = static_cast<std::size_t>(-1);
  std::vector<std::size_t> user(file.positions.size(), kNone);
  std::vector<bool> shared(file.positions.size(), false);
  for_each_face(file, [&](std::size_t face, std::span<const std::int32_t> corners) {
    for (const std::int32_t corner : corners) {
      const auto v = static_cast<std::size_t>(corner);
      if (user[v] == kNone) user[v] = objects.of_face[face];
      if (user[v] != objects.of_face[face]) shared[v] = true;
    }
  });
  return shared;
}

Joined join_along_edges(const ObjFile& file, const Objects& objects) {
  Joined joined(objects.names.size());
  if (objects.names.size() < 2) return joined;
  const std::vector<bool> shared = shared_vertices(file, objects);
  std::unordered_map<std::uint64_t, std::size_t> owner;
  for_each_face(file, [&](std::size_t face, std::span<const std::int32_t> corners) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::int32_t a = corners[i], b = corners[(i + 1) % corners.size()];
      if (!shared[static_cast<std::size_t>(a)] || !shared[static_cast<std::size_t>(b)]) continue;
      const auto [entry, fresh] = owner.try_emplace(edge_key(a, b), objects.of_face[face]);
      if (!fresh) joined.join(entry->second, objects.of_face[face]);
    }
  });
  return joined;
}

/// Where every face of the file went.
struct Placement {
  std::vector<std::size_t> mesh;
  std::vector<std::int32_t> face;
};

Placement place_faces(const Objects& objects, Joined& joined, ObjObjects& result) {
  std::vector<std::size_t> mesh_of(objects.names.size());
  for (std::size_t object = 0; object < objects.names.size(); ++object) {
    const std::size_t first = joined.find(object);
    if (first == object) {
      mesh_of[object] = result.meshes.size();
      result.meshes.emplace_back().name = objects.names[object];
    } else {
      mesh_of[object] = mesh_of[first];
      result.warnings.push_back(fmt::format("object '{}' shares edges with '{}': read as one surface",
                                            objects.names[object], objects.names[first]));
    }
  }
  Placement placement;
  std::vector<std::int32_t> count(result.meshes.size(), 0);
  for (const std::size_t object : objects.of_face) {
    placement.mesh.push_back(mesh_of[object]);
    placement.face.push_back(count[mesh_of[object]]++);
  }
  return placement;
}

/// Fills meshes with faces, still numbered as in the file.
void copy_faces(const ObjFile& file, const Placement& placement, std::vector<ControlMesh>& meshes) {
  for_each_face(file, [&](std::size_t face, std::span<const std::int32_t> corners) {
    ControlMesh& mesh = meshes[placement.mesh[face]];
    mesh.face_sizes.push_back(static_cast<std::int32_t>(corners.size()));
    mesh.face_indices.insert(mesh.face_indices.end(), corners.begin(), corners.end());
  });
}

/// Gives `mesh` its own positions, in the file's order, and renumbers faces, creases and corners.
void renumber(const ObjFile& file, ControlMesh& mesh, std::vector<std::int32_t>& scratch) {
  std::vector<std::int32_t> used(mesh.face_indices);
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  mesh.positions.reserve(used.size());
  for (std::size_t i = 0; i < used.size(); ++i) {
    mesh.positions.push_back(file.positions[static_cast<std::size_t>(used[i])]);
    scratch[static_cast<std::size_t>(used[i])] = static_cast<std::int32_t>(i);
  }
  const auto local = [&](std::int32_t v) { return scratch[static_cast<std::size_t>(v)]; };
  for (std::int32_t& v : mesh.face_indices) v = local(v);
  for (ControlMesh::Crease& crease : mesh.creases)
    crease = {local(crease.v0), local(crease.v1), crease.sharpness};
  for (ControlMesh::Corner& corner : mesh.corners) corner.v = local(corner.v);
}

void give_creases(const ObjFile& file, const Placement& placement, const ObjTags& tags,
                  std::vector<ControlMesh>& meshes) {
  std::unordered_map<std::uint64_t, float> sharpness;
  for (const ControlMesh::Crease& crease : tags.creases)
    sharpness[edge_key(crease.v0, crease.v1)] = crease.sharpness;
  if (sharpness.empty()) return;
  for_each_face(file, [&](std::size_t face, std::span<const std::int32_t> corners) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::int32_t a = corners[i], b = corners[(i + 1) % corners.size()];
      const auto entry = sharpness.find(edge_key(a, b));
      if (entry == sharpness.end()) continue;
      meshes[placement.mesh[face]].creases.push_back({std::min(a, b), std::max(a, b), entry->second});
      sharpness.erase(entry);
    }
  });
}

void give_corners(const ObjFile& file, const Placement& placement, const ObjTags& tags,
                  std::vector<ControlMesh>& meshes) {
  std::unordered_map<std::int32_t, float> sharpness;
  for (const ControlMesh::Corner& corner : tags.corners) sharpness[corner.v] = corner.sharpness;
  if (sharpness.empty()) return;
  // A vertex that two objects share is a corner of both; its faces may lie anywhere in the file.
  std::vector<std::vector<std::int32_t>> given(meshes.size());
  for_each_face(file, [&](std::size_t face, std::span<const std::int32_t> corners) {
    for (const std::int32_t v : corners) {
      if (sharpness.contains(v)) given[placement.mesh[face]].push_back(v);
    }
  });
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    std::sort(given[m].begin(), given[m].end());
    given[m].erase(std::unique(given[m].begin(), given[m].end()), given[m].end());
    for (const std::int32_t v : given[m]) meshes[m].corners.push_back({v, sharpness[v]});
  }
}

std::size_t count_unused(const ObjFile& file) {
  std::vector<bool> used(file.positions.size(), false);
  for (const std::int32_t v : file.face_indices) used[static_cast<std::size_t>(v)] = true;
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), false));
}

}  // namespace

Result<ObjObjects> split_objects(const std::filesystem::path& path, const ObjFile& file) {
  const Result<ObjTags> tags = interpret_tags(path, file);
  if (!tags) return tl::make_unexpected(tags.error());
  ObjObjects result;
  result.unused_vertices = count_unused(file);

  const Objects objects = number_objects(file, path.stem().string());
  Joined joined = join_along_edges(file, objects);
  const Placement placement = place_faces(objects, joined, result);
  copy_faces(file, placement, result.meshes);
  give_creases(file, placement, *tags, result.meshes);
  give_corners(file, placement, *tags, result.meshes);
  for (const std::int32_t hole : tags->holes) {
    const auto face = static_cast<std::size_t>(hole);
    result.meshes[placement.mesh[face]].holes.push_back(placement.face[face]);
  }
  std::vector<std::int32_t> scratch(file.positions.size());
  for (ControlMesh& mesh : result.meshes) {
    mesh.boundary = tags->boundary;
    renumber(file, mesh, scratch);
  }
  return result;
}

}  // namespace gnomon::scene
