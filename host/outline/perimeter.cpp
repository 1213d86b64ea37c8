// SPDX-License-Identifier: Apache-2.0
// Corners sorted along rows and along columns: a line of the face is a run in one of the two lists.
#include "host/outline/perimeter.hpp"

#include <algorithm>

namespace gnomon::outline {
namespace {

using Pair = std::pair<double, double>;

void sort_unique(std::vector<Pair>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

/// The places strictly between two places of a line.
std::span<const Pair> between(const std::vector<Pair>& list, double line, double from, double to) {
  const auto first = std::upper_bound(list.begin(), list.end(), Pair{line, from});
  const auto last = std::lower_bound(first, list.end(), Pair{line, to});
  return {first, last};
}

}  // namespace

CellCorners::CellCorners(std::span<const Cell> cells) {
  for (const Cell& c : cells)
    for (const double u : {c.u0, c.u1})
      for (const double v : {c.v0, c.v1}) {
        by_row_.emplace_back(v, u);
        by_column_.emplace_back(u, v);
      }
  sort_unique(by_row_);
  sort_unique(by_column_);
}

std::uint32_t CellCorners::index(double u, double v) const {
  const auto found = std::lower_bound(by_row_.begin(), by_row_.end(), Pair{v, u});
  return static_cast<std::uint32_t>(found - by_row_.begin());
}

std::vector<std::uint32_t> CellCorners::perimeter(const Cell& c) const {
  std::vector<std::uint32_t> out{index(c.u0, c.v0)};
  for (const auto& [v, u] : between(by_row_, c.v0, c.u0, c.u1)) out.push_back(index(u, v));
  out.push_back(index(c.u1, c.v0));
  for (const auto& [u, v] : between(by_column_, c.u1, c.v0, c.v1)) out.push_back(index(u, v));
  out.push_back(index(c.u1, c.v1));
  const auto top = between(by_row_, c.v1, c.u0, c.u1);
  for (auto p = top.rbegin(); p != top.rend(); ++p) out.push_back(index(p->second, p->first));
  out.push_back(index(c.u0, c.v1));
  const auto left = between(by_column_, c.u0, c.v0, c.v1);
  for (auto p = left.rbegin(); p != left.rend(); ++p) out.push_back(index(p->first, p->second));
  return out;
}

}  // namespace gnomon::outline
