// SPDX-License-Identifier: Apache-2.0
// What can be said about a control cage from its connectivity alone: counts for the report, and its winding.
#pragma once

#include <cstddef>
#include <cstdint>

#include "host/scene/control_mesh.hpp"

namespace gnomon::scene {

/// Counts of one cage (or, summed, of a model). Everything here is legal input; docs/models.md says what is
/// done about it.
struct MeshStatistics {
  std::size_t vertices = 0;  ///< used by at least one face
  std::size_t unused_vertices = 0;
  std::size_t faces = 0;
  std::size_t triangles = 0;
  std::size_t quads = 0;
  std::size_t ngons = 0;  ///< faces of five sides or more
  std::size_t largest_face = 0;
  std::size_t hole_faces = 0;
  std::size_t degenerate_faces = 0;  ///< of no area
  std::size_t edges = 0;
  std::size_t boundary_edges = 0;      ///< of one face
  std::size_t non_manifold_edges = 0;  ///< of more than two faces
  std::size_t inconsistent_edges = 0;  ///< run through by both of their faces in the same direction, as read
  std::size_t unorientable_edges =
      0;                           ///< of these, the ones that no choice of winding cures (a Moebius band)
  std::size_t reversed_faces = 0;  ///< turned over by `orient`
  std::size_t extraordinary_vertices =
      0;  ///< inside: not of four edges; on a boundary: of more than two faces
  std::size_t largest_valence = 0;
  std::size_t creases = 0;
  std::size_t corners = 0;

  MeshStatistics& operator+=(const MeshStatistics& other);
  bool operator==(const MeshStatistics&) const = default;
};

/// Counts everything but unused_vertices and reversed_faces. Time grows with the number of edges.
MeshStatistics measure(const ControlMesh& mesh);

/// Makes the winding of every connected part consistent by turning over the fewer faces, then, if the mesh is
/// closed and its volume negative (it was inside out), all of them: afterwards du x dv points outwards.
/// Neighbourhood across non-manifold edges does not count. Returns the number of faces turned over.
std::size_t orient(ControlMesh& mesh);

/// Turns every face over (needed where a transform mirrors).
void reverse_winding(ControlMesh& mesh);

/// True when the mesh has no boundary and no non-manifold edge, and no holes: it has an inside.
bool is_closed(const MeshStatistics& statistics);

}  // namespace gnomon::scene
