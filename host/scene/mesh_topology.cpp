// SPDX-License-Identifier: Apache-2.0
// Counts and winding of a control cage.
#include "host/scene/mesh_topology.hpp"

#include <algorithm>
#include <cmath>

#include "host/scene/half_edges.hpp"

namespace gnomon::scene {
namespace {

/// Twice the area times the unit normal (Newell's sum), about the face's own first vertex so that an offset
/// of the whole model costs no accuracy.
Vec3 area_vector(const ControlMesh& mesh, std::size_t first, std::size_t size) {
  const auto point = [&](std::size_t i) {
    return mesh.positions[static_cast<std::size_t>(mesh.face_indices[first + i])];
  };
  Vec3 sum(0, 0, 0);
  for (std::size_t i = 1; i + 1 < size; ++i) sum += (point(i) - point(0)).cross(point(i + 1) - point(0));
  return sum;
}

double longest_diagonal(const ControlMesh& mesh, std::size_t first, std::size_t size) {
  Box3 box;
  for (std::size_t i = 0; i < size; ++i) {
    box.extendBy(mesh.positions[static_cast<std::size_t>(mesh.face_indices[first + i])]);
  }
  return box.size().length();
}

/// A face whose area is below what double coordinates of its size can express.
bool is_degenerate(const ControlMesh& mesh, std::size_t first, std::size_t size) {
  const double length = longest_diagonal(mesh, first, size);
  return !(area_vector(mesh, first, size).length() > 1e-12 * length * length);
}

struct VertexCounts {
  std::int32_t edges = 0, faces = 0, boundary = 0;
};

void count_faces(const ControlMesh& mesh, MeshStatistics& s, std::vector<VertexCounts>& vertices) {
  std::size_t first = 0;
  for (const std::int32_t face_size : mesh.face_sizes) {
    const auto size = static_cast<std::size_t>(face_size);
    ++(size == 3 ? s.triangles : size == 4 ? s.quads : s.ngons);
    s.largest_face = std::max(s.largest_face, size);
    if (is_degenerate(mesh, first, size)) ++s.degenerate_faces;
    for (std::size_t i = 0; i < size; ++i) {
      ++vertices[static_cast<std::size_t>(mesh.face_indices[first + i])].faces;
    }
    first += size;
  }
  s.faces = mesh.face_sizes.size();
}

void count_edges(std::span<const HalfEdge> sides, MeshStatistics& s, std::vector<VertexCounts>& vertices) {
  for_each_edge(sides, [&](std::span<const HalfEdge> edge) {
    ++s.edges;
    if (edge.size() == 1) ++s.boundary_edges;
    if (edge.size() > 2) ++s.non_manifold_edges;
    if (edge.size() == 2 && edge[0].forward == edge[1].forward) ++s.inconsistent_edges;
    for (const std::int32_t v : {edge[0].low, edge[0].high}) {
      ++vertices[static_cast<std::size_t>(v)].edges;
      if (edge.size() == 1) ++vertices[static_cast<std::size_t>(v)].boundary;
    }
  });
}

void count_vertices(const std::vector<VertexCounts>& vertices, MeshStatistics& s) {
  for (const VertexCounts& v : vertices) {
    if (v.faces == 0) continue;
    ++s.vertices;
    s.largest_valence = std::max(s.largest_valence, static_cast<std::size_t>(v.edges));
    const bool regular = v.boundary == 0 ? v.edges == 4 : v.faces <= 2;
    if (!regular) ++s.extraordinary_vertices;
  }
}

/// For every face, its neighbours across edges of exactly two faces, and whether the two windings disagree
/// there.
struct Neighbours {
  struct Link {
    std::int32_t face;
    bool disagrees;
  };
  std::vector<std::size_t> start;
  std::vector<Link> links;

