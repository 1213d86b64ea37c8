// SPDX-License-Identifier: Apache-2.0
// Encoding a line; every narrowing of the walk is here.
#include <gnomon/golden/slb/line_encoder.hpp>

#include <algorithm>

namespace gnomon::golden::slb {
namespace {

/// A position relative to the pixel, in 1/U pixels: k + (0 or something below 1).
struct Relative {
  std::int64_t k = 0;
  bool inexact = false;

  bool in_pixel(std::int64_t unit) const { return k >= 0 && (k < unit || (k == unit && !inexact)); }
  /// In half units, rounded to odd where inexact: symmetric under negation.
  std::int64_t halves() const { return 2 * k + (inexact ? 1 : 0); }
  /// 1 - this.
  Relative mirrored(std::int64_t unit) const { return {unit - k - (inexact ? 1 : 0), inexact}; }
};

Relative relative(const Position& position, std::int64_t cell, std::int64_t unit) {
  return {(position.cell - cell) * unit + position.k, position.r != 0};
}

/// floor(c * D0 + 1/2), exact: U = D0 * 2^s, so that the thresholds are whole units.
std::int64_t round_fraction(const Relative& c, const SlbConfig& config) {
  return (c.k + config.subpixels() / 2) >> config.subpixel_bits;
}

/// floor(t * D1 + 1/2), saturated to 0..D1, of t in half units.
std::int64_t round_slope(std::int64_t halves, const SlbConfig& config) {
  const std::int64_t numerator = (halves * config.d1() + config.unit()) >> (config.subpixel_bits + 1);
  if (numerator < 0) return 0;
  return std::min(numerator / config.d0(), config.d1());
}

}  // namespace

Line encode_line(const EdgeSetup& edge, const Position& low, const Position& high, std::int64_t cell,
                 const SlbConfig& config) {
  const std::int64_t unit = config.unit();
  const Relative c0 = relative(low, cell, unit);
  const Relative c1 = relative(high, cell, unit);
  Line line;
  line.major = edge.y_major;
  line.xsign = edge.negative;
  line.cross = !c0.in_pixel(unit);
  // y-major and going up, or x-major and going left: the left side is where the minor coordinate is smaller.
  line.inner = edge.y_major != edge.forward;
  const Relative stored = line.cross ? c1 : c0;
  const Relative other = line.cross ? c0 : c1;
  const bool published = config.rounding == Rounding::Published;
  const bool mirrored = published && line.xsign;
  const std::int64_t frac = round_fraction(mirrored ? stored.mirrored(unit) : stored, config);
  line.frac = static_cast<std::uint16_t>(frac);
  if (edge.slope_q == 0 && edge.slope_r == 0) return line;
  std::int64_t rise = 0;  // of the magnitude, in half units
  if (published) {
    rise = 2 * edge.slope_q + (edge.slope_r != 0 ? 1 : 0);
  } else {
    const std::int64_t read_back = frac << (config.subpixel_bits + 1);
    rise = line.cross != line.xsign ? read_back - other.halves() : other.halves() - read_back;
  }
  line.slope = static_cast<std::uint16_t>(round_slope(rise, config));
  return line;
}

}  // namespace gnomon::golden::slb
