// SPDX-License-Identifier: Apache-2.0
// How a view's plane is turned around its axis, so that its entries are used well.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "host/base/light_plane.hpp"
#include "host/plan/light_view.hpp"

namespace gnomon::plan {

/// right and up turned around away, radians.
inline LightAxes turned(const LightAxes& axes, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {axes.right * c + axes.up * s, axes.up * c - axes.right * s, axes.away};
}

/// A part of what is seen, spread evenly: enough to compare extents.
inline ViewVoxels sampled(const ViewVoxels& seen) {
  constexpr std::size_t kEnough = 20000;
  const auto thinned = [](const std::vector<std::uint32_t>& numbers) {
    std::vector<std::uint32_t> some;
    const std::size_t step = std::max<std::size_t>(1, numbers.size() / kEnough);
    for (std::size_t i = 0; i < numbers.size(); i += step) some.push_back(numbers[i]);
    return some;
  };
  return {thinned(seen.casters), thinned(seen.receivers)};
}

/// The axes as they are, unless the plane takes fewer entries when it is turned. `side_log2(axes)` is what it
/// takes then.
template <class SideLog2>
LightAxes oriented(const LightAxes& axes, SideLog2 side_log2) {
  constexpr int kTurns = 6;  // of a right angle
  LightAxes best = axes;
  int least = side_log2(axes);
  for (int turn = 1; turn < kTurns; ++turn) {
    const LightAxes other = turned(axes, turn * std::numbers::pi / 2 / kTurns);
    const int side = side_log2(other);
    if (side >= least) continue;
    least = side;
    best = other;
  }
  return best;
}

}  // namespace gnomon::plan
