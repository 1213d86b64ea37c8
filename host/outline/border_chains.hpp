// SPDX-License-Identifier: Apache-2.0
// Faces' contours and borders put together to one balanced set of arcs. Theory: docs/outline.md, "Borders".
#pragma once

#include <span>

#include "host/outline/loops.hpp"
#include "host/outline/topology.hpp"
#include "host/outline/tracer.hpp"

namespace gnomon::outline {

struct BorderSampling {
  double sag;       ///< pixels: halves of curves are halved until they keep to this
  double min_edge;  ///< pixels: or are this short
  double max_edge;  ///< pixels: and are not longer than this
};

struct JoinedArcs {
  ArcGraph graph;
  std::size_t border_vertices = 0;
  std::size_t doubled_parts = 0;  ///< of which both sides are sent
};

/// `traces` holds one entry a face.
JoinedArcs join_traces(const surface::LimitSurface& surface, const LightView& view, const Topology& topology,
                       std::span<const FaceTrace> traces, const BorderSampling& sampling);

}  // namespace gnomon::outline
