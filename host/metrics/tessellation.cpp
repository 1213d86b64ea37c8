// SPDX-License-Identifier: Apache-2.0
// Midpoint recursion on each face; a cell is done when thirteen points of it lie within the sag of its
// bilinear quad.
#include "host/metrics/tessellation.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>

namespace gnomon::metrics {
namespace {

/// Beyond 2^-16 of a face, refinement would only follow a cusp.
constexpr int kDepthMax = 16;

struct Cell {
  double u0, v0, u1, v1;
  int depth_u, depth_v;
};

/// The 3x3 limit points of a cell: corners, middles of the sides, centre. p[row][column], rows along v.
struct CellPoints {
  Vec3 p[3][3];
};

double bend(const Vec3& a, const Vec3& middle, const Vec3& b) {
  return (middle - (a + b) * 0.5).length();
}

class FaceTessellator {
 public:
  FaceTessellator(const surface::LimitSurface& surface, std::uint32_t face, double sag, double longest_side,
                  std::atomic<std::size_t>& cells, std::size_t max_cells)
      : surface_(surface),
        face_(face),
        sag_(sag),
        longest_side_(longest_side),
        cells_(cells),
        max_cells_(max_cells) {}

  std::vector<ParamRect> run() {
    split({0, 0, 1, 1, 0, 0});
    return std::move(rects_);
  }

 private:
  void split(const Cell& cell) {
    if (cells_.load(std::memory_order_relaxed) > max_cells_) return;
    const CellPoints points = evaluate(cell);
    const auto [in_u, in_v] = must_split(cell, points);
    const double um = 0.5 * (cell.u0 + cell.u1);
    const double vm = 0.5 * (cell.v0 + cell.v1);
    if (!in_u && !in_v) {
      rects_.push_back({face_, static_cast<float>(cell.u0), static_cast<float>(cell.v0),
                        static_cast<float>(cell.u1), static_cast<float>(cell.v1)});
      cells_.fetch_add(1, std::memory_order_relaxed);
      return;
    }
    for (int j = 0; j < (in_v ? 2 : 1); ++j)
      for (int i = 0; i < (in_u ? 2 : 1); ++i)
        split({i == 0 ? cell.u0 : um, j == 0 ? cell.v0 : vm, in_u && i == 0 ? um : cell.u1,
               in_v && j == 0 ? vm : cell.v1, cell.depth_u + in_u, cell.depth_v + in_v});
  }

  CellPoints evaluate(const Cell& cell) const {
    CellPoints points;
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) points.p[j][i] = at(cell, 0.5 * i, 0.5 * j);
    return points;
  }

  Vec3 at(const Cell& cell, double s, double t) const {
    return surface_.position(face_, cell.u0 + s * (cell.u1 - cell.u0), cell.v0 + t * (cell.v1 - cell.v0));
  }

  std::pair<bool, bool> must_split(const Cell& cell, const CellPoints& c) const {
    const auto& p = c.p;
    double bend_u = 0;
    double bend_v = 0;
    double side_u = 0;
    double side_v = 0;
    for (int k = 0; k < 3; ++k) {
      bend_u = std::max(bend_u, bend(p[k][0], p[k][1], p[k][2]));
      bend_v = std::max(bend_v, bend(p[0][k], p[1][k], p[2][k]));
      side_u = std::max(side_u, (p[k][2] - p[k][0]).length());
      side_v = std::max(side_v, (p[2][k] - p[0][k]).length());
    }
    bool u = bend_u > sag_ || side_u > longest_side_;
    bool v = bend_v > sag_ || side_v > longest_side_;
    // The cell is cut along one diagonal: a twisted quad is off by its centre even where all its lines are
    // straight. Points at the quarters catch lines that cross their chord in the middle.
    if (!u && !v && (bend(p[0][0], p[1][1], p[2][2]) > sag_ || off_at_quarters(cell, c))) {
      u = bend_u > bend_v || (bend_u == bend_v && side_u >= side_v);
      v = !u;
    }
    return {u && cell.depth_u < kDepthMax, v && cell.depth_v < kDepthMax};
  }

  bool off_at_quarters(const Cell& cell, const CellPoints& c) const {
    for (const double t : {0.25, 0.75})
      for (const double s : {0.25, 0.75}) {
        const Vec3 bilinear =
            (c.p[0][0] * (1 - s) + c.p[0][2] * s) * (1 - t) + (c.p[2][0] * (1 - s) + c.p[2][2] * s) * t;
        if ((at(cell, s, t) - bilinear).length() > sag_) return true;
      }
    return false;
  }

  const surface::LimitSurface& surface_;
  std::uint32_t face_;
  double sag_, longest_side_;
  std::atomic<std::size_t>& cells_;
  std::size_t max_cells_;
  std::vector<ParamRect> rects_;
};

Tessellation attempt(std::span<const surface::LimitSurface> surfaces, const TessellationOptions& options,
                     const std::vector<bool>& wanted, double sag, std::size_t max_cells) {
  Tessellation result;
  result.sag = sag;
  std::atomic<std::size_t> cells = 0;
  for (std::size_t object = 0; object < surfaces.size(); ++object) {
    const surface::LimitSurface& surface = surfaces[object];
    std::vector<ParamRect>& rects = result.rects.emplace_back();
    if (object < wanted.size() && !wanted[object]) continue;
    std::vector<std::vector<ParamRect>> faces(surface.face_count());
    tbb::parallel_for(std::uint32_t{0}, surface.face_count(), [&](std::uint32_t face) {
      faces[face] = FaceTessellator(surface, face, sag, options.longest_side, cells, max_cells).run();
    });
    for (const auto& face : faces) rects.insert(rects.end(), face.begin(), face.end());
  }
  result.cells = cells;
  return result;
}

}  // namespace

Tessellation tessellate(std::span<const surface::LimitSurface> surfaces, const TessellationOptions& options,
                        const std::vector<bool>& wanted) {
  std::size_t faces = 0;
  for (const surface::LimitSurface& surface : surfaces) faces += surface.face_count();
  // Every face is at least one cell; a cage finer than the limit still gets its turn.
  const std::size_t max_cells = std::max(options.max_cells, 2 * faces);
  double sag = options.sag;
  for (;;) {
    Tessellation result = attempt(surfaces, options, wanted, sag, max_cells);
    if (result.cells <= max_cells || sag > options.longest_side) return result;
    sag *= 4;
  }
}

}  // namespace gnomon::metrics
