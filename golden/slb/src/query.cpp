// SPDX-License-Identifier: Apache-2.0
// The signs that decide a query; all products, no division.
#include <algorithm>
#include <gnomon/golden/slb/line_encoder.hpp>
#include <gnomon/golden/slb/query.hpp>

namespace gnomon::golden::slb {

bool inside(const Line& line, const PixelPoint& point, const SlbConfig& config) {
  const std::int64_t one = std::int64_t{1} << point.scale_bits;
  const std::int64_t minor = line.major ? point.x : point.y;
  const std::int64_t major = line.major ? point.y : point.x;
  const bool mirrored = config.rounding == Rounding::Published && line.xsign;
  const std::int64_t frac = mirrored ? config.d0() - line.frac : line.frac;
  const std::int64_t along = major - (line.cross ? one : 0);
  const std::int64_t twice_frac = 2 * frac + (reads_halfway(line, config) ? 1 : 0);
  const std::int64_t rise = 2 * std::int64_t{line.slope} * config.d0() * along;
  const std::int64_t value =
      (2 * minor * config.d0() - twice_frac * one) * config.d1() - (line.xsign ? -rise : rise);
  return line.inner ? value >= 0 : value <= 0;
}

bool chain_contains(FragmentOp op, const Line& a, const Line& b, const PixelPoint& point,
                    const SlbConfig& config) {
  const bool in_a = inside(a, point, config);
  if (op == FragmentOp::And) return in_a && inside(b, point, config);
  if (op == FragmentOp::Or) return in_a || inside(b, point, config);
  return in_a;
}

int chains_containing(const Fragment& fragment, const PixelPoint& point, const SlbConfig& config) {
  const int first = chain_contains(fragment.op, fragment.a, fragment.b, point, config) ? 1 : 0;
  if (fragment.op != FragmentOp::Two) return first;
  return first + (inside(fragment.b, point, config) ? 1 : 0);
}

QueryAnswer answer(const Entry& entry, const PixelPoint& point, std::uint32_t depth, std::uint32_t bias,
                   const SlbConfig& config) {
  const auto nearer = [&](std::uint32_t stored) { return std::uint64_t{stored} + bias < depth; };
  QueryAnswer result;
  result.has_fragment = entry.count > 0;
  result.overflow = entry.overflow;
  const bool full = nearer(entry.full_depth);
  for (int first = 0; first < entry.count;) {
    const auto head = static_cast<std::size_t>(first);
    std::uint32_t group_depth = 0;
    int contained = 0;
    do {
      const Fragment& fragment = entry.fragments[static_cast<std::size_t>(first)];
      group_depth = std::max(group_depth, fragment.depth);
      contained += chains_containing(fragment, point, config);
      ++first;
    } while (first < entry.count && entry.fragments[static_cast<std::size_t>(first)].cont);
    const bool covers = contained >= entry.fragments[head].threshold_m1 + 1;
    if (covers && nearer(group_depth) && !result.by_lines) {
      result.by_lines = true;
      result.object = entry.fragments[head].object;
    }
  }
  result.by_full = full;
  result.shadow = full || result.by_lines;
  return result;
}

}  // namespace gnomon::golden::slb
