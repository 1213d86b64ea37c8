// SPDX-License-Identifier: Apache-2.0
// Crossings become points of their curves; curves are sent as often as their faces' stretches add up to.
#include "host/outline/border_chains.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "host/outline/partition.hpp"
#include "host/outline/sides.hpp"
#include "host/surface/borders.hpp"

namespace gnomon::outline {
namespace {

/// Crossings this close on a curve are one: two faces find the same zero up to rounding.
constexpr double kSameCrossing = 1e-8;
constexpr int kDeepestHalving = 16;
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// The points of one curve where something ends: its ends, its middle (n-gons' edges are divided there) and
/// the contour's crossings, in order.
struct CurveStops {
  std::vector<double> t{0, 0.5, 1};
  std::uint32_t first = 0;   ///< of all stops of all curves
  std::vector<int> changes;  ///< of how often the curve is sent, at each stop

  void merge() {
    std::sort(t.begin(), t.end());
    std::vector<double> kept;
    for (const double x : t) {
      if (kept.empty() || x - kept.back() > kSameCrossing) {
        kept.push_back(x);
      } else if (x == 0.5 || x == 1) {
        kept.back() = x;
      }
    }
    t = std::move(kept);
    changes.assign(t.size(), 0);
  }
  std::size_t nearest(double x) const {
    const auto above = std::lower_bound(t.begin(), t.end(), x);
    if (above == t.end()) return t.size() - 1;
    if (above == t.begin() || *above - x < x - *(above - 1))
      return static_cast<std::size_t>(above - t.begin());
    return static_cast<std::size_t>(above - t.begin()) - 1;
  }
};

class Joiner {
 public:
  Joiner(const surface::LimitSurface& surface, const LightView& view, const Topology& topology,
         std::span<const FaceTrace> traces, const BorderSampling& sampling)
      : surface_(surface),
        view_(view),
        topology_(topology),
        traces_(traces),
        sampling_(sampling),
        curves_(topology.curves),
        sides_(traces.size(), Sides::Facing) {
    choose_sides();
    collect_stops();
  }

  JoinedArcs run() {
    join_corners();
    for (std::uint32_t face = 0; face < traces_.size(); ++face) add_face(face);
    for (std::uint32_t curve = 0; curve < curves_.size(); ++curve) add_curve(curve);
    return std::move(out_);
  }

 private:
  const SideOnCurve& side(std::uint32_t face, std::uint32_t s) const { return topology_.sides[face][s]; }

  /// For each open part, by its boundary in pieces of a pixel or less.
  void choose_sides() {
    std::map<std::uint32_t, std::vector<BoundaryPiece>> boundaries;
    for (const BoundaryHalf& half : topology_.boundary) add_pieces(half, boundaries[half.part]);
    for (const auto& [part, pieces] : boundaries) {
      sides_[part] = sides_to_send(pieces, view_.mirrored());
      out_.doubled_parts += sides_[part] == Sides::Both ? 1U : 0U;
    }
  }

  void add_pieces(const BoundaryHalf& half, std::vector<BoundaryPiece>& pieces) const {
    constexpr int kLeast = 4;
    constexpr double kMost = 256;
    const auto at = [&](double s) {
      const Vertex v = on_curve(half.curve, half.t0 + s * (half.t1 - half.t0));
      return Vec2(v.x, v.y);
    };
    double pixels = 0;
    for (int i = 0; i < kLeast; ++i) pixels += (at(double(i + 1) / kLeast) - at(double(i) / kLeast)).length();
    const int n = std::max(kLeast, static_cast<int>(std::min(kMost, pixels)));
    for (int i = 0; i < n; ++i) pieces.push_back({at(double(i) / n), at(double(i + 1) / n), half.times});
  }

  void collect_stops() {
    for (std::uint32_t face = 0; face < traces_.size(); ++face)
      for (const FaceTrace::Crossing& c : traces_[face].crossings)
        curves_[side(face, c.side).curve].t.push_back(side(face, c.side).at(c.s));
    std::uint32_t count = 0;
    for (CurveStops& curve : curves_) {
      curve.merge();
      curve.first = count;
      count += static_cast<std::uint32_t>(curve.t.size());
    }
    stops_ = Partition(count);
    node_.assign(count, kNone);
  }

  std::uint32_t stop(std::uint32_t face, std::uint32_t s, double at) const {
    const SideOnCurve& on = side(face, s);
    const CurveStops& curve = curves_[on.curve];
    return curve.first + static_cast<std::uint32_t>(curve.nearest(on.at(at)));
  }

  /// A side ends where the next begins.
  void join_corners() {
    for (std::uint32_t face = 0; face < traces_.size(); ++face)
      for (std::uint32_t s = 0; s < 4; ++s) {
        const std::uint32_t next = (s + 1) % 4;
        stops_.join(stop(face, s, s < 2 ? 1 : 0), stop(face, next, next < 2 ? 0 : 1));
      }
  }

