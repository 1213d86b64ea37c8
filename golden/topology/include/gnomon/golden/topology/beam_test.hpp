// SPDX-License-Identifier: Apache-2.0
// Does a beam meet a quad? Exact, in the plane (docs/vpu-topology.md, "The test").
#pragma once

#include <array>
#include <cstdint>

namespace gnomon::golden::topology {

/// A corner relative to the beam, in sub-entries.
struct Offset {
  std::int64_t x = 0, y = 0;
};

/// The beam lies in the triangle or on its sides, and the triangle has an area.
bool hits_triangle(const Offset& a, const Offset& b, const Offset& c);
/// It hits one of the triangles c0 c1 c2 and c0 c2 c3.
bool hits_quad(const std::array<Offset, 4>& corners);

}  // namespace gnomon::golden::topology
