// SPDX-License-Identifier: Apache-2.0
// The parameter sets that the unit is built with here; CMakeLists.txt has the same numbers.
#pragma once

#include "Vtopology_no_forwarding.h"
#include "Vtopology_scene.h"
#include "Vtopology_small.h"
#include "Vtopology_wide.h"
#include "tests/rtl/topology/outcome.hpp"

namespace gnomon::rtl_test::topology {

/// Defaults, with a plane and pools for a grid of 64.
struct SceneBuild {
  using Model = Vtopology_scene;
  static TopologyConfig config() {
    return {.voxel_bits = 6, .plane_log2 = 7, .nodes_log2 = 16, .quads_log2 = 14};
  }
};
/// Least of everything, pools that run out, slow memories whose ports stall.
struct SmallBuild {
  using Model = Vtopology_small;
  static TopologyConfig config() {
    return {.voxel_bits = 4,
            .voxel_frac_bits = 0,
            .normal_bits = 4,
            .matrix_frac_bits = 12,
            .depth_bits = 8,
            .plane_log2 = 4,
            .sub_bits = 2,
            .span_log2 = 2,
            .nodes_log2 = 8,
            .quads_log2 = 6};
  }
};
/// Widest numbers; quads may be larger than the plane.
struct WideBuild {
  using Model = Vtopology_wide;
  static TopologyConfig config() {
    return {.voxel_bits = 11,
            .voxel_frac_bits = 5,
            .normal_bits = 5,
            .matrix_frac_bits = 28,
            .depth_bits = 24,
            .plane_log2 = 5,
            .sub_bits = 8,
            .span_log2 = 6,
            .nodes_log2 = 11,
            .quads_log2 = 8};
  }
};

}  // namespace gnomon::rtl_test::topology
