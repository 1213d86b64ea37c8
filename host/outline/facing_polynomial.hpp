// SPDX-License-Identifier: Apache-2.0
// N.L over a rectangle of a polynomial piece, with proof of its sign. Theory: docs/outline.md, "Cells".
#pragma once

#include <array>
#include <utility>

#include "host/outline/facing.hpp"
#include "host/surface/patch_tree.hpp"

namespace gnomon::outline {

enum class Sign : std::uint8_t { Minus, Plus, Mixed };

/// The Jacobian of the projection of a bicubic, degree 5 x 5, in Bernstein form: it lies between its smallest
/// and largest coefficient.
class FacingPolynomial {
 public:
  FacingPolynomial(const surface::Patch& patch, const LightView& view);

  /// `edge_on`: what counts as zero, in the polynomial's own units.
  Sign sign(double edge_on) const;
  /// The same over the lower and the upper half of u, or of v.
  std::pair<FacingPolynomial, FacingPolynomial> halves(bool along_u) const;

 private:
  FacingPolynomial() = default;
  static constexpr std::size_t kCount = 6;  // coefficients of degree 5
  using Row = std::array<double, kCount>;
  std::array<Row, kCount> b_{};  // b_[i][j] belongs to u^i v^j
};

}  // namespace gnomon::outline
