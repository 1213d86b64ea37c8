// SPDX-License-Identifier: Apache-2.0
// Mean border displacement by stratified samples.
#include "host/slb/border_samples.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

namespace gnomon::slb {
namespace {

using golden::slb::SlbConfig;

/// An outline this near to a pixel touches it: far more than any rounding of it, far less than a sample's
/// distance.
constexpr double kTouch = 1e-3;
/// Pieces of border a pixel, and how far beside the outline its two sides are asked.
constexpr double kPiecesPerPixel = 16, kBeside = 1e-6;

/// Which pixels an outline touches.
class TouchedPixels {
 public:
  explicit TouchedPixels(const PolygonReference& reference)
      : side_(reference.side()), touched_(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_)) {
    for (const OutlineEdge& edge : reference.edges()) mark(edge);
  }
  bool at(int column, int row) const {
    return column >= 0 && row >= 0 && column < side_ && row < side_ && touched_[index(column, row)];
  }
  bool around(int column, int row) const {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        if (at(column + dx, row + dy)) return true;
      }
    }
    return false;
  }

 private:
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(side_) + static_cast<std::size_t>(column);
  }
  int pixel(double v) const { return static_cast<int>(std::floor(std::clamp(v, -1.0, side_ + 0.0))); }

  /// Row by row: the columns between where the edge enters the row and where it leaves it.
  void mark(const OutlineEdge& edge) {
    const Vec2 low = edge.from.y <= edge.to.y ? edge.from : edge.to;
    const Vec2 high = edge.from.y <= edge.to.y ? edge.to : edge.from;
    const double rise = high.y - low.y;
    const auto x_at = [&](double y) {
      return rise == 0 ? low.x : low.x + (high.x - low.x) * std::clamp((y - low.y) / rise, 0.0, 1.0);
    };
    const int last = std::min(side_ - 1, pixel(high.y + kTouch));
    for (int row = std::max(0, pixel(low.y - kTouch)); row <= last; ++row) {
      double left = x_at(row - kTouch), right = rise == 0 ? high.x : x_at(row + 1 + kTouch);
      if (left > right) std::swap(left, right);
      const int end = std::min(side_ - 1, pixel(right + kTouch));
      for (int column = std::max(0, pixel(left - kTouch)); column <= end; ++column)
        touched_[index(column, row)] = true;
    }
  }

  int side_;
  std::vector<bool> touched_;
};

/// The centre of the shadow map's texel that holds the point.
Vec2 texel_centre(const Vec2& point, double texels_per_pixel) {
  return {(std::floor(point.x * texels_per_pixel) + 0.5) / texels_per_pixel,
          (std::floor(point.y * texels_per_pixel) + 0.5) / texels_per_pixel};
}

/// Length of the outline that has shadow on one side and light on the other.
double border_length(const PolygonReference& reference) {
  double length = 0;
  for (const OutlineEdge& edge : reference.edges()) {
    const Vec2 along = edge.to - edge.from;
    const double whole = along.length();
    if (whole == 0) continue;
    const Vec2 beside = Vec2(-along.y, along.x) * (kBeside / whole);
    const auto pieces = static_cast<int>(std::ceil(whole * kPiecesPerPixel));
    for (int i = 0; i < pieces; ++i) {
      const Vec2 middle = edge.from + along * ((i + 0.5) / pieces);
      const bool on_plane =
          middle.x >= 0 && middle.y >= 0 && middle.x < reference.side() && middle.y < reference.side();
      if (on_plane && reference.covered(middle + beside) != reference.covered(middle - beside))
        length += whole / pieces;
    }
  }
  return length;
}

/// Fills a BorderSamples pixel by pixel.
class Sampler {
 public:
  Sampler(const PolygonReference& reference, const SlbConfig& config, const SampleOptions& options)
      : reference_(reference), config_(config), random_(options.seed) {}

  /// cells x cells points, one in each cell of the pixel.
  void pixel(int column, int row, int cells) {
    const double size = 1.0 / cells;
    for (int j = 0; j < cells; ++j) {
      for (int i = 0; i < cells; ++i)
        point({column + (i + unit()) * size, row + (j + unit()) * size}, static_cast<float>(size * size));
    }
  }
  BorderSamples take() {
    samples_.border = border_length(reference_);
    return std::move(samples_);
  }

 private:
  double unit() { return std::ldexp(static_cast<double>(random_() >> 11), -53); }

  void point(const Vec2& place, float weight) {
    const double one = std::ldexp(1.0, config_.query_bits);
    const auto x = static_cast<std::int64_t>(std::floor(place.x * one));
    const auto y = static_cast<std::int64_t>(std::floor(place.y * one));
    // Where the unit reads it: no error of the query's own rounding is measured.
    const Vec2 read{(static_cast<double>(x) + 0.5) / one, (static_cast<double>(y) + 0.5) / one};
    const bool shadow = reference_.covered(read);
    samples_.queries.push_back({x, y, config_.no_depth()});
    samples_.weights.push_back(weight);
    samples_.shadow.push_back(shadow);
    if (reference_.covered(texel_centre(read, 1)) != shadow)
      samples_.plain_wrong += static_cast<double>(weight);
    if (reference_.covered(texel_centre(read, std::ldexp(1.0, config_.frac_bits))) != shadow)
      samples_.fine_wrong += static_cast<double>(weight);
  }

  const PolygonReference& reference_;
  SlbConfig config_;
  std::mt19937_64 random_;
  BorderSamples samples_;
};

}  // namespace

BorderSamples border_samples(const PolygonReference& reference, const SlbConfig& config,
                             const SampleOptions& options) {
  if (reference.side() != config.side()) throw std::invalid_argument("reference and plane differ in size");
  const TouchedPixels touched(reference);
  Sampler sampler(reference, config, options);
  const int cells = std::max(1, static_cast<int>(std::ceil(std::sqrt(options.per_pixel))));
  const int cells_around = std::max(1, static_cast<int>(std::ceil(std::sqrt(options.per_pixel / 8.0))));
  for (int row = 0; row < config.side(); ++row) {
    for (int column = 0; column < config.side(); ++column)
      sampler.pixel(column, row,
                    touched.at(column, row)       ? cells
                    : touched.around(column, row) ? cells_around
                                                  : 1);
  }
  return sampler.take();
}

Displacement displacement(const BorderSamples& samples, std::span<const golden::slb::QueryAnswer> answers) {
  if (answers.size() != samples.queries.size()) throw std::invalid_argument("an answer a sample is needed");
  Displacement result;
  result.border = samples.border;
  result.samples = answers.size();
  double wrong_area = 0;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    if (answers[i].shadow == samples.shadow[i]) continue;
    ++result.wrong;
    wrong_area += static_cast<double>(samples.weights[i]);
  }
  if (samples.border > 0) {
    result.buffer = wrong_area / samples.border;
    result.plain_map = samples.plain_wrong / samples.border;
    result.fine_map = samples.fine_wrong / samples.border;
  }
  return result;
}

}  // namespace gnomon::slb
