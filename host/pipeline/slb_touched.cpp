// SPDX-License-Identifier: Apache-2.0
// Edges walked in steps that no pixel escapes by more than its neighbour.
#include "host/pipeline/slb_touched.hpp"

#include <algorithm>
#include <cmath>
#include <gnomon/golden/slb/formats.hpp>

namespace gnomon::pipeline {
namespace {

constexpr double kStep = 0.5;  // pixels

}  // namespace

SlbTouched::SlbTouched(std::span<const outline::ObjectOutline> outlines, int side) : side_(side) {
  const auto cells = static_cast<std::size_t>(side + 2) * static_cast<std::size_t>(side + 2);
  touched_.resize(cells);
  for (const outline::ObjectOutline& outline : outlines) {
    steps_.assign(cells, 0);  // winding numbers are an object's own
    for (const outline::Loop& loop : outline.loops)
      for (std::size_t i = 0; i < loop.size(); ++i) walk(loop[i], loop[(i + 1) % loop.size()]);
    crowded_ = crowded_ || most_steps_around() > golden::slb::kWindingMax;
  }
  steps_ = {};
}

void SlbTouched::walk(const outline::Vertex& from, const outline::Vertex& to) {
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const int steps = std::max(1, static_cast<int>(std::ceil(length / kStep)));
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    mark(from.x + (to.x - from.x) * t, from.y + (to.y - from.y) * t);
  }
}

void SlbTouched::mark(double x, double y) {
  const double column = std::floor(x), row = std::floor(y);
  // What lies beyond the plane to the left still winds around it; it is counted in the column beside it.
  if (column > side_ || row < -1 || row > side_) return;
  const int stride = side_ + 2;
  const int at_x = static_cast<int>(std::max(column, -1.0)) + 1, at_y = static_cast<int>(row) + 1;
  ++steps_[static_cast<std::size_t>(at_y * stride + at_x)];
  for (int y1 = std::max(at_y - 1, 0); y1 <= std::min(at_y + 1, stride - 1); ++y1)
    for (int x1 = std::max(at_x - 1, 0); x1 <= std::min(at_x + 1, stride - 1); ++x1)
      touched_[static_cast<std::size_t>(y1 * stride + x1)] = 1;
}

/// Every crossing of a pixel's border has a step in the pixel or beside it.
std::uint32_t SlbTouched::most_steps_around() const {
  const auto stride = static_cast<std::size_t>(side_ + 2);
  std::uint32_t most = 0;
  for (std::size_t y = 1; y + 1 < stride; ++y)
    for (std::size_t x = 1; x + 1 < stride; ++x) {
      std::uint32_t sum = 0;
      for (std::size_t row = y - 1; row <= y + 1; ++row)
        for (std::size_t column = x - 1; column <= x + 1; ++column) sum += steps_[row * stride + column];
      most = std::max(most, sum);
    }
  return most;
}

bool SlbTouched::at(const Vec2& pixel) const {
  const double column = std::floor(pixel.x), row = std::floor(pixel.y);
  if (std::min(column, row) < 0 || std::max(column, row) >= side_) return false;
  const auto index = (static_cast<int>(row) + 1) * (side_ + 2) + static_cast<int>(column) + 1;
  return touched_[static_cast<std::size_t>(index)] != 0;
}

}  // namespace gnomon::pipeline
