// SPDX-License-Identifier: Apache-2.0
// Checks a control mesh and brings it into canonical form.
#include "host/surface/cage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace gnomon::surface {
namespace {

struct Face {
  std::vector<int> vertices;
  bool hole = false;
};

bool finite(const Vec3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

std::optional<std::string> fault_of(std::span<const std::int32_t> vertices, std::size_t vertex_count) {
  if (vertices.size() < 3) return fmt::format("has {} vertices, at least 3 are needed", vertices.size());
  for (const auto v : vertices) {
    if (v < 0 || static_cast<std::size_t>(v) >= vertex_count) {
      return fmt::format("refers to vertex {} of {}", v, vertex_count);
    }
  }
  std::vector<std::int32_t> sorted(vertices.begin(), vertices.end());
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) return "repeats a vertex";
  return std::nullopt;
}

Result<std::vector<Face>> gather_faces(const scene::ControlMesh& mesh) {
  std::vector<Face> faces;
  std::size_t begin = 0;
  for (const auto size : mesh.face_sizes) {
    if (size < 0 || begin + static_cast<std::size_t>(size) > mesh.face_indices.size()) {
      return fail(fmt::format("object '{}': face {} lacks vertex indices", mesh.name, faces.size()));
    }
    const auto vertices = std::span(mesh.face_indices).subspan(begin, static_cast<std::size_t>(size));
    if (const auto fault = fault_of(vertices, mesh.positions.size())) {
      return fail(fmt::format("object '{}': face {} {}", mesh.name, faces.size(), *fault));
    }
    faces.push_back({{vertices.begin(), vertices.end()}, false});
    begin += static_cast<std::size_t>(size);
  }
  for (const auto h : mesh.holes) {
    if (h < 0 || static_cast<std::size_t>(h) >= faces.size()) {
      return fail(fmt::format("object '{}': hole {} is not one of its {} faces", mesh.name, h, faces.size()));
    }
    faces[static_cast<std::size_t>(h)].hole = true;
  }
  if (faces.empty()) return fail(fmt::format("object '{}' has no faces", mesh.name));
  return faces;
}

void canonicalise(std::vector<Face>& faces) {
  for (Face& f : faces) {
    std::rotate(f.vertices.begin(), std::min_element(f.vertices.begin(), f.vertices.end()), f.vertices.end());
  }
  std::sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) {
    return a.vertices != b.vertices ? a.vertices < b.vertices : a.hole < b.hole;
  });
}

Result<std::vector<Vec3>> transform(const scene::ControlMesh& mesh, const Mat4& to_grid) {
  std::vector<Vec3> positions;
  positions.reserve(mesh.positions.size());
  for (const Vec3& p : mesh.positions) {
    positions.push_back(p * to_grid);
    if (!finite(positions.back())) {
      return fail(fmt::format("object '{}': vertex {} is not finite in grid coordinates", mesh.name,
                              positions.size() - 1));
    }
  }
  return positions;
}

template <class Tag>
bool usable(const Tag& tag, std::size_t vertex_count) {
  const auto inside = [&](std::int32_t v) { return v >= 0 && static_cast<std::size_t>(v) < vertex_count; };
  if (!std::isfinite(tag.sharpness) || tag.sharpness < 0) return false;
  if constexpr (requires { tag.v; }) {
    return inside(tag.v);
  } else {
    return inside(tag.v0) && inside(tag.v1) && tag.v0 != tag.v1;
  }
}

}  // namespace

Result<Cage> make_cage(const scene::ControlMesh& mesh, const Mat4& to_grid) {
  auto faces = gather_faces(mesh);
  if (!faces) return tl::make_unexpected(faces.error());
  auto positions = transform(mesh, to_grid);
  if (!positions) return tl::make_unexpected(positions.error());
  for (const auto& c : mesh.creases) {
    if (!usable(c, mesh.positions.size())) {
      return fail(fmt::format("object '{}': crease {}-{} of sharpness {} is not usable", mesh.name, c.v0,
                              c.v1, c.sharpness));
    }
  }
  for (const auto& c : mesh.corners) {
    if (!usable(c, mesh.positions.size())) {
      return fail(
          fmt::format("object '{}': corner {} of sharpness {} is not usable", mesh.name, c.v, c.sharpness));
    }
  }
  canonicalise(*faces);

  Cage cage;
  cage.positions = std::move(*positions);
  cage.boundary = mesh.boundary;
  for (const Face& f : *faces) {
    cage.sizes.push_back(static_cast<int>(f.vertices.size()));
    cage.offsets.push_back(static_cast<int>(cage.indices.size()));
    cage.indices.insert(cage.indices.end(), f.vertices.begin(), f.vertices.end());
    cage.hole.push_back(f.hole);
  }
  cage.creases = mesh.creases;
  for (auto& c : cage.creases) {
    if (c.v0 > c.v1) std::swap(c.v0, c.v1);
  }
  std::sort(cage.creases.begin(), cage.creases.end(), [](const auto& a, const auto& b) {
    return std::tie(a.v0, a.v1, a.sharpness) < std::tie(b.v0, b.v1, b.sharpness);
  });
  cage.corners = mesh.corners;
  std::sort(cage.corners.begin(), cage.corners.end(), [](const auto& a, const auto& b) {
    return std::tie(a.v, a.sharpness) < std::tie(b.v, b.sharpness);
  });
  return cage;
}

}  // namespace gnomon::surface
