// SPDX-License-Identifier: Apache-2.0
// The lines of an entry as they are read back, in real numbers.
#include "host/slb/restored_lines.hpp"

#include <algorithm>
#include <cmath>
#include <gnomon/golden/slb/line_encoder.hpp>

namespace gnomon::slb {

using golden::slb::FragmentOp;
using golden::slb::SlbConfig;

double RestoredLine::depth_inside(const Vec2& in_pixel) const {
  const double minor = y_major ? in_pixel.x : in_pixel.y, major = y_major ? in_pixel.y : in_pixel.x;
  const double beyond = minor - (at_zero + slope * major);
  return inner ? beyond : -beyond;
}

double RestoredLine::distance(const Vec2& in_pixel) const {
  return std::abs(depth_inside(in_pixel)) / std::hypot(1.0, slope);
}

RestoredLine restore(const golden::slb::Line& line, const SlbConfig& config) {
  const bool mirrored = config.rounding == golden::slb::Rounding::Published && line.xsign;
  const auto code = static_cast<double>(mirrored ? config.d0() - line.frac : line.frac);
  const double half = golden::slb::reads_halfway(line, config) ? 0.5 : 0;
  const double crossing = (code + half) / static_cast<double>(config.d0());
  const double slope =
      (line.xsign ? -1 : 1) * static_cast<double>(line.slope) / static_cast<double>(config.d1());
  return {line.major, line.inner, crossing - (line.cross ? slope : 0), slope};
}

std::vector<bool> RestoredGroup::inside_of(const Vec2& in_pixel) const {
  std::vector<bool> inside;
  inside.reserve(lines.size());
  for (const RestoredLine& line : lines) inside.push_back(line.depth_inside(in_pixel) >= 0);
  return inside;
}

bool RestoredGroup::covers_with(const std::vector<bool>& inside) const {
  const auto contains = [&](const Chain& chain) {
    if (chain.op == FragmentOp::And) return inside[chain.a] && inside[chain.b];
    if (chain.op == FragmentOp::Or) return inside[chain.a] || inside[chain.b];
    return static_cast<bool>(inside[chain.a]);
  };
  return std::count_if(chains.begin(), chains.end(), contains) >= threshold;
}

bool RestoredGroup::covers(const Vec2& in_pixel) const {
  return covers_with(inside_of(in_pixel));
}

bool RestoredGroup::bounds(std::size_t line, const Vec2& in_pixel) const {
  std::vector<bool> inside = inside_of(in_pixel);
  inside[line] = true;
  const bool with = covers_with(inside);
  inside[line] = false;
  return with != covers_with(inside);
}

std::vector<RestoredGroup> restore(const golden::slb::Entry& entry, const SlbConfig& config) {
  std::vector<RestoredGroup> groups;
  for (std::size_t i = 0; i < entry.count; ++i) {
    const golden::slb::Fragment& fragment = entry.fragments[i];
    if (!fragment.cont || groups.empty())
      groups.push_back({fragment.object, 0, fragment.threshold_m1 + 1, {}, {}});
    RestoredGroup& group = groups.back();
    group.depth = std::max(group.depth, fragment.depth);
    const std::size_t a = group.lines.size();
    group.lines.push_back(restore(fragment.a, config));
    if (fragment.op != FragmentOp::One) group.lines.push_back(restore(fragment.b, config));
    if (fragment.op == FragmentOp::Two) {
      group.chains.push_back({FragmentOp::One, a, a});
      group.chains.push_back({FragmentOp::One, a + 1, a + 1});
    } else {
      group.chains.push_back({fragment.op, a, a + 1});
    }
  }
  return groups;
}

}  // namespace gnomon::slb
