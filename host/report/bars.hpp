// SPDX-License-Identifier: Apache-2.0
// Horizontal bars as inline SVG that stretches with the page; labels are the page's own text, so that they
// never shrink.
#pragma once

#include <span>
#include <string>

namespace gnomon::report {

/// One piece of a bar.
struct Segment {
  std::string style;  ///< class of the page's style sheet that gives the colour
  std::string label;  ///< told on hovering
  double value = 0;   ///< at least 0
};

/// The segments one after the other, `full` being the whole width; `label` is what a screen reader says.
std::string stacked_bar(std::span<const Segment> segments, double full, const std::string& label);

/// A bar that starts at `start`: one line of a waterfall.
std::string waterfall_bar(const Segment& segment, double start, double full, const std::string& label);

}  // namespace gnomon::report
