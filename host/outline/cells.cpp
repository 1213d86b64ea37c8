// SPDX-License-Identifier: Apache-2.0
// Recursion over the halves of a face: by proof where it is a polynomial, by samples elsewhere.
#include "host/outline/cells.hpp"

#include <algorithm>

namespace gnomon::outline {
namespace {

/// Halvings along one parameter; beyond, refinement would only follow a cusp.
constexpr int kDeepest = 16;

struct Node {
  Cell cell;
  int u_depth, v_depth;
};

class CellFinder {
 public:
  CellFinder(const surface::LimitSurface& surface, const LightView& view, std::uint32_t face, double size)
      : surface_(surface), view_(view), face_(face), size_(size / view.scale()) {}

  FaceCells run() {
    visit({{0, 0, 1, 1}, 0, 0});
    if (!signs_[static_cast<int>(Sign::Mixed)] &&
        signs_[static_cast<int>(Sign::Plus)] != signs_[static_cast<int>(Sign::Minus)]) {
      found_.sign = signs_[static_cast<int>(Sign::Plus)] ? Sign::Plus : Sign::Minus;
      found_.cells.clear();
    }
    return std::move(found_);
  }

 private:
  void keep(const Node& n, Sign sign) {
    found_.cells.push_back(n.cell);
    signs_[static_cast<int>(sign)] = true;
  }

  Stance at(const Node& n, double s, double t) const {
    const Cell& c = n.cell;
    return stance(surface_, view_, {face_, c.u0 + s * (c.u1 - c.u0), c.v0 + t * (c.v1 - c.v0)});
  }

  /// Which parameters to halve; by the middle's tangents.
  struct Cut {
    bool u, v;
  };
  Cut cut(const Node& n, const Stance& middle) const {
    return {middle.du.length() * (n.cell.u1 - n.cell.u0) > size_ &&
            n.u_depth<kDeepest, middle.dv.length() * (n.cell.v1 - n.cell.v0)> size_ && n.v_depth < kDeepest};
  }

  static std::pair<Node, Node> halves(const Node& n, bool along_u) {
    std::pair<Node, Node> h{n, n};
    if (along_u) {
      h.first.cell.u1 = h.second.cell.u0 = 0.5 * (n.cell.u0 + n.cell.u1);
      ++h.first.u_depth;
      ++h.second.u_depth;
    } else {
      h.first.cell.v1 = h.second.cell.v0 = 0.5 * (n.cell.v0 + n.cell.v1);
      ++h.first.v_depth;
      ++h.second.v_depth;
    }
    return h;
  }

  /// Any cell: as large as the pieces under it, so far.
  void visit(const Node& n) {
    const Cell& c = n.cell;
    const auto region = surface_.pieces(face_).region(c.u0, c.v0, c.u1, c.v1);
    if (region.whole && region.patch != nullptr) {
      const Stance middle = at(n, 0.5, 0.5);
      const double unit = middle.du.length() * middle.dv.length() * region.size * region.size *
                          view_.frame().x.cross(view_.frame().y).length();
      visit_polynomial(n, FacingPolynomial(*region.patch, view_), kEdgeOn * unit);
    } else if (region.whole) {
      visit_samples(n);
    } else {
      ++found_.visited;
      const Cut wanted = cut(n, at(n, 0.5, 0.5));
      if (!wanted.u && !wanted.v) return keep(n, Sign::Mixed);
      const auto [left, right] = halves(n, true);
      for (const Node& half : {left, right}) {
        const auto [low, high] = halves(half, false);
        visit(low);
        visit(high);
      }
    }
  }

  void visit_polynomial(const Node& n, const FacingPolynomial& facing, double edge_on) {
    ++found_.visited;
    const Sign sign = facing.sign(edge_on);
    if (sign != Sign::Mixed) return keep(n, sign);
    const Cut wanted = cut(n, at(n, 0.5, 0.5));
    if (!wanted.u && !wanted.v) return keep(n, Sign::Mixed);
    const bool along_u = wanted.u && (!wanted.v || n.u_depth <= n.v_depth);
    const auto [low, high] = halves(n, along_u);
    const auto [facing_low, facing_high] = facing.halves(along_u);
    visit_polynomial(low, facing_low, edge_on);
    visit_polynomial(high, facing_high, edge_on);
  }

  void visit_samples(const Node& n) {
    ++found_.visited;
    const Stance middle = at(n, 0.5, 0.5);
    double least = middle.cosine;
    double most = middle.cosine;
    for (const double t : {0.0, 0.5, 1.0})
      for (const double s : {0.0, 0.5, 1.0}) {
        const double cosine = at(n, s, t).cosine;
        least = std::min(least, cosine);
        most = std::max(most, cosine);
      }
    const double doubt = 0.5 * (most - least);
    if (least > std::max(doubt, kEdgeOn)) return keep(n, Sign::Plus);
    if (most <= std::max(-doubt, kEdgeOn) && doubt <= std::max(-most, kEdgeOn)) return keep(n, Sign::Minus);
    const Cut wanted = cut(n, middle);
    if (!wanted.u && !wanted.v) return keep(n, Sign::Mixed);
    const auto [low, high] = halves(n, wanted.u && (!wanted.v || n.u_depth <= n.v_depth));
    visit_samples(low);
    visit_samples(high);
  }

  const surface::LimitSurface& surface_;
  const LightView& view_;
  std::uint32_t face_;
  double size_;
  FaceCells found_;
  std::array<bool, 3> signs_{};
};

}  // namespace

FaceCells find_cells(const surface::LimitSurface& surface, const LightView& view, std::uint32_t face,
                     double size) {
  return CellFinder(surface, view, face, size).run();
}

}  // namespace gnomon::outline
