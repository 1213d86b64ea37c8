// SPDX-License-Identifier: Apache-2.0
// Where in a face the contour can be. Theory: docs/outline.md, "Cells".
#pragma once

#include <vector>

#include "host/outline/facing_polynomial.hpp"

namespace gnomon::outline {

/// A rectangle of parameters; bounds are dyadic fractions.
struct Cell {
  double u0, v0, u1, v1;
};

/// Either one sign for all of the face and no cells, or Mixed and cells that tile it.
struct FaceCells {
  Sign sign = Sign::Mixed;
  std::vector<Cell> cells;
  std::size_t visited = 0;
};

/// Halves the face until every cell has one sign for sure or is `size` pixels of surface wide at most.
FaceCells find_cells(const surface::LimitSurface& surface, const LightView& view, std::uint32_t face,
                     double size);

}  // namespace gnomon::outline
