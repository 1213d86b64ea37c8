// SPDX-License-Identifier: Apache-2.0
// A balanced set of arcs as closed loops. Theory: docs/outline.md, "Loops".
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "host/outline/outline.hpp"

namespace gnomon::outline {

/// Directed arcs between points of the plane; at every point as many arrive as leave.
struct ArcGraph {
  using Arc = std::pair<std::uint32_t, std::uint32_t>;
  std::vector<Vertex> points;
  std::vector<Arc> arcs;

  std::uint32_t add(const Vertex& point) {
    points.push_back(point);
    return static_cast<std::uint32_t>(points.size() - 1);
  }
  /// From a to b so many times, from b to a where negative.
  void add(std::uint32_t a, std::uint32_t b, int times);
};

/// Uses every arc once; no loop passes through a point twice. Throws std::logic_error where the arcs are not
/// balanced.
std::vector<Loop> link_loops(const ArcGraph& graph);

}  // namespace gnomon::outline
