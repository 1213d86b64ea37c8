// SPDX-License-Identifier: Apache-2.0
// Exact rationals; the shift by (epsilon, epsilon squared) as an explicit order of events.
#include "tests/golden/slb/reference.hpp"

#include <algorithm>
#include <gnomon/golden/slb/line_encoder.hpp>

namespace gnomon::golden::slb::testing {
namespace {

Rational pixels(std::int64_t value, const SlbConfig& config) {
  return Rational(value) / config.subpixels();
}

/// A crossing at parameter t; at equal t the coefficients of epsilon, then of epsilon squared, decide.
struct Event {
  Rational t, first_order, second_order;
  Side side = Side::Bottom;
  bool operator<(const Event& other) const {
    if (t != other.t) return t < other.t;
    if (first_order != other.first_order) return first_order < other.first_order;
    return second_order < other.second_order;
  }
};

/// Borders i with (a < i) != (b < i).
std::vector<std::int64_t> borders(const Rational& a, const Rational& b, std::int64_t near) {
  std::vector<std::int64_t> result;
  const Rational low = std::min(a, b), high = std::max(a, b);
  for (std::int64_t i = near; Rational(i) <= high; ++i)
    if (low < i) result.push_back(i);
  return result;
}

}  // namespace

std::vector<Side> reference_walk(const Vertex& from, const Vertex& to, const SlbConfig& config) {
  const Rational x0 = pixels(from.x, config), y0 = pixels(from.y, config);
  const Rational x1 = pixels(to.x, config), y1 = pixels(to.y, config);
  const Rational dx = x1 - x0, dy = y1 - y0;
  std::vector<Event> events;
  for (const std::int64_t i : borders(x0, x1, std::min(from.x, to.x) >> config.subpixel_bits))
    events.push_back({(i - x0) / dx, -1 / dx, 0, dx > 0 ? Side::Right : Side::Left});
  for (const std::int64_t j : borders(y0, y1, std::min(from.y, to.y) >> config.subpixel_bits))
    events.push_back({(j - y0) / dy, 0, -1 / dy, dy > 0 ? Side::Top : Side::Bottom});
  std::sort(events.begin(), events.end());
  std::vector<Side> sides;
  sides.reserve(events.size());
  for (const Event& event : events) sides.push_back(event.side);
  return sides;
}

Rational reference_crossing(const Vertex& from, const Vertex& to, std::int64_t border,
                            const SlbConfig& config) {
  const Rational x0 = pixels(from.x, config), y0 = pixels(from.y, config);
  const Rational dx = pixels(to.x - from.x, config), dy = pixels(to.y - from.y, config);
  if (abs(dx) <= abs(dy)) return x0 + (border - y0) * dx / dy;
  return y0 + (border - x0) * dy / dx;
}

Rational value_of(const Position& position, const EdgeSetup& edge, const SlbConfig& config) {
  return position.cell + (position.k + Rational(position.r) / edge.den) / config.unit();
}

Rational restored(const Line& line, const Rational& at, const SlbConfig& config) {
  Rational crossing = Rational(line.frac) / config.d0();
  if (config.rounding == Rounding::Published && line.xsign) crossing = 1 - crossing;
  if (config.rounding == Rounding::Better && config.frac_bits == config.slope_bits && line.cross) {
    const Rational other = crossing + (line.xsign ? 1 : -1) * Rational(line.slope) / config.d1();
    if (crossing < 1 && other >= 0 && other < 1) crossing += Rational(1, 2) / config.d0();
  }
  return crossing + (line.xsign ? -1 : 1) * Rational(line.slope) / config.d1() * (at - (line.cross ? 1 : 0));
}

Rational restored_bound(const SlbConfig& config) {
  const Rational fraction = Rational(1, 2) / config.d0(), slope = Rational(1, 2) / config.d1();
  return std::max(fraction, slope) +
         Rational(1) / (std::int64_t{1} << (config.subpixel_bits + config.frac_bits));
}

std::int64_t check_walk(const Vertex& from, const Vertex& to, const SlbConfig& config, std::int64_t fault) {
  const std::vector<Side> sides = reference_walk(from, to, config);
  EdgeWalker walker(from, to, config);
  std::int64_t compared = 0;
  for (std::size_t i = 0;; ++i) {
    const EdgeSetup& edge = walker.setup();
    const std::int64_t cell = edge.y_major ? walker.row() : walker.column();
    Position low = edge.forward ? walker.behind() : walker.ahead();
    const Position high = edge.forward ? walker.ahead() : walker.behind();
    low.k += fault;
    if (value_of(low, edge, config) != reference_crossing(from, to, cell, config)) return -1;
    if (value_of(high, edge, config) != reference_crossing(from, to, cell + 1, config)) return -1;
    compared += 2;
    if (i == sides.size()) return walker.done() ? compared + 1 : -1;
    if (walker.done() || walker.exit_side() != sides[i]) return -1;
    ++compared;
    walker.cross();
  }
}

}  // namespace gnomon::golden::slb::testing
