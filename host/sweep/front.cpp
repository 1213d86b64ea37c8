// SPDX-License-Identifier: Apache-2.0
// Pareto fronts.
#include "host/sweep/front.hpp"

#include <algorithm>
#include <cmath>

namespace gnomon::sweep {
namespace {

bool dominates(const std::vector<double>& a, const std::vector<double>& b) {
  bool better = false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] > b[i]) return false;
    better = better || a[i] < b[i];
  }
  return better;
}

}  // namespace

std::vector<bool> pareto_front(std::span<const std::vector<double>> objectives) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < objectives.size(); ++i) {
    if (std::ranges::all_of(objectives[i], [](double v) { return std::isfinite(v); })) order.push_back(i);
  }
  // In this order a point can only be beaten by one before it.
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) { return objectives[a] < objectives[b]; });
  std::vector<bool> on(objectives.size(), false);
  std::vector<std::size_t> front;
  for (const std::size_t i : order) {
    if (std::ranges::any_of(front, [&](std::size_t j) { return dominates(objectives[j], objectives[i]); }))
      continue;
    front.push_back(i);
    on[i] = true;
  }
  return on;
}

}  // namespace gnomon::sweep
