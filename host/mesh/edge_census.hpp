// SPDX-License-Identifier: Apache-2.0
// Whether a mesh is closed: how many faces run along each edge, and which way.
#pragma once

#include <cstdint>
#include <span>

#include "host/mesh/surface_mesh.hpp"

namespace gnomon::mesh {

struct EdgeCensus {
  std::uint64_t edges = 0;    ///< pairs of vertices that are neighbours on some face
  std::uint64_t open = 0;     ///< with one face
  std::uint64_t crowded = 0;  ///< with more than two
  std::uint64_t turned = 0;   ///< with two that run through it in the same direction
  /// Every edge has exactly two faces, in opposite directions.
  bool closed() const { return edges > 0 && open == 0 && crowded == 0 && turned == 0; }
};

/// 8 bytes a face's side, sorted on all cores. Vertices are numbers below 2^31.
EdgeCensus edge_census(std::span<const Corners> faces);

}  // namespace gnomon::mesh
