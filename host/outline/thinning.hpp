// SPDX-License-Identifier: Apache-2.0
// Dense loops to loops of edges as long as they may be. Theory: docs/outline.md, "How long edges are".
#pragma once

#include "host/outline/outline.hpp"

namespace gnomon::outline {

struct ThinningLimits {
  double sag;       ///< pixels between a vertex left out and the edge
  double depth;     ///< codes between them
  double min_edge;  ///< pixels: within this of an edge's start, anything may be left out
  double max_edge;  ///< pixels
};

/// A loop through some of the vertices of `dense`, beginning with the rightmost. Empty where all of them lie
/// on one line (1e-6 px): such a loop covers nothing.
Loop thinned(const Loop& dense, const ThinningLimits& limits);

/// All vertices within 1e-6 px of one line.
bool on_a_line(const Loop& loop);

}  // namespace gnomon::outline
