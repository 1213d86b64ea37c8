// SPDX-License-Identifier: Apache-2.0
// Quads in an order that visits the plane's entries near by near and leaves every list as it is. Theory:
// docs/planning.md, "Order of items".
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace gnomon::plan {

/// The entries that a quad is linked to, of a plane's rows and columns; none if it has no columns.
struct LinkedBox {
  std::uint32_t u = 0, v = 0, columns = 0, rows = 0;
};

/// A permutation: quad order[i] comes i-th. Of two quads with an entry in common the one that came first
/// still does. `side`: entries a row; boxes lie on the plane.
std::vector<std::uint32_t> depth_first(std::span<const LinkedBox> boxes, std::uint32_t side);

}  // namespace gnomon::plan
