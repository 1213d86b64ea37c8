// SPDX-License-Identifier: Apache-2.0
// Which pixels of the silhouette-line buffer's plane may hold a line, whatever its words' widths. Theory:
// docs/sweep.md, "Shared work".
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/base/vec.hpp"
#include "host/outline/outline.hpp"

namespace gnomon::pipeline {

/// The pixels that outlines pass through or come near, as vertices are rounded.
class SlbTouched {
 public:
  /// `side`: pixels of the plane.
  SlbTouched(std::span<const outline::ObjectOutline> outlines, int side);

  /// Whether the pixel that holds the point may hold a line. False off the plane.
  bool at(const Vec2& pixel) const;
  /// So many edges meet in one place that a winding number there may saturate, which shows along the whole
  /// row: then no pixel is safe from lines elsewhere.
  bool crowded() const { return crowded_; }

 private:
  void count(double x, double y);
  void mark(double x, double y);
  std::size_t index(int column, int row) const;
  std::uint32_t most_steps_around() const;

  int side_;
  std::vector<std::uint32_t> steps_;  ///< by pixel of the plane and one more all around; of one object
  std::vector<std::uint8_t> touched_;
  bool crowded_ = false;
};

}  // namespace gnomon::pipeline
