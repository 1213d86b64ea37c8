// SPDX-License-Identifier: Apache-2.0
// What the silhouette-line buffer holds, as a picture.
#include "host/slb/buffer_picture.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "host/slb/restored_lines.hpp"

namespace gnomon::slb {
namespace {

using golden::slb::Entry;
using golden::slb::SlbConfig;

constexpr int kLeastScaleWithGrid = 6;

int interest(const Entry& entry) {
  if (entry.overflow) return 8;
  int interest = entry.count > 0 ? 1 : 0;
  for (std::size_t i = 0; i < entry.count; ++i) {
    if (entry.fragments[i].op != golden::slb::FragmentOp::One) interest += 2;
  }
  return interest;
}

/// Shortest distance of a point from an edge.
double distance(const OutlineEdge& edge, const Vec2& point) {
  const Vec2 along = edge.to - edge.from;
  const double squared = along.dot(along);
  const double t = squared == 0 ? 0 : std::clamp((point - edge.from).dot(along) / squared, 0.0, 1.0);
  return (point - edge.from - along * t).length();
}

/// Draws one plane pixel after the other.
class Painter {
 public:
  Painter(std::span<const Entry> entries, const SlbConfig& config, const Window& window,
          const BufferPictureOptions& options)
      : entries_(entries), config_(config), window_(window), options_(options) {
    image_.width = window.columns * options.scale;
    image_.height = window.rows * options.scale;
    image_.rgb.resize(3 * static_cast<std::size_t>(image_.width) * static_cast<std::size_t>(image_.height));
  }

  render::Image paint(std::span<const OutlineEdge> outlines) {
    for (int row = window_.row; row < window_.row + window_.rows; ++row) {
      for (int column = window_.column; column < window_.column + window_.columns; ++column) {
        enter(column, row, outlines);
        for (int y = 0; y < options_.scale; ++y) {
          for (int x = 0; x < options_.scale; ++x) paint_image_pixel(x, y);
        }
      }
    }
    return std::move(image_);
  }

 private:
  void enter(int column, int row, std::span<const OutlineEdge> outlines) {
    corner_ = Vec2(column, row);
    entry_ = &entries_[static_cast<std::size_t>(row) * static_cast<std::size_t>(config_.side()) +
                       static_cast<std::size_t>(column)];
    groups_ = restore(*entry_, config_);
    near_.clear();
    const double margin = 2.0 / options_.scale;
    for (const OutlineEdge& edge : outlines) {
      const auto [left, right] = std::minmax(edge.from.x, edge.to.x);
      const auto [low, high] = std::minmax(edge.from.y, edge.to.y);
      if (right > column - margin && left < column + 1 + margin && high > row - margin &&
          low < row + 1 + margin)
        near_.push_back(edge);
    }
  }

  void paint_image_pixel(int x, int y) {
    std::array<int, 3> sum{};
    const int n = options_.supersample;
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const Colour colour =
            sample({(x + (i + 0.5) / n) / options_.scale, (y + (j + 0.5) / n) / options_.scale});
        for (std::size_t c = 0; c < 3; ++c) sum[c] += colour[c];
      }
    }
    const auto left = (static_cast<int>(corner_.x) - window_.column) * options_.scale + x;
    const auto up = (static_cast<int>(corner_.y) - window_.row) * options_.scale + y;
    const std::size_t at = 3 * (static_cast<std::size_t>(up) * static_cast<std::size_t>(image_.width) +
                                static_cast<std::size_t>(left));
    for (std::size_t c = 0; c < 3; ++c)
      image_.rgb[at + c] = static_cast<std::uint8_t>((sum[c] + n * n / 2) / (n * n));
  }

  Colour sample(const Vec2& in_pixel) const {
    const double scale = options_.scale;
    const bool large = options_.scale >= kLeastScaleWithGrid;
    for (const OutlineEdge& edge : near_) {
      if (distance(edge, corner_ + in_pixel) * scale < 0.7) return kExactColour;
    }
    const RestoredGroup* faint = nullptr;
    for (const RestoredGroup& group : groups_) {
      for (std::size_t i = 0; i < group.lines.size(); ++i) {
        const double away = group.lines[i].distance(in_pixel) * scale;
        if (away < (large ? 1.6 : 0.7) && group.bounds(i, in_pixel)) return kLineColours[group.object % 4];
        if (large && away < 0.6) faint = &group;
      }
    }
    if (faint != nullptr) return kFaintColour;
    const double border = std::min({in_pixel.x, in_pixel.y, 1 - in_pixel.x, 1 - in_pixel.y});
    if (large && border * scale < 0.5) return kGridColour;
    if (entry_->full_depth != config_.no_depth()) return kFullColour;
    for (const RestoredGroup& group : groups_) {
      if (group.covers(in_pixel)) return kInsideColour;
    }
    return entry_->overflow ? kOverflowColour : kLitColour;
  }

  std::span<const Entry> entries_;
  SlbConfig config_;
  Window window_;
  BufferPictureOptions options_;
  render::Image image_;
  Vec2 corner_;  // of the plane pixel being drawn
  const Entry* entry_ = nullptr;
  std::vector<RestoredGroup> groups_;
  std::vector<OutlineEdge> near_;
};

}  // namespace

Window whole_plane(const SlbConfig& config) {
  return {0, 0, config.side(), config.side()};
}

Window busiest_window(std::span<const Entry> entries, const SlbConfig& config, int size) {
  const int side = config.side(), span = std::min(size, side);
  const auto stride = static_cast<std::size_t>(side) + 1;
  // Sums over everything below and left of a corner.
  std::vector<std::int64_t> sums(stride * stride);
  const auto sum = [&](int column, int row) -> std::int64_t& {
    return sums[static_cast<std::size_t>(row) * stride + static_cast<std::size_t>(column)];
  };
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const auto at =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(side) + static_cast<std::size_t>(column);
      sum(column + 1, row + 1) =
          interest(entries[at]) + sum(column, row + 1) + sum(column + 1, row) - sum(column, row);
    }
  }
  Window best{0, 0, span, span};
  std::int64_t most = -1;
  for (int row = 0; row + span <= side; ++row) {
    for (int column = 0; column + span <= side; ++column) {
      const std::int64_t found = sum(column + span, row + span) - sum(column, row + span) -
                                 sum(column + span, row) + sum(column, row);
      if (found <= most) continue;
      most = found;
      best = {column, row, span, span};
    }
  }
  return best;
}

render::Image buffer_picture(std::span<const Entry> entries, const SlbConfig& config, const Window& window,
                             const BufferPictureOptions& options, std::span<const OutlineEdge> outlines) {
  const auto side = static_cast<std::size_t>(config.side());
  if (entries.size() != side * side) throw std::invalid_argument("not the entries of a whole plane");
  return Painter(entries, config, window, options).paint(outlines);
}

}  // namespace gnomon::slb
