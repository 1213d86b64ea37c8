// SPDX-License-Identifier: Apache-2.0
// Signs at corners, zeros between them, chords through the cells.
#include "host/outline/tracer.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "host/outline/perimeter.hpp"

namespace gnomon::outline {
namespace {

/// The zero of `f` between 0, where it is positive (f0), and 1, where it is not (f1): false position that
/// halves the value of an end that stays (Illinois).
template <class F>
double find_zero(double f0, double f1, F f) {
  constexpr double kFlat = 1e-13;
  double a = 0;
  double b = 1;
  int kept = 0;
  for (int step = 0; step < 60; ++step) {
    const double t = (a * f1 - b * f0) / (f1 - f0);
    const double ft = f(t);
    if (std::abs(ft) <= kFlat || b - a <= kFlat) return t;
    if (ft > 0) {
      a = t;
      f0 = ft;
      if (kept == 1) f1 *= 0.5;
      kept = 1;
    } else {
      b = t;
      f1 = ft;
      if (kept == -1) f0 *= 0.5;
      kept = -1;
    }
  }
  return 0.5 * (a + b);
}

class FaceTracer {
 public:
  FaceTracer(const surface::LimitSurface& surface, const LightView& view, std::uint32_t face,
             std::span<const Cell> cells)
      : surface_(surface), view_(view), face_(face), cells_(cells), corners_(cells) {
    for (std::uint32_t i = 0; i < corners_.size(); ++i) nodes_.push_back(node(corners_[i]));
  }

  FaceTrace run() {
    for (const Cell& cell : cells_) trace(cell);
    divide_border();
    return std::move(out_);
  }

 private:
  struct Node {
    Parameter at;
    double excess;  // of the cosine over what is edge-on
    bool plus() const { return excess > 0; }
  };

  double excess(const Parameter& p) const {
    return stance(surface_, view_, {face_, p.u, p.v}).cosine - kEdgeOn;
  }
  Node node(const Parameter& p) const { return {p, excess(p)}; }

  void trace(const Cell& cell) {
    const std::vector<std::uint32_t> ring = corners_.perimeter(cell);
    const std::size_t changes = count_changes(ring);
    if (changes == 2) {
      chord(ring);
    } else if (changes > 2) {
      const auto middle = static_cast<std::uint32_t>(nodes_.size());
      nodes_.push_back(node({0.5 * (cell.u0 + cell.u1), 0.5 * (cell.v0 + cell.v1)}));
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const std::array triangle{middle, ring[i], ring[(i + 1) % ring.size()]};
        if (count_changes(triangle) == 2) chord(triangle);
      }
    }
  }

  std::size_t count_changes(std::span<const std::uint32_t> ring) const {
    std::size_t changes = 0;
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (nodes_[ring[i]].plus() != nodes_[ring[(i + 1) % ring.size()]].plus()) ++changes;
    return changes;
  }

  /// The anticlockwise ring leaves plus at one crossing and comes back at the other.
  void chord(std::span<const std::uint32_t> ring) {
    FaceTrace::Arc arc{};
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::uint32_t a = ring[i];
      const std::uint32_t b = ring[(i + 1) % ring.size()];
      if (nodes_[a].plus() == nodes_[b].plus()) continue;
      (nodes_[a].plus() ? arc.from : arc.to) = nodes_[a].plus() ? crossing(a, b) : crossing(b, a);
    }
    out_.arcs.push_back(arc);
  }

  FaceTrace::End crossing(std::uint32_t plus, std::uint32_t minus) {
    const auto [known, fresh] = known_.try_emplace({plus, minus});
    if (fresh) known->second = find(nodes_[plus], nodes_[minus]);
    return known->second;
  }

  FaceTrace::End find(const Node& plus, const Node& minus) {
    const auto at = [&](double t) {
      return Parameter{plus.at.u + t * (minus.at.u - plus.at.u), plus.at.v + t * (minus.at.v - plus.at.v)};
    };
    const double t = find_zero(plus.excess, minus.excess, [&](double x) { return excess(at(x)); });
    const Parameter p = t == 1 ? minus.at : at(t);
    if (const int side = common_side(plus.at, minus.at); side >= 0) {
      out_.crossings.push_back({static_cast<std::uint32_t>(side), side % 2 == 0 ? p.u : p.v});
      return {true, static_cast<std::uint32_t>(out_.crossings.size() - 1)};
    }
    out_.points.push_back(view_.vertex(surface_.position(face_, p.u, p.v)));
    return {false, static_cast<std::uint32_t>(out_.points.size() - 1)};
  }

  static int common_side(const Parameter& a, const Parameter& b) {
    if (a.v == b.v && (a.v == 0 || a.v == 1)) return a.v == 0 ? 0 : 2;
    if (a.u == b.u && (a.u == 0 || a.u == 1)) return a.u == 0 ? 3 : 1;
    return -1;
  }

  void divide_border() {
    for (std::uint32_t side = 0; side < 4; ++side) {
      const bool rising = side < 2;
      std::vector<double> cuts;
      for (const FaceTrace::Crossing& c : out_.crossings)
        if (c.side == side) cuts.push_back(c.s);
      std::sort(cuts.begin(), cuts.end());
      if (!rising) std::reverse(cuts.begin(), cuts.end());
      double from = rising ? 0 : 1;
      bool plus = nodes_[corners_.index(side == 1 || side == 2 ? 1 : 0, side >= 2 ? 1 : 0)].plus();
      for (const double cut : cuts) {
        out_.stretches.push_back({side, from, cut, plus});
        from = cut;
        plus = !plus;
      }
      out_.stretches.push_back({side, from, rising ? 1.0 : 0.0, plus});
    }
  }

  const surface::LimitSurface& surface_;
  const LightView& view_;
  std::uint32_t face_;
  std::span<const Cell> cells_;
  CellCorners corners_;
  std::vector<Node> nodes_;  // the corners, then middles of cells
  std::map<std::pair<std::uint32_t, std::uint32_t>, FaceTrace::End> known_;
  FaceTrace out_;
};

FaceTrace one_sign(bool plus) {
  FaceTrace trace;
  trace.stretches = {{0, 0, 1, plus}, {1, 0, 1, plus}, {2, 1, 0, plus}, {3, 1, 0, plus}};
  return trace;
}

}  // namespace

FaceTrace trace_face(const surface::LimitSurface& surface, const LightView& view, std::uint32_t face,
                     double size) {
  const FaceCells found = find_cells(surface, view, face, size);
  FaceTrace trace = found.sign == Sign::Mixed ? FaceTracer(surface, view, face, found.cells).run()
                                              : one_sign(found.sign == Sign::Plus);
  trace.cells = found.visited;
  return trace;
}

}  // namespace gnomon::outline
