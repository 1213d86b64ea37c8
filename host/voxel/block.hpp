// SPDX-License-Identifier: Apache-2.0
// The unit of work: a rectangle of one face's parameters with a lattice over it, and the list of all of them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "host/surface/limit_surface.hpp"
#include "host/voxel/criterion.hpp"
#include "host/voxel/point_memo.hpp"

namespace gnomon::voxel {

/// Parameters are integers in units of 2^-24, which floats hold exactly.
inline constexpr int kParameterBits = 24;
inline constexpr std::uint32_t kParameterOne = 1U << kParameterBits;
inline double parameter(std::uint32_t i) {
  return static_cast<double>(i) * (1.0 / kParameterOne);
}

/// A cell of the recursion: [u0, u0 + 2^log_u] x [v0, v0 + 2^log_v].
struct Cell {
  std::uint32_t u0 = 0, v0 = 0;
  int log_u = kParameterBits, log_v = kParameterBits;

  std::uint32_t u1() const { return u0 + (1U << log_u); }
  std::uint32_t v1() const { return v0 + (1U << log_v); }
  /// Its two or four halves, u running fastest.
  std::vector<Cell> children(Split split) const;
};

/// A cell whose whole recursion fits on a lattice of 2^cells_u by 2^cells_v.
struct Block {
  std::uint32_t object = 0, face = 0;
  Cell cell;
  int cells_u = 0, cells_v = 0;

  std::size_t points() const { return ((std::size_t{1} << cells_u) + 1) * ((std::size_t{1} << cells_v) + 1); }
  /// Share of a whole face, for progress.
  double area() const { return parameter(1U << cell.log_u) * parameter(1U << cell.log_v); }
};

/// How the recursion runs, the same everywhere.
struct RecursionRules {
  Adjacency adjacency;
  std::uint32_t res;
  int smallest_log;  ///< log2 of the smallest side of a cell: the recursion floor

  static RecursionRules of(const Grid& grid);
  Split split(const Corners& corners, bool wider_u) const {
    const auto wider = [&] { return wider_u; };
    return adjacency == Adjacency::N18 ? criterion<Adjacency::N18>(corners, wider)
                                       : criterion<Adjacency::N26>(corners, wider);
  }
};

/// The voxel of a limit point.
VoxelKey voxel_at(const surface::LimitSurface& surface, std::uint32_t face, std::uint32_t u, std::uint32_t v,
                  std::uint32_t res);

/// Enumerates the blocks of all faces in a fixed order. The recursion's first levels run here, until a cell
/// lies in one polynomial piece and is small enough for a lattice.
class BlockSource {
 public:
  BlockSource(std::span<const surface::LimitSurface> surfaces, RecursionRules rules)
      : surfaces_(surfaces), rules_(rules) {}

  std::optional<Block> next();
  std::uint64_t evaluations() const { return evaluations_; }

 private:
  std::optional<Block> lattice_for(const Cell& cell) const;
  bool divide(const Cell& cell);
  bool next_face();
  VoxelKey at(std::uint32_t u, std::uint32_t v);

  std::span<const surface::LimitSurface> surfaces_;
  RecursionRules rules_;
  std::uint32_t object_ = 0, next_face_ = 0, face_ = 0;
  std::vector<Cell> stack_;
  PointMemo memo_;
  std::uint64_t evaluations_ = 0;
};

}  // namespace gnomon::voxel
