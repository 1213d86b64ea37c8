// SPDX-License-Identifier: Apache-2.0
// Edges walked in steps so short that no pixel escapes.
#include "host/pipeline/slb_touched.hpp"

#include <algorithm>
#include <cmath>
#include <gnomon/golden/slb/formats.hpp>

namespace gnomon::pipeline {
namespace {

// Pixels. Vertices are moved by less than 0.012 (half a sub-pixel of 2^-6 each way), points between steps are
// half a step away.
constexpr double kStep = 0.125;
constexpr double kMargin = 0.2;
constexpr double kCountStep = 0.5;

template <class Visit>
void walk(const outline::Vertex& from, const outline::Vertex& to, double step, Visit visit) {
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const int steps = std::max(1, static_cast<int>(std::ceil(length / step)));
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    visit(from.x + (to.x - from.x) * t, from.y + (to.y - from.y) * t);
  }
}

}  // namespace

SlbTouched::SlbTouched(std::span<const outline::ObjectOutline> outlines, int side) : side_(side) {
  const auto cells = static_cast<std::size_t>(side + 2) * static_cast<std::size_t>(side + 2);
  touched_.resize(cells);
  for (const outline::ObjectOutline& outline : outlines) {
    steps_.assign(cells, 0);  // winding numbers are an object's own
    for (const outline::Loop& loop : outline.loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const outline::Vertex &from = loop[i], &to = loop[(i + 1) % loop.size()];
        walk(from, to, kCountStep, [this](double x, double y) { count(x, y); });
        walk(from, to, kStep, [this](double x, double y) { mark(x, y); });
      }
    crowded_ = crowded_ || most_steps_around() > golden::slb::kWindingMax;
  }
  steps_ = {};
}

/// What lies beyond the plane to the left still winds around it; it is counted in the column beside it.
void SlbTouched::count(double x, double y) {
  const double column = std::max(std::floor(x), -1.0), row = std::floor(y);
  if (column > side_ || row < -1 || row > side_) return;
  ++steps_[index(static_cast<int>(column), static_cast<int>(row))];
}

void SlbTouched::mark(double x, double y) {
  if (std::min(x, y) < -0.5 || std::max(x, y) > side_ + 0.5) return;
  for (const double column : {std::floor(x - kMargin), std::floor(x + kMargin)})
    for (const double row : {std::floor(y - kMargin), std::floor(y + kMargin)})
      touched_[index(static_cast<int>(column), static_cast<int>(row))] = 1;
}

std::size_t SlbTouched::index(int column, int row) const {
  return static_cast<std::size_t>(row + 1) * static_cast<std::size_t>(side_ + 2) +
         static_cast<std::size_t>(column + 1);
}

/// Every crossing of a pixel's border has a step in the pixel or beside it.
std::uint32_t SlbTouched::most_steps_around() const {
  const std::size_t stride = static_cast<std::size_t>(side_) + 2;
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
  return touched_[index(static_cast<int>(column), static_cast<int>(row))] != 0;
}

}  // namespace gnomon::pipeline
