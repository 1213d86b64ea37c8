// SPDX-License-Identifier: Apache-2.0
// Real numbers, rounded where the page says so.
#include "reference.hpp"

#include <algorithm>
#include <utility>

namespace gnomon::test {
namespace {

namespace topology = golden::topology;

Rational power_of_two(int exponent) {
  const Integer magnitude = Integer(1) << (exponent < 0 ? -exponent : exponent);
  return exponent < 0 ? Rational(Integer(1), magnitude) : Rational(magnitude);
}
Rational dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Point minus(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Twice the signed area that two corners span with the beam.
Rational area(const Point& start, const Point& a, const Point& b) {
  return (a[0] - start[0]) * (b[1] - start[1]) - (a[1] - start[1]) * (b[0] - start[0]);
}

/// The clearance is in the beam's depth.
std::optional<Point> beam_in_perspective(const exact::PerspectiveUnit& light, const topology::Item& voxel,
                                         bool two_sided, std::uint32_t clearance,
                                         topology::TopologyResult& result) {
  const golden::VoxelItem item{voxel.position, voxel.normal};
  const exact::Sight sight = light.see(item);
  result.behind = sight.behind;
  result.outside_cone = !sight.behind && light.outside_cone(sight);
  const Rational descent = light.descent(item);
  const bool reached = !result.behind && !result.outside_cone;
  result.facing_away = reached && (descent == 0 || (descent > 0 && !two_sided));
  if (!reached || result.facing_away) return std::nullopt;
  const exact::Moved moved = light.move(item, sight, descent > 0, clearance);
  return Point{moved.fine[0], moved.fine[1], Rational(floor(moved.key))};
}

}  // namespace

Integer floor(const Rational& x) {
  const Integer n = numerator(x), d = denominator(x);
  const Integer quotient = n / d;
  return n < 0 && quotient * d != n ? quotient - 1 : quotient;
}

Rational floor_to(const Rational& x, int bits) {
  return Rational(floor(x * power_of_two(bits))) * power_of_two(-bits);
}

bool paper_hit(const Point& start, const Point& v0, const Point& v1, const Point& v2) {
  const Point u = minus(v1, v0), v = minus(v2, v0);
  const Point normal = cross(u, v);
  if (normal[2] == 0) return false;  // the beam is parallel to the plane, or there is none
  const Rational distance = dot(normal, minus(start, v0)) / normal[2];  // towards smaller depth
  if (distance <= 0) return false;
  const Point meeting = {start[0], start[1], start[2] - distance};
  const Point w = minus(meeting, v0);
  const Rational uv = dot(u, v), uu = dot(u, u), vv = dot(v, v), wu = dot(w, u), wv = dot(w, v);
  const Rational below = uv * uv - uu * vv;
  const Rational s = (uv * wv - vv * wu) / below;
  const Rational t = (uv * wu - uu * wv) / below;
  return s >= 0 && t >= 0 && s + t <= 1;
}

bool light_space_hit(const Point& start, const Point& v0, const Point& v1, const Point& v2) {
  const std::array<Rational, 3> w = {area(start, v1, v2), area(start, v2, v0), area(start, v0, v1)};
  const Rational whole = w[0] + w[1] + w[2];
  if (whole == 0) return false;
  const int sign = whole > 0 ? 1 : -1;
  for (const Rational& x : w)
    if (x * sign < 0) return false;
  return (w[0] * (v0[2] - start[2]) + w[1] * (v1[2] - start[2]) + w[2] * (v2[2] - start[2])) * sign < 0;
}

Rational TopologyReference::row(std::size_t first, const std::array<Rational, 3>& at,
                                int fraction_bits) const {
  Rational sum = 0;
  for (std::size_t i = 0; i < 3; ++i)
    sum += Rational(registers_.matrix[first + i]) * power_of_two(-fraction_bits) * at[i];
  return sum;
}

Rational TopologyReference::saturated(const Rational& depth) const {
  return std::clamp(depth, Rational(0), Rational(config_.no_depth()) - 1);
}

bool TopologyReference::Quad::meets(const Integer& u, const Integer& v) const {
  return u0 <= u && u <= u1 && v0 <= v && v <= v1;
}

bool TopologyReference::Quad::linked_to(const Integer& u, const Integer& v) const {
  return meets(u, v) && (v - v0) * (u1 - u0 + 1) + (u - u0) < linked;
}

Point TopologyReference::orthographic_place(const topology::Item& item) const {
  const int f = config_.matrix_frac_bits, depth_bits = config_.position_bits() + 4;
  const std::array<Rational, 3> at = {item.position[0], item.position[1], item.position[2]};
  return {row(0, at, f) + Rational(registers_.matrix[3]) * power_of_two(-f),
          row(4, at, f) + Rational(registers_.matrix[7]) * power_of_two(-f),
          row(8, at, depth_bits) + Rational(registers_.matrix[11]) * power_of_two(-depth_bits)};
}

std::optional<Point> TopologyReference::place(const topology::Item& item) const {
  if (!light_) return orthographic_place(item);
  const exact::Sight sight = light_->see({item.position, item.normal});
  if (sight.behind) return std::nullopt;
  return Point{sight.fine[0], sight.fine[1], sight.key};
}

void TopologyReference::put(const std::array<topology::Item, 4>& items) {
  const Rational limit = power_of_two(config_.plane_log2 + 1);
  Quad quad{};
  quad.number = numbered_++;
  std::array<std::vector<Integer>, 2> entries;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto real = place(items[i]);
    if (!real) return;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const Rational held = std::clamp(floor_to((*real)[axis], config_.sub_bits), -limit,
                                       limit - power_of_two(-config_.sub_bits));
      quad.corners[i][axis] = held * power_of_two(config_.sub_bits);
      entries[axis].push_back(floor(held));
    }
    quad.corners[i][2] = saturated(Rational(floor((*real)[2])));
    quad.far = std::max(quad.far, floor(quad.corners[i][2]));
  }
  const auto [u0, u1] = std::minmax_element(entries[0].begin(), entries[0].end());
  const auto [v0, v1] = std::minmax_element(entries[1].begin(), entries[1].end());
  const Integer span = Integer(1) << config_.span_log2, last = config_.side() - 1;
  const bool storable =
      *u1 - *u0 < span && *v1 - *v0 < span && quad.number < (std::uint64_t{1} << config_.quads_log2);
  quad.u0 = std::max(*u0, Integer(0));
  quad.v0 = std::max(*v0, Integer(0));
  quad.u1 = std::min(*u1, last);
  quad.v1 = std::min(*v1, last);
  if (quad.u0 > quad.u1 || quad.v0 > quad.v1) return;
  const auto size = static_cast<std::uint64_t>((quad.u1 - quad.u0 + 1) * (quad.v1 - quad.v0 + 1));
  quad.linked = storable ? std::min(size, (std::uint64_t{1} << config_.nodes_log2) - nodes_) : 0;
  nodes_ += quad.linked;
  quads_.push_back(quad);
}

