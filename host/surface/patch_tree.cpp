// SPDX-License-Identifier: Apache-2.0
// Finds the polynomial pieces of a face by fitting and checking.
#include "host/surface/patch_tree.hpp"

#include <algorithm>
#include <cmath>

namespace gnomon::surface {
namespace {

// A bicubic is sampled away from its borders, where Bfr might answer from a neighbouring piece.
constexpr std::array kSamples{0.125, 0.375, 0.625, 0.875};

// Bezier ordinates of the cubic with given values at the samples.
constexpr double kToBezier[4][4] = {{35. / 16, -35. / 16, 21. / 16, -5. / 16},
                                    {-253. / 144, 271. / 48, -185. / 48, 139. / 144},
                                    {139. / 144, -185. / 48, 271. / 48, -253. / 144},
                                    {-5. / 16, 21. / 16, -35. / 16, 35. / 16}};

// A fit counts as the surface itself where it errs by no more than this share of the face's size.
constexpr double kTolerance = 0x1p-36;

// Pieces that span fewer grid units are not worth a fit: Bfr answers for the few points in them.
constexpr double kDirectExtent = 6;
constexpr int kDeepestLevel = 12;

using Grid4 = std::array<std::array<Lane4, 4>, 4>;

// Applies `m` along the first index: out[i] = sum m[i][k] in[k].
Grid4 apply_first(const double (&m)[4][4], const Grid4& in) {
  Grid4 out{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      for (std::size_t j = 0; j < 4; ++j) {
        for (std::size_t x = 0; x < 4; ++x) out[i][j].x[x] += m[i][k] * in[k][j].x[x];
      }
    }
  }
  return out;
}

Grid4 transposed(const Grid4& in) {
  Grid4 out;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) out[i][j] = in[j][i];
  }
  return out;
}

Grid4 apply_both(const double (&m)[4][4], const Grid4& in) {
  return transposed(apply_first(m, transposed(apply_first(m, in))));
}

constexpr double kBezierToPower[4][4] = {{1, 0, 0, 0}, {-3, 3, 0, 0}, {3, -6, 3, 0}, {-1, 3, -3, 1}};

// The largest coordinate of three times the differences along the first index bounds the derivative: hull
// property.
double speed_bound(const Grid4& bezier) {
  double largest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t x = 0; x < 3; ++x)
        largest = std::max(largest, std::abs(bezier[i + 1][j].x[x] - bezier[i][j].x[x]));
    }
  }
  return 3 * largest;
}

double extent(const Grid4& points) {
  Box3 box;
  for (const auto& row : points) {
    for (const Lane4& p : row) box.extendBy(Vec3(p.x[0], p.x[1], p.x[2]));
  }
  const Vec3 size = box.size();
  return std::max({size.x, size.y, size.z});
}

}  // namespace

struct PatchTree::Square {
  double u, v, size;
  int level;
};

class PatchTree::Builder {
 public:
  Builder(PatchTree& tree, const FaceSource& source, ParametricFace face)
      : tree_(tree), source_(source), face_(face) {
    tree_.nodes_.emplace_back();
    build(0, {0, 0, 1, 0});
  }

 private:
  Vec3 at(const Square& s, double u, double v) const {
    return source_.position(face_, s.u + u * s.size, s.v + v * s.size);
  }

