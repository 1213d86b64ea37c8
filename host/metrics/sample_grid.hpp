// SPDX-License-Identifier: Apache-2.0
// A regular grid of samples on every parametric face, dense enough for the asked spacing.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/metrics/exact_reference.hpp"
#include "host/surface/limit_surface.hpp"

namespace gnomon::metrics {

/// The cells of one face: nu x nv rectangles of equal size in parameter space, row by row along v.
struct FaceGrid {
  std::uint32_t object, face;
  std::uint32_t nu, nv;
  std::size_t first_cell;  ///< index of the first cell among all cells
  std::size_t first_node;  ///< nodes are the (nu + 1) x (nv + 1) corners
  std::size_t cell(std::uint32_t i, std::uint32_t j) const { return first_cell + std::size_t{j} * nu + i; }
  std::size_t node(std::uint32_t i, std::uint32_t j) const {
    return first_node + std::size_t{j} * (nu + 1) + i;
  }
};

/// Where in cell (i, j) its sample lies, in parameters: anywhere in it, evenly spread, always the same.
/// Samples at the centres would keep step with the voxels wherever a surface runs along the grid.
std::array<double, 2> sample_parameter(const FaceGrid& grid, std::uint32_t i, std::uint32_t j);

/// Cell (i, j) of a face's grid, which is number `grid` among all.
struct CellRef {
  std::uint32_t grid;
  std::uint32_t i, j;
};

/// One row of one face: the unit of work that threads share.
struct GridRow {
  std::uint32_t grid;
  std::uint32_t row;
};

struct SampleGrids {
  std::vector<FaceGrid> faces;
  std::size_t cells = 0, nodes = 0;
  std::vector<GridRow> cell_rows() const;
  std::vector<GridRow> node_rows() const;
};

/// Chooses nu and nv so that neighbouring samples are about `spacing` voxels apart at most. Objects whose
/// entry in `receives` is 0 are left out.
SampleGrids sample_grids(std::span<const surface::LimitSurface> surfaces, double spacing,
                         std::span<const std::uint8_t> receives);

/// The exact answer at a parameter of a face.
Exact exact_at(const ExactReference& reference, std::span<const surface::LimitSurface> surfaces,
               std::uint32_t object, std::uint32_t face, double u, double v);

}  // namespace gnomon::metrics
