// SPDX-License-Identifier: Apache-2.0
// Closed surfaces as quads between voxels: streams like those of a scene.
#pragma once

#include "tests/rtl/topology/programs.hpp"

namespace gnomon::rtl_test::topology {

struct Surface {
  std::vector<Quad> quads;
  std::vector<Item> voxels;  ///< every corner once, with its normal
};

/// A sphere over a rolling ground, quads about a voxel wide. `config`: at least 64 voxels a side.
Surface sphere_over_ground(const TopologyConfig& config);

/// Farthest first, so that pushed-front lists begin with the nearest.
void sort_far_first(std::vector<Quad>& quads, const std::array<double, 3>& direction);

}  // namespace gnomon::rtl_test::topology
