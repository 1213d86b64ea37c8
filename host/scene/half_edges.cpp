// SPDX-License-Identifier: Apache-2.0
// The sides of a cage's faces, grouped by the edge they lie on.
#include "host/scene/half_edges.hpp"

#include <algorithm>
#include <tuple>

namespace gnomon::scene {
namespace {

/// Calls visit(face, from, to) for every side of every face.
template <class Visit>
void for_each_side(const ControlMesh& mesh, Visit visit) {
  std::size_t first = 0;
  for (std::size_t face = 0; face < mesh.face_sizes.size(); ++face) {
    const auto size = static_cast<std::size_t>(mesh.face_sizes[face]);
    for (std::size_t i = 0; i < size; ++i) {
      visit(static_cast<std::int32_t>(face), mesh.face_indices[first + i],
            mesh.face_indices[first + (i + 1) % size]);
    }
    first += size;
  }
}

}  // namespace

std::vector<HalfEdge> sorted_half_edges(const ControlMesh& mesh) {
  // A counting sort by the lower vertex leaves groups of a few sides each: linear time on any cage.
  std::vector<std::size_t> start(mesh.positions.size() + 1, 0);
  for_each_side(mesh, [&](std::int32_t, std::int32_t from, std::int32_t to) {
    ++start[static_cast<std::size_t>(std::min(from, to)) + 1];
  });
  for (std::size_t v = 1; v < start.size(); ++v) start[v] += start[v - 1];

  std::vector<HalfEdge> sides(mesh.face_indices.size());
  std::vector<std::size_t> next(start.begin(), start.end() - 1);
  for_each_side(mesh, [&](std::int32_t face, std::int32_t from, std::int32_t to) {
    const std::int32_t low = std::min(from, to);
    sides[next[static_cast<std::size_t>(low)]++] = {low, std::max(from, to), face, from < to};
  });
  for (std::size_t v = 0; v + 1 < start.size(); ++v) {
    std::sort(sides.begin() + static_cast<std::ptrdiff_t>(start[v]),
              sides.begin() + static_cast<std::ptrdiff_t>(start[v + 1]),
              [](const HalfEdge& a, const HalfEdge& b) {
                return std::tie(a.high, a.face, a.forward) < std::tie(b.high, b.face, b.forward);
              });
  }
  return sides;
}

}  // namespace gnomon::scene
