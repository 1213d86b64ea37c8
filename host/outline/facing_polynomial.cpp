// SPDX-License-Identifier: Apache-2.0
// Products of derivatives in powers, turned into Bernstein form and halved there.
#include "host/outline/facing_polynomial.hpp"

#include <algorithm>

namespace gnomon::outline {
namespace {

/// a[i][j] u^i v^j, of at most degree 5 each.
using Powers = std::array<std::array<double, 6>, 6>;

/// One plane coordinate of a bicubic.
Powers coordinate(const surface::Patch& patch, const Vec3& axis) {
  Powers a{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      const auto& c = patch.c[i][j].x;
      a[i][j] = axis.dot(Vec3(c[0], c[1], c[2]));
    }
  return a;
}

Powers by_u(const Powers& a) {
  Powers d{};
  for (std::size_t i = 1; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) d[i - 1][j] = static_cast<double>(i) * a[i][j];
  return d;
}

Powers by_v(const Powers& a) {
  Powers d{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 1; j < 4; ++j) d[i][j - 1] = static_cast<double>(j) * a[i][j];
  return d;
}

/// into += factor * a * b, with a of degree 2 x 3 and b of degree 3 x 2.
void add_product(Powers& into, double factor, const Powers& a, const Powers& b) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t k = 0; k < 4; ++k)
        for (std::size_t l = 0; l < 3; ++l) into[i + k][j + l] += factor * a[i][j] * b[k][l];
}

/// Bernstein coefficients of degree 5: b_k = sum over i <= k of C(k,i) / C(5,i) a_i.
template <class Row>
Row to_bernstein(const Row& a) {
  constexpr double kBinomial[6][6] = {{1, 0, 0, 0, 0, 0}, {1, 1, 0, 0, 0, 0}, {1, 2, 1, 0, 0, 0},
                                      {1, 3, 3, 1, 0, 0}, {1, 4, 6, 4, 1, 0}, {1, 5, 10, 10, 5, 1}};
  Row b{};
  for (std::size_t k = 0; k < 6; ++k)
    for (std::size_t i = 0; i <= k; ++i) b[k] += kBinomial[k][i] / kBinomial[5][i] * a[i];
  return b;
}

template <class Matrix>
Matrix transposed(const Matrix& m) {
  Matrix t{};
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) t[i][j] = m[j][i];
  return t;
}

/// De Casteljau at one half, of numbers or of whole rows.
template <class Row>
std::pair<Row, Row> halve(Row b) {
  Row low{};
  Row high{};
  for (std::size_t n = 6; n-- > 0;) {
    low[5 - n] = b[0];
    high[n] = b[n];
    for (std::size_t i = 0; i < n; ++i) b[i] = 0.5 * (b[i] + b[i + 1]);
  }
  return {low, high};
}

}  // namespace

FacingPolynomial::FacingPolynomial(const surface::Patch& patch, const LightView& view) {
  const Powers x = coordinate(patch, view.frame().x);
  const Powers y = coordinate(patch, view.frame().y);
  const double side = view.mirrored() ? -1 : 1;
  Powers f{};
  add_product(f, side, by_u(x), by_v(y));
  add_product(f, -side, by_u(y), by_v(x));
  for (auto& row : f) row = to_bernstein(row);
  f = transposed(f);
  for (auto& row : f) row = to_bernstein(row);
  b_ = transposed(f);
}

Sign FacingPolynomial::sign(double edge_on) const {
  double least = b_[0][0];
  double most = b_[0][0];
  for (const Row& row : b_) {
    const auto [low, high] = std::minmax_element(row.begin(), row.end());
    least = std::min(least, *low);
    most = std::max(most, *high);
  }
  if (most <= edge_on) return Sign::Minus;
  return least > edge_on ? Sign::Plus : Sign::Mixed;
}

std::pair<FacingPolynomial, FacingPolynomial> FacingPolynomial::halves(bool along_u) const {
  std::pair<FacingPolynomial, FacingPolynomial> out{FacingPolynomial(), FacingPolynomial()};
  const auto b = along_u ? transposed(b_) : b_;
  for (std::size_t i = 0; i < kCount; ++i) std::tie(out.first.b_[i], out.second.b_[i]) = halve(b[i]);
  if (along_u) {
    out.first.b_ = transposed(out.first.b_);
    out.second.b_ = transposed(out.second.b_);
  }
  return out;
}

}  // namespace gnomon::outline
