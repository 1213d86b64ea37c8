// SPDX-License-Identifier: Apache-2.0
// The face's longest piece along each parameter decides how many cells it gets.
#include "host/metrics/sample_grid.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace gnomon::metrics {
namespace {

constexpr int kProbes = 9;  ///< points a side at which a face's speed is measured
using Probes = std::array<std::array<Vec3, kProbes>, kProbes>;

/// Three points a side are enough to see that a face is smaller than a sample's share.
bool is_tiny(const surface::LimitSurface& surface, std::uint32_t face, double spacing) {
  const Vec3 middle = surface.position(face, 0.5, 0.5);
  for (const double v : {0.0, 0.5, 1.0})
    for (const double u : {0.0, 0.5, 1.0})
      if ((surface.position(face, u, v) - middle).length() > 0.5 * spacing) return false;
  return true;
}

std::uint32_t cells_for(double longest_piece, double spacing) {
  // Rounding must not give a face of exact size one cell more.
  const double cells = std::ceil(longest_piece * (kProbes - 1) / spacing - 1e-6);
  return static_cast<std::uint32_t>(std::max(1.0, cells));
}

void choose(const surface::LimitSurface& surface, FaceGrid& grid, double spacing) {
  grid.nu = grid.nv = 1;
  if (is_tiny(surface, grid.face, spacing)) return;
  Probes p;
  for (std::size_t j = 0; j < kProbes; ++j)
    for (std::size_t i = 0; i < kProbes; ++i)
      p[j][i] = surface.position(grid.face, static_cast<double>(i) / (kProbes - 1),
                                 static_cast<double>(j) / (kProbes - 1));
  double along_u = 0;
  double along_v = 0;
  for (std::size_t j = 0; j < kProbes; ++j)
    for (std::size_t i = 0; i + 1 < kProbes; ++i) {
      along_u = std::max(along_u, (p[j][i + 1] - p[j][i]).length());
      along_v = std::max(along_v, (p[i + 1][j] - p[i][j]).length());
    }
  grid.nu = cells_for(along_u, spacing);
  grid.nv = cells_for(along_v, spacing);
}

/// The finaliser of splitmix64: every input bit changes about half of the output's.
std::uint64_t scramble(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ULL;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBULL;
  return x ^ (x >> 31);
}

std::vector<GridRow> rows(const std::vector<FaceGrid>& faces, std::uint32_t extra) {
  std::vector<GridRow> result;
  for (std::uint32_t g = 0; g < faces.size(); ++g)
    for (std::uint32_t row = 0; row < faces[g].nv + extra; ++row) result.push_back({g, row});
  return result;
}

}  // namespace

std::array<double, 2> sample_parameter(const FaceGrid& grid, std::uint32_t i, std::uint32_t j) {
  const std::uint64_t which = (std::uint64_t{grid.object} << 32) | grid.face;
  const std::uint64_t noise = scramble(scramble(which) ^ ((std::uint64_t{j} << 32) | i));
  const double s = (static_cast<double>(noise & 0xFFFFF) + 0.5) / 0x100000;
  const double t = (static_cast<double>(noise >> 44) + 0.5) / 0x100000;
  return {(i + s) / grid.nu, (j + t) / grid.nv};
}

std::vector<GridRow> SampleGrids::cell_rows() const {
  return rows(faces, 0);
}
std::vector<GridRow> SampleGrids::node_rows() const {
  return rows(faces, 1);
}

SampleGrids sample_grids(std::span<const surface::LimitSurface> surfaces, double spacing,
                         std::span<const std::uint8_t> receives) {
  SampleGrids grids;
  for (std::uint32_t object = 0; object < surfaces.size(); ++object) {
    if (receives[object] == 0) continue;
    for (std::uint32_t face = 0; face < surfaces[object].face_count(); ++face)
      grids.faces.push_back({object, face, 1, 1, 0, 0});
  }
  tbb::parallel_for(std::size_t{0}, grids.faces.size(),
                    [&](std::size_t i) { choose(surfaces[grids.faces[i].object], grids.faces[i], spacing); });
  for (FaceGrid& grid : grids.faces) {
    grid.first_cell = grids.cells;
    grid.first_node = grids.nodes;
    grids.cells += std::size_t{grid.nu} * grid.nv;
    grids.nodes += (std::size_t{grid.nu} + 1) * (grid.nv + 1);
  }
  return grids;
}

Exact exact_at(const ExactReference& reference, std::span<const surface::LimitSurface> surfaces,
               std::uint32_t object, std::uint32_t face, double u, double v) {
  const surface::LimitSurface& surface = surfaces[object];
  return reference.classify({surface.position(face, u, v), surface.normal(face, u, v), object});
}

}  // namespace gnomon::metrics
