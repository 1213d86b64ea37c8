// SPDX-License-Identifier: Apache-2.0
// The builds with the silhouette-line buffer that are tested here; parameters as in CMakeLists.txt. Together
// they have every fragment count, both roundings, F below, at and above S, lines of 8 and of 16 pixels, and
// fast, slow and stalling memories.
#pragma once

#include <gnomon/golden/config.hpp>

#include "Vslb_deep.h"
#include "Vslb_default.h"
#include "Vslb_faulty.h"
#include "Vslb_published.h"
#include "Vslb_small.h"
#include "Vslb_wide.h"

namespace gnomon::rtl_test {

/// A Verilated model and what it was built with.
template <class M>
struct SlbBuild;

inline golden::HardwareConfig slb_base() {
  golden::HardwareConfig config;
  config.plane_log2 = 4;
  config.en_slb = true;
  config.slb_plane_log2 = 5;
  return config;
}

template <>
struct SlbBuild<Vslb_default> {
  static golden::HardwareConfig config() { return slb_base(); }
};

/// Lines of 8 pixels, one fragment, a slow memory that stalls.
template <>
struct SlbBuild<Vslb_small> {
  static golden::HardwareConfig config() {
    golden::HardwareConfig config = slb_base();
    config.slb_plane_log2 = 3;
    config.frac_bits = config.slope_bits = 4;
    config.frags_per_pixel = 1;
    config.subpixel_bits = config.query_bits = 7;
    config.depth_bits = 8;
    return config;
  }
};

/// The widest lines and the most fragments.
template <>
struct SlbBuild<Vslb_wide> {
  static golden::HardwareConfig config() {
    golden::HardwareConfig config = slb_base();
    config.slb_plane_log2 = 4;
    config.frac_bits = 8;
    config.slope_bits = 9;
    config.frags_per_pixel = 4;
    config.subpixel_bits = config.query_bits = 14;
    config.depth_bits = 24;
    return config;
  }
};

/// Rounding as published; three fragments.
template <>
struct SlbBuild<Vslb_published> {
  static golden::HardwareConfig config() {
    golden::HardwareConfig config = slb_base();
    config.frac_bits = config.slope_bits = 3;
    config.frags_per_pixel = 3;
    config.subpixel_bits = 16;
    config.query_bits = 6;
    config.depth_bits = 16;
    config.slb_rounding = golden::slb::Rounding::Published;
    return config;
  }
};

/// Fewer slope than crossing bits, many query bits, a plane that stalls.
template <>
struct SlbBuild<Vslb_deep> {
  static golden::HardwareConfig config() {
    golden::HardwareConfig config = slb_base();
    config.slb_plane_log2 = 6;
    config.frac_bits = 5;
    config.slope_bits = 3;
    config.subpixel_bits = 8;
    config.query_bits = 16;
    config.depth_bits = 12;
    return config;
  }
};

/// Holds seeded faults, to be chosen by a plusarg; none is chosen by itself. A row has a whole span of lines.
template <>
struct SlbBuild<Vslb_faulty> {
  static golden::HardwareConfig config() {
    golden::HardwareConfig config = slb_base();
    config.en_vpu_offset = false;
    config.slb_plane_log2 = 6;
    config.frac_bits = config.slope_bits = 4;
    config.subpixel_bits = config.query_bits = 7;
    config.depth_bits = 8;
    return config;
  }
};

}  // namespace gnomon::rtl_test
