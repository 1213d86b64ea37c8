// SPDX-License-Identifier: Apache-2.0
// The points of one block, each evaluated when it is first asked for. Theory: docs/voxelization.md, "Blocks".
#pragma once

#include <bit>
#include <optional>
#include <span>
#include <vector>

#include "host/surface/patch_tree.hpp"
#include "host/voxel/bend.hpp"
#include "host/voxel/block.hpp"
#include "host/voxel/border_cache.hpp"
#include "host/voxel/point_memo.hpp"

namespace gnomon::voxel {

/// A limit point in units of 2^-16 voxel.
using GridPoint = std::array<std::uint32_t, 3>;

/// Reused from block to block.
class Lattice {
 public:
  /// `keep_points` keeps positions too, for N = 6; what other blocks have evaluated is then not reused.
  Lattice(std::span<const surface::LimitSurface> surfaces, std::span<BorderCache> borders, std::uint32_t res,
          bool keep_points)
      : surfaces_(surfaces), borders_(borders), res_(res), keep_points_(keep_points) {}

  /// Forgets the points on borders of earlier blocks.
  void forget() { memo_.start(); }

  void start(const Block& block);
  /// The same block, with `more_u` and `more_v` times halved steps; keeps all points. Only with
  /// `keep_points`.
  void refine(int more_u, int more_v);

  const Block& block() const { return block_; }
  const surface::LimitSurface& surface() const { return *surface_; }
  int width() const { return width_; }  ///< cells
  int height() const { return height_; }
  std::uint32_t u_at(int i) const { return block_.cell.u0 + (static_cast<std::uint32_t>(i) << log_u_); }
  std::uint32_t v_at(int j) const { return block_.cell.v0 + (static_cast<std::uint32_t>(j) << log_v_); }
  /// Whether any point asked for lies outside the grid.
  bool leaves_grid() const { return guard_.crossed(); }
  /// How many of the points asked for had been evaluated before, for other blocks or faces.
  std::uint64_t remembered() const { return remembered_; }

  /// The voxel of point (i, j), 0..width by 0..height. `kExact` says that points are kept.
  template <bool kExact>
  VoxelKey at(int i, int j);

  // Of points that have been asked for.
  void remember(int i, int j) { memo_.remember(u_at(i), v_at(j), key(i, j)); }  ///< for blocks to come
  bool visited(int i, int j) const { return (line(j).visited[i >> 6] >> (i & 63) & 1) != 0; }
  VoxelKey key(int i, int j) const { return line(j).keys[i]; }
  GridPoint point(int i, int j) const { return points_[index(i, j)]; }
  /// How far the block bends, if all of it is one polynomial.
  std::optional<Bend> bend() const;
  /// If it is: how far the middle of the stretch from i0 to i1 (j0 to j1) lies from the middle between its
  /// ends.
  Vec3 off_u(int i0, int i1, int j) const;
  Vec3 off_v(int i, int j0, int j1) const;
  /// In row-major order.
  template <class Visit>
  void for_each_visited(Visit visit) const;

  /// The voxel with point (i, j) as its representative; `nudged` is raised where the normal had to be nudged.
  Voxel representative(int i, int j, std::uint64_t& nudged);

 private:
  using Row = std::array<surface::Lane4, 4>;
  struct Line {
    VoxelKey* keys;
    std::uint64_t* visited;
    bool ready;  // whether `cubic` is
    bool slope_ready;
    Row cubic;  // the surface along the line
  };
  using Fixed = std::array<std::uint32_t, 4>;

  Line& line(int j) { return lines_[static_cast<std::size_t>(j)]; }
  const Line& line(int j) const { return lines_[static_cast<std::size_t>(j)]; }
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * (static_cast<std::size_t>(width_) + 1) + static_cast<std::size_t>(i);
  }
  // A polynomial that lattice points lie in, and their parameters in there.
  struct Chart {
    const surface::Patch* patch = nullptr;  // null: there is no such polynomial
    double u_origin = 0, u_step = 0, v_origin = 0, v_step = 0;