  Neighbours(std::span<const HalfEdge> sides, std::size_t faces) : start(faces + 1, 0) {
    for_each_edge(sides, [&](std::span<const HalfEdge> edge) {
      if (edge.size() != 2) return;
      ++start[static_cast<std::size_t>(edge[0].face) + 1];
      ++start[static_cast<std::size_t>(edge[1].face) + 1];
    });
    for (std::size_t f = 1; f < start.size(); ++f) start[f] += start[f - 1];
    links.resize(start.back());
    std::vector<std::size_t> next(start.begin(), start.end() - 1);
    for_each_edge(sides, [&](std::span<const HalfEdge> edge) {
      if (edge.size() != 2) return;
      const bool disagrees = edge[0].forward == edge[1].forward;
      links[next[static_cast<std::size_t>(edge[0].face)]++] = {edge[1].face, disagrees};
      links[next[static_cast<std::size_t>(edge[1].face)]++] = {edge[0].face, disagrees};
    });
  }
};

/// One flag a face: turn it over? Breadth first from each part's first face; the smaller side of each part is
/// turned.
std::vector<bool> faces_to_turn(const Neighbours& neighbours, std::size_t faces) {
  std::vector<bool> turn(faces, false), seen(faces, false);
  std::vector<std::size_t> part;
  for (std::size_t seed = 0; seed < faces; ++seed) {
    if (seen[seed]) continue;
    part.assign(1, seed);
    seen[seed] = true;
    std::size_t turned = 0;
    for (std::size_t head = 0; head < part.size(); ++head) {
      const std::size_t face = part[head];
      if (turn[face]) ++turned;
      for (std::size_t i = neighbours.start[face]; i < neighbours.start[face + 1]; ++i) {
        const auto other = static_cast<std::size_t>(neighbours.links[i].face);
        if (seen[other]) continue;
        seen[other] = true;
        turn[other] = turn[face] != neighbours.links[i].disagrees;
        part.push_back(other);
      }
    }
    if (2 * turned > part.size()) {
      for (const std::size_t face : part) turn[face] = !turn[face];
    }
  }
  return turn;
}

void turn_faces(ControlMesh& mesh, const std::vector<bool>& turn) {
  auto first = mesh.face_indices.begin();
  for (std::size_t face = 0; face < mesh.face_sizes.size(); ++face) {
    const auto end = first + mesh.face_sizes[face];
    // The first vertex stays: parameters of the face keep their origin.
    if (turn[face]) std::reverse(first + 1, end);
    first = end;
  }
}

/// Six times the signed volume, about a vertex of the mesh.
double signed_volume(const ControlMesh& mesh) {
  const Vec3 centre = mesh.positions[static_cast<std::size_t>(mesh.face_indices[0])];
  double volume = 0;
  std::size_t first = 0;
  for (const std::int32_t face_size : mesh.face_sizes) {
    const auto size = static_cast<std::size_t>(face_size);
    const Vec3 p = mesh.positions[static_cast<std::size_t>(mesh.face_indices[first])] - centre;
    volume += p.dot(area_vector(mesh, first, size));
    first += size;
  }
  return volume;
}

}  // namespace

MeshStatistics& MeshStatistics::operator+=(const MeshStatistics& other) {
  for (auto member : {&MeshStatistics::vertices, &MeshStatistics::unused_vertices, &MeshStatistics::faces,
                      &MeshStatistics::triangles, &MeshStatistics::quads, &MeshStatistics::ngons,
                      &MeshStatistics::hole_faces, &MeshStatistics::degenerate_faces, &MeshStatistics::edges,
                      &MeshStatistics::boundary_edges, &MeshStatistics::non_manifold_edges,
                      &MeshStatistics::inconsistent_edges, &MeshStatistics::unorientable_edges,
                      &MeshStatistics::reversed_faces, &MeshStatistics::extraordinary_vertices,
                      &MeshStatistics::creases, &MeshStatistics::corners}) {
    this->*member += other.*member;
  }
  largest_face = std::max(largest_face, other.largest_face);
  largest_valence = std::max(largest_valence, other.largest_valence);
  return *this;
}

MeshStatistics measure(const ControlMesh& mesh) {
  MeshStatistics s;
  std::vector<VertexCounts> vertices(mesh.positions.size());
  count_faces(mesh, s, vertices);
  count_edges(sorted_half_edges(mesh), s, vertices);
  count_vertices(vertices, s);
  s.hole_faces = mesh.holes.size();
  s.creases = mesh.creases.size();
  s.corners = mesh.corners.size();
  return s;
}

std::size_t orient(ControlMesh& mesh) {
  if (mesh.face_sizes.empty()) return 0;
  const std::vector<HalfEdge> sides = sorted_half_edges(mesh);
  bool closed = mesh.holes.empty(), consistent = true;
  for_each_edge(sides, [&](std::span<const HalfEdge> edge) {
    closed = closed && edge.size() == 2;
    consistent = consistent && (edge.size() != 2 || edge[0].forward != edge[1].forward);
  });
  std::vector<bool> turn(mesh.face_sizes.size(), false);
  if (!consistent) {
    turn = faces_to_turn(Neighbours(sides, mesh.face_sizes.size()), mesh.face_sizes.size());
    turn_faces(mesh, turn);
  }
  if (closed && signed_volume(mesh) < 0) {
    reverse_winding(mesh);
    turn.flip();
  }
  return static_cast<std::size_t>(std::count(turn.begin(), turn.end(), true));
}

void reverse_winding(ControlMesh& mesh) {
  turn_faces(mesh, std::vector<bool>(mesh.face_sizes.size(), true));
}

bool is_closed(const MeshStatistics& s) {
  return s.boundary_edges == 0 && s.non_manifold_edges == 0 && s.hole_faces == 0;
}

}  // namespace gnomon::scene
