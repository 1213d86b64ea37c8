// SPDX-License-Identifier: Apache-2.0
// Exact rationals, floor by division.
#include "tests/golden/exact_oracle.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

namespace gnomon::exact {
namespace {

using golden::Register;
using golden::VoxelItem;
using golden::VoxelResult;
using golden::VoxelState;

using Point = std::array<Rational, 3>;

constexpr std::array kFirstOfRow{Register::MatrixUx, Register::MatrixVx, Register::MatrixDx};

Register offset(Register first, int by) {
  return static_cast<Register>(static_cast<int>(first) + by);
}

/// The integer that stands for x with `frac` fraction bits; x must have no more than these.
Integer hold(const Rational& x, int frac) {
  const Rational scaled = x * power_of_two(frac);
  if (denominator(scaled) != 1) throw std::logic_error("a value has more fraction bits than its format");
  return numerator(scaled);
}

std::pair<std::int64_t, std::int64_t> entry(const Landing& landing) {
  return {landing.u.convert_to<std::int64_t>(), landing.v.convert_to<std::int64_t>()};
}

}  // namespace

Integer floor(const Rational& x) {
  const Integer n = numerator(x), d = denominator(x);  // d > 0
  Integer quotient = n / d;                            // towards zero
  if (n < 0 && quotient * d != n) --quotient;
  return quotient;
}

Rational power_of_two(int exponent) {
  Rational result = 1;
  for (int i = 0; i < std::abs(exponent); ++i) result *= 2;
  return exponent < 0 ? 1 / result : result;
}

Rational floor_to(const Rational& x, int bits) {
  const Rational one = power_of_two(bits);
  return Rational(floor(x * one)) / one;
}

Unit::Unit(const golden::HardwareConfig& config, const stimulus::RegisterValues& registers)
    : config_(config), registers_(registers) {}

Integer Unit::held(Register reg) const {
  return registers_[static_cast<std::size_t>(reg)];
}

Rational Unit::value(Register reg) const {
  const bool depth = reg >= Register::MatrixDx && reg <= Register::MatrixD1;
  const bool matrix = reg <= Register::MatrixV1;
  const int frac = matrix                          ? config_.matrix_frac_bits
                   : depth                         ? config_.position_bits() + 4
                   : reg == Register::OffsetFactor ? 16
                                                   : 0;
  return Rational(held(reg)) / power_of_two(frac);
}

Point Unit::project(const VoxelItem& item) const {
  Point point;
  for (std::size_t i = 0; i < 3; ++i) {
    point[i] = value(offset(kFirstOfRow[i], 3));
    for (int axis = 0; axis < 3; ++axis) {
      point[i] += value(offset(kFirstOfRow[i], axis)) * item.position[static_cast<std::size_t>(axis)];
    }
  }
  return point;
}

Point Unit::gradient(const VoxelItem& item) const {
  Point sum;
  for (std::size_t i = 0; i < 3; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      sum[i] += value(offset(kFirstOfRow[i], axis)) * item.normal[static_cast<std::size_t>(axis)];
    }
  }
  return sum;
}

Landing Unit::land(const Point& point) const {
  return {floor(point[0]), floor(point[1]), floor(point[2])};
}

Landing Unit::land_offset(const Point& point, const Point& gradient) const {
  const Rational factor = value(Register::OffsetFactor);
  const int f = config_.matrix_frac_bits;
  return {floor(point[0] + floor_to(factor * gradient[0], f)),
          floor(point[1] + floor_to(factor * gradient[1], f)),
          floor(floor_to(point[2], 4) + floor_to(factor * floor_to(gradient[2], 4), 4))};
}

/// A magnitude as the margin test sees it: the held integer without its lowest bits, saturated.
Integer Unit::scaled(const Rational& magnitude, int frac_bits, Register shift, int width) const {
  const Rational whole = abs(magnitude) * power_of_two(frac_bits);
  const Integer kept = floor(whole / power_of_two(held(shift).convert_to<int>()));
  return std::min<Integer>(kept, (Integer(1) << width) - 1);
}

bool Unit::exceeds_margin(const Integer& delta, const Point& gradient) const {
  const int f = config_.matrix_frac_bits, depth_frac = config_.position_bits() + 4;
  const Integer delta_n = scaled(Rational(delta), 0, Register::DeltaShift, 12);
  const Integer g_dn = scaled(gradient[2], depth_frac, Register::FacingShift, 16);
  const Integer g_un = scaled(gradient[0], f, Register::TiltShift, 16);
  const Integer g_vn = scaled(gradient[1], f, Register::TiltShift, 16);
  return delta_n * delta_n * g_dn * g_dn > held(Register::MarginSquared) * (g_un * g_un + g_vn * g_vn);
}

bool Unit::on_plane(const Landing& landing) const {
  const Integer side = Integer(1) << config_.plane_log2;
  return landing.u >= 0 && landing.u < side && landing.v >= 0 && landing.v < side;
}

std::uint32_t Unit::saturated(const Integer& depth) const {
  const Integer last = (Integer(1) << config_.depth_bits) - 2;
  return std::clamp<Integer>(depth, 0, last).convert_to<std::uint32_t>();
}

