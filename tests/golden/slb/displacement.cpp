// SPDX-License-Identifier: Apache-2.0
// Monte Carlo over the pixels at the outline.
#include "tests/golden/slb/displacement.hpp"

#include "tests/golden/slb/oracle.hpp"

namespace gnomon::golden::slb::testing {
namespace {

enum class Zone { Far, Next, Outline };

Zone zone(const Oracle& oracle, int side, int column, int row) {
  if (oracle.near_outline(column, row)) return Zone::Outline;
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      const int x = column + dx, y = row + dy;
      if (x >= 0 && y >= 0 && x < side && y < side && oracle.near_outline(x, y)) return Zone::Next;
    }
  return Zone::Far;
}

/// The middle of the map's pixel that holds the point.
std::int64_t sample_point(std::int64_t v, int bits_per_pixel) {
  const int shift = kPointBits - bits_per_pixel;
  return ((v >> shift) << shift) + (std::int64_t{1} << (shift - 1)) + 1;
}

}  // namespace

Displacement& Displacement::operator+=(const Displacement& other) {
  wrong_area += other.wrong_area;
  wrong_area_fine += other.wrong_area_fine;
  wrong_area_plain += other.wrong_area_plain;
  length += other.length;
  queries += other.queries;
  wrong += other.wrong;
  chains += other.chains;
  dropped += other.dropped;
  return *this;
}

void draw(SlbModel& model, const Scene& scene) {
  std::uint8_t id = 0;
  for (const Object& object : scene) {
    model.begin_object(id++, true, 0);
    for (const Loop& loop : object) model.loop(loop);
    model.fill();
    model.end_object();
  }
}

Displacement measure(const Scene& scene, const SlbConfig& config, int per_pixel, std::uint64_t seed) {
  SlbModel model(config);
  draw(model, scene);
  const Oracle oracle(scene, config);
  Random random(seed);
  Displacement result;
  result.length = perimeter(scene, config);
  result.chains = model.counters().chains;
  result.dropped = model.counters().chains_dropped + model.counters().chains_reduced;
  const int q = config.query_bits;
  for (int row = 0; row < config.side(); ++row)
    for (int column = 0; column < config.side(); ++column) {
      const Zone here = zone(oracle, config.side(), column, row);
      if (here == Zone::Far) continue;
      const int count = here == Zone::Outline ? per_pixel : (per_pixel + 7) / 8;
      const double weight = 1.0 / count;
      for (int i = 0; i < count; ++i) {
        const std::int64_t x = (std::int64_t{column} << q) + random.integer(0, (std::int64_t{1} << q) - 1);
        const std::int64_t y = (std::int64_t{row} << q) + random.integer(0, (std::int64_t{1} << q) - 1);
        const std::int64_t px = (2 * x + 1) << (kPointBits - q - 1), py = (2 * y + 1) << (kPointBits - q - 1);
        const bool expected = oracle.covered(px, py);
        const bool answer = model.query({x, y, 1}, 0).shadow;
        const auto map = [&](int bits) {
          return oracle.covered(sample_point(px, bits), sample_point(py, bits));
        };
        ++result.queries;
        if (answer != expected) {
          ++result.wrong;
          result.wrong_area += weight;
        }
        if (map(config.frac_bits) != expected) result.wrong_area_fine += weight;
        if (map(0) != expected) result.wrong_area_plain += weight;
      }
    }
  return result;
}

}  // namespace gnomon::golden::slb::testing
