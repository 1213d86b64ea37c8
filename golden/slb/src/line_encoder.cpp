// SPDX-License-Identifier: Apache-2.0
// Encoding a line; every narrowing of the walk is here.
#include <algorithm>
#include <cstdlib>
#include <gnomon/golden/slb/line_encoder.hpp>

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

Line published_line(Line line, const EdgeSetup& edge, const Relative& c0, const Relative& c1,
                    const SlbConfig& config) {
  const std::int64_t unit = config.unit();
  line.cross = !c0.in_pixel(unit);
  const Relative stored = line.cross ? c1 : c0;
  line.frac = static_cast<std::uint16_t>(round_fraction(line.xsign ? stored.mirrored(unit) : stored, config));
  const Relative rise{edge.slope_q, edge.slope_r != 0};
  line.slope = static_cast<std::uint16_t>(round_slope(rise.halves(), config));
  return line;
}

struct Candidate {
  Line line;
  bool valid = false;
  std::int64_t score = 0;  ///< error, in 1 / (2 U D1) pixels
};

/// Stores the crossing of border M = `cross`, on the lattice of the codes or halfway between.
Candidate candidate(Line line, bool cross, bool halfway, const Relative& c0, const Relative& c1,
                    const SlbConfig& config) {
  const Relative stored = cross ? c1 : c0, other = cross ? c0 : c1;
  std::int64_t frac = halfway ? stored.k >> config.subpixel_bits : round_fraction(stored, config);
  if (halfway && stored.k == config.unit()) --frac;
  if (frac < 0 || frac > config.d0() - (halfway ? 1 : 0)) return {};
  const std::int64_t read_back = (2 * frac + (halfway ? 1 : 0)) << config.subpixel_bits;
  const std::int64_t rise = cross != line.xsign ? read_back - other.halves() : other.halves() - read_back;
  const std::int64_t slope = round_slope(rise, config);
  line.cross = cross;
  line.frac = static_cast<std::uint16_t>(frac);
  line.slope = static_cast<std::uint16_t>(slope);
  // Restored minus true, at both borders; the line between them is off by nearly the largest of these on
  // average.
  const std::int64_t stored_error = (read_back - stored.halves()) * config.d1();
  const std::int64_t short_of = rise * config.d1() - 2 * slope * config.unit();
  const std::int64_t other_error = cross != line.xsign ? short_of : -short_of;
  const std::int64_t score =
      std::max({std::abs(stored_error), std::abs(other_error), std::abs(stored_error + other_error)});
  return {line, reads_halfway(line, config) == halfway, score};
}

}  // namespace

bool reads_halfway(const Line& line, const SlbConfig& config) {
  if (config.rounding != Rounding::Better || config.frac_bits != config.slope_bits) return false;
  const int other = line.xsign ? line.frac + line.slope : line.frac - line.slope;
  const auto d0 = static_cast<int>(config.d0());
  return line.cross && line.frac < d0 && other >= 0 && other < d0;
}

Line encode_line(const EdgeSetup& edge, const Position& low, const Position& high, std::int64_t cell,
                 const SlbConfig& config) {
  const std::int64_t unit = config.unit();
  const Relative c0 = relative(low, cell, unit);
  const Relative c1 = relative(high, cell, unit);
  Line line;
  line.major = edge.y_major;
  line.xsign = edge.negative;
  // y-major and going up, or x-major and going left: the left side is where the minor coordinate is smaller.
  line.inner = edge.y_major != edge.forward;
  if (config.rounding == Rounding::Published) return published_line(line, edge, c0, c1, config);
  Candidate best = candidate(line, false, false, c0, c1, config);
  if (edge.slope_q == 0 && edge.slope_r == 0) {
    best.line.slope = 0;  // a straight wall is the same line in every pixel
    return best.line;
  }
  for (const bool halfway : {false, true}) {
    if (halfway && config.frac_bits != config.slope_bits) continue;
    const Candidate next = candidate(line, true, halfway, c0, c1, config);
    if (next.valid && (!best.valid || next.score < best.score)) best = next;
  }
  return best.line;
}

}  // namespace gnomon::golden::slb
