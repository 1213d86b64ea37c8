// SPDX-License-Identifier: Apache-2.0
// Marching squares with bisected crossings, plus the borders of faces.
#include "host/metrics/shadow_border.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "host/metrics/face_borders.hpp"
#include "host/metrics/light_scale.hpp"

namespace gnomon::metrics {
namespace {

constexpr int kBisections = 6;  ///< a crossing is known to 1/64 of a cell's side

/// What one thread found in one piece of work.
struct Part {
  BorderLength length;
  std::vector<Vec3> points;
  std::vector<CellRef> cells;

  void add(Exact shadow_side, double piece) {
    (shadow_side == Exact::Attached ? length.attached : length.cast) += piece;
  }
};

void join(ShadowBorder& border, std::size_t object, const Part& part) {
  border.length[object] = border.length[object] + part.length;
  border.points.insert(border.points.end(), part.points.begin(), part.points.end());
  border.cells.insert(border.cells.end(), part.cells.begin(), part.cells.end());
}

struct Crossing {
  Vec3 point;
  Exact shadow_side;
};

class Tracer {
 public:
  Tracer(const ExactReference& reference, std::span<const surface::LimitSurface> surfaces,
         const SampleGrids& grids, std::span<const Exact> samples)
      : reference_(reference),
        scale_(reference.light()),
        surfaces_(surfaces),
        grids_(grids),
        samples_(samples),
        nodes_(grids.nodes) {
    const std::vector<GridRow> rows = grids.node_rows();
    tbb::parallel_for(std::size_t{0}, rows.size(), [&](std::size_t r) {
      const FaceGrid& grid = grids_.faces[rows[r].grid];
      for (std::uint32_t i = 0; i <= grid.nu; ++i)
        nodes_[grid.node(i, rows[r].row)] = node_answer(grid, i, rows[r].row);
    });
  }

  Part row(const GridRow& where) const {
    const FaceGrid& grid = grids_.faces[where.grid];
    Part border;
    for (std::uint32_t i = 0; i < grid.nu; ++i) {
      if (trace_cell(grid, i, where.row, border)) border.cells.push_back({where.grid, i, where.row});
    }
    return border;
  }

 private:
  Exact node_answer(const FaceGrid& grid, std::uint32_t i, std::uint32_t j) const {
    if (i > 0 && j > 0 && i < grid.nu && j < grid.nv) {
      const Exact a = samples_[grid.cell(i - 1, j - 1)];
      if (a == samples_[grid.cell(i, j - 1)] && a == samples_[grid.cell(i - 1, j)] &&
          a == samples_[grid.cell(i, j)])
        return a;
    }
    return exact_at(reference_, surfaces_, grid.object, grid.face, static_cast<double>(i) / grid.nu,
                    static_cast<double>(j) / grid.nv);
  }

  /// Between two neighbouring nodes of different answer, always from the lower: both cells at an edge find
  /// the same point.
  Crossing bisect(const FaceGrid& grid, std::uint32_t i, std::uint32_t j, bool along_u) const {
    const double v0 = static_cast<double>(j) / grid.nv;
    const double u0 = static_cast<double>(i) / grid.nu;
    Exact low = nodes_[grid.node(i, j)];
    Exact high = along_u ? nodes_[grid.node(i + 1, j)] : nodes_[grid.node(i, j + 1)];
    double from = 0;
    double to = 1;
    const auto at = [&](double t) {
      return std::array{along_u ? u0 + t / grid.nu : u0, along_u ? v0 : v0 + t / grid.nv};
    };
    for (int k = 0; k < kBisections; ++k) {
      const double middle = 0.5 * (from + to);
      const auto [u, v] = at(middle);
      const Exact answer = exact_at(reference_, surfaces_, grid.object, grid.face, u, v);
      const bool is_low = in_shadow(answer) == in_shadow(low);
      (is_low ? from : to) = middle;
      (is_low ? low : high) = answer;
    }
    const auto [u, v] = at(0.5 * (from + to));
    return {surfaces_[grid.object].position(grid.face, u, v), in_shadow(low) ? low : high};
  }

  /// Whether the border crosses the cell.
  bool trace_cell(const FaceGrid& grid, std::uint32_t i, std::uint32_t j, Part& border) const {
    // Corners anticlockwise; side k runs from corner k to corner k + 1.
    const std::array<bool, 4> dark = {
        in_shadow(nodes_[grid.node(i, j)]), in_shadow(nodes_[grid.node(i + 1, j)]),
        in_shadow(nodes_[grid.node(i + 1, j + 1)]), in_shadow(nodes_[grid.node(i, j + 1)])};
    std::array<Crossing, 4> crossings;
    std::size_t count = 0;
    for (std::uint32_t k = 0; k < 4; ++k) {
      if (dark[k] == dark[(k + 1) % 4]) continue;
      crossings[count++] = bisect(grid, i + (k == 1 ? 1 : 0), j + (k == 2 ? 1 : 0), k % 2 == 0);
    }
    if (count == 2) add_segment(crossings[0], crossings[1], border);
    if (count < 4) return count > 0;
    // A saddle: the sample inside says whether the corners like it are connected through the cell.
    const bool connected = in_shadow(samples_[grid.cell(i, j)]) == dark[0];
    add_segment(crossings[0], crossings[connected ? 1 : 3], border);
    add_segment(crossings[2], crossings[connected ? 3 : 1], border);
    return true;
  }

