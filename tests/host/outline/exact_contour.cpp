// SPDX-License-Identifier: Apache-2.0
// Signs of N.L on a grid, zeros by bisection, triangles.
#include "exact_contour.hpp"

#include <array>

namespace gnomon::outline::test {
namespace {

class Finder {
 public:
  Finder(const surface::LimitSurface& surface, const LightFrame& frame, int n)
      : surface_(surface), frame_(frame), light_(frame.x.cross(frame.y)), n_(n) {}

  std::vector<Loop> run() {
    for (face_ = 0; face_ < surface_.face_count(); ++face_) {
      const auto side = static_cast<std::size_t>(n_) + 1;
      std::vector<Node> nodes;
      nodes.reserve(side * side);
      for (int j = 0; j <= n_; ++j)
        for (int i = 0; i <= n_; ++i) nodes.push_back(node(double(i) / n_, double(j) / n_));
      for (std::size_t j = 0; j + 1 < side; ++j)
        for (std::size_t i = 0; i + 1 < side; ++i) {
          const std::size_t k = j * side + i;
          triangle({nodes[k], nodes[k + 1], nodes[k + side + 1]});
          triangle({nodes[k], nodes[k + side + 1], nodes[k + side]});
        }
    }
    return std::move(pieces_);
  }

 private:
  struct Node {
    double u, v;
    bool plus;
  };

  Node node(double u, double v) const { return {u, v, surface_.normal(face_, u, v).dot(light_) > 0}; }

  Vertex zero(Node a, Node b) const {
    for (int step = 0; step < 40; ++step) {
      const Node middle = node((a.u + b.u) / 2, (a.v + b.v) / 2);
      (middle.plus == a.plus ? a : b) = middle;
    }
    const Vec3 p = surface_.position(face_, a.u, a.v);
    const Vec2 xy = frame_.pixel(p);
    return {xy.x, xy.y, frame_.code(p)};
  }

  void triangle(const std::array<Node, 3>& t) {
    Loop piece;
    for (std::size_t i = 0; i < 3; ++i)
      if (t[i].plus != t[(i + 1) % 3].plus) piece.push_back(zero(t[i], t[(i + 1) % 3]));
    if (!piece.empty()) pieces_.push_back(piece);
  }

  const surface::LimitSurface& surface_;
  LightFrame frame_;
  Vec3 light_;
  int n_;
  std::uint32_t face_ = 0;
  std::vector<Loop> pieces_;
};

}  // namespace

std::vector<Loop> exact_contour(const surface::LimitSurface& surface, const LightFrame& frame, int n) {
  return Finder(surface, frame, n).run();
}

}  // namespace gnomon::outline::test
