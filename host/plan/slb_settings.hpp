// SPDX-License-Identifier: Apache-2.0
// What the user may choose about the silhouette-line buffer; the rest follows from the scene.
#pragma once

#include <algorithm>
#include <gnomon/golden/config.hpp>

namespace gnomon::plan {

struct SlbSettings {
  int frac_bits = 7;      ///< F
  int slope_bits = 7;     ///< S
  int frags = 2;          ///< K: fragments a pixel, two lines each
  int subpixel_bits = 0;  ///< fraction bits of a vertex; 0: the fewest that F and S allow
  int query_bits = 0;     ///< fraction bits of a query; 0: the fewest that F allows
  int depth_bits = 20;
  golden::slb::Rounding rounding = golden::slb::Rounding::Better;
  int plane_log2 = 0;  ///< log2 of the plane's side; 0: what the scene needs

  /// The hardware with a plane of this size, and without the projection unit's resolve pass. Not checked.
  golden::HardwareConfig hardware(int side_log2) const {
    golden::HardwareConfig config;
    config.en_vpu_offset = false;
    config.en_slb = true;
    config.slb_plane_log2 = side_log2;
    config.frac_bits = frac_bits;
    config.slope_bits = slope_bits;
    config.frags_per_pixel = frags;
    config.depth_bits = depth_bits;
    config.subpixel_bits =
        subpixel_bits > 0 ? subpixel_bits : std::max(frac_bits + 3, slope_bits - frac_bits + 4);
    config.query_bits = query_bits > 0 ? query_bits : frac_bits + 3;
    config.slb_rounding = rounding;
    return config;
  }
};

}  // namespace gnomon::plan
