// SPDX-License-Identifier: Apache-2.0
// All sides of all faces, sorted.
#include "host/mesh/edge_census.hpp"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <vector>

namespace gnomon::mesh {

EdgeCensus edge_census(std::span<const Corners> faces) {
  // The lower vertex, the higher one, and the direction in the lowest bit.
  std::vector<std::uint64_t> sides;
  sides.reserve(faces.size() * 4);
  for (const Corners& face : faces) {
    const std::size_t count = corner_count(face);
    for (std::size_t k = 0; k < count; ++k) {
      const std::uint64_t from = face[k];
      const std::uint64_t to = face[(k + 1) % count];
      sides.push_back(std::min(from, to) << 32 | std::max(from, to) << 1 | (from > to ? 1U : 0U));
    }
  }
  tbb::parallel_sort(sides.begin(), sides.end());
  EdgeCensus census;
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && sides[end] >> 1 == sides[begin] >> 1) ++end;
    ++census.edges;
    if (end - begin == 1) ++census.open;
    if (end - begin > 2) ++census.crowded;
    if (end - begin == 2 && sides[begin] == sides[begin + 1]) ++census.turned;
  }
  return census;
}

}  // namespace gnomon::mesh
