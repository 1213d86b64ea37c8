// SPDX-License-Identifier: Apache-2.0
// Questions about closed loops in the plane.
#pragma once

#include <vector>

#include "host/outline/outline.hpp"

namespace gnomon::outline::test {

/// Loops of one object, by rows of the plane, so that many points can be asked.
class LoopSet {
 public:
  explicit LoopSet(const std::vector<Loop>& loops);
  /// How often the loops run around the point.
  int winding(double x, double y) const;
  /// Pixels to the nearest edge, at most `limit` (which is at most 1).
  double distance(double x, double y, double limit) const;

 private:
  struct Edge {
    Vertex a, b;
  };
  const std::vector<Edge>* row(double y) const;
  std::vector<std::vector<Edge>> rows_;
  int first_row_ = 0;
};

/// Positive if the loop runs anticlockwise.
double signed_area(const Loop& loop);
double length(const Loop& loop);

}  // namespace gnomon::outline::test
