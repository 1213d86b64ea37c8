// SPDX-License-Identifier: Apache-2.0
// The steps in order, for each surface.
#include "host/outline/outline.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "host/outline/border_chains.hpp"
#include "host/outline/thinning.hpp"

namespace gnomon::outline {
namespace {

/// The radius, in pixels, that the density of points is made for.
constexpr double kTypicalRadius = 22;
/// Depth that a vertex left out may differ by, in pixels' lengths.
constexpr double kDepthSlack = 0.125;

std::optional<Error> check(const Options& o) {
  if (o.frac_bits < 1 || o.frac_bits > 16)
    return Error{fmt::format("outline: frac_bits is {}, must be 1..16", o.frac_bits)};
  if (!(o.min_edge > 0 && o.min_edge <= o.max_edge && std::isfinite(o.max_edge)))
    return Error{fmt::format("outline: edges of {} to {} pixels, must be 0 < min_edge <= max_edge",
                             o.min_edge, o.max_edge)};
  return std::nullopt;
}

double sag(const Options& o) {
  return std::ldexp(0.25, -o.frac_bits);
}

/// Points that vertices are chosen among must be denser than the vertices will be, the more so where they are
/// to be balanced to within the sag.
double cell_size(const Options& o) {
  const double edge = std::sqrt(2 * kTypicalRadius / std::ldexp(1.0, o.frac_bits));
  return o.fit_pixels ? std::clamp(edge / 4, 0.15, 0.5) : std::max(o.min_edge, std::min(1.0, edge / 2));
}

class Outliner {
 public:
  Outliner(const LightView& view, const Options& options) : view_(view), options_(options) {}

  ObjectOutline run(const surface::LimitSurface& surface, std::uint32_t object) const {
    const Topology topology = find_topology(surface);
    const std::vector<FaceTrace> traces = trace(surface);
    ObjectOutline out;
    out.object = object;
    out.statistics = topology.counts;
    for (const FaceTrace& t : traces) {
      out.statistics.contour_faces += t.arcs.empty() ? 0U : 1U;
      out.statistics.cells += t.cells;
      out.statistics.contour_vertices += t.points.size() + t.crossings.size();
    }
    const BorderSampling sampling{sag(options_) / 16, 0.25 * options_.min_edge,
                                  std::min(1.0, options_.max_edge)};
    const JoinedArcs arcs = join_traces(surface, view_, topology, traces, sampling);
    out.statistics.border_vertices = arcs.border_vertices;
    out.statistics.doubled_parts = arcs.doubled_parts;
    add_loops(link_loops(arcs.graph), out);
    return out;
  }

 private:
  std::vector<FaceTrace> trace(const surface::LimitSurface& surface) const {
    std::vector<FaceTrace> traces(surface.face_count());
    tbb::parallel_for(std::uint32_t{0}, surface.face_count(), [&](std::uint32_t face) {
      traces[face] = trace_face(surface, view_, face, cell_size(options_));
    });
    return traces;
  }

  void add_loops(const std::vector<Loop>& dense, ObjectOutline& out) const {
    const ThinningLimits limits{sag(options_), kDepthSlack * view_.codes_per_pixel(), options_.min_edge,
                                options_.max_edge, options_.fit_pixels};
    for (const Loop& d : dense) {
      Loop loop = thinned(d, limits);
      if (loop.empty()) {
        ++out.statistics.dropped_loops;
        continue;
      }
      if (view_.mirrored()) std::reverse(loop.begin() + 1, loop.end());
      out.statistics.vertices += loop.size();
      out.loops.push_back(std::move(loop));
    }
  }

  const LightView& view_;
  const Options& options_;
};

}  // namespace

Result<std::vector<ObjectOutline>> outlines(std::span<const surface::LimitSurface> surfaces,
                                            const LightFrame& frame, const Options& options) {
  if (const auto error = check(frame)) return tl::make_unexpected(*error);
  if (const auto error = check(options)) return tl::make_unexpected(*error);
  const LightView view(frame);
  const Outliner outliner(view, options);
  std::vector<ObjectOutline> out;
  const auto all = [&] {
    for (std::uint32_t i = 0; i < surfaces.size(); ++i) out.push_back(outliner.run(surfaces[i], i));
  };
  const tbb::global_control allow(
      tbb::global_control::max_allowed_parallelism,
      std::max<std::size_t>(options.threads,
                            tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism)));
  tbb::task_arena arena(options.threads == 0 ? tbb::task_arena::automatic
                                             : static_cast<int>(options.threads));
  arena.execute(all);
  return out;
}

}  // namespace gnomon::outline
