// SPDX-License-Identifier: Apache-2.0
// The corners of a face's cells, and which of them lie on a cell's perimeter.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "host/outline/cells.hpp"

namespace gnomon::outline {

struct Parameter {
  double u, v;
};

/// Every corner of every cell of one face, once. Cells of different size meet along lines: the larger one's
/// perimeter has the smaller ones' corners on it, so that both cut the line in the same places.
class CellCorners {
 public:
  explicit CellCorners(std::span<const Cell> cells);

  std::size_t size() const { return by_row_.size(); }
  Parameter operator[](std::uint32_t corner) const { return {by_row_[corner].second, by_row_[corner].first}; }
  std::uint32_t index(double u, double v) const;
  /// All corners on the cell's perimeter, anticlockwise in (u, v) from (u0, v0).
  std::vector<std::uint32_t> perimeter(const Cell& cell) const;

 private:
  using Pair = std::pair<double, double>;
  std::vector<Pair> by_row_;     // (v, u), sorted: the corners' numbers
  std::vector<Pair> by_column_;  // (u, v), sorted
};

}  // namespace gnomon::outline