std::vector<NamedValue> Unit::intermediates(const VoxelItem& item, std::uint32_t code) const {
  const int f = config_.matrix_frac_bits, depth_frac = config_.position_bits() + 4;
  const Point point = project(item);
  const Landing own = land(point);
  std::vector<NamedValue> values{{"d", saturated(own.d)},
                                 {"d_floor", own.d},
                                 {"d_acc", hold(point[2], depth_frac)},
                                 {"d_coarse", hold(floor_to(point[2], 4), 4)}};
  for (const std::size_t row : {0u, 1u}) values.push_back({"u_acc", hold(point[row], f)});
  values.push_back({"u", own.u});
  values.push_back({"u", own.v});
  const Rational factor = value(Register::OffsetFactor);
  for (const int sign : {1, -1}) {
    Point g = gradient(item);
    for (Rational& component : g) component *= sign;
    for (const std::size_t row : {0u, 1u}) {
      const Rational step = floor_to(factor * g[row], f);
      values.push_back({"g_u", hold(g[row], f)});
      values.push_back({"u_step_product", hold(factor * g[row], f + 16)});
      values.push_back({"u_step", hold(step, f)});
      values.push_back({"u_moved_acc", hold(point[row] + step, f)});
      values.push_back({"g_un", scaled(g[row], f, Register::TiltShift, 16)});
    }
    const Landing moved = land_offset(point, g);
    const Rational coarse = floor_to(g[2], 4);
    values.push_back({"g_d", hold(g[2], depth_frac)});
    values.push_back({"g_d_coarse", hold(coarse, 4)});
    values.push_back({"d_step_product", hold(factor * coarse, 20)});
    values.push_back({"d_step", hold(floor_to(factor * coarse, 4), 4)});
    values.push_back({"d_moved_acc", hold(floor_to(point[2], 4) + floor_to(factor * coarse, 4), 4)});
    values.push_back({"u_moved", moved.u});
    values.push_back({"u_moved", moved.v});
    values.push_back({"d_moved_floor", moved.d});
    values.push_back({"d_moved", saturated(moved.d)});
    const Integer delta_signed = Integer(saturated(moved.d)) - code;
    const Integer delta = std::max<Integer>(0, delta_signed);
    const Integer delta_n = scaled(Rational(delta), 0, Register::DeltaShift, 12);
    const Integer g_dn = scaled(g[2], depth_frac, Register::FacingShift, 16);
    const Integer g_un = scaled(g[0], f, Register::TiltShift, 16),
                  g_vn = scaled(g[1], f, Register::TiltShift, 16);
    const Integer tilt_squared = g_un * g_un + g_vn * g_vn;
    values.push_back({"delta_signed", delta_signed});
    values.push_back({"delta", delta});
    values.push_back({"delta_n", delta_n});
    values.push_back({"g_dn", g_dn});
    values.push_back({"margin_left_root", delta_n * g_dn});
    values.push_back({"margin_left", delta_n * g_dn * delta_n * g_dn});
    values.push_back({"tilt_squared", tilt_squared});
    values.push_back({"margin_right", held(Register::MarginSquared) * tilt_squared});
  }
  return values;
}

std::int64_t register_value(std::size_t index, golden::Word word, const golden::HardwareConfig& config) {
  const golden::RegisterFormat format = golden::register_format(static_cast<Register>(index), config);
  const Integer range = Integer(1) << format.width;
  const Integer low = Integer(word) % range;
  const bool negative = format.is_signed && 2 * low >= range;
  return Integer(negative ? low - range : low).convert_to<std::int64_t>();
}

void project(Plane& plane, const Unit& unit, const VoxelItem& item) {
  const Landing landing = unit.land(unit.project(item));
  if (!unit.on_plane(landing)) return;
  const std::uint32_t depth = unit.saturated(landing.d);
  const auto [place, fresh] = plane.try_emplace(entry(landing), depth);
  if (!fresh) place->second = std::min(place->second, depth);
}

VoxelResult resolve(const Plane& plane, const Unit& unit, const VoxelItem& item, bool two_sided) {
  const Point point = unit.project(item);
  Point g = unit.gradient(item);
  if (two_sided && g[2] > 0) {
    for (Rational& component : g) component = -component;
  }
  const Landing own = unit.land(point);
  VoxelResult result{.state = VoxelState::Lit, .off_plane = !unit.on_plane(own)};
  if (g[2] >= 0) {
    result.state = VoxelState::Shadow;
    result.facing_away = true;
    return result;
  }
  const auto near = result.off_plane ? plane.end() : plane.find(entry(own));
  if (near == plane.end()) return result;
  result.nearest = near->second;
  if (near->second >= unit.saturated(own.d)) return result;
  result.uncertain = true;
  const Landing moved = unit.land_offset(point, g);
  const auto target = unit.on_plane(moved) ? plane.find(entry(moved)) : plane.end();
  if (target == plane.end()) {
    result.offset_empty = true;
    return result;
  }
  const Integer delta = Integer(unit.saturated(moved.d)) - target->second;
  if (delta <= 0) return result;
  result.delta = delta.convert_to<std::uint32_t>();
  result.beyond_max = delta > unit.limit();
  if (result.beyond_max || unit.exceeds_margin(delta, g)) result.state = VoxelState::Shadow;
  return result;
}

}  // namespace gnomon::exact