topology::ListHead TopologyReference::head(std::int64_t u, std::int64_t v) const {
  topology::ListHead head;
  Integer near = config_.no_depth();
  for (const Quad& q : quads_) {
    if (!q.meets(u, v)) continue;
    head.present = true;
    near = std::min(near, q.far);
    (q.linked_to(u, v) ? head.linked : head.dropped) = true;
  }
  if (head.present) head.near = static_cast<std::uint32_t>(near);
  return head;
}

std::vector<std::uint32_t> TopologyReference::list(std::int64_t u, std::int64_t v) const {
  std::vector<std::uint32_t> numbers;
  for (auto q = quads_.rbegin(); q != quads_.rend(); ++q)
    if (q->linked_to(u, v)) numbers.push_back(q->number);
  return numbers;
}

std::optional<Point> TopologyReference::beam(const topology::Item& voxel, bool two_sided,
                                             std::uint32_t& clearance,
                                             topology::TopologyResult& result) const {
  if (light_) return beam_in_perspective(*light_, voxel, two_sided, std::exchange(clearance, 0), result);
  const int f = config_.matrix_frac_bits, depth_bits = config_.position_bits() + 4;
  std::array<Rational, 3> normal = {voxel.normal[0], voxel.normal[1], voxel.normal[2]};
  if (two_sided && row(8, normal, depth_bits) > 0)
    for (Rational& n : normal) n = -n;
  const Rational descent = row(8, normal, depth_bits);
  result.facing_away = descent >= 0;
  if (result.facing_away) return std::nullopt;
  const Rational factor = Rational(registers_.offset_factor) * power_of_two(-16);
  Point moved = orthographic_place(voxel);
  for (std::size_t axis = 0; axis < 2; ++axis) moved[axis] += floor_to(factor * row(4 * axis, normal, f), f);
  moved[2] = Rational(floor(floor_to(moved[2], 4) + floor_to(factor * floor_to(descent, 4), 4)));
  return moved;
}

topology::TopologyResult TopologyReference::resolve(const topology::Item& voxel, bool two_sided,
                                                    std::uint32_t clearance, bool sorted) const {
  topology::TopologyResult result;
  const auto moved = this->beam(voxel, two_sided, clearance, result);
  result.shadow = !moved;
  if (!moved) return result;
  Point beam;
  bool on_plane = true;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const Rational held = floor_to((*moved)[axis], config_.sub_bits);
    on_plane = on_plane && held >= 0 && held < config_.side();
    beam[axis] = held * power_of_two(config_.sub_bits);
  }
  result.off_plane = !on_plane;
  if (!on_plane) return result;
  beam[2] = saturated((*moved)[2]);

  const Integer u = floor(beam[0] * power_of_two(-config_.sub_bits));
  const Integer v = floor(beam[1] * power_of_two(-config_.sub_bits));
  bool dropped = false;
  for (const Quad& q : quads_) {
    if (!q.meets(u, v)) continue;
    dropped = dropped || !q.linked_to(u, v);
    result.uncertain = result.uncertain || Rational(q.far + clearance) < beam[2];
  }
  if (!result.uncertain) return result;
  for (auto q = quads_.rbegin(); q != quads_.rend() && !result.hit; ++q) {
    if (!q->linked_to(u, v)) continue;
    ++result.visited;
    if (Rational(q->far + clearance) >= beam[2]) {
      if (sorted) break;
      continue;
    }
    ++result.tested;
    // The published form, with the depths that the page leaves out.
    const auto& c = q->corners;
    result.hit = paper_hit(beam, c[0], c[1], c[2]) || paper_hit(beam, c[0], c[2], c[3]);
    if (result.hit) result.quad = q->number;
  }
  result.fallback = !result.hit && dropped;
  result.shadow = result.hit || result.fallback;
  return result;
}

}  // namespace gnomon::test
