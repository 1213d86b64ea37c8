// SPDX-License-Identifier: Apache-2.0
// Loops that reach the corners of the silhouette-line buffer's front end.
#pragma once

#include "tests/golden/slb/shapes.hpp"
#include "tests/rtl/slb/outline/outcome.hpp"

namespace gnomon::rtl_test::slb {

using golden::slb::testing::Random;

/// Every special case that the page names, once or a few times, each small.
std::vector<Loop> directed_loops(const SlbConfig& config);

/// Loops of all sizes: walks of small and large steps, on and off pixel corners and borders, with repeats and
/// spikes, stars, whole-range triangles; short ones and tiny ones among them.
std::vector<Loop> random_loops(std::uint64_t seed, int count, const SlbConfig& config);

/// Edges from one end of the coordinate range to the other: 4N pixels long.
std::vector<Loop> longest_edges(const SlbConfig& config);

/// A circle of `radius` pixels around the plane's centre in edges of about `edge` pixels, with sloping
/// depths.
Loop smooth_loop(const SlbConfig& config, double radius, double edge);

}  // namespace gnomon::rtl_test::slb
