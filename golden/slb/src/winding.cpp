// SPDX-License-Identifier: Apache-2.0
// Winding numbers by summing crossings from the left.
#include <algorithm>
#include <gnomon/golden/slb/formats.hpp>
#include <gnomon/golden/slb/winding.hpp>
#include <utility>

namespace gnomon::golden::slb {

Winding::Winding(const SlbConfig& config) : side_(config.side()), first_(side_), last_(-1) {
  reset();
}

void Winding::reset() {
  const auto rows = static_cast<std::size_t>(side_);
  rows_.clear();
  rows_.resize(rows);
  carry_.assign(rows, 0);
  taken_.resize(rows);
  begin();
}

void Winding::begin() {
  first_ = side_;
  last_ = -1;
}

std::vector<Winding::Cell>& Winding::touch(int row) {
  first_ = std::min(first_, row);
  last_ = std::max(last_, row);
  std::vector<Cell>& cells = rows_[static_cast<std::size_t>(row)];
  if (cells.empty()) cells.resize(rows_.size());
  return cells;
}

bool Winding::crossing(std::int64_t column, std::int64_t row, bool upwards) {
  if (row < 0 || row >= side_ || column >= side_) return true;
  const auto y = static_cast<std::size_t>(row);
  std::vector<Cell>& cells = touch(static_cast<int>(row));
  std::int16_t& sum = column < 0 ? carry_[y] : cells[static_cast<std::size_t>(column)].change;
  const int next = sum + (upwards ? -1 : 1);
  if (next < kWindingMin || next > kWindingMax) return false;
  sum = static_cast<std::int16_t>(next);
  return true;
}

bool Winding::mark_lines(int column, int row) {
  bool& lines = touch(row)[static_cast<std::size_t>(column)].lines;
  return std::exchange(lines, true);
}

std::span<const Winding::Pixel> Winding::take_row(int row) {
  int sum = std::exchange(carry_[static_cast<std::size_t>(row)], std::int16_t{0});
  std::vector<Cell>& cells = touch(row);
  for (std::size_t column = 0; column < cells.size(); ++column) {
    Cell& cell = cells[column];
    taken_[column] = {sum, cell.lines};
    sum += cell.change;
    cell.change = 0;
    cell.lines = false;
  }
  return taken_;
}

void Winding::set_result(int column, int row, Result result) {
  rows_[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)].result = result;
}

Winding::Result Winding::result(int column, int row) const {
  // Rows that this object did not touch hold an earlier one's results.
  if (row < first_ || row > last_) return {};
  return rows_[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)].result;
}

}  // namespace gnomon::golden::slb
