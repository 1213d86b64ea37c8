// SPDX-License-Identifier: Apache-2.0
// Winding numbers by counting the crossings of a ray to the left.
#include "host/slb/polygon_reference.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <numeric>

namespace gnomon::slb {
namespace {

int sign_of_exact(const Vec2& from, const Vec2& to, const Vec2& point) {
  using Exact = boost::multiprecision::cpp_rational;
  const auto minus = [](double a, double b) { return Exact(Exact(a) - Exact(b)); };
  const Exact left = minus(to.x, from.x) * minus(point.y, from.y);
  const Exact right = minus(to.y, from.y) * minus(point.x, from.x);
  return left > right ? 1 : left < right ? -1 : 0;
}

/// What an edge adds to the winding number of a point: +1 or -1 if a ray to the left crosses it.
int crossing(const OutlineEdge& edge, const Vec2& point) {
  const bool from_below = edge.from.y < point.y, to_below = edge.to.y < point.y;
  if (from_below == to_below) return 0;
  // The ray crosses an edge that lies left of the point: the point lies right of it going up.
  const int side = exact_side(edge.from, edge.to, point);
  if (from_below) return side < 0 ? -1 : 0;
  return side > 0 ? 1 : 0;
}

}  // namespace

int exact_side(const Vec2& from, const Vec2& to, const Vec2& point) {
  const double left = (to.x - from.x) * (point.y - from.y);
  const double right = (to.y - from.y) * (point.x - from.x);
  const double difference = left - right;
  // Two differences and a product are off by less than 3 roundings each, the last difference by one.
  const double bound = 4 * std::numeric_limits<double>::epsilon() * (std::abs(left) + std::abs(right));
  if (difference > bound) return 1;
  if (-difference > bound) return -1;
  return sign_of_exact(from, to, point);
}

PolygonReference::PolygonReference(const LoopScene& scene, int side)
    : rows_(static_cast<std::size_t>(side)), side_(side) {
  for (std::size_t caster = 0; caster < scene.size(); ++caster) {
    depths_.push_back(scene[caster].depth);
    for (const Loop& loop : scene[caster].loops) {
      for (std::size_t i = 0; i < loop.size(); ++i)
        edges_.push_back({caster, loop[i], loop[(i + 1) % loop.size()]});
    }
  }
  all_.resize(edges_.size());
  std::iota(all_.begin(), all_.end(), 0U);
  for (const std::uint32_t i : all_) {
    const auto [low, high] = std::minmax(edges_[i].from.y, edges_[i].to.y);
    if (high < 0 || low >= side) continue;
    const auto first = static_cast<std::size_t>(std::max(0.0, std::floor(low)));
    const auto last = static_cast<std::size_t>(std::min(side - 1.0, std::floor(high)));
    for (std::size_t row = first; row <= last; ++row) rows_[row].push_back(i);
  }
}

template <class Visit>
void PolygonReference::visit_windings(const Vec2& point, Visit&& visit) const {
  const bool on_rows = point.y >= 0 && point.y < side_;
  const std::vector<std::uint32_t>& near = on_rows ? rows_[static_cast<std::size_t>(point.y)] : all_;
  for (std::size_t i = 0; i < near.size();) {
    const std::size_t caster = edges_[near[i]].caster;
    int winding = 0;
    for (; i < near.size() && edges_[near[i]].caster == caster; ++i)
      winding += crossing(edges_[near[i]], point);
    if (!visit(caster, winding)) return;
  }
}

int PolygonReference::winding(std::size_t caster, const Vec2& point) const {
  int found = 0;
  visit_windings(point, [&](std::size_t which, int winding) {
    if (which == caster) found = winding;
    return which < caster;
  });
  return found;
}

bool PolygonReference::in_shadow(const Vec2& point, double z) const {
  bool shadow = false;
  visit_windings(point, [&](std::size_t caster, int winding) {
    shadow = winding >= 1 && depths_[caster] < z;
    return !shadow;
  });
  return shadow;
}

bool PolygonReference::covered(const Vec2& point) const {
  return in_shadow(point, std::numeric_limits<double>::infinity());
}

}  // namespace gnomon::slb