  Grid4 sample(const Square& s) const {
    Grid4 g{};
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) {
        const Vec3 p = at(s, kSamples[i], kSamples[j]);
        g[i][j].x = {p.x, p.y, p.z, 0};
      }
    }
    return g;
  }

  bool matches(const Square& s, const Patch& patch, double u, double v) const {
    const Lane4 fit = cubic(patch.row(v), u);
    const Vec3 p = at(s, u, v);
    return std::abs(fit.x[0] - p.x) <= tolerance_ && std::abs(fit.x[1] - p.y) <= tolerance_ &&
           std::abs(fit.x[2] - p.z) <= tolerance_;
  }

  // What is irregular lies at the corners and along the sides of the face, so only squares that touch them
  // can differ from a polynomial; there the difference is largest on the touching side.
  bool is_polynomial(const Square& s, const Patch& patch) const {
    const double end = 1 - s.size;
    if (source_.regular(face_.cage_face) || (s.u > 0 && s.v > 0 && s.u < end && s.v < end)) return true;
    for (const double t : {0.0, 1.0, 0.5, 0.0625, 0.9375}) {
      if ((s.u == 0 && !matches(s, patch, 0, t)) || (s.v == 0 && !matches(s, patch, t, 0)) ||
          (s.u == end && !matches(s, patch, 1, t)) || (s.v == end && !matches(s, patch, t, 1))) {
        return false;
      }
    }
    return matches(s, patch, 0.5, 0.5);
  }

  void build(std::size_t node, const Square& s) {
    const Grid4 bezier = apply_both(kToBezier, sample(s));
    if (s.level == 0) tolerance_ = kTolerance * extent(bezier);
    const Patch patch{apply_both(kBezierToPower, bezier)};
    tree_.nodes_[node].u_speed = speed_bound(bezier) / s.size;
    tree_.nodes_[node].v_speed = speed_bound(transposed(bezier)) / s.size;
    if (is_polynomial(s, patch)) {
      tree_.nodes_[node].patch = static_cast<std::int32_t>(tree_.patches_.size());
      tree_.patches_.push_back(patch);
    } else if (extent(bezier) > kDirectExtent && s.level < kDeepestLevel) {
      subdivide(node, s);
    }
  }

  void subdivide(std::size_t node, const Square& s) {
    const std::size_t first = tree_.nodes_.size();
    tree_.nodes_[node].children = static_cast<std::int32_t>(first);
    tree_.nodes_.resize(first + 4);
    double u_speed = 0;
    double v_speed = 0;
    for (std::size_t c = 0; c < 4; ++c) {
      const double half = s.size / 2;
      build(first + c, {s.u + (c % 2 == 0 ? 0 : half), s.v + (c < 2 ? 0 : half), half, s.level + 1});
      u_speed = std::max(u_speed, tree_.nodes_[first + c].u_speed);
      v_speed = std::max(v_speed, tree_.nodes_[first + c].v_speed);
    }
    tree_.nodes_[node].u_speed = u_speed;
    tree_.nodes_[node].v_speed = v_speed;
  }

  PatchTree& tree_;
  const FaceSource& source_;
  ParametricFace face_;
  double tolerance_ = 0;
};

PatchTree::PatchTree(const FaceSource& source, ParametricFace face) {
  Builder(*this, source, face);
  nodes_.shrink_to_fit();
  patches_.shrink_to_fit();
}

PatchTree::Hit PatchTree::find(double u, double v) const {
  double scale = 1;
  std::size_t node = 0;
  while (nodes_[node].children >= 0) {
    u *= 2;
    v *= 2;
    scale *= 2;
    const bool right = u >= 1;
    const bool upper = v >= 1;
    u -= right ? 1 : 0;
    v -= upper ? 1 : 0;
    node = static_cast<std::size_t>(nodes_[node].children) + (right ? 1U : 0U) + (upper ? 2U : 0U);
  }
  const std::int32_t patch = nodes_[node].patch;
  return {patch < 0 ? nullptr : &patches_[static_cast<std::size_t>(patch)], u, v, scale};
}

PatchTree::Region PatchTree::region(double u0, double v0, double u1, double v1) const {
  Square s{0, 0, 1, 0};
  std::size_t node = 0;
  while (nodes_[node].children >= 0) {
    const double half = s.size / 2;
    const bool right = u0 >= s.u + half;
    const bool upper = v0 >= s.v + half;
    if ((!right && u1 > s.u + half) || (!upper && v1 > s.v + half)) break;
    s = {s.u + (right ? half : 0), s.v + (upper ? half : 0), half, s.level + 1};
    node = static_cast<std::size_t>(nodes_[node].children) + (right ? 1U : 0U) + (upper ? 2U : 0U);
  }
  const Node& n = nodes_[node];
  return {n.patch < 0 ? nullptr : &patches_[static_cast<std::size_t>(n.patch)],
          n.children < 0,
          s.u,
          s.v,
          s.size,
          n.u_speed,
          n.v_speed};
}

}  // namespace gnomon::surface
