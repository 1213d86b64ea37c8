// SPDX-License-Identifier: Apache-2.0
// The parameter sets that slb_outline is built with here; CMakeLists.txt has the same numbers.
#pragma once

#include "Voutline_default.h"
#include "Voutline_long.h"
#include "Voutline_narrow.h"
#include "Voutline_published.h"
#include "tests/rtl/slb/outline/outcome.hpp"

namespace gnomon::rtl_test::slb {

struct DefaultBuild {
  using Model = Voutline_default;
  static SlbConfig config() { return {}; }
};
/// Widest coordinates, and edges of 65,536 pixels.
struct LongBuild {
  using Model = Voutline_long;
  static SlbConfig config() {
    return {.frac_bits = 8, .slope_bits = 8, .depth_bits = 8, .plane_log2 = 14, .subpixel_bits = 12};
  }
};
/// Most slope bits on the fewest fraction bits, deepest depths, smallest plane, one divider.
struct NarrowBuild {
  using Model = Voutline_narrow;
  static SlbConfig config() {
    return {.frac_bits = 3, .slope_bits = 9, .depth_bits = 24, .plane_log2 = 3, .subpixel_bits = 15};
  }
};
/// The published rounding, more fraction bits than slope bits, fewest sub-pixels, three dividers.
struct PublishedBuild {
  using Model = Voutline_published;
  static SlbConfig config() {
    return {.frac_bits = 5,
            .slope_bits = 4,
            .depth_bits = 12,
            .plane_log2 = 5,
            .subpixel_bits = 8,
            .rounding = golden::slb::Rounding::Published};
  }
};

}  // namespace gnomon::rtl_test::slb
