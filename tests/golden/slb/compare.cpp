// SPDX-License-Identifier: Apache-2.0
// Comparison with the winding oracle.
#include "tests/golden/slb/compare.hpp"

#include <set>
#include <utility>

#include "tests/golden/slb/oracle.hpp"

namespace gnomon::golden::slb::testing {
namespace {

using Pixels = std::set<std::pair<std::int64_t, std::int64_t>>;

/// Pixels with a chain of several vertices, or a corner of less than a right angle.
Pixels excused_pixels(const Scene& scene, const SlbConfig& config) {
  Pixels pixels;
  ChainBuilder builder(
      config,
      [&](const Chain& chain) {
        if (chain.vertices > 1) pixels.insert({chain.column, chain.row});
      },
      [](std::int64_t, std::int64_t, bool) {});
  for (const Object& object : scene)
    for (const Loop& loop : object) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vertex &a = loop[i], &b = loop[(i + 1) % loop.size()], &c = loop[(i + 2) % loop.size()];
        if ((b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y) < 0)
          pixels.insert({b.x >> config.subpixel_bits, b.y >> config.subpixel_bits});
        builder.vertex(a);
      }
      builder.close();
    }
  return pixels;
}

}  // namespace

Comparison compare(SlbModel& model, const Scene& scene, int per_pixel, std::uint64_t seed) {
  const SlbConfig& config = model.config();
  const Oracle oracle(scene, config);
  const Pixels excuses = excused_pixels(scene, config);
  const double limit = 1.0 / static_cast<double>(std::min(config.d0(), config.d1()));
  Random random(seed);
  Comparison result;
  const int q = config.query_bits;
  for (int row = 0; row < config.side(); ++row)
    for (int column = 0; column < config.side(); ++column)
      for (int i = 0; i < per_pixel; ++i) {
        const std::int64_t x = (std::int64_t{column} << q) + random.integer(0, (std::int64_t{1} << q) - 1);
        const std::int64_t y = (std::int64_t{row} << q) + random.integer(0, (std::int64_t{1} << q) - 1);
        const std::int64_t px = (2 * x + 1) << (kPointBits - q - 1), py = (2 * y + 1) << (kPointBits - q - 1);
        const QueryAnswer answer = model.query({x, y, 1}, 0);
        ++result.compared;
        if (answer.shadow == oracle.covered(px, py)) continue;
        ++result.wrong;
        if (!oracle.near_outline(column, row)) ++result.wrong_away;
        if (oracle.distance(px, py) <= limit) continue;
        const bool excused = answer.overflow || excuses.contains({column, row});
        ++(excused ? result.excused : result.wrong_far);
      }
  return result;
}

}  // namespace gnomon::golden::slb::testing