  Vertex on_curve(std::uint32_t curve, double t) const {
    const surface::Place p = surface_.borders().place({false, curve, t});
    return view_.vertex(surface_.position(p.face, p.u, p.v));
  }

  std::uint32_t node(std::uint32_t curve, std::size_t index) {
    const std::uint32_t stop = stops_.find(curves_[curve].first + static_cast<std::uint32_t>(index));
    if (node_[stop] == kNone) node_[stop] = out_.graph.add(on_curve(curve, curves_[curve].t[index]));
    return node_[stop];
  }

  void add_face(std::uint32_t face) {
    const FaceTrace& trace = traces_[face];
    const Sides sides = sides_[topology_.part[face]];
    const auto first = static_cast<std::uint32_t>(out_.graph.points.size());
    out_.graph.points.insert(out_.graph.points.end(), trace.points.begin(), trace.points.end());
    const auto end = [&](const FaceTrace::End& e) {
      if (!e.border) return first + e.index;
      const FaceTrace::Crossing& c = trace.crossings[e.index];
      const SideOnCurve& on = side(face, c.side);
      return node(on.curve, curves_[on.curve].nearest(on.at(c.s)));
    };
    for (const FaceTrace::Arc& arc : trace.arcs) {
      const std::uint32_t from = end(arc.from);
      out_.graph.add(from, end(arc.to), contour_times(sides));
    }
    for (const FaceTrace::Stretch& s : trace.stretches) {
      const int times = stretch_times(sides, s.plus);
      if (times == 0) continue;
      const SideOnCurve& on = side(face, s.side);
      CurveStops& curve = curves_[on.curve];
      curve.changes[curve.nearest(on.at(s.from))] += times;
      curve.changes[curve.nearest(on.at(s.to))] -= times;
    }
  }

  /// From..to counts +1 at from and -1 at to, whichever comes first: so running sums are how often the curve
  /// is sent upwards.
  void add_curve(std::uint32_t curve) {
    int times = 0;
    for (std::size_t i = 0; i + 1 < curves_[curve].t.size(); ++i) {
      times += curves_[curve].changes[i];
      if (times != 0) add_stretch(curve, i, times);
    }
  }

  void add_stretch(std::uint32_t curve, std::size_t index, int times) {
    const double t0 = curves_[curve].t[index];
    const double t1 = curves_[curve].t[index + 1];
    const std::uint32_t from = node(curve, index);
    const std::uint32_t to = node(curve, index + 1);
    std::vector<Vertex> inner;
    sample(curve, {t0, on_curve(curve, t0)}, {t1, on_curve(curve, t1)}, 0, inner);
    std::uint32_t at = from;
    for (const Vertex& v : inner) {
      const std::uint32_t next = out_.graph.add(v);
      out_.graph.add(at, next, times);
      at = next;
    }
    out_.graph.add(at, to, times);
    out_.border_vertices += inner.size() + 1;
  }

  struct CurvePoint {
    double t;
    Vertex v;
  };

  static double distance(const Vertex& a, const Vertex& b) { return std::hypot(a.x - b.x, a.y - b.y); }

  /// How far a point of a stretch is from the middle of its ends, along the share `s` of it.
  static double off(const Vertex& a, const Vertex& p, const Vertex& b, double s) {
    return std::hypot(p.x - a.x - s * (b.x - a.x), p.y - a.y - s * (b.y - a.y));
  }

  /// The points strictly between two of a curve, in order.
  void sample(std::uint32_t curve, const CurvePoint& a, const CurvePoint& b, int depth,
              std::vector<Vertex>& out) const {
    const auto at = [&](double s) {
      const double t = a.t + s * (b.t - a.t);
      return CurvePoint{t, on_curve(curve, t)};
    };
    const CurvePoint middle = at(0.5);
    const double length = distance(a.v, middle.v) + distance(middle.v, b.v);
    const bool close = length <= sampling_.max_edge &&
                       (length <= sampling_.min_edge || (off(a.v, middle.v, b.v, 0.5) <= sampling_.sag &&
                                                         off(a.v, at(0.25).v, b.v, 0.25) <= sampling_.sag &&
                                                         off(a.v, at(0.75).v, b.v, 0.75) <= sampling_.sag));
    if (close || depth == kDeepestHalving) return;
    sample(curve, a, middle, depth + 1, out);
    out.push_back(middle.v);
    sample(curve, middle, b, depth + 1, out);
  }

  const surface::LimitSurface& surface_;
  const LightView& view_;
  const Topology& topology_;
  std::span<const FaceTrace> traces_;
  BorderSampling sampling_;
  std::vector<CurveStops> curves_;
  std::vector<Sides> sides_;  // of parts
  Partition stops_{0};
  std::vector<std::uint32_t> node_;  // in the graph, of each set of stops
  JoinedArcs out_;
};

}  // namespace

JoinedArcs join_traces(const surface::LimitSurface& surface, const LightView& view, const Topology& topology,
                       std::span<const FaceTrace> traces, const BorderSampling& sampling) {
  return Joiner(surface, view, topology, traces, sampling).run();
}

}  // namespace gnomon::outline
