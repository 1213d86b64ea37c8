// SPDX-License-Identifier: Apache-2.0
// Winding numbers by summing crossings from the left.
#include <algorithm>
#include <gnomon/golden/slb/formats.hpp>
#include <gnomon/golden/slb/winding.hpp>

namespace gnomon::golden::slb {

Winding::Winding(const SlbConfig& config) : side_(config.side()), first_(side_), last_(-1) {
  reset();
}

void Winding::reset() {
  const auto rows = static_cast<std::size_t>(side_);
  change_.assign(rows * rows, 0);
  lines_.assign(rows * rows, false);
  results_.assign(rows * rows, Result{});
  carry_.assign(rows, 0);
  begin();
}

void Winding::begin() {
  first_ = side_;
  last_ = -1;
}

std::size_t Winding::index(int column, int row) const {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(side_) + static_cast<std::size_t>(column);
}

void Winding::touch(int row) {
  first_ = std::min(first_, row);
  last_ = std::max(last_, row);
}

bool Winding::crossing(std::int64_t column, std::int64_t row, bool upwards) {
  if (row < 0 || row >= side_ || column >= side_) return true;
  const int y = static_cast<int>(row);
  touch(y);
  std::int16_t& sum =
      column < 0 ? carry_[static_cast<std::size_t>(y)] : change_[index(static_cast<int>(column), y)];
  const int next = sum + (upwards ? -1 : 1);
  if (next < kWindingMin || next > kWindingMax) return false;
  sum = static_cast<std::int16_t>(next);
  return true;
}

bool Winding::mark_lines(int column, int row) {
  touch(row);
  const std::size_t i = index(column, row);
  const bool before = lines_[i];
  lines_[i] = true;
  return before;
}

Winding::Row Winding::take_row(int row) {
  Row result;
  int sum = carry_[static_cast<std::size_t>(row)];
  carry_[static_cast<std::size_t>(row)] = 0;
  for (int column = 0; column < side_; ++column) {
    const std::size_t i = index(column, row);
    result.winding.push_back(sum);
    result.lines.push_back(lines_[i]);
    sum += change_[i];
    change_[i] = 0;
    lines_[i] = false;
  }
  return result;
}

void Winding::set_result(int column, int row, Result result) {
  results_[index(column, row)] = result;
}

Winding::Result Winding::result(int column, int row) const {
  // Rows that this object did not touch hold an earlier one's results.
  return row >= first_ && row <= last_ ? results_[index(column, row)] : Result{};
}

}  // namespace gnomon::golden::slb