    double u(int i) const { return u_origin + u_step * i; }
    double v(int j) const { return v_origin + v_step * j; }
  };
  // Of the smallest piece that holds a rectangle of parameters.
  Chart chart(std::uint32_t u0, std::uint32_t v0, std::uint32_t u1, std::uint32_t v1) const;

  // Whether a point lies inside the block, so that its own polynomial answers without further ado.
  bool own(int i, int j) const {
    return static_cast<unsigned>(i - 1) < own_columns_ && static_cast<unsigned>(j - 1) < own_rows_;
  }
  const Row& row(int j);
  Fixed fixed(int i, int j);
  [[gnu::noinline]] VoxelKey foreign(int i, int j);
  VoxelKey border(int i, int j);
  const BorderCache::Stretch* side(int i, int j) const;
  template <bool kExact>
  VoxelKey keep(int i, int j, const Fixed& p);
  Vec3 unit_normal(int i, int j, std::uint64_t& nudged);
  void map_to_piece();
  void map_to_borders();

  std::span<const surface::LimitSurface> surfaces_;
  std::span<BorderCache> borders_;
  std::uint32_t res_;
  bool keep_points_;

  Block block_;
  const surface::LimitSurface* surface_ = nullptr;
  const surface::PatchTree* pieces_ = nullptr;
  Chart own_;            // of the whole block; without it, points are asked for one by one
  Chart right_, above_;  // of the sides u = width and v = height (but their last points), if not own_
  std::optional<Row> above_row_;
  int width_ = 0, height_ = 0;
  int log_u_ = 0, log_v_ = 0;  // of a lattice step
  unsigned own_columns_ = 0, own_rows_ = 0;
  int last_own_u_ = 0, last_own_v_ = 0;  // up to where the block's polynomial answers
  std::array<BorderCache::Stretch, 4>
      sides_;  // v low, u high, v high, u low: where they are sides of the face
  GridGuard guard_{0};
  std::uint64_t remembered_ = 0;  // points that had been evaluated before
  PointMemo memo_;                // of points on borders of blocks within the face

  std::vector<Line> lines_;
  std::vector<Row> slopes_;  // of the lines, by v
  std::vector<VoxelKey> keys_;
  std::vector<std::uint64_t> visited_;
  std::vector<GridPoint> points_;
  struct Kept {
    int i, j;
    GridPoint point;
  };
  std::vector<Kept> kept_;  // while the lattice is refined
};

namespace detail {

inline std::array<std::uint32_t, 4> snap_lanes(const surface::Lane4& p, double res) {
  std::array<std::uint32_t, 4> out;
  for (std::size_t k = 0; k < 4; ++k) out[k] = snap(p.x[k], res);
  return out;
}

}  // namespace detail

template <bool kExact>
inline VoxelKey Lattice::keep(int i, int j, const Fixed& p) {
  if constexpr (kExact) points_[index(i, j)] = {p[0], p[1], p[2]};
  const VoxelKey key = pack(p[0] >> kFractionBits, p[1] >> kFractionBits, p[2] >> kFractionBits);
  line(j).keys[i] = key;
  return key;
}

template <bool kExact>
inline VoxelKey Lattice::at(int i, int j) {
  Line& l = line(j);
  std::uint64_t& word = l.visited[i >> 6];
  const std::uint64_t bit = std::uint64_t{1} << (i & 63);
  if ((word & bit) != 0) return l.keys[i];
  word |= bit;
  const VoxelKey key =
      own(i, j) ? keep<kExact>(
                      i, j, detail::snap_lanes(surface::cubic(l.ready ? l.cubic : row(j), own_.u(i)), res_))
                : foreign(i, j);
  guard_.add(key);
  return key;
}

template <class Visit>
void Lattice::for_each_visited(Visit visit) const {
  for (int j = 0; j <= height_; ++j) {
    for (int w = 0; w <= width_ >> 6; ++w) {
      for (std::uint64_t bits = line(j).visited[w]; bits != 0; bits &= bits - 1) {
        visit(w * 64 + std::countr_zero(bits), j);
      }
    }
  }
}

}  // namespace gnomon::voxel
