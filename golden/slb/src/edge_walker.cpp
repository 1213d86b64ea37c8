// SPDX-License-Identifier: Apache-2.0
// Integer DDA with remainder; no drift at any distance.
#include <algorithm>
#include <gnomon/golden/slb/edge_walker.hpp>
#include <gnomon/golden/slb/line_encoder.hpp>
#include <stdexcept>

namespace gnomon::golden::slb {
namespace {

std::int64_t magnitude_of(std::int64_t value) {
  return value < 0 ? -value : value;
}

/// D0 * start (in sub-pixels) plus or minus q + r / den, floored. q <= U, so that one correction each way is
/// enough.
Position offset(std::int64_t start, bool minus, std::int64_t q, std::int64_t r, std::int64_t den,
                const SlbConfig& config) {
  const std::int64_t fraction = start & (config.subpixels() - 1);
  Position position{start >> config.subpixel_bits, config.d0() * fraction, r};
  if (!minus) {
    position.k += q;
  } else {
    position.k -= r == 0 ? q : q + 1;
    position.r = r == 0 ? 0 : den - r;
  }
  if (position.k < 0) {
    position.k += config.unit();
    --position.cell;
  } else if (position.k >= config.unit()) {
    position.k -= config.unit();
    ++position.cell;
  }
  return position;
}

}  // namespace

Position add(const Position& a, const Position& b, std::int64_t den, std::int64_t unit) {
  Position sum{a.cell + b.cell, a.k + b.k, a.r + b.r};
  if (sum.r >= den) {
    sum.r -= den;
    ++sum.k;
  }
  if (sum.k >= unit) {
    sum.k -= unit;
    ++sum.cell;
  }
  return sum;
}

Position subtract(const Position& a, const Position& b, std::int64_t den, std::int64_t unit) {
  Position difference{a.cell - b.cell, a.k - b.k, a.r - b.r};
  if (difference.r < 0) {
    difference.r += den;
    --difference.k;
  }
  if (difference.k < 0) {
    difference.k += unit;
    --difference.cell;
  }
  return difference;
}

EdgeSetup set_up_edge(const Vertex& from, const Vertex& to, const SlbConfig& config) {
  const std::int64_t dx = to.x - from.x, dy = to.y - from.y;
  EdgeSetup edge;
  edge.y_major = magnitude_of(dx) <= magnitude_of(dy);
  const std::int64_t major_from = edge.y_major ? from.y : from.x;
  const std::int64_t major_to = edge.y_major ? to.y : to.x;
  const std::int64_t minor_from = edge.y_major ? from.x : from.y;
  const std::int64_t minor_delta = edge.y_major ? dx : dy;
  edge.forward = major_to > major_from;
  edge.negative = minor_delta != 0 && (minor_delta < 0) == edge.forward;
  edge.adjust = !edge.y_major && minor_delta != 0 && !edge.negative;
  edge.den = magnitude_of(major_to - major_from);
  if (edge.den == 0) throw std::logic_error("an edge needs two different vertices");
  const int s = config.subpixel_bits;
  const std::int64_t from_cell = major_from >> s;
  edge.major_crossings = magnitude_of((major_to >> s) - from_cell);
  const std::int64_t distance =
      edge.forward ? ((from_cell + 1) << s) - major_from : major_from - (from_cell << s);
  const std::int64_t rise = config.d0() * magnitude_of(minor_delta);
  const std::int64_t first = rise * distance, whole = rise << s;
  const bool minus = minor_delta < 0;
  edge.ahead = offset(minor_from, minus, first / edge.den, first % edge.den, edge.den, config);
  edge.slope_q = whole / edge.den;
  edge.slope_r = whole % edge.den;
  edge.step = offset(0, minus, edge.slope_q, edge.slope_r, edge.den, config);
  return edge;
}

EdgeDepth::EdgeDepth(const Vertex& from, const Vertex& to, std::int64_t den, std::int64_t first_distance,
                     const SlbConfig& config)
    : from_(from.depth), to_(to.depth), den_(den) {
  sloped_ = from_ != to_ && den > config.subpixels();
  if (!sloped_) return;
  rising_ = to_ > from_;
  const std::int64_t whole = magnitude_of(to_ - from_) << config.subpixel_bits;
  quotient_ = whole / den;
  remainder_ = whole % den;
  const int s = config.subpixel_bits;
  behind_ = from_;
  // Never below the true depth: rising, everything is rounded up; falling, the fall is rounded down.
  ahead_r_ = rising_ ? den - 1 : 0;
  ahead_ = rising_ ? from_ + (((quotient_ + 1) * first_distance + config.subpixels() - 1) >> s)
                   : from_ - ((quotient_ * first_distance) >> s);
}

std::uint32_t EdgeDepth::largest() const {
  if (!sloped_) return static_cast<std::uint32_t>(std::max(from_, to_));
  return static_cast<std::uint32_t>(rising_ ? std::min(ahead_, to_) : std::max(behind_, to_));
}

void EdgeDepth::advance() {
  if (!sloped_) return;
  behind_ = ahead_;
  ahead_r_ += remainder_;
  const std::int64_t carry = ahead_r_ >= den_ ? 1 : 0;
  ahead_r_ -= carry * den_;
  ahead_ += rising_ ? quotient_ + carry : -(quotient_ + carry);
}

EdgeWalker::EdgeWalker(const Vertex& from, const Vertex& to, const SlbConfig& config)
    : config_(config),
      setup_(set_up_edge(from, to, config)),
      behind_(subtract(setup_.ahead, setup_.step, setup_.den, config.unit())),
      ahead_(setup_.ahead),
      column_(from.x >> config.subpixel_bits),
      row_(from.y >> config.subpixel_bits),
      end_column_(to.x >> config.subpixel_bits),
      end_row_(to.y >> config.subpixel_bits),
      remaining_(setup_.major_crossings),
      depth_(
          from, to, setup_.den,
          [&] {
            const std::int64_t major = setup_.y_major ? from.y : from.x;
            const std::int64_t inside = major & (config.subpixels() - 1);
            return setup_.forward ? config.subpixels() - inside : inside;
          }(),
          config) {}

std::int64_t EdgeWalker::cell_of(const Position& position) const {
  return position.cell - (setup_.adjust && position.k == 0 && position.r == 0 ? 1 : 0);
}

std::int64_t EdgeWalker::target_cell() const {
  if (remaining_ > 0) return cell_of(ahead_);
  return setup_.y_major ? end_column_ : end_row_;
}

bool EdgeWalker::done() const {
  return column_ == end_column_ && row_ == end_row_ && remaining_ == 0;
}

Side EdgeWalker::exit_side() const {
  const std::int64_t cell = setup_.y_major ? column_ : row_;
  const std::int64_t target = target_cell();
  if (cell != target) {
    if (setup_.y_major) return target > cell ? Side::Right : Side::Left;
    return target > cell ? Side::Top : Side::Bottom;
  }
  if (setup_.y_major) return setup_.forward ? Side::Top : Side::Bottom;
  return setup_.forward ? Side::Right : Side::Left;
}

void EdgeWalker::cross() {
  const Side side = exit_side();
  switch (side) {
    case Side::Bottom:
      --row_;
      break;
    case Side::Right:
      ++column_;
      break;
    case Side::Top:
      ++row_;
      break;
    case Side::Left:
      --column_;
      break;
  }
  const bool vertical_move = side == Side::Bottom || side == Side::Top;
  if (vertical_move != setup_.y_major) return;
  behind_ = ahead_;
  ahead_ = add(ahead_, setup_.step, setup_.den, config_.unit());
  --remaining_;
  depth_.advance();
}

Line EdgeWalker::line() const {
  const Position& low = setup_.forward ? behind_ : ahead_;
  const Position& high = setup_.forward ? ahead_ : behind_;
  return encode_line(setup_, low, high, setup_.y_major ? column_ : row_, config_);
}

}  // namespace gnomon::golden::slb
