// SPDX-License-Identifier: Apache-2.0
// Dense loops to loops of few edges. Theory: docs/outline.md, "How long edges are".
#pragma once

#include "host/outline/outline.hpp"

namespace gnomon::outline {

struct ThinningLimits {
  double sag;       ///< pixels: an edge is as long as all of the curve beside it keeps this close
  double depth;     ///< codes: and this close in depth
  double min_edge;  ///< pixels: shorter edges are not made, except by corners; if not fit_pixels
  double max_edge;  ///< pixels: longer edges are not made
  bool fit_pixels;  ///< at most one vertex for each time the loop is in a pixel, edges balanced
};

/// A loop along `dense`. Empty where all of `dense` lies on one line (1e-6 px): such a loop covers nothing.
Loop thinned(const Loop& dense, const ThinningLimits& limits);

/// All vertices within 1e-6 px of one line.
bool on_a_line(const Loop& loop);

}  // namespace gnomon::outline