  void add_segment(const Crossing& a, const Crossing& b, Part& border) const {
    const double length = scale_.length(a.point, b.point);
    border.add(a.shadow_side, 0.5 * length);
    border.add(b.shadow_side, 0.5 * length);
    border.points.push_back(a.point);
    border.points.push_back((a.point + b.point) * 0.5);
  }

  const ExactReference& reference_;
  LightScale scale_;
  std::span<const surface::LimitSurface> surfaces_;
  const SampleGrids& grids_;
  std::span<const Exact> samples_;
  std::vector<Exact> nodes_;
};

/// Where two faces meet at a crease and one side is lit, the border runs along the crease itself.
class CreaseTracer {
 public:
  CreaseTracer(const ExactReference& reference, std::span<const surface::LimitSurface> surfaces,
               std::uint32_t object, double spacing)
      : reference_(reference),
        scale_(reference.light()),
        surfaces_(surfaces),
        object_(object),
        spacing_(spacing) {}

  Part group(BorderGroup pieces) const {
    Part border;
    for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
      // Two halves meet wherever their wholes do; those are counted there.
      if (pieces[i].whole() || pieces[i + 1].whole()) pair(pieces[i], pieces[i + 1], border);
    }
    return border;
  }

 private:
  Vec3 point(const BorderPiece& piece, double s) const {
    const auto [u, v] = on_side(piece.side, piece.at(s));
    return surfaces_[object_].position(piece.face, u, v);
  }
  Exact answer(const BorderPiece& piece, double s) const {
    const auto [u, v] = on_side(piece.side, piece.at(s));
    return exact_at(reference_, surfaces_, object_, piece.face, u, v);
  }

  void pair(const BorderPiece& a, const BorderPiece& b, Part& border) const {
    double length = 0;
    for (int k = 0; k < 8; ++k) length += (point(a, (k + 1) / 8.0) - point(a, k / 8.0)).length();
    const int steps = std::max(1, static_cast<int>(std::ceil(length / spacing_)));
    Vec3 from = point(a, 0);
    for (int k = 0; k < steps; ++k) {
      const Vec3 to = point(a, (k + 1.0) / steps);
      const Exact one = answer(a, (k + 0.5) / steps);
      const Exact other = answer(b, (k + 0.5) / steps);
      if (in_shadow(one) != in_shadow(other)) {
        border.add(in_shadow(one) ? one : other, scale_.length(from, to));
        border.points.push_back((from + to) * 0.5);
      }
      from = to;
    }
  }

  const ExactReference& reference_;
  LightScale scale_;
  std::span<const surface::LimitSurface> surfaces_;
  std::uint32_t object_;
  double spacing_;
};

void along_creases(const ExactReference& reference, std::span<const surface::LimitSurface> surfaces,
                   std::uint32_t object, double spacing, ShadowBorder& border) {
  std::vector<std::uint32_t> faces(surfaces[object].face_count());
  std::iota(faces.begin(), faces.end(), 0u);
  const FaceBorders borders(surfaces[object], faces);
  const CreaseTracer tracer(reference, surfaces, object, spacing);
  std::vector<Part> parts(borders.size());
  tbb::parallel_for(std::size_t{0}, borders.size(),
                    [&](std::size_t g) { parts[g] = tracer.group(borders[g]); });
  for (const Part& part : parts) join(border, object, part);
}

}  // namespace

ShadowBorder shadow_border(const ExactReference& reference, std::span<const surface::LimitSurface> surfaces,
                           const SampleGrids& grids, std::span<const Exact> samples, double spacing) {
  const Tracer tracer(reference, surfaces, grids, samples);
  const std::vector<GridRow> rows = grids.cell_rows();
  std::vector<Part> parts(rows.size());
  tbb::parallel_for(std::size_t{0}, rows.size(), [&](std::size_t r) { parts[r] = tracer.row(rows[r]); });
  ShadowBorder border;
  border.length.resize(surfaces.size());
  for (std::uint32_t object = 0; object < surfaces.size(); ++object) {
    if (reference.receives(object)) along_creases(reference, surfaces, object, spacing, border);
  }
  // Joined in row order, so that the last bits do not depend on the threads.
  for (std::size_t r = 0; r < rows.size(); ++r) join(border, grids.faces[rows[r].grid].object, parts[r]);
  return border;
}

}  // namespace gnomon::metrics
