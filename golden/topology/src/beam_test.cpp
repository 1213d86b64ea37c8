// SPDX-License-Identifier: Apache-2.0
// Five cross products.
#include <gnomon/golden/topology/beam_test.hpp>

namespace gnomon::golden::topology {
namespace {

std::int64_t cross(const Offset& a, const Offset& b) {
  return a.x * b.y - a.y * b.x;
}

/// All on one side, and not all in line with the beam.
bool agree(std::int64_t a, std::int64_t b, std::int64_t c) {
  const bool left = a >= 0 && b >= 0 && c >= 0;
  const bool right = a <= 0 && b <= 0 && c <= 0;
  return left != right;
}

}  // namespace

bool hits_triangle(const Offset& a, const Offset& b, const Offset& c) {
  return agree(cross(a, b), cross(b, c), cross(c, a));
}

bool hits_quad(const std::array<Offset, 4>& corners) {
  const auto& [c0, c1, c2, c3] = corners;
  const std::int64_t diagonal = cross(c2, c0);
  return agree(cross(c0, c1), cross(c1, c2), diagonal) || agree(-diagonal, cross(c2, c3), cross(c3, c0));
}

}  // namespace gnomon::golden::topology
