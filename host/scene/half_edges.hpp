// SPDX-License-Identifier: Apache-2.0
// The sides of a cage's faces, grouped by the edge they lie on.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/scene/control_mesh.hpp"

namespace gnomon::scene {

/// One side of a face. `high` > `low` are its vertices; `forward` says whether the face runs from low to
/// high.
struct HalfEdge {
  std::int32_t low, high;
  std::int32_t face;
  bool forward;
};

/// All sides of all faces, sorted by (low, high, face). Linear in memory: 16 bytes a side, for cages of
/// millions of faces.
std::vector<HalfEdge> sorted_half_edges(const ControlMesh& mesh);

/// Calls visit(span of the half-edges of one edge) for every edge.
template <class Visit>
void for_each_edge(std::span<const HalfEdge> sides, Visit visit) {
  for (std::size_t begin = 0; begin < sides.size();) {
    std::size_t end = begin + 1;
    while (end < sides.size() && sides[end].low == sides[begin].low && sides[end].high == sides[begin].high)
      ++end;
    visit(sides.subspan(begin, end - begin));
    begin = end;
  }
}

}  // namespace gnomon::scene
