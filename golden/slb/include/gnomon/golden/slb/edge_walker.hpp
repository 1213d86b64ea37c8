// SPDX-License-Identifier: Apache-2.0
// Walks the pixels that one edge touches, with exact border crossings (docs/slb.md, "Walk").
#pragma once

#include <cstdint>
#include <gnomon/golden/slb/formats.hpp>

namespace gnomon::golden::slb {

/// Where an edge meets a major border: cell + (k + r / den) / U pixels, 0 <= k < U, 0 <= r < den.
struct Position {
  std::int64_t cell = 0, k = 0, r = 0;
  bool operator==(const Position&) const = default;
};

/// Quotients of one edge, floor division with remainder.
struct EdgeSetup {
  bool y_major = false;
  bool forward = false;   ///< the major coordinate grows along the edge
  bool negative = false;  ///< minor and major coordinate run in opposite senses
  bool adjust = false;    ///< an exact integer belongs to the cell below (x-major, positive slope)
  std::int64_t den = 1;   ///< |major difference|, sub-pixels
  std::int64_t major_crossings = 0;
  Position ahead;                         ///< at the first major border in walking direction
  Position step;                          ///< from one major border to the next in walking direction
  std::int64_t slope_q = 0, slope_r = 0;  ///< magnitude of the step, in 1/U pixels
};
/// `from` and `to` must differ.
EdgeSetup set_up_edge(const Vertex& from, const Vertex& to, const SlbConfig& config);

Position add(const Position& a, const Position& b, std::int64_t den, std::int64_t unit);
Position subtract(const Position& a, const Position& b, std::int64_t den, std::int64_t unit);

/// Depth codes along one edge at its major borders, never below the true depth.
class EdgeDepth {
 public:
  EdgeDepth(const Vertex& from, const Vertex& to, std::int64_t den, std::int64_t first_distance,
            const SlbConfig& config);
  /// Largest depth between the border behind and the border ahead.
  std::uint32_t largest() const;
  /// The border ahead becomes the border behind.
  void advance();

 private:
  std::int64_t from_ = 0, to_ = 0, den_ = 1, quotient_ = 0, remainder_ = 0;
  bool sloped_ = false, rising_ = false;
  std::int64_t ahead_ = 0, ahead_r_ = 0, behind_ = 0;
};

class EdgeWalker {
 public:
  EdgeWalker(const Vertex& from, const Vertex& to, const SlbConfig& config);

  std::int64_t column() const { return column_; }
  std::int64_t row() const { return row_; }
  /// The edge ends in the current pixel.
  bool done() const;
  /// The side by which the edge leaves the current pixel. Only if not done.
  Side exit_side() const;
  /// Goes to the next pixel. Only if not done.
  void cross();
  /// The edge's line in the current pixel.
  Line line() const;
  /// Upper bound of the edge's depth in the current pixel.
  std::uint32_t depth() const { return depth_.largest(); }

  const EdgeSetup& setup() const { return setup_; }
  const Position& behind() const { return behind_; }
  const Position& ahead() const { return ahead_; }

 private:
  std::int64_t cell_of(const Position& position) const;
  std::int64_t target_cell() const;

  SlbConfig config_;
  EdgeSetup setup_;
  Position behind_, ahead_;
  std::int64_t column_, row_, end_column_, end_row_, remaining_;
  EdgeDepth depth_;
};

}  // namespace gnomon::golden::slb
