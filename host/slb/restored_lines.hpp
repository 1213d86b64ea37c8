// SPDX-License-Identifier: Apache-2.0
// The lines of an entry as they are read back, in real numbers, for drawing.
#pragma once

#include <gnomon/golden/slb/formats.hpp>
#include <vector>

#include "host/base/vec.hpp"

namespace gnomon::slb {

/// minor = at_zero + slope * major inside the pixel, both 0..1.
struct RestoredLine {
  bool y_major = false;
  bool inner = false;  ///< the caster is where minor is larger
  double at_zero = 0, slope = 0;

  /// Minor distance of the point from the line: positive on the caster's side.
  double depth_inside(const Vec2& in_pixel) const;
  /// Shortest distance, plane pixels.
  double distance(const Vec2& in_pixel) const;
};
RestoredLine restore(const golden::slb::Line& line, const golden::slb::SlbConfig& config);

/// One object in a pixel.
struct RestoredGroup {
  struct Chain {
    golden::slb::FragmentOp op;  ///< One, And or Or
    std::size_t a, b;            ///< indices of lines; b with And and Or
  };
  std::uint8_t object = 0;
  std::uint32_t depth = 0;
  int threshold = 1;
  std::vector<RestoredLine> lines;
  std::vector<Chain> chains;

  bool covers(const Vec2& in_pixel) const;
  /// Whether crossing that line near the point changes what the group covers.
  bool bounds(std::size_t line, const Vec2& in_pixel) const;

 private:
  bool covers_with(const std::vector<bool>& inside) const;
  std::vector<bool> inside_of(const Vec2& in_pixel) const;
};
std::vector<RestoredGroup> restore(const golden::slb::Entry& entry, const golden::slb::SlbConfig& config);

}  // namespace gnomon::slb
